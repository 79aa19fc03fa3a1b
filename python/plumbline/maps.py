"""Exact affine maps: LAR's t, s and r."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, cast, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plumbline import _core
from plumbline._cached import cached
from plumbline._numbers import Number, Numbers, exact_text
from plumbline.errors import Error

if TYPE_CHECKING:
    from plumbline.models import LarModel, ModelLike
    from plumbline.structure import Struct

ANGLE_BOUND = 1e-15
"""By how many radians what stands for a rotation may deviate."""


def exact_texts(values: Iterable[Number], numbers: Numbers) -> list[str]:
    """The exact texts of numbers.

    Raises
    ------
    Error
        For what is no number, and for another choice than doubles and decimals.
    """
    if numbers not in ("doubles", "decimals"):
        raise Error(f'numbers are "doubles" or "decimals": {numbers!r}')
    try:
        return [exact_text(value, numbers) for value in values]
    except (TypeError, ValueError) as error:
        raise Error(str(error)) from None


class Map:
    """An exact affine map of the plane, of space, of any dimension.

    Made by `t`, `s` and `r`, by composition, or of a matrix. Immutable. In a `Struct` it applies to
    all that follows it in the same body.

    Parameters
    ----------
    matrix : array or sequence of rows
        In homogeneous coordinates, as LAR has them: d + 1 rows of d + 1 numbers, the last row
        0 ... 0 1; or the first d rows alone.
    numbers : {"decimals", "doubles"}
        Whether floats stand for the decimals that they print as, or for what they are.

    Examples
    --------
    >>> import plumbline
    >>> plumbline.Map([[0, -1, 2], [1, 0, 0]]).apply((1, 0))
    (Fraction(2, 1), Fraction(1, 1))
    """

    def __init__(
        self, matrix: ArrayLike | Sequence[Sequence[Number]], *, numbers: Numbers = "decimals"
    ) -> None:
        try:
            rows = [list(row) for row in cast(Iterable[Iterable[Number]], matrix)]
        except TypeError:
            raise Error(f"a matrix is a sequence of rows: {matrix!r:.60}") from None
        width = len(rows[0]) if rows else 0
        if width < 2 or len(rows) not in (width - 1, width) or {len(r) for r in rows} != {width}:
            raise Error(f"a matrix has d or d + 1 rows of d + 1 numbers: {matrix!r:.60}")
        if len(rows) == width:
            last = exact_texts(rows.pop(), numbers)
            if [Fraction(x) for x in last] != [0] * (width - 1) + [1]:
                raise Error(f"the last row of a matrix is 0 ... 0 1: {', '.join(last)}")
        texts = exact_texts((x for row in rows for x in row), numbers)
        self._affine: _core.Affine | None = _core.Affine.of_texts(width - 1, texts)
        self._bound = Fraction(0)
        self._degrees: Fraction | None = None
        self._text = ""

    @classmethod
    def _of(
        cls,
        affine: _core.Affine | None,
        text: str = "",
        bound: Fraction = Fraction(0),
        degrees: Fraction | None = None,
    ) -> Map:
        result = object.__new__(cls)
        result._affine = affine
        result._bound = bound
        result._degrees = degrees
        result._text = text
        return result

    @property
    def _core(self) -> _core.Affine:
        """The map itself; a rotation by degrees is replaced when it is asked for."""
        if self._affine is None:
            assert self._degrees is not None
            self._affine, self._bound = _core.Affine.rotation(str(self._degrees), ANGLE_BOUND)
        return self._affine

    @property
    def dimension(self) -> int:
        """Of the space that it maps."""
        return 2 if self._affine is None else self._affine.dimension

    @property
    def degrees(self) -> Fraction | None:
        """Of a rotation of the plane that was given in degrees these, exactly; else None."""
        return self._degrees

    @property
    def bound(self) -> Fraction:
        """By how many radians the angle may be another one than what was asked for; 0: not at
        all."""
        self._core  # noqa: B018
        return self._bound

    @cached
    def exact(self) -> tuple[tuple[Fraction, ...], ...]:
        """The d + 1 rows of the matrix in homogeneous coordinates, exactly."""
        entries, d = self._core.entries(), self.dimension
        rows = [tuple(entries[i : i + d + 1]) for i in range(0, len(entries), d + 1)]
        return *rows, (*[Fraction(0)] * d, Fraction(1))

    @property
    def matrix(self) -> NDArray[np.float64]:
        """The same, correctly rounded, (d + 1, d + 1): larlib's Mat."""
        return np.array([[_core.nearest_double(str(x)) for x in row] for row in self.exact])

    def __matmul__(self, inner: Map) -> Map:
        """The map that does `inner` first. Rotations by degrees are added, and only their sum is
        replaced."""
        if not isinstance(inner, Map):
            return NotImplemented
        if self._degrees is not None and inner._degrees is not None:
            return r(degrees=self._degrees + inner._degrees)
        bound = self.bound + inner.bound
        return Map._of(self._core.after(inner._core), f"{self!r} @ {inner!r}", bound)

    def inverse(self) -> Map:
        """The map that undoes it, exactly.

        Raises
        ------
        Error
            Where there is none.
        """
        if self._degrees is not None:
            return r(degrees=-self._degrees)
        return Map._of(self._core.inverse(), f"({self!r}).inverse()", self.bound)

    def embed(self, k: int) -> Map:
        """The map of a space of k more dimensions that leaves these as they are; -k fewer.

        Raises
        ------
        Error
            Where nothing would be left, or what is left out acts on what stays.
        """
        return Map._of(self._core.embedded(k), f"({self!r}).embed({k})", self.bound)

    def apply(
        self, point: Iterable[Number], *, numbers: Numbers = "decimals"
    ) -> tuple[Fraction, ...]:
        """The image of a point, exactly."""
        return tuple(self._core.applied(exact_texts(point, numbers)))

    @overload
    def __call__(self, model: Struct) -> Struct: ...
    @overload
    def __call__(self, model: ModelLike) -> LarModel: ...
    def __call__(self, model: Any) -> Any:
        """A model under the map; of a Struct the Struct that has the map before it."""
        from plumbline.models import as_model
        from plumbline.structure import Struct

        if isinstance(model, Struct):
            return Struct([self, model])
        return as_model(model).mapped(self)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Map):
            return NotImplemented
        return self._core == other._core

    def __hash__(self) -> int:
        return hash(self.exact)

    def __reduce__(self) -> tuple[Any, ...]:
        if self._degrees is not None:
            return _turned, (self._degrees,)
        texts = [str(x) for x in self._core.entries()]
        return _remade, (self.dimension, texts, self._text, self._bound)

    def __repr__(self) -> str:
        if self._text:
            return self._text
        return f"Map({[[str(x) for x in row] for row in self.exact[:-1]]})"


