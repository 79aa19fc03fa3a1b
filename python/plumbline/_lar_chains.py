"""LAR's boundary operators, and Julia's conventions: part of `plumbline.lar`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plumbline import _core
from plumbline._lar_structures import evalStruct
from plumbline._numbers import Numbers
from plumbline.arrangement import arrange as exact_arrangement
from plumbline.errors import Error
from plumbline.lines import LinesLike
from plumbline.lists import Lists
from plumbline.models import CellsLike, LarModel, ModelLike, as_model, starts_and_indices
from plumbline.structure import Struct, StructLike

if TYPE_CHECKING:
    import scipy.sparse
from plumbline._lar_runs import Floats


def larBoundary(cells: CellsLike, facets: CellsLike) -> scipy.sparse.csc_array:
    """The boundary operator mod 2 of cells given by their vertices, facets x cells.

    A facet bounds a cell where all its vertices are the cell's: right where cells are convex. Of
    an arrangement `d2`, `FE` and `planar_arrangement` are right always.

    Notes
    -----
    Source: larBoundary of larlib's module boundary.

    Examples
    --------
    >>> from plumbline.lar import larBoundary
    >>> larBoundary([[0, 1, 2]], [[0, 1], [1, 2], [0, 2], [2, 3]]).toarray().T.tolist()
    [[1, 1, 1, 0]]
    """
    return _incidences(cells, facets).boundary_operator()


def boundaryCells(cells: CellsLike, facets: CellsLike) -> list[int]:
    """The facets that an odd number of cells hold, as `larBoundary` has it: the boundary of all.
    Source: boundaryCells of larlib's module boundary."""
    found: list[int] = _incidences(cells, facets).boundary_cells().tolist()
    return found


def coboundary_0(EV: CellsLike) -> scipy.sparse.csr_array:
    """The coboundary operator from vertices to edges, E x V: -1 at an edge's first vertex, +1 at
    its second one. Source: coboundary_0 of LinearAlgebraicRepresentation.jl."""
    from scipy.sparse import csr_array

    starts, indices = starts_and_indices(EV)
    if (np.diff(starts) != 2).any():
        raise Error("edges are pairs of vertices")
    signs = np.tile(np.array([-1, 1], dtype=np.int8), len(starts) - 1)
    columns = int(indices.max()) + 1 if len(indices) else 0
    return csr_array((signs, indices, starts), shape=(len(starts) - 1, columns))


def coboundary_1(FV: CellsLike, EV: CellsLike) -> scipy.sparse.csr_array:
    """The coboundary operator from edges to faces, F x E, unsigned: the transpose of `larBoundary`,
    with its rule. Source: u_coboundary_1 of LinearAlgebraicRepresentation.jl; signed, and right for
    faces of any shape, is copFE of `planar_arrangement`."""
    return larBoundary(FV, EV).transpose().tocsr()


def planar_arrangement(
    lines_like: LinesLike, *, numbers: Numbers | None = None
) -> tuple[Floats, scipy.sparse.csr_array, scipy.sparse.csr_array]:
    """The exact arrangement as LinearAlgebraicRepresentation.jl has it: V and the signed coboundary
    operators.

    Returns
    -------
    V : ndarray (n, 2)
        A point a row; `to_julia` has a point a column.
    copEV : csr_array, E x V
        -1 at an edge's tail, +1 at its head.
    copFE : csr_array, F x E
        Bounded faces, counter-clockwise: +1 where the edge runs along. ``copFE @ copEV`` is 0. An
        edge with the face on both sides has no entry.

    Notes
    -----
    There dangling edges and bridges are dropped, and vertices within 1e-8 are one; here nothing is.
    """
    a = exact_arrangement(lines_like, numbers=numbers)
    return a.V, a.d1.T.tocsr(), a.d2[:, 1:].T.tocsr()


