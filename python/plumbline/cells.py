"""The cells of a subdivision of the plane, as arrays and as exact numbers."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plumbline import _core
from plumbline._cached import cached
from plumbline._numbers import ensure_unmasked, in_doubles
from plumbline._whole import whole
from plumbline.errors import Error
from plumbline.line_inputs import are_beyond_doubles, point_texts
from plumbline.lines import ExactPoint, Lines
from plumbline.lists import Lists
from plumbline.points import Points

if TYPE_CHECKING:
    import scipy.sparse


class Cells:
    """The cells of a subdivision of the plane: what `Arrangement` says of vertices, edges and
    faces."""

    def __init__(self, core: _core.Complex, lines: Lines) -> None:
        self._core = core
        self.lines = lines

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
