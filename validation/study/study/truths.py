"""What an answer is held against.

- *authored*: the drawing's numbers as a file would hold them;
- *doubles*: the numbers that the engine was given, each a double, as what they are;
- *intended*: what was meant before rounding, where the family knows it;
- *contract*: what the engine's own tolerance promises: of a grid the snap rounded complex; of a
  snap distance that all nearer things are one, and nothing else. Whether two things near *that*
  distance are one, engines may read differently; there is no contract where that matters.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

import numpy as np
import plumbline
from plumbline import Arrangement, _core

from study.engines import Configuration
from study.families import Case, ExactSegment, largest_coordinate
from study.nearness import Nearness
from study.snapping import snap_rounded, snap_rounded_down

COARSE = 2.0**-44  # of the largest coordinate: spacings of grids that doubles tell well apart
_WELL_APART = 1000  # units of rounding, from which on doubles tell distances well enough
_MANY = 2000  # pairs that are near
_READINGS = 4  # times a snap distance, or that part: tolerances of two things may add up, for one


class Disagreement(Exception):
    """Both exact engines gave different arrangements: a fault of this project."""


@dataclass(frozen=True)
class Numbers:
    """Numbers of cells, where nothing more is known; faces with the unbounded one."""

    vertices: int
    edges: int
    faces: int


class Truths:
    """The exact side of a case; arranged when asked for, once."""

    def __init__(self, case: Case) -> None:
        self._case = case
        self._fit: dict[int, bool] = {}  # by identity of arrangements, which live as long as this
        self._contracts: dict[tuple[str, float, str], Arrangement | Numbers | None] = {}

    @cached_property
    def doubles(self) -> Arrangement:
        rows = np.array(self._case.segments, dtype=np.float64).reshape(-1, 4)
        return plumbline.arrange(rows, numbers="doubles", threads=1)

    @cached_property
    def authored(self) -> Arrangement:
        if self._case.authored_in_doubles:
            return self.doubles
        return _arranged(self._case.authored)

    @cached_property
    def intended(self) -> Arrangement | None:
        case = self._case
        if case.intended is None:
            return None
        return self.authored if case.intended == case.authored else _arranged(case.intended)

    def of(self, name: str, engine: Configuration) -> Arrangement | Numbers | None:
        """A truth by its name; None where there is none."""
        if name == "contract":
            return self.contract(engine)
        if name == "intended":
            return self.intended
        return self.doubles if name == "doubles" else self.authored

    def contract(self, of: Configuration) -> Arrangement | Numbers | None:
        """None where the engine promises nothing else than the doubles, or it is not known."""
        key = (of.tolerance_kind, of.tolerance, of.promise)
        if of.tolerance_kind == "none" or of.tolerance <= 0:
            return None
        if key not in self._contracts:
            if of.tolerance_kind == "grid":
                is_fine = of.tolerance < COARSE * largest_coordinate(self._case)
                if is_fine or of.promise == "some":
                    return None  # doubles hardly tell points of a fine grid apart
                round_to = snap_rounded_down if of.promise == "integers" else snap_rounded
                rounded = round_to(self._case.segments, Fraction(repr(of.tolerance)))
                self._contracts[key] = _arranged(rounded) if rounded else None
            else:
                self._contracts[key] = self._fallen_together(of.tolerance, of.promise)
        return self._contracts[key]

    @cached_property
    def nearness(self) -> Nearness:
        return Nearness(self.doubles)

    @cached_property
    def feature_size(self) -> float | None:
        """Of the doubles' arrangement, the least distance of two vertices or of a vertex from an
        edge. None where it would take long: of large drawings, and where much is as near as
        doubles do not tell."""
        return least_feature(self.doubles, self.nearness)

    @cached_property
    def meant_size(self) -> float | None:
        """The same of what was meant, where that is known; else of the doubles."""
        meant = self.intended
        if meant is None or meant is self.doubles:
            return self.feature_size
        return least_feature(meant, Nearness(meant))

    def fits_doubles(self, truth: Arrangement | Numbers) -> bool:
        """See `fits_doubles`."""
        if isinstance(truth, Numbers):
            return True
        if id(truth) not in self._fit:
            self._fit[id(truth)] = fits_doubles(truth)
        return self._fit[id(truth)]

    def ensure_both_engines(self) -> None:
        """Throws: Disagreement."""
        for of in (self.doubles, self.authored, self.intended):
            if of is None:
                continue
            other = plumbline.arrange(of.lines, exact_engine="cgal", threads=1)
            if other.signature != of.signature:
                raise Disagreement(f"{self._case.unit}: {of!r}, {other!r}")

    def _fallen_together(self, distance: float, promise: str) -> Arrangement | Numbers | None:
        """The doubles' arrangement, where nothing is near; else what the ladder says. None where it
        would take long, where something is about as near as the distance, or where the engine
        promises of near things only that some are one."""
        farthest = _READINGS * distance
        if not self.nearness.is_known or self.nearness.count_within(farthest) > _MANY:
            return None
        ladder = plumbline.ladder(self.doubles, max_steps=10**6, largest_radius=farthest)
        steps = [step for step in ladder.steps if step.radius <= farthest]
        if not steps:
            return self.doubles
        last = steps[-1]
        if promise == "some" or last.radius > distance / _READINGS:
            return None
        return Numbers(last.vertices, last.edges, last.faces)


def fits_doubles(of: Arrangement) -> bool:
    """Whether it has the same cells when each vertex is rounded to its nearest double. Where it has
    not, other doubles may still hold the same cells."""
    return _core.is_kept_by_simple_rounding(of._core, None)


def least_feature(of: Arrangement, near: Nearness) -> float | None:
    """See `Truths.feature_size`."""
    if not near.is_known or not of.counts.edges:
        return None
    if near.least > _WELL_APART * near.rounding:
        return near.least
    if near.count_within(near.least) > _MANY:
        return None
    size = of.feature_size()
    squares = (size.squared_vertex_vertex, size.squared_vertex_edge)
    return min((_root(s) for s in squares if s > 0), default=None)


def _root(square: Fraction) -> float:
    """Also where the square is too small for a double."""
    shift = max(0, square.denominator.bit_length() - square.numerator.bit_length()) // 2
    return math.ldexp(math.sqrt(square * 4**shift), -shift)


def _arranged(segments: list[ExactSegment]) -> Arrangement:
    return plumbline.arrange(segments, threads=1)
