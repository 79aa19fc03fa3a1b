"""Numbers as people hold them, as the exact texts that the library takes."""

from __future__ import annotations

import math
from decimal import Decimal
from fractions import Fraction
from typing import Any, Literal, Union

import numpy as np

Number = Union[int, float, str, Decimal, Fraction, "np.integer[Any]", "np.floating[Any]"]
"""A number: exact but for floats, which stand for the decimal that they print as, or, where
``numbers="doubles"`` says so, for the number that they are."""

Numbers = Literal["doubles", "decimals"]


def exact_text(value: Number, numbers: Numbers = "decimals") -> str:
    """The exact text of a number: a decimal or a fraction "p/q".

    Raises
    ------
    ValueError
        For what is no number, or not finite.
    """
    if isinstance(value, (float, np.floating)):
        value = float(value)
        if not math.isfinite(value):
            raise ValueError(f"a finite number is needed: {value!r}")
        if numbers == "doubles":
            return str(Fraction(value))
        return repr(value)
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, str):
        return value.strip()
    if isinstance(value, Decimal):
        if not value.is_finite():
            raise ValueError(f"a finite number is needed: {value!r}")
        return str(value)
    if hasattr(value, "numerator") and hasattr(value, "denominator"):
        return f"{int(value.numerator)}/{int(value.denominator)}"
    raise ValueError(f"a number is needed: {value!r}")


def optional_text(value: Number | None) -> str | None:
    """The same, None for None."""
    return None if value is None else exact_text(value)
