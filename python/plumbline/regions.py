"""What polygons cover together, exactly: unions, differences, and what expressions select."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

from plumbline import _core
from plumbline._cached import cached
from plumbline._crs import ensure_same_crs
from plumbline._numbers import Numbers
from plumbline._tables import to_geodataframe
from plumbline._warnings import warn_of_loss
from plumbline._whole import threads_of
from plumbline.errors import Error
from plumbline.line_inputs import lines
from plumbline.lines import ExactPoint, Lines, LinesLike
from plumbline.points import Points

if TYPE_CHECKING:
    from geopandas import GeoDataFrame

FillRule = Literal["evenodd", "nonzero", "positive", "negative"]
"""Of which winding numbers a polygon's inside is: the odd ones, those that are not 0, those above
0, those below."""
ExactPolygon = list[list[ExactPoint]]
"""Rings of exact points, the first one repeated at the end; the outer ring first."""


class Region:
    """A part of the plane: polygons with exact corners, none over another.

    Made by `plumbline.union_all`, `select` and the like. All functions that take polygons take it,
    exactly; what is made of it for others has doubles that are proven to be valid together.

    See Also
    --------
    plumbline.union_all, plumbline.select, plumbline.dissolve
    """

    def __init__(self, core: _core.RegionPolygons, input: Lines) -> None:
        self._core = core
        self._input = input

    @property
    def area(self) -> Fraction:
        """The exact area."""
        return sum(self.areas, Fraction(0))

    @cached
    def areas(self) -> list[Fraction]:
        """Per polygon, exactly."""
        return self._core.areas

    @cached
    def polygons(self) -> list[ExactPolygon]:
        """The polygons with exact corners. Outer rings run counter-clockwise, holes clockwise."""
        return exact_polygons(self._core.complex, set(self._core.faces()))

    @cached
    def lines(self) -> Lines:
        """The sides of the polygons, exactly."""
        core = self._core.drawing()
        core.set_frame(self._input.crs, True)
        return Lines(core, self._input.numbers)

    @property
    def _as_lines(self) -> Lines:
        return self.lines

    def equals(self, other: LinesLike) -> bool:
        """Whether it covers the same points, exactly; where corners are does not matter."""
        return not len(symmetric_difference(self, other))

    @cached
    def _table(self) -> _core.Table:
        return self._core.table(self._input._core, 0)

    def to_shapely(self) -> NDArray[np.object_]:
        """Shapely's polygons, in doubles that are proven to be valid together. Needs shapely."""
        return polygons_of_table(self._table)

    def to_geopandas(self) -> GeoDataFrame:
        """A GeoDataFrame of the same polygons with ``area``, rounded, and ``area_exact``, a text.
        Needs geopandas."""
        return to_geodataframe(self._table, self._input.crs)

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        return {"type": "MultiPolygon", "coordinates": nested_coordinates(self._table)}

    def __len__(self) -> int:
        return len(self._core)

    def __iter__(self) -> Iterator[ExactPolygon]:
        return iter(self.polygons)

    def __reduce__(self) -> tuple[Any, ...]:
        return union_all, (self.lines,)

    def __repr__(self) -> str:
        count = "1 polygon" if len(self) == 1 else f"{len(self)} polygons"
        return f"<Region: {count}, area {float(self.area):.6g}>"


def exact_polygons(complex: _core.Complex, faces: set[int]) -> list[ExactPolygon]:
    """The polygons of these faces, by face."""
    return [polygon for _, polygon in polygons_with_faces(complex, faces)]


def polygons_with_faces(
    complex: _core.Complex, faces: set[int]
) -> Iterator[tuple[int, ExactPolygon]]:
    """Faces of these, each with a polygon of it, by face."""
    points = Points(complex)
    vertices, ring_starts, polygon_starts, face_of = _core.polygon_rings(complex)
    for p, face in enumerate(face_of.tolist()):
        if face in faces:
            rings = range(polygon_starts[p], polygon_starts[p + 1])
            yield (
                face,
                [[points[v] for v in vertices[ring_starts[r] : ring_starts[r + 1]]] for r in rings],
            )


