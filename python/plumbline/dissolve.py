"""Polygons joined by what they have in common."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from plumbline import _core
from plumbline._attributes import attributes_of, joined_values
from plumbline._numbers import Numbers
from plumbline._optional import needed
from plumbline._whole import threads_of
from plumbline.errors import Error
from plumbline.lines import Lines, LinesLike
from plumbline.regions import FillRule, Region, layer_of

if TYPE_CHECKING:
    from geopandas import GeoDataFrame


class Dissolved(Mapping[Any, Region]):
    """Regions by what their polygons have in common.

    Made by `plumbline.dissolve`. In the order of the keys, or where they have none, of the layer.
    """

    def __init__(self, regions: dict[Any, Region], layer: Any, members: dict[Any, list[int]]):
        self._regions = regions
        self._layer = layer
        self._members = members

    def __getitem__(self, key: Any) -> Region:
        return self._regions[key]

    def __iter__(self) -> Iterator[Any]:
        return iter(self._regions)

    def __len__(self) -> int:
        return len(self._regions)

    def members(self, key: Any) -> list[int]:
        """Positions of the features that were joined."""
        return self._members[key]

    def to_geopandas(self) -> GeoDataFrame:
        """A GeoDataFrame with a multipolygon for each key, which is the index. Needs geopandas.

        Columns: those of the layer, of each key's first feature, as geopandas.dissolve has them;
        ``area_exact``, a text; ``geometry``.
        """
        frames, shapely = needed("geopandas"), needed("shapely")
        first = [[members[0]] for members in self._members.values()]
        columns = {n: joined_values(v, first) for n, v in attributes_of(self._layer).items()}
        columns["area_exact"] = [str(region.area) for region in self.values()]
        geometry = [shapely.multipolygons(list(r.to_shapely())) for r in self.values()]
        crs = next((r._input.crs for r in self.values()), "")
        index = needed("pandas").Index(list(self), tupleize_cols=False)
        return frames.GeoDataFrame(columns, geometry=geometry, crs=crs or None, index=index)

    def __repr__(self) -> str:
        return f"<Dissolved: {len(self)} regions, {', '.join(map(repr, list(self)[:5]))}>"


def _keys(layer: Any, of: Lines, by: Any) -> list[Any]:
    """Per item its key."""
    if by is None:
        return [0] * of.item_count
    if isinstance(by, str) and by in getattr(layer, "columns", ()):
        return list(layer[by])
    if isinstance(by, str) and by == "layer":
        return [of.source(i).layer for i in range(of.item_count)]
    if isinstance(by, str) or not hasattr(by, "__iter__"):
        raise Error(f'by is a column, "layer", or a key for each feature: {by!r:.60}')
    keys = list(by)
    if len(keys) != of.item_count:
        raise Error(f"there are {of.item_count} features and {len(keys)} keys")
    return keys


def dissolve(
    polygons: LinesLike,
    /,
    by: Any = None,
    *,
    rule: FillRule = "evenodd",
    numbers: Numbers | None = None,
    threads: int | None = None,
) -> Dissolved:
    """Polygons joined by what they have in common: GeoDataFrame.dissolve, exactly.

    Parameters
    ----------
    polygons : GeoDataFrame, geometries, or whatever `lines` takes with polygons
    by : str or sequence, optional
        A column; "layer" of a drawing; a key for each feature. By default all are joined, with the
        key 0. Features whose key is None or not a number are left out, as in geopandas.
    rule, numbers, threads
        As in `union_all`.

    Returns
    -------
    Dissolved
        A mapping of each key to its `Region`. Where keys overlap each has the whole of its own.

    Raises
    ------
    Error
        For a column that is not there, as many keys as there are no features; as `union_all`.

    Examples
    --------
    >>> import plumbline, shapely
    >>> squares = shapely.box([0, 1, 5], 0, [2, 3, 6], 1)
    >>> found = plumbline.dissolve(squares, by=["field", "field", "lake"])
    >>> {key: region.area for key, region in found.items()}
    {'field': Fraction(3, 1), 'lake': Fraction(1, 1)}
    """
    of = layer_of(polygons, numbers)
    keys = _keys(polygons, of, by)
    members: dict[Any, list[int]] = {}
    for i in sorted({i for i in _core.polygon_items(of._core) if i is not None}):
        if keys[i] is not None and keys[i] == keys[i]:
            members.setdefault(keys[i], []).append(i)
    with suppress(TypeError):  # keys without an order stay as they come
        members = dict(sorted(members.items()))
    number = {i: n for n, of_key in enumerate(members.values()) for i in of_key}
    left_out = len(members)
    groups = [
        left_out if i is None else number.get(i, left_out) for i in _core.polygon_items(of._core)
    ]
    found = _core.dissolve(of._core, groups, rule, threads_of(threads))
    regions = {key: Region(core, of) for key, core in zip(members, found)}
    return Dissolved(regions, polygons, members)
