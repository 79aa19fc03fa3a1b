"""The exact arrangement of line work."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from plumbline import _core
from plumbline._cached import cached
from plumbline._crs import ensure_same_crs
from plumbline._numbers import Number, Numbers
from plumbline._progress import Progress, told
from plumbline._whole import threads_of
from plumbline.cells import Cells
from plumbline.errors import Error
from plumbline.line_inputs import lines
from plumbline.lines import Lines, LinesLike

if TYPE_CHECKING:
    import geopandas
    import networkx
    import pyarrow

    from plumbline.polygons import FacePolygons
    from plumbline.rounding import RoundedArrangement


class Arrangement(Cells):
    """The subdivision of the plane that line work induces: vertices, edges, faces, exactly.

    Made by `plumbline.arrange`. Immutable; arrays are read-only views of the complex's memory.
    Everything is in canonical order: vertices by (x, y); edges by (tail, head), the tail being
    lexicographically first; face 0 is the unbounded one. Halfedge ``2 e`` runs along edge ``e``,
    ``2 e + 1`` against it; each has a face on its left.

    Attributes
    ----------
    lines : Lines
        The line work that it is of.
    labels : pandas.Index or None
        Names of the items, where the line work was a GeoDataFrame or a GeoSeries: its index.

    See Also
    --------
    plumbline.arrange
    """

    def __init__(self, core: _core.Complex, lines: Lines, labels: Any | None = None) -> None:
        super().__init__(core, lines)
        self.labels = labels
        self._doubles: RoundedArrangement | None = None

    @property
    def exact(self) -> Arrangement:
        """Itself; of a rounded one, the arrangement that was rounded."""
        return self

    # In other programs' words. Coordinates are those of `rounded()`. Where that has the same
    # incidences, which is nearly always, cells have the numbers that they have here; else those of
    # `rounded()`, whose `face_origin` leads back.

    def rounded(
        self, decimals: int | None = None, *, progress: Progress = None
    ) -> RoundedArrangement:
        """The arrangement with coordinates that are doubles, or decimals, proven to be a valid
        one: see `plumbline.snap_round`. That in doubles is kept."""
        from plumbline.rounding import snap_round

        if decimals is not None:
            return snap_round(self, decimals=decimals, progress=progress)
        if self._doubles is None:
            self._doubles = snap_round(self, progress=progress)
        return self._doubles

    def _in_doubles(self, decimals: int | None = None) -> RoundedArrangement:
        """The same, for what holds doubles."""
        rounded = self.rounded(decimals)
        if not rounded.valid_as_doubles:
            raise Error(
                f"doubles are too coarse for these {rounded.decimals} decimals: ask for fewer, or "
                "for a .json or .lines file"
            )
        return rounded

    def _placed(self) -> tuple[Arrangement, NDArray[np.float64]]:
        """Cells and places of their vertices that are proven to be valid together."""
        rounded = self._in_doubles()
        if rounded is self or not rounded.has_same_incidences:
            return rounded, rounded.vertices
        return self, rounded.vertices[rounded.vertex_image]

    @cached
    def polygons(self) -> FacePolygons:
        """The bounded faces as valid polygons, in arrays, without shapely."""
        from plumbline.polygons import polygons_of

        base, coords = self._placed()
        return polygons_of(base._core, coords)

    def to_shapely(self) -> NDArray[np.object_]:
        """The bounded faces as shapely's polygons, all valid, none over another: the first is
        face 1. Needs shapely.

        Edges that end within a face are left out of its polygon.

        Examples
        --------
        >>> import plumbline
        >>> a = plumbline.arrange([(0, 0, 2, 2), (0, 2, 2, 0), (0, 0, 0, 2)])
        >>> a.to_shapely()
        array([<POLYGON ((0 0, 1 1, 0 2, 0 0))>], dtype=object)
        """
        return self.polygons.to_shapely()

    def to_geopandas(self, sources: bool = True) -> geopandas.GeoDataFrame:
        """The bounded faces as a GeoDataFrame, in the reference system of the input. Needs
        geopandas.

        Returns
        -------
        GeoDataFrame
            Columns ``face``; ``area``, the exact one, correctly rounded (where rounding merged
            or parted any face, that of the polygon itself); ``perimeter``, rounded; ``depth``;
            ``parent``, the face that it lies in; with `sources` ``sources``, lists of the items
            that bound it or end in it, and, where the input has an index, their labels in
            ``source_index``; ``geometry``.
        """
        from plumbline.exports import faces_table

        return faces_table(self, sources)

    def edges_to_geopandas(self, sources: bool = True) -> geopandas.GeoDataFrame:
        """The edges as a GeoDataFrame. Needs geopandas.

        Returns
        -------
        GeoDataFrame
            Columns ``edge``; ``tail``, ``head``, vertices; ``left``, ``right``, faces, 0 the
            unbounded one; ``length``, rounded; with `sources` the items that cover it, as in
            `to_geopandas`; ``geometry``.
        """
        from plumbline.exports import edges_table

        return edges_table(self, sources)

    def to_networkx(self, dual: bool = False, exact: bool = False) -> networkx.Graph[int]:
        """The graph of vertices and edges, or with `dual` that of faces. Needs networkx.

        Parameters
        ----------
        dual : bool
            Nodes are faces, 0 the unbounded one, with ``area`` and ``depth``; edges lie between
            faces that share more than points, with the ``length`` that they share.
        exact : bool
            Whether nodes have an exact ``point``, faces an exact ``area``: Fractions.

        Returns
        -------
        networkx.Graph
            Nodes are vertices, with ``pos``, doubles. Edges have ``edge``, ``length`` and
            ``sources``.
        """
        from plumbline.exports import dual_graph, graph

        return dual_graph(self, exact) if dual else graph(self, exact)

    def to_arrow(self, sources: bool = True) -> pyarrow.Table:
        """The table of `to_geopandas` for Arrow, polygons as ``geoarrow.polygon``: hardly
        anything is copied, and shapely is not needed. Needs pyarrow."""
        from plumbline.exports import arrow_table

        return arrow_table(self, sources)

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        """That table for whatever takes Arrow's streams: DuckDB, Polars, lonboard, GDAL."""
        stream: object = self.to_arrow().__arrow_c_stream__(requested_schema)
        return stream

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        """The bounded faces as a FeatureCollection, with the properties of `to_geojson`."""
        collection: dict[str, Any] = json.loads(self.to_geojson())
        return collection

    def to_geojson(self, cells: str | Sequence[str] = "faces") -> str:
        """Cells (one or more of "faces", "edges", "vertices") as GeoJSON, in the drawing's own
        coordinates, which RFC 7946 takes for degrees."""
        from plumbline.exports import features_text

        return features_text(self, "geojson", cells, None)

    def to_topojson(self, cells: str | Sequence[str] = "faces") -> str:
        """The same as TopoJSON, without quantisation: what faces share is there once."""
        from plumbline.exports import features_text

        return features_text(self, "topojson", cells, None)

    def to_wkt(self, cells: str | Sequence[str] = "faces") -> str:
        """The same as well-known text, a geometry a line."""
        from plumbline.exports import features_text

        return features_text(self, "wkt", cells, None)

    def to_json(self, compact: bool = False) -> str:
        """Everything as JSON, exactly, as the tool writes it: vertices, edges with their sources,
        faces with areas and points inside, what was rejected.

        Parameters
        ----------
        compact : bool
            Without what follows from the rest: a third of the size.
        """
        from plumbline.exports import json_text

        return json_text(self, compact, None)

    def _exact_area(self) -> NDArray[np.float64]:
        """Per face the area of what it is exactly; where rounding merged any, its own."""
        return self.area

    def _vertices_frame(self) -> geopandas.GeoDataFrame:
        from plumbline.exports import vertices_table

        return vertices_table(self)

    def _written(self, format: str, **options: Any) -> str:
        from plumbline.write import arrangement_text

        return arrangement_text(self, format, **options)

    def _repr_svg_(self) -> str:
        from plumbline._pictures import arrangement_picture

        return arrangement_picture(self)

    def _violations(self) -> list[_core.Violation]:
        return self._core.validate() + self._core.validate_coverage(self.lines._core)

    def __eq__(self, other: object) -> bool:
        """Whether they are the same subdivision; what covers the edges does not matter."""
        if not isinstance(other, Arrangement):
            return NotImplemented
        return self.signature == other.signature

    def __hash__(self) -> int:
        return hash(self.signature)

    def __reduce__(self) -> tuple[Any, ...]:
        return _arranged, (self.lines, self.labels)

    def __repr__(self) -> str:
        n = self.counts
        return (
            f"<Arrangement: {n.vertices} vertices, {n.edges} edges, {n.faces - 1} bounded faces; "
            f"floats as {self.lines.numbers}>"
        )


