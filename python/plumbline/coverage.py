"""Coverages: layers of polygons that should neither overlap nor leave gaps."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

from plumbline import _core
from plumbline._cached import cached
from plumbline._numbers import Number, Numbers
from plumbline._optional import needed
from plumbline._sizes import optional_size, size_text
from plumbline.arrangement import arrange
from plumbline.errors import Error
from plumbline.lines import ExactPoint, Lines, LinesLike
from plumbline.regions import ExactPolygon, layer_of, polygons_of_table, polygons_with_faces

if TYPE_CHECKING:
    from geopandas import GeoDataFrame

Policy = Literal["longest-border", "largest", "smallest", "first"]


@dataclass(frozen=True)
class CoverageFault:
    """What is wrong in one place."""

    kind: str
    """"overlap", "gap", or "unmatched vertex", a corner in the middle of another one's side."""
    features: tuple[int, ...]
    """Positions of the features: those that overlap; those around the gap; of a vertex first the
    one whose side has no vertex there."""
    at: ExactPoint
    """A point inside, or the vertex, exactly."""
    area: Fraction
    """Exactly; 0 of a vertex."""
    width: float
    """Diameter of the largest circle in it, within some percent; 0 of a vertex."""


class _Layer:
    """Polygons with what is wrong with them."""

    def __init__(self, polygons: LinesLike, numbers: Numbers | None) -> None:
        self.lines = layer_of(polygons, numbers)
        self.core = _core.coverage(self.lines._core, arrange(self.lines)._core)
        self.items: list[Any] = self.core.items(self.lines._core)
        self.core_faults = self.core.faults(self.lines._core)

    def fault(self, core: _core.CoverageFault) -> CoverageFault:
        features = tuple(self.items[r] for r in core.polygons if r is not None)
        return CoverageFault(core.kind, features, core.at, core.area, core.width)

    def faults(self) -> list[CoverageFault]:
        return [self.fault(core) for core in self.core_faults]


def coverage_faults(
    polygons: LinesLike, /, *, numbers: Numbers | None = None
) -> list[CoverageFault]:
    """What is wrong with polygons that should neither overlap nor leave gaps, exactly.

    Parameters
    ----------
    polygons : GeoDataFrame, geometries, or whatever `lines` takes with polygons
    numbers : {"doubles", "decimals"}, optional
        As in `lines`.

    Returns
    -------
    list of CoverageFault
        Overlaps and gaps, then vertices that neighbours do not share, from left to right. All that
        polygons enclose and none covers is a gap, a lake, too.

    Raises
    ------
    Error
        For lines that are no polygons; as `arrange`.

    Examples
    --------
    >>> import plumbline, shapely
    >>> fault = plumbline.coverage_faults(shapely.box([0, 2], [0, 0], [3, 4], [1, 1]))[0]
    >>> fault.kind, fault.features, fault.area
    ('overlap', (0, 1), Fraction(1, 1))
    """
    return _Layer(polygons, numbers).faults()


def coverage_is_valid(
    polygons: LinesLike, /, *, gap_width: Number = 0, numbers: Numbers | None = None
) -> bool:
    """Whether polygons are a coverage: shapely.coverage_is_valid, exactly.

    Parameters
    ----------
    polygons, numbers
        As in `coverage_faults`.
    gap_width : number
        Gaps that are not wider count; by default none do. No overlap may be there, however small,
        and no vertex that neighbours do not share.

    Returns
    -------
    bool

    Raises
    ------
    Error
        For a negative width; as `coverage_faults`.

    Examples
    --------
    >>> import plumbline, shapely
    >>> plumbline.coverage_is_valid(shapely.box([0, 2], [0, 0], [2, 4], [1, 1]))
    True
    >>> plumbline.coverage_is_valid(shapely.box([0, 2], [0, 0], [2, 4], [1, 2]))
    False
    """
    most = float(Fraction(size_text("gap_width", gap_width)))
    return all(
        f.kind == "gap" and f.width > most for f in coverage_faults(polygons, numbers=numbers)
    )


