"""Exact planar arrangements, and results held against them.

Line work goes in as files, arrays, geometries or exact numbers; it comes out as what it cuts the
plane into, exactly. ``plumbline.arrange(anything)`` is where to begin.
"""

from plumbline import lar
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
from plumbline.lar import random_lines
from plumbline.lines import Lines, lines
from plumbline.lists import Lists
from plumbline.maps import Map, r, s, t
from plumbline.models import LarModel
from plumbline.repair import Repair, Undone, compare_rules, repair, undo
from plumbline.rooms import Rooms, rooms
from plumbline.structure import Struct, Structure, box, evaluate

__all__ = [
    "Arrangement",
    "Drawing",
    "Error",
    "FileError",
    "InternalError",
    "LarModel",
    "LimitError",
    "Lines",
    "Lists",
    "LossWarning",
    "Map",
    "Points",
    "Repair",
    "Rooms",
    "Struct",
    "Structure",
    "Undone",
    "__version__",
    "arrange",
    "box",
    "compare_rules",
    "evaluate",
    "lar",
    "lines",
    "r",
    "random_lines",
    "read",
    "repair",
    "rooms",
    "s",
    "same",
    "signature",
    "t",
    "undo",
    "validate",
]
