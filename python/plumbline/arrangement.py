"""The exact arrangement of line work."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plumbline import _core
from plumbline._numbers import Number, Numbers, exact_text
from plumbline._progress import Progress, told
from plumbline.errors import Error
from plumbline.lines import ExactPoint, Lines, LinesLike, lines
from plumbline.lists import Lists

if TYPE_CHECKING:
    import scipy.sparse


class Points(Sequence[ExactPoint]):
    """Exact coordinates, made when asked for: `points[i]` is a pair of Fractions."""

    def __init__(self, core: _core.Complex) -> None:
        self._core = core

    def __len__(self) -> int:
        return self._core.counts().vertices

    @overload
    def __getitem__(self, i: int) -> ExactPoint: ...
    @overload
    def __getitem__(self, i: slice) -> list[ExactPoint]: ...
    def __getitem__(self, i: int | slice) -> ExactPoint | list[ExactPoint]:
        if isinstance(i, slice):
            return [self._core.point(k) for k in range(len(self))[i]]
        return self._core.point(range(len(self))[i])

    def __iter__(self) -> Iterator[ExactPoint]:
        for i in range(len(self)):
            yield self._core.point(i)

    def fractions(self) -> tuple[NDArray[Any], NDArray[Any]]:
        """Numerators and denominators in lowest terms, (V, 2) each: int64 where all fit, else
        arrays of ints."""
        small = self._core.small_fractions()
        if small is not None:
            return small[:, 0::2], small[:, 1::2]
        numerators = np.empty((len(self), 2), dtype=object)
        denominators = np.empty((len(self), 2), dtype=object)
        for i, point in enumerate(self):
            numerators[i] = [c.numerator for c in point]
            denominators[i] = [c.denominator for c in point]
        return numerators, denominators

    def mpq(self) -> list[tuple[Any, Any]]:
        """All points as pairs of gmpy2's mpq, for fast exact arithmetic. Needs gmpy2."""
        import gmpy2

        return [(gmpy2.mpq(x), gmpy2.mpq(y)) for x, y in self]

    def __repr__(self) -> str:
        return f"<Points: {len(self)} exact points>"


