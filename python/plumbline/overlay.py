"""Two layers of polygons over each other."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import NDArray

from plumbline import _core
from plumbline._attributes import attributes_of, joined_values, labels_of, named
from plumbline._cached import cached
from plumbline._crs import ensure_same_crs
from plumbline._numbers import Numbers
from plumbline._optional import needed
from plumbline._whole import threads_of
from plumbline.errors import Error
from plumbline.lines import Lines, LinesLike
from plumbline.regions import (
    ExactPolygon,
    FillRule,
    Region,
    layer_of,
    nested_coordinates,
    polygons_of_table,
    polygons_with_faces,
    warn_of_open,
)

if TYPE_CHECKING:
    from geopandas import GeoDataFrame

OVERLAYS = ("intersection", "union", "identity", "symmetric_difference", "difference")


@dataclass(frozen=True)
class OverlayPiece:
    """What lies in the same polygons of both layers: it may be of several parts."""

    first: tuple[int, ...]
    """Positions of the features of the first layer that it lies in, ascending."""
    second: tuple[int, ...]
    """The same of the second layer."""
    area: Fraction
    """Exactly."""


class Overlay(Sequence[OverlayPiece]):
    """Two layers of polygons, laid over each other: pieces that know what they lie in.

    Made by `plumbline.overlay`. Pieces are in the order of their least corners.

    See Also
    --------
    plumbline.overlay
    """

    def __init__(self, core: _core.Overlay, layers: tuple[Any, Any], made_of: Any) -> None:
        self._core = core
        self._layers = layers  # as they were given, for their attributes
        self._made_of = made_of

    @cached
    def _pieces(self) -> list[OverlayPiece]:
        items = self._core.items()
        # The items of the second layer are counted on from those of the first one.
        before = self._made_of[0].item_count

        def positions(regions: Sequence[int | None], start: int) -> tuple[int, ...]:
            found = {items[r] for r in regions if r is not None}
            return tuple(sorted(i - start for i in found if i is not None))

        return [
            OverlayPiece(positions(p.first, 0), positions(p.second, before), p.area)
            for p in self._core.pieces
        ]

    def __len__(self) -> int:
        return len(self._pieces)

    @overload
    def __getitem__(self, i: int) -> OverlayPiece: ...
    @overload
    def __getitem__(self, i: slice) -> list[OverlayPiece]: ...
    def __getitem__(self, i: int | slice) -> OverlayPiece | list[OverlayPiece]:
        return self._pieces[i]

    @property
    def area(self) -> Fraction:
        """The exact area of all pieces."""
        return sum((piece.area for piece in self), Fraction(0))

    @cached
    def polygons(self) -> list[list[ExactPolygon]]:
        """Per piece its parts with exact corners. Neighbours have the same corners on the side
        that they share."""
        of_face = {f: i for i, p in enumerate(self._core.pieces) for f in p.faces}
        result: list[list[ExactPolygon]] = [[] for _ in self._pieces]
        for face, polygon in polygons_with_faces(self._core.complex, set(of_face)):
            result[of_face[face]].append(polygon)
        return result

    @cached
    def region(self) -> Region:
        """All pieces as one."""
        one, other = self._made_of[:2]
        return Region(self._core.whole(), one if one.crs else other)

    @cached
    def _table(self) -> _core.Table:
        return self._core.table(0)

    def _piece_of_parts(self) -> list[int]:
        numbers: list[Any] = self._table.values(0)
        return [number - 1 for number in numbers]

    def to_shapely(self) -> NDArray[np.object_]:
        """Per piece a polygon, or a multipolygon, in doubles that are proven to be a partition;
        None for a piece that is too small for doubles. Needs shapely."""
        shapely = needed("shapely")
        parts = polygons_of_table(self._table)
        result = np.full(len(self), None, dtype=object)
        of_piece: dict[int, list[Any]] = {}
        for piece, part in zip(self._piece_of_parts(), parts):
            of_piece.setdefault(piece, []).append(part)
        for i, found in of_piece.items():
            result[i] = found[0] if len(found) == 1 else shapely.multipolygons(found)
        return result

    def to_geopandas(self) -> GeoDataFrame:
        """A GeoDataFrame with a row for each piece. Needs geopandas.

        Columns: those of both layers (of a difference of the first alone), with ``_1`` and ``_2``
        where both have one of a name; ``first`` and ``second``, lists of the features' labels in
        the index of the layer, or their positions; ``area``, rounded; ``area_exact``, a text;
        ``geometry``. Where a piece lies in several features of a layer, attributes are lists of
        theirs.
        """
        frames = needed("geopandas")
        columns: dict[str, Any] = {}
        has_second = self._made_of[2] != "difference"
        tables = [attributes_of(layer) for layer in self._layers[: 1 + has_second]]
        clash = set(tables[0]).intersection(*tables) if has_second else set()
        for k, table in enumerate(tables):
            of_pieces = [(p.first, p.second)[k] for p in self]
            for name, values in table.items():
                key = f"{name}_{k + 1}" if name in clash else name
                columns[key] = joined_values(values, of_pieces)
        for k, name in enumerate(("first", "second")):
            labels = labels_of(self._layers[k])
            columns[name] = [named(labels, (p.first, p.second)[k]) for p in self]
        columns["area"] = [float(p.area) for p in self]
        columns["area_exact"] = [str(p.area) for p in self]
        return frames.GeoDataFrame(columns, geometry=self.to_shapely(), crs=self._crs or None)

    @property
    def _crs(self) -> str:
        return self._made_of[0].crs or str(self._made_of[1].crs)

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        parts: list[list[Any]] = [[] for _ in self]
        for piece, part in zip(self._piece_of_parts(), nested_coordinates(self._table)):
            parts[piece].append(part)
        features = [
            {
                "type": "Feature",
                "properties": {
                    "first": list(p.first),
                    "second": list(p.second),
                    "area_exact": str(p.area),
                },
                "geometry": {"type": "MultiPolygon", "coordinates": part},
            }
            for p, part in zip(self, parts)
        ]
        return {"type": "FeatureCollection", "features": features}

    def __reduce__(self) -> tuple[Any, ...]:
        return _made, (self._layers, *self._made_of)

    def __repr__(self) -> str:
        count = "1 piece" if len(self) == 1 else f"{len(self)} pieces"
        return f"<Overlay: {count}, {self._made_of[2]}, area {float(self.area):.6g}>"


def _made(layers: tuple[Any, Any], one: Lines, other: Lines, how: str, rule: str) -> Overlay:
    core = _core.overlay(one._core, other._core, how, rule, 0)
    return Overlay(core, layers, (one, other, how, rule))


def overlay(
    a: LinesLike,
    b: LinesLike,
    /,
    how: str = "intersection",
    *,
    rule: FillRule = "evenodd",
    numbers: Numbers | None = None,
    threads: int | None = None,
) -> Overlay:
    """Two layers of polygons laid over each other: geopandas.overlay of polygons, exactly.

    Parameters
    ----------
    a, b : GeoDataFrame, geometries, Region, or whatever `lines` takes with polygons
    how : {"intersection", "union", "identity", "symmetric_difference", "difference"}
        Which pieces stay: those in both layers; in either; in the first; in one alone; in the
        first alone.
    rule, numbers, threads
        As in `union_all`.

    Returns
    -------
    Overlay
        Pieces cover what they should, point by point, and their areas add up to the last digit.
        Where features of one layer overlap, a piece lies in all of them, and is there once:
        geopandas has it once for each pair. ``to_geopandas()`` has the attributes of both.

    Raises
    ------
    Error
        For another `how`; as `union_all`; for two reference systems.

    Notes
    -----
    As `arrange`. What touches in lines or points alone makes no piece.

    Examples
    --------
    >>> import plumbline, shapely
    >>> parcels, zones = shapely.box([0, 2], 0, [2, 4], 2), shapely.box([1], [1], [3], [3])
    >>> made = plumbline.overlay(parcels, zones)
    >>> [(piece.first, piece.second, piece.area) for piece in made]
    [((0,), (0,), Fraction(1, 1)), ((1,), (0,), Fraction(1, 1))]
    """
    if how not in OVERLAYS:
        raise Error(f"how is one of {', '.join(OVERLAYS)}: {how!r}")
    one, other = layer_of(a, numbers), layer_of(b, numbers)
    ensure_same_crs(one, other)
    core = _core.overlay(one._core, other._core, how, rule, threads_of(threads))
    warn_of_open(len(core.open))
    return Overlay(core, (a, b), (one, other, how, rule))
