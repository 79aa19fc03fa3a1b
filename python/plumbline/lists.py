"""Lists of lists of indices."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray


def _read_only(array: NDArray[np.uint32]) -> NDArray[np.uint32]:
    if not array.flags.writeable:
        return array
    view = array.view()
    view.flags.writeable = False
    return view


class Lists(Sequence[NDArray[np.uint32]]):
    """A list of lists of indices, stored flat, as the rows of a SciPy CSR matrix or an Arrow list.

    Examples
    --------
    >>> import plumbline
    >>> square = plumbline.arrange([(0, 0, 1, 0), (1, 0, 1, 1), (1, 1, 0, 1), (0, 1, 0, 0)])
    >>> square.cycles[0].tolist()
    [0, 4, 7, 3]
    >>> len(square.cycles)
    2
    """

    __slots__ = ("_indices", "_indptr")

    def __init__(self, indptr: NDArray[np.uint32], indices: NDArray[np.uint32]) -> None:
        self._indptr = _read_only(indptr)
        self._indices = _read_only(indices)

    @property
    def indptr(self) -> NDArray[np.uint32]:
        """Where each list starts in `indices`, and where the last one ends. (n + 1,), read-only."""
        return self._indptr

    @property
    def indices(self) -> NDArray[np.uint32]:
        """All lists one after the other. Read-only."""
        return self._indices

    def __len__(self) -> int:
        return len(self.indptr) - 1

    @overload
    def __getitem__(self, i: int) -> NDArray[np.uint32]: ...
    @overload
    def __getitem__(self, i: slice) -> list[NDArray[np.uint32]]: ...
    def __getitem__(self, i: int | slice) -> NDArray[np.uint32] | list[NDArray[np.uint32]]:
        if isinstance(i, slice):
            return [self[k] for k in range(*i.indices(len(self)))]
        k = int(i.__index__())
        if k < 0:
            k += len(self)
        if not 0 <= k < len(self):
            raise IndexError("there are fewer lists")
        return self.indices[self.indptr[k] : self.indptr[k + 1]]

    def __iter__(self) -> Iterator[NDArray[np.uint32]]:
        for i in range(len(self)):
            yield self[i]

    def __contains__(self, value: object) -> bool:
        """Whether one of them is this list."""
        return self.count(value) > 0

    def count(self, value: Any) -> int:
        """How many of them are this list."""
        return len(self._positions(value))

    def index(self, value: Any, start: int = 0, stop: int | None = None) -> int:
        """The position of the first that is this list.

        Raises
        ------
        ValueError
            Where there is none.
        """
        among = range(len(self))[start:stop]
        for i in self._positions(value):
            if i in among:
                return i
        raise ValueError(f"no such list: {value!r:.60}")

    def _positions(self, value: Any) -> list[int]:
        try:
            wanted = np.asarray(value)
        except ValueError:
            return []
        if wanted.ndim != 1:
            return []
        there = np.flatnonzero(self.lengths == len(wanted)).tolist()
        return [i for i in there if np.array_equal(self[i], wanted)]

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