def bool2d(
    assembly: StructLike,
) -> tuple[Floats, scipy.sparse.csr_array, scipy.sparse.csr_array, NDArray[np.bool_]]:
    """The atoms of plane models: faces that they cut the plane into, and which models hold each.

    Any set operation is one of columns: ``m[:, 0] & ~m[:, 1]`` are the faces of the first without
    the second model, whose boundary is ``copFE.T @ chain``.

    Parameters
    ----------
    assembly : Struct, Structure or model
        Each of its models, as `evalStruct` has them, is a region: what an odd number of its cells
        covers. Models of cells, so inner edges part nothing.

    Returns
    -------
    W, copEV, copFE
        As `planar_arrangement` of the boundaries of all models has them.
    boolmatrix : ndarray of bool, (F, models)
        Whether the face lies in the model. Exact: told from face to face over edges, not by points
        within faces and rays, as there.

    Raises
    ------
    Error
        For models that are not plane, have no cells, or whose boundary has edges without length.

    Notes
    -----
    Source: bool2d of LinearAlgebraicRepresentation.jl. There models must have no inner edges,
    and points within faces are 1e-4 of a normal away from an edge.

    Examples
    --------
    >>> from plumbline.lar import Struct, bool2d, t
    >>> square = ([(0, 0), (2, 0), (0, 2), (2, 2)], [[0, 1, 2, 3]])
    >>> W, copEV, copFE, m = bool2d(Struct([square, t(1, 1), square]))
    >>> m.astype(int).tolist()
    [[1, 0], [1, 1], [0, 1]]
    """
    boundaries = [model.boundary() for model in evalStruct(assembly)]
    if not boundaries:
        raise Error("an assembly without models has no faces")
    starts = np.cumsum([0, *(len(boundary.cells[-1]) for boundary in boundaries)])
    a = exact_arrangement(Struct(boundaries).structure.evaluate())
    if len(a.lines) != starts[-1]:
        raise Error("edges of a model's boundary have no length")
    begin, region = _core.regions_of_faces(a.lines._core, a._core, starts.tolist())
    matrix = np.zeros((len(begin) - 1, len(boundaries)), dtype=bool)
    matrix[np.repeat(np.arange(len(begin) - 1), np.diff(begin)), region] = True
    return a.V, a.d1.T.tocsr(), a.d2[:, 1:].T.tocsr(), matrix[1:]


def to_julia(model: ModelLike) -> tuple[Any, ...]:
    """A model as LinearAlgebraicRepresentation.jl has it: V with a point a column, (d, n), and
    cells as lists of vertices counted from 1.

    Examples
    --------
    >>> from plumbline.lar import to_julia
    >>> V, EV = to_julia(([(0, 0), (1, 0), (1, 1)], [[0, 1], [1, 2]]))
    >>> V.shape, EV
    ((2, 3), [[1, 2], [2, 3]])
    """
    V, *cells = as_model(model)
    return (V.T, *([[v + 1 for v in cell] for cell in array.tolist()] for array in cells))


def from_julia(
    V: ArrayLike, *cells: Sequence[Sequence[int]], numbers: Numbers = "decimals"
) -> LarModel:
    """The model of what LinearAlgebraicRepresentation.jl has: points as columns, vertices counted
    from 1.

    Examples
    --------
    >>> from plumbline.lar import from_julia
    >>> from_julia([[0, 1, 1], [0, 0, 1]], [[1, 2], [2, 3]]).cells[0].tolist()
    [[0, 1], [1, 2]]
    """
    points = list(zip(*np.asarray(V, dtype=object).tolist(), strict=True))
    from_0 = [[[int(v) - 1 for v in cell] for cell in array] for array in cells]
    return LarModel(points, *from_0, numbers=numbers)


def _incidences(cells: CellsLike, facets: CellsLike) -> LarModel:
    """A model of these cells whose vertices have no places of their own."""
    arrays = [starts_and_indices(cells), starts_and_indices(facets)]
    count = max((int(indices.max()) + 1 for _, indices in arrays if len(indices)), default=0)
    return LarModel(np.zeros((count, 1)), *(Lists(*array) for array in arrays))
