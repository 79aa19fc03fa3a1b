"""Arguments that several functions take."""

from __future__ import annotations

from typing import Any

from plumbline import _core
from plumbline._numbers import Numbers
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


def ensure_none(options: dict[str, Any]) -> None:
    """Of options for writing, where there are none to choose."""
    if options:
        raise Error(f"this is written without options: {', '.join(options)}")


def written_table(table: _core.Table, format: str, what: str) -> str:
    """The rows of a result in a format of features."""
    formats = ("geojson", "topojson", "dxf", "wkt", "csv", "wkb")
    if format not in formats:
        raise Error(f"{what} is written as json, pictures or {', '.join(formats)}: {format!r}")
    return table.written(format)


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
