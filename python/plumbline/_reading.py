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
    """A file as it was read: its name, its bytes, and how it was read."""

    path: str
    content: bytes
    options: _core.ReadOptions

    @classmethod
    def of_file(cls, path: str | os.PathLike[str], options: _core.ReadOptions) -> Reading | None:
        """Of a file; None for a pipe, which can be read once."""
        if not os.path.isfile(path):
            return None
        try:
            return cls(os.fspath(path), Path(path).read_bytes(), options)
        except OSError:
            return None

    def state(self, structure: _core.Structure) -> tuple[Any, ...] | None:
        """What `structure_read` makes the structure of again; None where it would be another."""
        format = self.options.format or os.path.splitext(self.path)[1].lower().lstrip(".")
        for known in ("json", "geojson", "struct") if format == "json" else (format,):
            try:
                if self.again(known) == structure:
                    options = [getattr(self.options, name) for name in _OPTIONS]
                    return self.path, self.content, options, known
            except (Error, UnicodeDecodeError, OSError, EOFError):
                continue
        return None

    def again(self, format: str) -> _core.Structure:
        """The structure, read again of the bytes in this format."""
        if format == "wkb":
            return _core.read_wkb(self.content, self.path, self.options)
        content = gzip.decompress(self.content) if format == "svgz" else self.content
        text = content.decode()
        if format == "struct":
            return _core.Structure.of_json(text, self.path)
        name = "svg" if format == "svgz" else format
        return _core.read_text(name, text, self.path, self.options)


def structure_read(
    path: str, content: bytes, values: list[Any], format: str
) -> tuple[_core.Structure, Reading]:
    """Of the state of a reading: the structure, and the reading."""
    options = _core.ReadOptions()
    for name, value in zip(_OPTIONS, values):
        setattr(options, name, str(value) if isinstance(value, Fraction) else value)
    reading = Reading(path, content, options)
    return reading.again(format), reading
