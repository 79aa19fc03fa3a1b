"""LAR models: exact vertices of any dimension, and arrays of cells over them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Union, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plumbline import _core
from plumbline._cached import cached
from plumbline._numbers import Number, Numbers
from plumbline.errors import Error
from plumbline.lists import Lists
from plumbline.maps import Map, exact_texts

if TYPE_CHECKING:
    import scipy.sparse

VerticesLike = Union[ArrayLike, Sequence[Sequence[Number]]]
CellsLike = Union[ArrayLike, Lists, Sequence[Sequence[int]]]
ModelLike = Union["LarModel", Sequence[Any]]
"""A `LarModel`, or a tuple or list (V, CV), (V, FV, EV), ... as LAR has it."""

_MOST_EXACT = 2**53  # integers up to here are doubles


class LarModel:
    """A LAR model, (V, CV), (V, FV, EV) or (V, CV, FV, EV): vertices, and arrays of cells given by
    their vertices, those of the highest dimension first.

    Immutable; arrays are read-only. It unpacks as LAR's tuples do: ``V, FV, EV = model``.

    Parameters
    ----------
    V : array (n, d) or sequence of points
        Of int, Fraction, Decimal, str ("1/3") or float.
    *cells : array (m, k) of integers, `Lists` or sequence of sequences
        Indices of vertices, from 0.
    numbers : {"decimals", "doubles"}
        Whether floats stand for the decimals that they print as, or for what they are.

    Raises
    ------
    Error
        For what is no number, or not finite, and for cells of vertices that are not there.

    Examples
    --------
    >>> import plumbline
    >>> square = plumbline.LarModel([(0, 0), (0, 1), ("1/3", 0), ("1/3", 1)], [[0, 1, 2, 3]])
    >>> square
    <LarModel: 4 vertices in 2 dimensions, cells: 1>
    >>> square.exact(2)
    (Fraction(1, 3), Fraction(0, 1))
    >>> V, CV = square
    >>> CV.tolist()
    [[0, 1, 2, 3]]
    """

    def __init__(self, V: VerticesLike, *cells: CellsLike, numbers: Numbers = "decimals") -> None:
        self._core = _core_model(V, [starts_and_indices(array) for array in cells], numbers)

    @classmethod
    def _of(cls, core: _core.LarModel) -> LarModel:
        result = object.__new__(cls)
        result._core = core
        return result

    @property
    def dimension(self) -> int:
        """Of the space, not of the cells."""
        return self._core.dimension

    @cached
    def V(self) -> NDArray[np.float64]:
        """Vertices, correctly rounded to nearest doubles, (n, d)."""
        return self._core.coords()

    @property
    def verts(self) -> NDArray[np.float64]:
        """larlib's name for them."""
        return self.V

    def exact(self, v: int) -> tuple[Fraction, ...]:
        """The coordinates of a vertex, exactly."""
        return tuple(self._core.point(range(self._core.vertex_count)[v]))

    @property
    def points(self) -> list[tuple[Fraction, ...]]:
        """All vertices, exactly."""
        return [self.exact(v) for v in range(self._core.vertex_count)]

    @cached
    def cells(self) -> tuple[Lists, ...]:
        """The arrays of cells, those of the highest dimension first."""
        return tuple(Lists(*self._core.cells(k)) for k in range(self._core.array_count))

    def __len__(self) -> int:
        """As of LAR's tuple: 2 of (V, CV), 3 of (V, FV, EV)."""
        return 1 + self._core.array_count

    def __getitem__(self, i: int) -> NDArray[np.float64] | Lists:
        parts: list[NDArray[np.float64] | Lists] = [self.V, *self.cells]
        return parts[i]

    def __iter__(self) -> Iterator[Any]:
        yield self.V
        yield from self.cells

    def mapped(self, map: Map) -> LarModel:
        """The model under a map, exactly: larlib's larApply."""
        return LarModel._of(self._core.mapped(map._core))

    def embed(self, k: int) -> LarModel:
        """With k coordinates 0 more per vertex; for k < 0 without its last -k coordinates."""
        return LarModel._of(self._core.embedded(k))

    def boundary_operator(self, k: int = 0) -> scipy.sparse.csc_array:
        """The boundary operator mod 2 from `cells[k]` to `cells[k + 1]`, facets x cells: 1 where
        the facet's vertices are all among the cell's, which is right where cells are convex."""
        from scipy.sparse import csc_array

        data, indices, indptr, shape = self._core.boundary(k)
        return csc_array((data, indices, indptr), shape=shape)

    def boundary_cells(self, k: int = 0) -> NDArray[np.uint32]:
        """The facets, in `cells[k + 1]`, that an odd number of cells of `cells[k]` hold: the
        boundary of the chain of all cells. Ascending."""
        return self._core.boundary_cells(k)

    def boundary(self) -> LarModel:
        """The boundary of the chain of all cells: of a model of the plane the sides that an odd
        number of its polygons have, of others the facets that an odd number of cells hold.

        Raises
        ------
        Error
            For a cell of the plane that cannot be drawn, and for other cells without facets.
        """
        return LarModel._of(self._core.boundary_of_all())

    def to_json(self) -> str:
        """As text that `plumbline.read` takes as a .json file: exact."""
        return self._core.to_json()

    def __eq__(self, other: object) -> bool:
        """Whether vertices, exactly, and cells are the same, in the same order."""
        if not isinstance(other, LarModel):
            return NotImplemented
        same_size = self._core.vertex_count == other._core.vertex_count
        return same_size and self.cells == other.cells and self.points == other.points

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        cells = [(array.indptr, array.indices) for array in self.cells]
        texts = [str(x) for point in self.points for x in point]
        return _remade, (self.dimension, texts, cells)

    def __repr__(self) -> str:
        counts = ", ".join(str(len(array)) for array in self.cells) or "none"
        return (
            f"<LarModel: {self._core.vertex_count} vertices in {self.dimension} dimensions, "
            f"cells: {counts}>"
        )