def polygons_of_table(table: _core.Table) -> NDArray[np.object_]:
    """Shapely's polygons of the rows of a table."""
    from plumbline._tables import _geometries

    return np.asarray(_geometries(table), dtype=object)


def nested_coordinates(table: _core.Table) -> list[list[list[list[float]]]]:
    """Coordinates of the rows' polygons, as GeoJSON has them."""
    coords, parts, features = table.geometries()
    rings = [coords[a:b].tolist() for a, b in pairwise(parts)]
    return [rings[a:b] for a, b in pairwise(features)]


def layer_of(values: LinesLike, numbers: Numbers | None) -> Lines:
    """Polygons as lines.

    Raises
    ------
    Error
        For lines none of which is a polygon.

    Warns
    -----
    LossWarning
        Where some are none.
    """
    of = lines(values, numbers=numbers)
    count = _core.polygon_items(of._core)
    if len(of) and not len(count):
        raise Error(
            "none of these lines is a polygon, or closed (for what lines enclose: "
            "plumbline.polygonize)"
        )
    return of


def warn_of_open(open_segments: int) -> None:
    """Says that some segments are parts of no polygon."""
    if open_segments:
        segments = "1 segment is" if open_segments == 1 else f"{open_segments} segments are"
        warn_of_loss(f"{segments} part of no polygon")


def union_all(
    polygons: LinesLike,
    /,
    *,
    rule: FillRule = "evenodd",
    numbers: Numbers | None = None,
    threads: int | None = None,
) -> Region:
    """What polygons cover together: shapely.union_all of polygons, exactly.

    Parameters
    ----------
    polygons : geometries, GeoDataFrame, Region, or whatever `lines` takes with polygons
        Closed lines count as polygons. A polygon need not be valid: `rule` says what it covers.
    rule : {"evenodd", "nonzero", "positive", "negative"}
        Which points each polygon covers, by how often its rings go around them, counter-clockwise.
    numbers : {"doubles", "decimals"}, optional
        What floats stand for, as in `lines`.
    threads : int, optional
        As in `plumbline.arrange`.

    Returns
    -------
    Region
        What touches in points alone is apart. Sides keep the corners that polygons had there.

    Raises
    ------
    Error
        For lines that are no polygons, a rule that is none; as `arrange`.

    Notes
    -----
    As `arrange`.

    Examples
    --------
    >>> import plumbline
    >>> plumbline.union_all("MULTIPOLYGON (((0 0, 3 0, 0 3, 0 0)), ((1 1, 2 1, 2 2, 1 1)))").area
    Fraction(9, 2)
    >>> squares = ["POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))", "POLYGON ((1 1, 3 1, 3 3, 1 3, 1 1))"]
    >>> import shapely
    >>> plumbline.union_all(shapely.from_wkt(squares))
    <Region: 1 polygon, area 7>
    """
    of = layer_of(polygons, numbers)
    groups = [0] * len(_core.polygon_items(of._core))
    found = _core.dissolve(of._core, groups, rule, threads_of(threads))
    if not found:
        return _both(of, of, "union", rule, threads_of(threads))
    return Region(found[0], of)


def _both(a: Lines, b: Lines, how: str, rule: str, threads: int) -> Region:
    made = _core.overlay(a._core, b._core, how, rule, threads)
    warn_of_open(len(made.open))
    return Region(made.whole(), a if a.crs else b)


def _of_two(
    a: LinesLike, b: LinesLike, how: str, rule: FillRule, numbers: Numbers | None
) -> Region:
    one, other = layer_of(a, numbers), layer_of(b, numbers)
    ensure_same_crs(one, other)
    return _both(one, other, how, rule, 0)


