"""Exact planar arrangements, and results held against them.

Line work goes in as files, arrays, geometries or exact numbers; it comes out as what it cuts the
plane into, exactly. ``plumbline.arrange(anything)`` is where to begin.
"""

from plumbline._core import __version__
from plumbline.arrangement import (
    Arrangement,
    Points,
    arrange,
    same,
    signature,
    validate,
)
from plumbline.drawing import Drawing, read
from plumbline.errors import Error, FileError, InternalError, LimitError, LossWarning
from plumbline.lines import Lines, lines
from plumbline.lists import Lists
from plumbline.repair import Repair, Undone, compare_rules, repair, undo
from plumbline.rooms import Rooms, rooms

__all__ = [
    "Arrangement",
    "Drawing",
    "Error",
    "FileError",
    "InternalError",
    "LimitError",
    "Lines",
    "Lists",
    "LossWarning",
    "Points",
    "Repair",
    "Rooms",
    "Undone",
    "__version__",
    "arrange",
    "compare_rules",
    "lines",
    "read",
    "repair",
    "rooms",
    "same",
    "signature",
    "undo",
    "validate",
]
