"""Drawings that were made of other ones, written into their files."""

from __future__ import annotations

import os
from collections.abc import Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from plumbline import _core
from plumbline._warnings import warn_of_loss
from plumbline.errors import Error
from plumbline.lines import Lines
from plumbline.write import refuse_to_overwrite

if TYPE_CHECKING:
    from plumbline.repair import Repair
    from plumbline.undo import Undone


_FEATURE_FORMATS = ("geojson", "topojson", "dxf", "wkt", "csv", "wkb")


_FORMATS = ("lines", *_FEATURE_FORMATS, "svg")


def _is_decimal(value: Fraction) -> bool:
    rest = value.denominator
    for factor in (2, 5):
        while rest % factor == 0:
            rest //= factor
    return rest == 1


def _ensure_none(options: Mapping[str, Any]) -> None:
    if options:
        raise Error(f"a drawing is written without these options: {', '.join(options)}")


def _drawing_text(format: str, source: Lines, output: Lines) -> str | bytes:
    """A drawing made of another one: in the file that this was read from, as far as that goes."""
    read_from = getattr(source, "_read_from", None)
    if format in ("dxf", "svg") and read_from is not None:
        patched = _core.patched_file(*_file_first(read_from, format), source._core, output._core)
        if not patched.why_not:
            return patched.text
        warn_of_loss(f"lines alone are written, of all elements: {patched.why_not}")
    if format == "lines":
        return _core.exact_lines(output._core)
    if format == "svg":
        return _core.picture_of_lines(output._core)
    if format in _FEATURE_FORMATS:
        return _core.line_table(output._core).written(format)
    raise Error(f"a drawing is written as {', '.join(_FORMATS)}: {format!r}")


def _file_first(
    read_from: tuple[str, _core.ReadOptions], format: str
) -> tuple[str, str, _core.ReadOptions]:
    return read_from[0], format, read_from[1]


def _write(
    what: Repair | Undone,
    path: str | os.PathLike[str],
    format: str | None,
    **options: Any,
) -> None:
    file = os.fspath(path)
    refuse_to_overwrite(what, file)
    if not isinstance(format, str) and format is not None:
        raise Error(f"a format is a name: {format!r}")
    chosen = format or os.path.splitext(file)[1].lstrip(".").lower()
    text = what._written(chosen, **options)
    _core.write_file(file, text.encode() if isinstance(text, str) else text)
