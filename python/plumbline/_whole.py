"""Whole numbers that users give."""

from __future__ import annotations

from typing import Any

from plumbline.errors import Error

_MOST_THREADS = 1 << 16
_MOST = (1 << 63) - 1


def whole(value: Any, what: str) -> int:
    """A whole number; those of NumPy are, too."""
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise Error(f"{what} is a whole number: {value!r:.60}")
    try:
        return int(value.__index__())
    except TypeError:
        raise Error(f"{what} is a whole number: {value!r:.60}") from None


def count(value: Any, what: str) -> int:
    """A number of things, or one that is larger than any that there are."""
    number = whole(value, what)
    if number < 0:
        raise Error(f"{what} is a number of things, 0 or more: {value!r:.60}")
    return min(number, _MOST)


def optional_count(value: int | None, what: str) -> int | None:
    """The same, None for None."""
    return None if value is None else count(value, what)


def threads_of(value: int | None) -> int:
    """How many threads the library is told: 0 for as many as there are cores."""
    return 0 if value is None else min(count(value, "threads"), _MOST_THREADS)


def decimals_of(value: int | None) -> int | None:
    """Decimals that coordinates are rounded to; None for doubles."""
    if value is None:
        return None
    number = whole(value, "decimals")
    if not 0 <= number <= 18:
        raise Error(f"decimals are 0 to 18: {value!r:.60}")
    return number
