"""At which radii a drawing falls together."""

from __future__ import annotations

from typing import Any

from plumbline import _core
from plumbline._arguments import arrangement_of, count, ensure_none
from plumbline._core import LadderStep
from plumbline._notebook import drawn
from plumbline._numbers import Number
from plumbline._sizes import nearest_size
from plumbline.arrangement import Arrangement
from plumbline.errors import Error
from plumbline.lines import LinesLike

__all__ = ["Ladder", "LadderStep", "ladder"]


class Ladder:
    """How a drawing falls together as the tolerance grows. Made by `plumbline.ladder`.

    Attributes
    ----------
    arrangement : Arrangement
        That of the drawing, whose cells the steps name.
    right_radii : RightRadii or None
        Of a check: with which radii the engine is right.
    """

    def __init__(
        self,
        core: _core.ToleranceLadder,
        arrangement: Arrangement,
        right_radii: _core.RightRadii | None = None,
    ) -> None:
        self._core = core
        self.arrangement = arrangement
        self.right_radii = right_radii

    @property
    def steps(self) -> list[LadderStep]:
        """Critical radii, ascending: from each one on, numbers of cells are others."""
        return self._core.steps

    @property
    def is_complete(self) -> bool:
        """Whether it goes on until nothing changes any more."""
        return self._core.is_complete

    def __len__(self) -> int:
        return len(self.steps)

    def to_text(self, limit: int = 20) -> str:
        """A table of its first steps."""
        return self._core.to_text(self.arrangement._core, count(limit, "the limit"))

    def to_svg(self) -> str:
        """A picture: numbers of cells over the logarithm of the radius."""
        return self._core.to_svg(self.right_radii)

    def _repr_svg_(self) -> str | None:
        return drawn(self.to_svg())

    def _written(self, format: str, **options: Any) -> str:
        """The content of a file: what `plumbline.write` asks for."""
        ensure_none(options)
        if format != "svg":
            raise Error(f"a ladder is written as svg: {format!r}")
        return self.to_svg()

    def __str__(self) -> str:
        return self.to_text()

    def __repr__(self) -> str:
        steps = f"{len(self)} critical radii"
        if len(self):
            steps += f" from {self.steps[0].radius:.6g} to {self.steps[-1].radius:.6g}"
        return f"<Ladder: {steps}{'' if self.is_complete else ', not complete'}>"


def ladder(
    lines: Arrangement | LinesLike,
    max_steps: int = 1000,
    largest_radius: Number | None = None,
) -> Ladder:
    """The critical radii of a drawing: where its numbers of vertices, edges or faces change if all
    that is no further apart than the radius counts as one.

    Parameters
    ----------
    lines : Arrangement, or line work as `arrange` takes it
    max_steps : int
        At most so many steps.
    largest_radius : number, optional
        Steps beyond it are left out.

    Returns
    -------
    Ladder
        With exact radii. Does not depend on how the drawing is moved, turned, mirrored or scaled.

    Raises
    ------
    Error
        For a drawing without any vertex, a negative radius; as `arrange`.

    Notes
    -----
    O(n log n), and some microseconds for each pair within the last radius.

    Examples
    --------
    A corner with a gap of a hundredth:

    >>> import plumbline
    >>> l = plumbline.ladder([(0, 0, 2, 0), ("2.01", 0, 4, 2), (4, 2, 0, 0)])
    >>> l
    <Ladder: 4 critical radii from 0.01 to 2.82136>
    >>> l.steps[0].squared_radius, l.steps[0].faces
    (Fraction(1, 10000), 2)
    """
    arrangement = arrangement_of(lines)
    if not arrangement.counts.vertices:
        raise Error("there is nothing drawn that could fall together")
    core = _core.tolerance_ladder(
        arrangement._core,
        count(max_steps, "max_steps"),
        None if largest_radius is None else nearest_size("largest_radius", largest_radius),
    )
    return Ladder(core, arrangement)
