"""Numbers as people hold them, as the exact texts that the library takes."""

from __future__ import annotations

from decimal import Decimal
from fractions import Fraction
from typing import Any, Literal, Union

import numpy as np
from numpy.typing import NDArray

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
        if not np.isfinite(value):
            raise ValueError(f"a finite number is needed: {value!r}")
        if isinstance(value, np.longdouble):
            raise ValueError(f"a double is needed, which {type(value).__name__} is more than")
        if numbers == "doubles":
            return str(Fraction(float(value)))
        return repr(value) if type(value) is float else str(value)
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


def in_doubles(array: NDArray[Any], numbers: Numbers | None) -> NDArray[np.float64]:
    """An array of floats as doubles; where they stand for the decimals that they print as, with the
    same decimals: 0.1 for the float32 0.1.

    Raises
    ------
    ValueError
        For floats that are more than doubles.
    """
    if array.dtype.kind == "f" and array.dtype.itemsize > 8:
        raise ValueError(f"doubles are needed, which {array.dtype} is more than")
    if array.dtype.kind == "f" and array.dtype.itemsize < 8 and numbers == "decimals":
        array = array.astype(str)
    return np.ascontiguousarray(array, dtype=np.float64)


def ensure_unmasked(values: Any) -> None:
    """A ValueError for arrays with a mask that is set."""
    if np.ma.isMaskedArray(values) and np.ma.getmaskarray(values).any():
        raise ValueError("values are masked: leave them out, or fill them")


def optional_text(value: Number | None) -> str | None:
    """The same, None for None."""
    return None if value is None else exact_text(value)
