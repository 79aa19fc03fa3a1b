"""Exact coordinates, made when asked for."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

from plumbline import _core
from plumbline.lines import ExactPoint


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