class CleanCoverage(Sequence[list[ExactPolygon]]):
    """A coverage whose gaps and overlaps each belong to one polygon: per feature its parts with
    exact corners.

    Made by `plumbline.coverage_clean`.
    """

    def __init__(self, core: _core.CleanCoverage, layer: _Layer, polygons: LinesLike) -> None:
        self._core = core
        self._layer = layer
        self._polygons = polygons

    @property
    def _lines(self) -> Lines:
        return self._layer.lines

    @cached
    def changes(self) -> list[tuple[CoverageFault, int]]:
        """Overlaps and gaps, as they were, with the feature that has each now."""
        layer = self._layer
        return [(layer.fault(c.fault), layer.items[c.to or 0]) for c in self._core.changes]

    @cached
    def vanished(self) -> list[int]:
        """Features of which nothing is left."""
        return [self._layer.items[r] for r in self._core.vanished if r is not None]

    @cached
    def areas(self) -> list[Fraction]:
        """Per feature, exactly."""
        result = [Fraction(0)] * self._lines.item_count
        for item, area in zip(self._layer.items, self._core.coverage.areas(), strict=True):
            result[item] += area
        return result

    @cached
    def polygons(self) -> list[list[ExactPolygon]]:
        """Per feature its parts with exact corners; where features still overlap, parted there."""
        clean = self._core.coverage
        of_face: dict[Any, list[int]] = {}
        for item, faces in zip(self._layer.items, clean.faces(), strict=True):
            for face in faces:
                of_face.setdefault(face, []).append(item)
        result: list[list[ExactPolygon]] = [[] for _ in range(self._lines.item_count)]
        for face, polygon in polygons_with_faces(clean.complex, set(of_face)):
            for item in of_face[face]:
                result[item].append(polygon)
        return result

    def __len__(self) -> int:
        return self._lines.item_count

    def __getitem__(self, i: Any) -> Any:
        return self.polygons[i]

    def to_shapely(self) -> NDArray[np.object_]:
        """Per feature a polygon or a multipolygon, in doubles that are proven to be valid together;
        an empty one where nothing is left. Needs shapely."""
        shapely = needed("shapely")
        table = self._core.coverage.table(self._lines._core, 0)
        parts: list[list[Any]] = [[] for _ in range(len(self))]
        numbers: list[Any] = table.values(0)
        for number, part in zip(numbers, polygons_of_table(table), strict=True):
            parts[self._layer.items[number - 1]].append(part)
        result = np.empty(len(self), dtype=object)
        for i, of in enumerate(parts):
            result[i] = of[0] if len(of) == 1 else shapely.multipolygons(of)
        return result

    def to_geopandas(self) -> GeoDataFrame:
        """The layer with these polygons; of what was no GeoDataFrame geometries alone. Needs
        geopandas."""
        geometries = self.to_shapely()
        if hasattr(self._polygons, "columns") and hasattr(self._polygons, "set_geometry"):
            result: GeoDataFrame = self._polygons.set_geometry(geometries, crs=self._polygons.crs)
            return result
        frames = needed("geopandas")
        return frames.GeoDataFrame(geometry=geometries, crs=self._lines.crs or None)

    def __repr__(self) -> str:
        return f"<CleanCoverage: {len(self)} features, {len(self.changes)} changes>"


def coverage_clean(
    polygons: LinesLike,
    /,
    *,
    policy: Policy = "longest-border",
    width: Number | None = None,
    area: Number | None = None,
    numbers: Numbers | None = None,
) -> CleanCoverage:
    """Polygons with gaps and overlaps given to one of those beside them: shapely.coverage_clean
    without moving a vertex.

    Parameters
    ----------
    polygons, numbers
        As in `coverage_faults`.
    policy : {"longest-border", "largest", "smallest", "first"}
        Who gets what several could have.
    width, area : number, optional
        What is wider, or larger, stays as it is: it is a lake. By default all goes.

    Returns
    -------
    CleanCoverage

    Raises
    ------
    Error
        For another policy, a negative size; as `coverage_faults`.

    Examples
    --------
    >>> import plumbline, shapely
    >>> made = plumbline.coverage_clean(shapely.box([0, 2], [0, 0], [3, 9], [1, 1]))
    >>> made.areas, made.changes[0][1]
    ([Fraction(2, 1), Fraction(7, 1)], 1)
    """
    if policy not in ("longest-border", "largest", "smallest", "first"):
        raise Error(f"a policy is longest-border, largest, smallest or first: {policy!r}")
    sizes = optional_size("width", width), optional_size("area", area)
    layer = _Layer(polygons, numbers)
    core = _core.clean(layer.core, layer.lines._core, layer.core_faults, policy, *sizes)
    return CleanCoverage(core, layer, polygons)