def _arranged(of: Lines, labels: Any | None) -> Arrangement:
    return Arrangement(_core.arrange(of._core, False, 0, None), of, labels)


def arrange(
    lines_like: LinesLike,
    /,
    *,
    points: Sequence[Sequence[Number]] | None = None,
    numbers: Numbers | None = None,
    ids: Sequence[Any] | None = None,
    exact_engine: str = "bucket",
    threads: int | None = None,
    progress: Progress = None,
) -> Arrangement:
    """The arrangement of line work: everything that it cuts the plane into, exactly.

    Overlaps, duplicates, lines through one point and touching ends are all resolved; nothing is
    moved, merged or lost.

    Parameters
    ----------
    lines_like : array, sequence, geometries, path, text or Lines
        As `lines` takes it.
    points, numbers, ids
        As in `lines`.
    exact_engine : {"bucket", "cgal"}
        Both give the same; CGAL's sweep is the slower reference.
    threads : int, optional
        At most so many; by default, and for 0, as many as there are cores. Does not change the
        result.
    progress : bool or function, optional
        True for a bar of tqdm; a function is told which part is done, from 0 to 1. The engine
        "bucket" alone tells; Ctrl-C ends its work, with or without `progress`.

    Returns
    -------
    Arrangement

    Raises
    ------
    Error
        As `lines`; LimitError for 2^31 crossings or more.

    Warns
    -----
    LossWarning
        As `lines`: what has coordinates beyond 8.7e99, or not finite, takes no part.

    Notes
    -----
    O((n + K) log n) expected for n segments with K crossings; some tenths of a second for 100,000.
    The work is done without the GIL.

    Examples
    --------
    >>> import plumbline
    >>> a = plumbline.arrange([(0, 0, 2, 2), (0, 2, 2, 0), (0, 0, 0, 2)])
    >>> a
    <Arrangement: 5 vertices, 5 edges, 1 bounded faces; floats as doubles>
    >>> a.points[2], a.areas[1]
    ((Fraction(1, 1), Fraction(1, 1)), Fraction(1, 1))

    Whether 0.1 is a tenth is a question of what is meant:

    >>> tee = [(0.0, 0.0, 0.9, 0.3), (0.3, 0.2, 0.3, 0.1)]
    >>> plumbline.arrange(tee, numbers="decimals").counts.edges
    3
    >>> plumbline.arrange(tee, numbers="doubles").counts.edges
    2
    """
    if exact_engine not in ("bucket", "cgal"):
        raise Error(f'exact engines are "bucket" and "cgal": {exact_engine!r}')
    most = threads_of(threads)
    of = lines(lines_like, numbers=numbers, points=points, ids=ids)
    with told(progress, "arranging") as callback:
        core = _core.arrange(of._core, exact_engine == "cgal", most, callback)
    return Arrangement(core, of, _labels(lines_like))


