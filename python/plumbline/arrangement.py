"""The exact arrangement of line work."""

from __future__ import annotations

import json
from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plumbline import _core
from plumbline._cached import cached
from plumbline._crs import ensure_same_crs
from plumbline._numbers import Number, Numbers, ensure_unmasked, in_doubles
from plumbline._progress import Progress, told
from plumbline._whole import threads_of, whole
from plumbline.errors import Error
from plumbline.line_inputs import are_beyond_doubles, lines, point_texts
from plumbline.lines import ExactPoint, Lines, LinesLike
from plumbline.lists import Lists
from plumbline.points import Points

if TYPE_CHECKING:
    import geopandas
    import networkx
    import pyarrow
    import scipy.sparse

    from plumbline.polygons import FacePolygons
    from plumbline.rounding import RoundedArrangement


class Arrangement:
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
        self._core = core
        self.lines = lines
        self.labels = labels
        self._doubles: RoundedArrangement | None = None

    @property
    def exact(self) -> Arrangement:
        """Itself; of a rounded one, the arrangement that was rounded."""
        return self

    # Vertices.

    @cached
    def vertices(self) -> NDArray[np.float64]:
        """Vertices, correctly rounded to nearest doubles, (V, 2). Two vertices may round to the
        same doubles, and edges cross: `rounded` has doubles that are proven to be free of that."""
        return self._core.coords()

    @property
    def points(self) -> Points:
        """Vertices, exactly."""
        return Points(self._core)

    # Edges.

    @cached
    def edges(self) -> NDArray[np.uint32]:
        """Edges as pairs of vertices, tail first, (E, 2)."""
        return self._core.edges()

    @cached
    def edge_segments(self) -> Lists:
        """Per edge the segments of `lines` that cover it, ascending."""
        return Lists(*self._core.edge_sources())

    @cached
    def sources(self) -> Lists:
        """Per edge the items of the input that cover it (rows, geometries, elements), ascending,
        each once."""
        return Lists(*self._core.edge_items(self.lines._core))

    @cached
    def face_sources(self) -> Lists:
        """Per face (the unbounded one, too) the items of the input that bound it or end within
        it, ascending, each once."""
        return Lists(*_core.face_items(self._core, self.lines._core))

    @cached
    def antennas(self) -> NDArray[np.intp]:
        """Edges with the same face on both sides: dangling ones and bridges."""
        left = self.halfedge_face
        edges = np.flatnonzero(left[0::2] == left[1::2])
        edges.flags.writeable = False
        return edges

    # Faces.

    def __len__(self) -> int:
        """How many bounded faces there are."""
        return self.counts.faces - 1

    @cached
    def cycles(self) -> Lists:
        """Closed walks of halfedges, each with one face on its left: outer boundaries run
        counter-clockwise, holes clockwise."""
        return Lists(*self._core.cycles())

    @cached
    def face_outer(self) -> NDArray[np.uint32]:
        """Per face its outer boundary, a cycle; 2**32 - 1 of the unbounded face 0, which has
        none."""
        return self._core.face_outer()

    @cached
    def face_holes(self) -> Lists:
        """Per face its holes, as cycles."""
        return Lists(*self._core.face_holes())

    @cached
    def isolated_vertices(self) -> Lists:
        """Per face the vertices of no edge that lie in it."""
        return Lists(*self._core.face_isolated_vertices())

    @cached
    def halfedge_face(self) -> NDArray[np.uint32]:
        """Per halfedge the face on its left, (2 E,)."""
        return self._core.halfedge_face()

    @cached
    def depth(self) -> NDArray[np.uint32]:
        """Per face how deep it is nested: 0 for the unbounded one, its parent's + 1 else."""
        return self._core.face_depth()

    @cached
    def parent(self) -> NDArray[np.uint32]:
        """Per face the face that it, or the connected component that it is of, lies in."""
        return _core.face_parents(self._core)

    @cached
    def vertex_component(self) -> NDArray[np.uint32]:
        """Per vertex its connected component."""
        return self._core.vertex_component()

    @cached
    def component_parent(self) -> NDArray[np.uint32]:
        """Per connected component the face that it lies in."""
        return self._core.component_parent()

    @cached
    def area(self) -> NDArray[np.float64]:
        """Per face its area without holes, correctly rounded; 0 of the unbounded one."""
        return self._core.area_doubles()

    @cached
    def areas(self) -> tuple[Fraction, ...]:
        """The same, exactly."""
        return tuple(self._core.face_areas())

    @cached
    def perimeter(self) -> NDArray[np.float64]:
        """Per face the length of its boundary, rounded; edges with it on both sides left out."""
        return _core.perimeters(self._core)

    def interior_point(self, face: int) -> ExactPoint:
        """A point inside a bounded face, exactly."""
        return self._core.interior_point(self._bounded(face))

    def _bounded(self, face: int) -> int:
        number = whole(face, "a face")
        if not 0 < number <= len(self):
            raise Error(f"bounded faces are 1 to {len(self)}: {face}")
        return number

    # In LAR's words.

    @property
    def V(self) -> NDArray[np.float64]:
        """LAR's name for `vertices`."""
        return self.vertices

    @property
    def EV(self) -> NDArray[np.uint32]:
        """LAR's name for `edges`."""
        return self.edges

    @cached
    def FV(self) -> Lists:
        """Per bounded face (the first is face 1) the vertices of its outer boundary as walked
        counter-clockwise, then those of its holes; edges that end within it left out: LAR's FV."""
        return Lists(*_core.face_walks(self._core))

    @cached
    def FE(self) -> Lists:
        """Per bounded face its edges, ascending, those that end within it, too: LAR's FE."""
        return Lists(*self._core.face_edges())

    @cached
    def d1(self) -> scipy.sparse.csc_array:
        """The boundary operator from edges to vertices, V x E: -1 at the tail, +1 at the head."""
        return _csc(self._core.boundary_1())

    @cached
    def d2(self) -> scipy.sparse.csc_array:
        """The boundary operator from faces to edges, E x F; column 0 is the unbounded face.
        ``d1 @ d2`` is 0."""
        return _csc(self._core.boundary_2())

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

    # As a whole.

    @cached
    def counts(self) -> _core.Counts:
        """Numbers of cells."""
        return self._core.counts()

    @cached
    def signature(self) -> str:
        """32 hexadecimal digits that depend on coordinates and incidences alone: equal
        arrangements have equal ones, on every machine, however the input was ordered."""
        return self._core.signature()

    def feature_size(self) -> _core.FeatureSize:
        """The least distances between two vertices, and between a vertex and an edge.

        Raises
        ------
        Error
            Where there are no edges.
        """
        if not self.counts.edges:
            raise Error("there are no edges")
        return self._core.feature_size()

    def locate(self, points: ArrayLike) -> NDArray[np.uint32]:
        """The face that each point lies in, exactly; 0 is the unbounded one.

        Parameters
        ----------
        points : array (n, 2), or a sequence of points (x, y); one point alone
            Arrays hold doubles or integers, which are taken as they are. In a sequence numbers are
            exact, and floats stand for what those of the drawing do. Of a point on an edge or a
            vertex, a face that has it on its boundary.

        Returns
        -------
        ndarray of uint32, (n,)

        Raises
        ------
        Error
            For an array of another shape, and coordinates that are no finite numbers.
        """
        values: Any = points
        if isinstance(values, np.ndarray) and values.dtype != object:
            coords = _doubles_of_points(values)
            if coords is not None:
                return self._core.locate_points(coords)
            values = values.reshape(-1, 2).tolist()
        faces = [self._core.locate(point) for point in point_texts(values, self.lines.numbers)]
        return np.array(faces, dtype=np.uint32)

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


def _doubles_of_points(array: NDArray[Any]) -> NDArray[np.float64] | None:
    """Points (n, 2) as doubles; None for integers that are none."""
    if array.shape != (2,) and (array.ndim != 2 or array.shape[1] != 2):
        raise Error(f"points are an array (n, 2), or (2,) of one: {array.shape}")
    if array.dtype.kind not in "iuf":
        raise Error(f"an array of numbers is needed: {array.dtype}")
    if are_beyond_doubles(array):
        return None
    try:
        ensure_unmasked(array)
        coords = in_doubles(array.reshape(-1, 2), None)
    except ValueError as error:
        raise Error(str(error)) from None
    if not np.isfinite(coords).all():
        raise Error("points have finite coordinates")
    return coords


def _csc(parts: tuple[Any, Any, Any, Any]) -> scipy.sparse.csc_array:
    from scipy.sparse import csc_array

    data, indices, indptr, shape = parts
    return csc_array((data, indices, indptr), shape=shape)


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
