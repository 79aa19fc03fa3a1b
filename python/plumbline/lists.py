"""Lists of lists of indices."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray


class Lists(Sequence[NDArray[np.uint32]]):
    """A list of lists of indices, stored flat, as the rows of a SciPy CSR matrix or an Arrow list.

    Attributes
    ----------
    indptr : ndarray of uint32, (n + 1,)
        Where each list starts in `indices`, and where the last one ends. Read-only.
    indices : ndarray of uint32
        All lists one after the other. Read-only.

    Examples
    --------
    >>> import plumbline
    >>> square = plumbline.arrange([(0, 0, 1, 0), (1, 0, 1, 1), (1, 1, 0, 1), (0, 1, 0, 0)])
    >>> square.cycles[0].tolist()
    [0, 4, 7, 3]
    >>> len(square.cycles)
    2
    """

    __slots__ = ("indices", "indptr")

    def __init__(self, indptr: NDArray[np.uint32], indices: NDArray[np.uint32]) -> None:
        self.indptr = indptr
        self.indices = indices

    def __len__(self) -> int:
        return len(self.indptr) - 1

    @overload
    def __getitem__(self, i: int) -> NDArray[np.uint32]: ...
    @overload
    def __getitem__(self, i: slice) -> list[NDArray[np.uint32]]: ...
    def __getitem__(self, i: int | slice) -> NDArray[np.uint32] | list[NDArray[np.uint32]]:
        if isinstance(i, slice):
            return [self[k] for k in range(*i.indices(len(self)))]
        if i < 0:
            i += len(self)
        if not 0 <= i < len(self):
            raise IndexError("there are fewer lists")
        return self.indices[self.indptr[i] : self.indptr[i + 1]]

    def __iter__(self) -> Iterator[NDArray[np.uint32]]:
        for i in range(len(self)):
            yield self[i]

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Lists):
            return NotImplemented
        return np.array_equal(self.indptr, other.indptr) and np.array_equal(
            self.indices, other.indices
        )

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        return Lists, (self.indptr, self.indices)

    def __repr__(self) -> str:
        return f"<Lists: {len(self)} lists of {len(self.indices)} indices>"

    @property
    def lengths(self) -> NDArray[np.intp]:
        """How long each list is."""
        starts = self.indptr.astype(np.intp)
        return starts[1:] - starts[:-1]

    def tolist(self) -> list[list[int]]:
        """The same as lists of ints."""
        return [part.tolist() for part in self]
