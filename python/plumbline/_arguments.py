"""Arguments that several functions take."""

from __future__ import annotations

from typing import Any

from plumbline import _core
from plumbline._numbers import Numbers
from plumbline._progress import Progress
from plumbline._whole import count, threads_of
from plumbline.arrangement import Arrangement, arrange
from plumbline.errors import Error
from plumbline.lines import LinesLike

__all__ = ["arrangement_of", "count", "ensure_none", "threads_of", "written_table"]


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
