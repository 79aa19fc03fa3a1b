"""What rules in use make of a drawing, beside its repair."""

from __future__ import annotations

from typing import TYPE_CHECKING

from plumbline import _core
from plumbline._numbers import Number
from plumbline.arrangement import Arrangement
from plumbline.errors import Error
from plumbline.line_inputs import lines
from plumbline.lines import Lines, LinesLike

if TYPE_CHECKING:
    pass
from plumbline.repair import Repair


def compare_rules(
    drawing: Arrangement | LinesLike, repair: Repair, tolerance: Number | None = None
) -> list[_core.RuleOutcome]:
    """What rules in use make of a drawing, beside its repair: see `Repair.compare_rules`.

    Raises
    ------
    Error
        Where the repair is one of another drawing.
    """
    of = lines(drawing.lines if isinstance(drawing, Arrangement) else drawing)
    if of is not repair.input and _signature(of) != _signature(repair.input):
        raise Error("the repair is one of another drawing")
    return repair.compare_rules(tolerance)


def _signature(of: Lines) -> str:
    return _core.rounded_signature(of._core)
