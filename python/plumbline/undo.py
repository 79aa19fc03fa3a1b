"""Repairs undone."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from plumbline import _core
from plumbline._json import dumped
from plumbline.errors import Error
from plumbline.line_inputs import ensure_utf8, lines
from plumbline.lines import Lines, LinesLike

if TYPE_CHECKING:
    pass
from plumbline._drawing_files import (
    _drawing_text,
    _ensure_none,
    _write,
)
from plumbline.repair import Repair


class Undone(Lines):
    """The drawing that was repaired, made of the repaired one by `plumbline.undo`."""

    def __init__(self, core: _core.SegmentSet, repaired: Lines) -> None:
        super().__init__(core, repaired.numbers)
        self._repaired = repaired

    def write(self, path: str | os.PathLike[str], *, format: str | None = None) -> None:
        """Writes the drawing, as `Repair.write` does, into the file of the repaired one."""
        _write(self, path, format)

    @property
    def _patched(self) -> Lines:
        """The drawing whose file is written with changes."""
        return self._repaired

    def _written(self, format: str, **options: Any) -> str | bytes:
        _ensure_none(options)
        return _drawing_text(format, self._patched, self)

    def __getstate__(self) -> tuple[Any, ...]:
        return (*super().__getstate__(), self._repaired)

    def __setstate__(self, state: tuple[Any, ...]) -> None:
        core, numbers, self._repaired = state
        super().__setstate__((core, numbers))


def undo(output: LinesLike, log: Repair | str | os.PathLike[str] | Mapping[str, Any], /) -> Undone:
    """The drawing that was repaired, of the repaired one.

    Parameters
    ----------
    output : whatever `lines` takes
        The repaired drawing, in any format: its segments are known by the nearest doubles of their
        ends.
    log : Repair, path, text or mapping
        The repair; or what `Repair.to_json` says: a file, the text itself, or what the json module
        makes of it.

    Returns
    -------
    Undone
        Lines with the sources that the input had. Its method ``write`` puts them into the file
        that `output` was read from.

    Raises
    ------
    Error
        Where this is not the drawing that the repair made, where the log does not lead back, and
        for what is no log, with its place.

    Examples
    --------
    >>> import plumbline
    >>> fixed = plumbline.repair([(0, 0, 3, 0), (1, 1, 1, "0.01")], grow="0.1")
    >>> list(plumbline.undo(fixed.output, fixed.to_json())) == list(fixed.input)
    True
    """
    repaired = lines(output)
    return Undone(_core.undo(repaired._core, _log_of(log)), repaired)


def _log_of(log: Repair | str | os.PathLike[str] | Mapping[str, Any]) -> _core.RepairLog:
    if isinstance(log, Repair):
        return _core.repair_log(log.input._core, log._core)
    if isinstance(log, Mapping):
        return _log_of_text(dumped(log))
    if isinstance(log, str) and log.lstrip().startswith("{") and not os.path.exists(log):
        return _log_of_text(ensure_utf8(log))
    if not isinstance(log, (str, os.PathLike)):
        raise Error(f"a log is a Repair, a path, a text or a mapping: {type(log).__name__}")
    return _core.read_repair_log(os.fspath(log))


def _log_of_text(text: str) -> _core.RepairLog:
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "log.json")
        with open(file, "w", encoding="utf-8") as stream:
            stream.write(text)
        try:
            return _core.read_repair_log(file)
        except Error as error:
            message = str(error).replace(file, "<log>")
            raise Error(message, "<log>", error.line, error.column, error.text) from None