def _turned(degrees: Fraction) -> Map:
    return r(degrees=degrees)


def _remade(dimension: int, texts: list[str], text: str, bound: Fraction) -> Map:
    return Map._of(_core.Affine.of_texts(dimension, texts), text, bound)


def t(*by: Number, numbers: Numbers = "decimals") -> Map:
    """The translation by so much in each dimension: larlib's `t`.

    Parameters
    ----------
    *by : number
        One for each dimension: int, Fraction, Decimal, str ("1/3") or float.
    numbers : {"decimals", "doubles"}
        A float stands for the decimal that it prints as, 0.1 for 1/10, or for what it is.

    Examples
    --------
    >>> import plumbline
    >>> plumbline.t(0.1, "1/3").apply((0, 0))
    (Fraction(1, 10), Fraction(1, 3))
    """
    texts = exact_texts(by, numbers)
    if not texts:
        raise Error("a translation has a number for each dimension: there are none")
    return Map._of(_core.Affine.translation(texts), f"t({', '.join(texts)})")


def s(*factors: Number, numbers: Numbers = "decimals") -> Map:
    """The scaling by a factor in each dimension: larlib's `s`. Numbers as in `t`.

    Examples
    --------
    >>> import plumbline
    >>> plumbline.s(2, -1).apply((1, 1))
    (Fraction(2, 1), Fraction(-1, 1))
    """
    texts = exact_texts(factors, numbers)
    if not texts:
        raise Error("a scaling has a factor for each dimension: there are none")
    return Map._of(_core.Affine.scaling(texts), f"s({', '.join(texts)})")


def r(*angles: Number, degrees: Number | None = None, numbers: Numbers = "decimals") -> Map:
    """The rotation about the origin: larlib's `r`, an exact isometry.

    Parameters
    ----------
    *angles : number
        Radians. One: of the plane, from +x towards +y. Three: of space about this vector, by its
        length, counter-clockwise where it points to the viewer.
    degrees : number, optional
        Of the plane, in place of radians. Multiples of 90 are exact; others are added up along the
        way to a model, as far as there are but translations, reflections and scalings by one factor
        in between, and only their sum is replaced: twice 45 is 90, exactly.
    numbers : {"decimals", "doubles"}
        As in `t`.

    Returns
    -------
    Map
        By a rational rotation whose angle differs by at most 1e-15 radians; `bound` tells. Of
        radians, a quarter turn within that bound is taken, as for math.pi / 2. Where the original
        loses the sign of rotations about coordinate axes of space, this one keeps it.

    Examples
    --------
    >>> import math, plumbline
    >>> plumbline.r(math.pi / 2) == plumbline.r(degrees=90)
    True
    >>> plumbline.r(degrees=45) @ plumbline.r(degrees=45) == plumbline.r(degrees=90)
    True
    >>> float(plumbline.r(degrees=45).bound) <= 1e-15
    True
    """
    if degrees is not None:
        if angles:
            raise Error(f"a rotation is by radians or by degrees: {angles!r}, {degrees!r}")
        (text,) = exact_texts([degrees], numbers)
        exactly = _core.Affine.scaling([text]).entries()[0]
        return Map._of(None, f"r(degrees={exactly})", degrees=exactly)
    texts = exact_texts(angles, numbers)
    if len(texts) == 1:
        affine, bound = _core.Affine.rotation_in_radians(texts[0], ANGLE_BOUND)
    elif len(texts) == 3:
        x, y, z = texts
        affine, bound = _core.Affine.rotation_in_space(x, y, z, ANGLE_BOUND)
    else:
        raise Error(f"a rotation has one angle or three: {angles!r}")
    return Map._of(affine, f"r({', '.join(texts)})", bound)