def _labels(values: Any) -> Any | None:
    """The index of a GeoDataFrame or a GeoSeries."""
    if hasattr(values, "geometry") and hasattr(values, "crs"):
        return getattr(values, "index", None)
    return None


def signature(x: Arrangement | LinesLike) -> str:
    """The signature of an arrangement, or of that of line work: see `Arrangement.signature`."""
    return x.signature if isinstance(x, Arrangement) else arrange(x).signature


def same(a: Arrangement | LinesLike, b: Arrangement | LinesLike) -> bool:
    """Whether two arrangements, or those of two pieces of line work, are the same subdivision of
    the plane, to the last digit.

    Raises
    ------
    Error
        Where both have reference systems, and different ones; as `arrange`.

    Examples
    --------
    >>> import plumbline
    >>> plumbline.same([(0, 0, 2, 0)], [(2, 0, 1, 0), (0, 0, 2, 0), (0, 0, 1, 0)])
    False
    >>> plumbline.same([(0, 0, 2, 0)], [(2, 0, 0, 0), (0, 0, 2, 0)])
    True
    """
    ensure_same_crs(a, b)
    one, other = (x if isinstance(x, Arrangement) else arrange(x) for x in (a, b))
    ensure_same_crs(one, other)
    return one.signature == other.signature


def validate(x: Arrangement | LinesLike) -> list[_core.Violation]:
    """What is not true of an arrangement, or of that of line work, as a cellular complex and as a
    cover of its lines, by code that is independent of what made it: nothing, unless this library
    is broken."""
    return (x if isinstance(x, Arrangement) else arrange(x))._violations()
