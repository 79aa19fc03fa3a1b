"""Sizes and choices that users give, as the library takes them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction
from typing import Union

from plumbline import _core
from plumbline._numbers import Number, exact_text
from plumbline.errors import Error

Unit = Union[str, Number, "_core.LengthUnit"]
"""A unit of length by its name ("mm", "metres", "ft"), or how many metres it is."""

_METRES = {
    ("mm", "millimetre", "millimetres", "millimeter", "millimeters"): "0.001",
    ("cm", "centimetre", "centimetres", "centimeter", "centimeters"): "0.01",
    ("dm", "decimetre", "decimetres", "decimeter", "decimeters"): "0.1",
    ("m", "metre", "metres", "meter", "meters"): "1",
    ("km", "kilometre", "kilometres", "kilometer", "kilometers"): "1000",
    ("in", "inch", "inches"): "0.0254",
    ("ft", "foot", "feet"): "0.3048",
}


def size_text(what: str, value: Number) -> str:
    """The exact text of a size of 0 or more; an Error that says `what` for anything else."""
    try:
        if isinstance(value, bool):
            raise ValueError
        text = exact_text(value)
        _core.nearest_double(text)  # refuses exponents that would fill the memory
        size = Fraction(text)
    except (ValueError, ZeroDivisionError, TypeError):
        raise Error(f"{what} is a number of 0 or more, in drawing units: {value!r}") from None
    if size < 0:
        raise Error(f"{what} is a number of 0 or more, in drawing units: {value!r}")
    return str(size)


def optional_size(what: str, value: Number | None) -> str | None:
    """The same, None for None."""
    return None if value is None else size_text(what, value)


def nearest_size(what: str, value: Number) -> float:
    """The nearest double of such a size; an Error for one beyond the doubles."""
    nearest = _core.nearest_double(size_text(what, value))
    if not math.isfinite(nearest):
        raise Error(f"{what} is a number that doubles can hold: {value!r:.60}")
    return nearest


def names(values: str | Sequence[str]) -> list[str]:
    """Names of layers or elements: one alone, or several."""
    return [values] if isinstance(values, str) else [str(value) for value in values]


def unit_of(value: Unit) -> _core.LengthUnit:
    """The unit of a name or a number of metres."""
    if isinstance(value, _core.LengthUnit):
        return value
    for known, metres in _METRES.items():
        if isinstance(value, str) and value.strip().lower() in known:
            return _core.LengthUnit(known[0], metres)
    try:
        metres = size_text("a unit", value)
    except Error:
        metres = "0"
    if metres == "0":
        raise Error(
            "a unit is mm, cm, dm, m, km, in or ft, or how many metres a drawing unit is: "
            f"{value!r}"
        )
    return _core.LengthUnit("", metres)
