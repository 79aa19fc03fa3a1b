"""Exact planar arrangements, and results held against them.

Line work goes in as files, arrays, geometries or exact numbers; it comes out as what it cuts the
plane into, exactly. ``plumbline.arrange(anything)`` is where to begin.
"""

from plumbline import lar
from plumbline._core import VERSION as __version__
from plumbline._core import EngineConfiguration
from plumbline._programs import ListedEngine, engines
from plumbline.arrangement import Arrangement, arrange, same, signature, validate
from plumbline.certificate import Verdict, certificate, verify
from plumbline.check import Answer, Cause, Check, Engine, Finding, FindingGroup, RightRadii, check
from plumbline.compare import Comparison, compare, compare_result
from plumbline.coverage import (
    CleanCoverage,
    CoverageFault,
    coverage_clean,
    coverage_faults,
    coverage_is_valid,
)
from plumbline.cross_check import cross_check, engine_names, engine_parameters
from plumbline.diagnosis import Defect, Diagnosis, InvalidRing, Opening, diagnose, validity
from plumbline.dissolve import Dissolved, dissolve
from plumbline.drawing import Drawing, read
from plumbline.errors import Error, FileError, InternalError, LimitError, LossWarning
from plumbline.evaluation import box, evaluate
from plumbline.ladder import Ladder, LadderStep, ladder
from plumbline.lar import random_lines
from plumbline.line_inputs import lines
from plumbline.lines import Lines
from plumbline.lists import Lists
from plumbline.maps import Map, r, s, t
from plumbline.minimise import Minimised, minimise
from plumbline.models import LarModel
from plumbline.noding import node, polygonize, polygonize_full
from plumbline.overlay import Overlay, OverlayPiece, overlay
from plumbline.points import Points
from plumbline.polygons import FacePolygons, Triangles, triangulate
from plumbline.regions import (
    Region,
    difference,
    intersection,
    select,
    symmetric_difference,
    union,
    union_all,
)
from plumbline.repair import Repair, repair
from plumbline.rooms import Rooms, rooms
from plumbline.rounding import RoundedArrangement, snap_round
from plumbline.rules import compare_rules
from plumbline.sourced import Sourced
from plumbline.structure import Struct, Structure
from plumbline.undo import Undone, undo
from plumbline.validation import is_valid, is_valid_reason, make_valid
from plumbline.write import write

__all__ = [
    "Answer",
    "Arrangement",
    "Cause",
    "Check",
    "CleanCoverage",
    "Comparison",
    "CoverageFault",
    "Defect",
    "Diagnosis",
    "Dissolved",
    "Drawing",
    "Engine",
    "EngineConfiguration",
    "Error",
    "FacePolygons",
    "FileError",
    "Finding",
    "FindingGroup",
    "InternalError",
    "InvalidRing",
    "Ladder",
    "LadderStep",
    "LarModel",
    "LimitError",
    "Lines",
    "ListedEngine",
    "Lists",
    "LossWarning",
    "Map",
    "Minimised",
    "Opening",
    "Overlay",
    "OverlayPiece",
    "Points",
    "Region",
    "Repair",
    "RightRadii",
    "Rooms",
    "RoundedArrangement",
    "Sourced",
    "Struct",
    "Structure",
    "Triangles",
    "Undone",
    "Verdict",
    "__version__",
    "arrange",
    "box",
    "certificate",
    "check",
    "compare",
    "compare_result",
    "compare_rules",
    "coverage_clean",
    "coverage_faults",
    "coverage_is_valid",
    "cross_check",
    "diagnose",
    "difference",
    "dissolve",
    "engine_names",
    "engine_parameters",
    "engines",
    "evaluate",
    "intersection",
    "is_valid",
    "is_valid_reason",
    "ladder",
    "lar",
    "lines",
    "make_valid",
    "minimise",
    "node",
    "overlay",
    "polygonize",
    "polygonize_full",
    "r",
    "random_lines",
    "read",
    "repair",
    "rooms",
    "s",
    "same",
    "select",
    "signature",
    "snap_round",
    "symmetric_difference",
    "t",
    "triangulate",
    "undo",
    "union",
    "union_all",
    "validate",
    "validity",
    "verify",
    "write",
]