class Arrangement:
    """The subdivision of the plane that line work induces: vertices, edges, faces, exactly.

    Made by `plumbline.arrange`. Immutable; arrays are read-only views of the complex's memory.
    Everything is in canonical order: vertices by (x, y); edges by (tail, head), the tail being
    lexicographically first; face 0 is the unbounded one. Halfedge ``2 e`` runs along edge ``e``,
    ``2 e + 1`` against it; each has a face on its left.

    See Also
    --------
    plumbline.arrange
    """

    def __init__(self, core: _core.Complex, lines: Lines) -> None:
        self._core = core
        self.lines = lines

    # Vertices.

    @cached_property
    def vertices(self) -> NDArray[np.float64]:
        """Vertices, correctly rounded to nearest doubles, (V, 2). Two vertices may round to the
        same doubles, and edges cross: `rounded` has doubles that are proven to be free of that."""
        return self._core.coords()

    @property
    def points(self) -> Points:
        """Vertices, exactly."""
        return Points(self._core)

    # Edges.

    @cached_property
    def edges(self) -> NDArray[np.uint32]:
        """Edges as pairs of vertices, tail first, (E, 2)."""
        return self._core.edges()

    @cached_property
    def edge_segments(self) -> Lists:
        """Per edge the segments of `lines` that cover it, ascending."""
        return Lists(*self._core.edge_sources())

    @cached_property
    def sources(self) -> Lists:
        """Per edge the items of the input that cover it (rows, geometries, elements), ascending,
        each once."""
        return Lists(*self._core.edge_items(self.lines._core))

    @cached_property
    def antennas(self) -> NDArray[np.intp]:
        """Edges with the same face on both sides: dangling ones and bridges."""
        left = self.halfedge_face
        return np.flatnonzero(left[0::2] == left[1::2])

    # Faces.

    def __len__(self) -> int:
        """How many bounded faces there are."""
        return self.counts.faces - 1

    @cached_property
    def cycles(self) -> Lists:
        """Closed walks of halfedges, each with one face on its left: outer boundaries run
        counter-clockwise, holes clockwise."""
        return Lists(*self._core.cycles())

    @cached_property
    def face_outer(self) -> NDArray[np.uint32]:
        """Per face its outer boundary, a cycle; 2**32 - 1 of the unbounded face 0, which has
        none."""
        return self._core.face_outer()

    @cached_property
    def face_holes(self) -> Lists:
        """Per face its holes, as cycles."""
        return Lists(*self._core.face_holes())

    @cached_property
    def isolated_vertices(self) -> Lists:
        """Per face the vertices of no edge that lie in it."""
        return Lists(*self._core.face_isolated_vertices())

    @cached_property
    def halfedge_face(self) -> NDArray[np.uint32]:
        """Per halfedge the face on its left, (2 E,)."""
        return self._core.halfedge_face()

    @cached_property
    def depth(self) -> NDArray[np.uint32]:
        """Per face how deep it is nested: 0 for the unbounded one, its parent's + 1 else."""
        return self._core.face_depth()

    @cached_property
    def vertex_component(self) -> NDArray[np.uint32]:
        """Per vertex its connected component."""
        return self._core.vertex_component()

    @cached_property
    def component_parent(self) -> NDArray[np.uint32]:
        """Per connected component the face that it lies in."""
        return self._core.component_parent()

    @cached_property
    def area(self) -> NDArray[np.float64]:
        """Per face its area without holes, correctly rounded; 0 of the unbounded one."""
        return self._core.area_doubles()

    @cached_property
    def areas(self) -> list[Fraction]:
        """The same, exactly."""
        return self._core.face_areas()

    def interior_point(self, face: int) -> ExactPoint:
        """A point inside a bounded face, exactly."""
        return self._core.interior_point(self._bounded(face))

    def _bounded(self, face: int) -> int:
        if not 0 < face <= len(self):
            raise Error(f"bounded faces are 1 to {len(self)}: {face}")
        return face

    # In LAR's words.

    @property
    def V(self) -> NDArray[np.float64]:
        """LAR's name for `vertices`."""
        return self.vertices

    @property
    def EV(self) -> NDArray[np.uint32]:
        """LAR's name for `edges`."""
        return self.edges

    @cached_property
    def FV(self) -> Lists:
        """Per bounded face (the first is face 1) its vertices, ascending: LAR's FV."""
        return Lists(*self._core.face_vertices())

    @cached_property
    def FE(self) -> Lists:
        """Per bounded face its edges, ascending, those that end within it, too: LAR's FE."""
        return Lists(*self._core.face_edges())

    @cached_property
    def d1(self) -> scipy.sparse.csc_array:
        """The boundary operator from edges to vertices, V x E: -1 at the tail, +1 at the head."""
        return _csc(self._core.boundary_1())

    @cached_property
    def d2(self) -> scipy.sparse.csc_array:
        """The boundary operator from faces to edges, E x F; column 0 is the unbounded face.
        ``d1 @ d2`` is 0."""
        return _csc(self._core.boundary_2())

    # As a whole.

    @cached_property
    def counts(self) -> _core.Counts:
        """Numbers of cells."""
        return self._core.counts()

    @cached_property
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
        points : array (n, 2) of floats, or a sequence of exact points
            Of a point on an edge or a vertex, a face that has it on its boundary.
        """
        if isinstance(points, np.ndarray) and points.dtype != object:
            coords = np.ascontiguousarray(points.reshape(-1, 2), dtype=np.float64)
            if not np.isfinite(coords).all():
                raise Error("points have finite coordinates")
            return self._core.locate_points(coords)
        chosen = self.lines.numbers
        faces = [
            self._core.locate((exact_text(x, chosen), exact_text(y, chosen)))
            for x, y in points  # type: ignore[misc, union-attr]
        ]
        return np.array(faces, dtype=np.uint32)

    def __eq__(self, other: object) -> bool:
        """Whether they are the same subdivision; what covers the edges does not matter."""
        if not isinstance(other, Arrangement):
            return NotImplemented
        return self.signature == other.signature

    def __hash__(self) -> int:
        return hash(self.signature)

    def __reduce__(self) -> tuple[Any, ...]:
        return _arranged, (self.lines,)

    def __repr__(self) -> str:
        n = self.counts
        return (
            f"<Arrangement: {n.vertices} vertices, {n.edges} edges, {n.faces - 1} bounded faces; "
            f"floats as {self.lines.numbers}>"
        )


def _csc(parts: tuple[Any, Any, Any, Any]) -> scipy.sparse.csc_array:
    from scipy.sparse import csc_array

    data, indices, indptr, shape = parts
    return csc_array((data, indices, indptr), shape=shape)


def _arranged(of: Lines) -> Arrangement:
    return Arrangement(_core.arrange(of._core, False, 0, None), of)


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
        At most so many; by default as many as there are cores. Does not change the result.
    progress : bool or function, optional
        True for a bar of tqdm; a function is told which part is done, from 0 to 1. Ctrl-C ends
        the work in any case.

    Returns
    -------
    Arrangement

    Raises
    ------
    Error
        As `lines`; LimitError for coordinates beyond 8.7e99 and 2^31 crossings or more.

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
    of = lines(lines_like, numbers=numbers, points=points, ids=ids)
    with told(progress, "arranging") as callback:
        core = _core.arrange(of._core, exact_engine == "cgal", threads or 0, callback)
    return Arrangement(core, of)


def signature(x: Arrangement | LinesLike) -> str:
    """The signature of an arrangement, or of that of line work: see `Arrangement.signature`."""
    return x.signature if isinstance(x, Arrangement) else arrange(x).signature


def same(a: Arrangement | LinesLike, b: Arrangement | LinesLike) -> bool:
    """Whether two arrangements, or those of two pieces of line work, are the same subdivision of
    the plane, to the last digit.

    Examples
    --------
    >>> import plumbline
    >>> plumbline.same([(0, 0, 2, 0)], [(2, 0, 1, 0), (0, 0, 2, 0), (0, 0, 1, 0)])
    False
    >>> plumbline.same([(0, 0, 2, 0)], [(2, 0, 0, 0), (0, 0, 2, 0)])
    True
    """
    return signature(a) == signature(b)


def validate(x: Arrangement) -> list[_core.Violation]:
    """What is not true of an arrangement as a cellular complex and as a cover of its lines, by code
    that is independent of what made it: nothing, unless this library is broken."""
    return x._core.validate() + x._core.validate_coverage(x.lines._core)
