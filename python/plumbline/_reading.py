"""What a drawing was read from: as much as makes it again."""

from __future__ import annotations

import gzip
import os
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Any

from plumbline import _core
from plumbline.errors import Error

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
    """A file as it was read: its name, and how it was read; of what was pickled its bytes."""

    path: str
    options: _core.ReadOptions
    content: bytes | None = None

    @classmethod
    def of_file(cls, path: str | os.PathLike[str], options: _core.ReadOptions) -> Reading | None:
        """Of a file; None for a pipe, which can be read once."""
        return cls(os.fspath(path), options) if os.path.isfile(path) else None

    def _bytes(self) -> bytes:
        return Path(self.path).read_bytes() if self.content is None else self.content

    def state(self, structure: _core.Structure) -> tuple[Any, ...] | None:
        """What `structure_read` makes the structure of again; None where it would be another, as
        where the file is no longer what it was."""
        format = self.options.format or os.path.splitext(self.path)[1].lower().lstrip(".")
        try:
            content = self._bytes()
        except OSError:
            return None
        for known in ("json", "geojson", "struct") if format == "json" else (format,):
            try:
                if self.again(known, content) == structure:
                    options = [getattr(self.options, name) for name in _OPTIONS]
                    return self.path, content, options, known
            except (Error, UnicodeDecodeError, OSError, EOFError):
                continue
        return None

    def again(self, format: str, content: bytes) -> _core.Structure:
        """The structure, read again of the bytes in this format."""
        if format == "wkb":
            return _core.read_wkb(content, self.path, self.options)
        if format == "struct":
            return _core.Structure.of_json(content.decode(), self.path)
        if format == "svgz":
            return _core.read_text("svg", gzip.decompress(content), self.path, self.options)
        return _core.read_text(format, content, self.path, self.options)


def structure_read(
    path: str, content: bytes, values: list[Any], format: str
) -> tuple[_core.Structure, Reading]:
    """Of the state of a reading: the structure, and the reading."""
    options = _core.ReadOptions()
    for name, value in zip(_OPTIONS, values):
        setattr(options, name, str(value) if isinstance(value, Fraction) else value)
    reading = Reading(path, options, content)
    return reading.again(format, content), reading
