"""Exact planar arrangements, and results held against them.

Line work goes in as files, arrays, geometries or exact numbers; it comes out as what it cuts the
plane into, exactly. ``plumbline.arrange(anything)`` is where to begin.
"""

from plumbline import lar
from plumbline._core import __version__
from plumbline.arrangement import Arrangement, arrange, same, signature, validate
from plumbline.drawing import Drawing, read
from plumbline.errors import Error, FileError, InternalError, LimitError, LossWarning
from plumbline.lar import random_lines
from plumbline.lines import Lines, lines
from plumbline.lists import Lists
from plumbline.maps import Map, r, s, t
from plumbline.models import LarModel
from plumbline.noding import Sourced, node, polygonize, polygonize_full
from plumbline.points import Points
from plumbline.polygons import FacePolygons, Triangles, triangulate
from plumbline.repair import Repair, Undone, compare_rules, repair, undo
from plumbline.rooms import Rooms, rooms
from plumbline.rounding import RoundedArrangement, snap_round
from plumbline.structure import Struct, Structure, box, evaluate
from plumbline.write import write

__all__ = [
    "Arrangement",
    "Drawing",
    "Error",
    "FacePolygons",
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
    "RoundedArrangement",
    "Sourced",
    "Struct",
    "Structure",
    "Triangles",
    "Undone",
    "__version__",
    "arrange",
    "box",
    "compare_rules",
    "evaluate",
    "lar",
    "lines",
    "node",
    "polygonize",
    "polygonize_full",
    "r",
    "random_lines",
    "read",
    "repair",
    "rooms",
    "s",
    "same",
    "signature",
    "snap_round",
    "t",
    "triangulate",
    "undo",
    "validate",
    "write",
]