def _remade(dimension: int, texts: list[str], cells: list[tuple[Any, Any]]) -> LarModel:
    return LarModel._of(_core.LarModel.of_texts(dimension, texts, cells))


def as_model(model: ModelLike, numbers: Numbers = "decimals") -> LarModel:
    """A model of LAR's tuple.

    Raises
    ------
    Error
        For what is neither.
    """
    if isinstance(model, LarModel):
        return model
    if isinstance(model, (tuple, list)) and len(model) >= 2:
        return LarModel(model[0], *model[1:], numbers=numbers)
    raise Error(f"a model is (V, CV), (V, FV, EV), ...: {model!r:.60}")


def _core_model(
    V: VerticesLike, cells: list[tuple[NDArray[np.uint32], NDArray[np.uint32]]], numbers: Numbers
) -> _core.LarModel:
    exact_texts([], numbers)
    if isinstance(V, np.ndarray) and V.dtype.kind in "iuf":
        if V.ndim != 2 or V.shape[1] == 0:
            raise Error(f"vertices are an array (n, d): {V.shape}")
        fits = V.dtype.kind == "f" or not V.size or np.abs(V).max() <= _MOST_EXACT
        if fits and V.dtype.itemsize <= 8:
            coords = np.ascontiguousarray(V, dtype=np.float64)
            return _core.LarModel.of_doubles(coords, numbers == "decimals", cells)
    try:
        rows = [tuple(point) for point in cast(Iterable[Iterable[Number]], V)]
    except TypeError:
        raise Error(f"vertices are a sequence of points: {V!r:.60}") from None
    dimension = len(rows[0]) if rows else 2
    for row in rows:
        if len(row) != dimension or not row:
            raise Error(f"vertices have {dimension} coordinates each: {row!r:.60}")
    texts = exact_texts((x for row in rows for x in row), numbers)
    return _core.LarModel.of_texts(dimension, texts, cells)


def starts_and_indices(cells: CellsLike) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
    """Cells as the rows of a CSR matrix."""
    if isinstance(cells, Lists):
        return (
            np.ascontiguousarray(cells.indptr, dtype=np.uint32),
            np.ascontiguousarray(cells.indices, dtype=np.uint32),
        )
    if isinstance(cells, np.ndarray) and cells.dtype != object:
        if cells.ndim != 2:
            raise Error(f"cells are an array (m, k) or a sequence of sequences: {cells.shape}")
        starts = np.arange(len(cells) + 1) * cells.shape[1]
        flat = cells.ravel()
    else:
        try:
            rows = [list(cell) for cell in cast(Iterable[Iterable[int]], cells)]
        except TypeError:
            raise Error(f"cells are a sequence of sequences: {cells!r:.60}") from None
        starts = np.cumsum([0, *map(len, rows)])
        flat = np.array([v for row in rows for v in row])
        if not flat.size:
            flat = flat.astype(np.uint32)
    if flat.dtype.kind not in "iu":
        raise Error(f"cells hold indices of vertices: {flat[:5].tolist()}")
    if flat.size and (flat.min() < 0 or flat.max() >= 2**32 - 1):
        raise Error(f"an index of a vertex that cannot be: {min(flat.min(), flat.max())}")
    return starts.astype(np.uint32), np.ascontiguousarray(flat, dtype=np.uint32)
