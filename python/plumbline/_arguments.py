"""Arguments that several functions take."""

from __future__ import annotations

import math
from typing import Any

from plumbline import _core
from plumbline._numbers import Number, Numbers, exact_text
from plumbline._progress import Progress
from plumbline.arrangement import Arrangement, arrange
from plumbline.errors import Error
from plumbline.lines import LinesLike


def arrangement_of(
    drawing: Arrangement | LinesLike,
    *,
    numbers: Numbers | None = None,
    threads: int | None = None,
    progress: Progress = None,
) -> Arrangement:
    """The arrangement of a drawing, which may be one already."""
    if not isinstance(drawing, Arrangement):
        return arrange(drawing, numbers=numbers, threads=threads, progress=progress)
    if numbers not in (None, drawing.lines.numbers):
        raise Error("this is an arrangement already: make it with these numbers instead")
    return drawing


def number_text(value: Number, what: str) -> str:
    """The exact text of a number, known to be one."""
    try:
        text = exact_text(value)
        _core.nearest_double(text)
    except ValueError as error:
        raise Error(f"{what} is a number: {value!r} ({error})") from None
    return text


def size_text(value: Number, what: str) -> str:
    """The exact text of a number that is not negative."""
    text = number_text(value, what)
    if _core.nearest_double(text) < 0:
        raise Error(f"{what} is not negative: {value!r}")
    return text


def optional_size(value: Number | None, what: str) -> float | None:
    """The nearest double of a number that is not negative; None for None."""
    return None if value is None else size(value, what)


def size(value: Number, what: str) -> float:
    """The nearest double of a number that is not negative."""
    nearest = _core.nearest_double(size_text(value, what))
    if not math.isfinite(nearest):
        raise Error(f"{what} is too large: {value!r}")
    return nearest


def count(value: Any, what: str) -> int:
    """A number of things."""
    if isinstance(value, bool) or not hasattr(value, "__index__") or value.__index__() < 0:
        raise Error(f"{what} is a number of things: {value!r}")
    return int(value.__index__())


def threads_of(value: int | None) -> int:
    """How many threads the library is told: 0 for as many as there are cores."""
    if value is None:
        return 0
    if count(value, "threads") == 0:
        raise Error(f"threads are at least 1, or None for as many as there are cores: {value!r}")
    return value