def intersection(
    a: LinesLike, b: LinesLike, /, *, rule: FillRule = "evenodd", numbers: Numbers | None = None
) -> Region:
    """What is in both of two layers of polygons: shapely.intersection of polygons, exactly.

    Parameters
    ----------
    a, b : geometries, GeoDataFrame, Region, or whatever `lines` takes with polygons
        Each is taken as a whole: a point is in it that is in any of its polygons.
    rule, numbers
        As in `union_all`.

    Returns
    -------
    Region
        Without what touches in lines or points alone.

    Raises
    ------
    Error
        As `union_all`; for two reference systems.

    Examples
    --------
    >>> import plumbline
    >>> a, b = "POLYGON ((0 0, 3 0, 0 1, 0 0))", "POLYGON ((0 0, 1 0, 0 3, 0 0))"
    >>> plumbline.intersection(a, b).polygons[0][0][2]
    (Fraction(3, 4), Fraction(3, 4))
    """
    return _of_two(a, b, "intersection", rule, numbers)


def union(
    a: LinesLike, b: LinesLike, /, *, rule: FillRule = "evenodd", numbers: Numbers | None = None
) -> Region:
    """What is in either of two layers of polygons; all as in `intersection`.

    Examples
    --------
    >>> import plumbline
    >>> plumbline.union("POLYGON ((0 0, 3 0, 0 1, 0 0))", "POLYGON ((0 0, 1 0, 0 3, 0 0))").area
    Fraction(9, 4)
    """
    return _of_two(a, b, "union", rule, numbers)


def difference(
    a: LinesLike, b: LinesLike, /, *, rule: FillRule = "evenodd", numbers: Numbers | None = None
) -> Region:
    """What is in the first of two layers of polygons alone; all as in `intersection`.

    Examples
    --------
    >>> import plumbline
    >>> a, b = "POLYGON ((0 0, 3 0, 0 1, 0 0))", "POLYGON ((0 0, 1 0, 0 3, 0 0))"
    >>> plumbline.difference(a, b).area
    Fraction(3, 4)
    """
    return _of_two(a, b, "difference", rule, numbers)


def symmetric_difference(
    a: LinesLike, b: LinesLike, /, *, rule: FillRule = "evenodd", numbers: Numbers | None = None
) -> Region:
    """What is in one of two layers of polygons alone; all as in `intersection`.

    Examples
    --------
    >>> import plumbline
    >>> a = "POLYGON ((0 0, 3 0, 3 1, 0 1, 0 0))"
    >>> len(plumbline.symmetric_difference(a, "POLYGON ((0 0, 1 0, 3 0, 3 1, 0 1, 0 0))"))
    0
    """
    return _of_two(a, b, "symmetric_difference", rule, numbers)


def select(
    drawing: LinesLike,
    expression: str,
    /,
    *,
    rule: FillRule = "evenodd",
    numbers: Numbers | None = None,
    threads: int | None = None,
) -> Region:
    """What an expression of layers selects of a drawing, exactly.

    Parameters
    ----------
    drawing : path, geometries, GeoDataFrame with a column ``layer``, or whatever `lines` takes
        A layer has its polygons, and what its other lines enclose where they close.
    expression : str
        Names of layers, ``!`` not, ``&`` and, ``|`` or, ``^`` either, ``-`` without, parentheses;
        ``count``, in how many regions, and ``count(NAME)``, compared with a number by ``<``,
        ``<=``, ``=``, ``!=``, ``>=``, ``>``. Names are in quotes where they have other characters
        than letters, digits and ``_ . : * ?``, which stand for any characters and for one.
    rule, numbers, threads
        As in `union_all`.

    Returns
    -------
    Region

    Raises
    ------
    Error
        For an expression that is none, with the place; a layer that is not there; a drawing
        without polygons; what selects all of the plane.

    Examples
    --------
    >>> import plumbline, shapely
    >>> squares = shapely.box([0, 1], [0, 1], [2, 3], [2, 3])
    >>> plan = plumbline.lines(squares, layers=["WALLS", "DOORS"])
    >>> plumbline.select(plan, "WALLS - DOORS").area, plumbline.select(plan, "count >= 2").area
    (Fraction(3, 1), Fraction(1, 1))
    """
    of = lines(drawing, numbers=numbers)
    found, _, open_segments = _core.select(of._core, expression, rule, threads_of(threads))
    warn_of_open(len(open_segments))
    return Region(found, of)
