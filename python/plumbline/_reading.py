"""What a drawing was read from: as much as makes it again."""

from __future__ import annotations

import gzip
import os
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from plumbline import _core

_OPTIONS = (
    "format",
    "chord_tolerance",
    "hidden",
    "layers",
    "without_layers",
    "hatches",
    "layer_property",
    "join_curves",
    "shortest_decimals",
)


@dataclass(frozen=True)
class Reading:
    """A file as it was read: its name, its bytes, and how it was read."""

    path: str
    content: bytes
    options: _core.ReadOptions

    @classmethod
    def of_file(cls, path: str | os.PathLike[str], options: _core.ReadOptions) -> Reading:
        return cls(os.fspath(path), Path(path).read_bytes(), options)

    def again(self) -> _core.Structure | None:
        """The structure, read again of the bytes; None where they are no text."""
        format = self.options.format or os.path.splitext(self.path)[1].lower().lstrip(".")
        content = self.content
        if format == "wkb":
            return _core.read_wkb(content, self.path, self.options)
        try:
            if format == "svgz":
                format, content = "svg", gzip.decompress(content)
            return _core.read_text(format, content.decode(), self.path, self.options)
        except (UnicodeDecodeError, OSError, EOFError):
            return None

    def __reduce__(self) -> tuple[Any, ...]:
        options = [getattr(self.options, name) for name in _OPTIONS]
        return _reading, (self.path, self.content, options)


def _reading(path: str, content: bytes, values: list[Any]) -> Reading:
    options = _core.ReadOptions()
    for name, value in zip(_OPTIONS, values):
        setattr(options, name, str(value) if isinstance(value, Fraction) else value)
    return Reading(path, content, options)
