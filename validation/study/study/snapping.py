"""Snap rounding, exactly and from its definition: what engines with a grid promise.

Hobby, "Practical segment intersection with finite precision output" (1999): each vertex of the
arrangement makes its pixel of the grid hot; a segment becomes the chain of the centres of the hot
pixels that it meets. Pixels are half-open, so that ties go upwards. Shares nothing with the
library's own rounding but the arrangement's vertices.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from fractions import Fraction
from math import floor

import numpy as np
import plumbline

from study.families import Doubles, ExactSegment

_HALF = Fraction(1, 2)
_ROUNDING = 2.0**-48  # more than some operations on doubles lose, relative to the largest of them


def snap_rounded(segments: Sequence[Doubles], grid: Fraction) -> list[ExactSegment]:
    """The pieces of all chains, each once. They meet in their ends alone."""
    rows = np.array(segments, dtype=np.float64).reshape(-1, 4)
    vertices = plumbline.arrange(rows, numbers="doubles", threads=1).points
    hot = sorted({(floor(x / grid + _HALF), floor(y / grid + _HALF)) for x, y in vertices})
    centres = np.array(hot, dtype=np.float64)
    pieces = set()
    for row in segments:
        ends = [Fraction(c) / grid for c in row]
        chain = _chain(ends, hot, _near(ends, centres))
        for a, b in itertools.pairwise(chain):
            pieces.add((min(a, b), max(a, b)))
    return [(a[0] * grid, a[1] * grid, b[0] * grid, b[1] * grid) for a, b in sorted(pieces)]


def snap_rounded_down(segments: Sequence[Doubles], grid: Fraction) -> list[ExactSegment]:
    """What is promised where coordinates are integers: ends are on the grid before anything else,
    rounded to the nearest with ties away from 0, and crossings are rounded down, so that the pixel
    of a point has it as its lower left corner."""
    on_grid = [[_rounded_away(Fraction(c) / grid) for c in s] for s in segments]
    shifted = [_four_doubles([c - 0.5 for c in s]) for s in on_grid]  # exact: below 2^52
    pieces = snap_rounded([s for s in shifted if s[:2] != s[2:]], Fraction(1))
    return [(a * grid, b * grid, c * grid, d * grid) for a, b, c, d in pieces]


def _rounded_away(value: Fraction) -> int:
    away = floor(abs(value) + _HALF)
    return away if value >= 0 else -away


def _four_doubles(values: Sequence[float]) -> Doubles:
    a, b, c, d = values
    return (a, b, c, d)


def _near(ends: Sequence[Fraction], centres: np.ndarray) -> list[int]:
    """Pixels whose centres are within 1 of the line and of the box, with a margin for rounding:
    candidates, of which exact numbers decide."""
    ax, ay, bx, by = (float(c) for c in ends)
    x, y = centres[:, 0], centres[:, 1]
    margin = 1 + _ROUNDING * max(abs(float(c)) for c in ends)
    dx, dy = bx - ax, by - ay
    length = max(abs(dx), abs(dy), 1e-300)
    off = np.abs((x - ax) * (dy / length) - (y - ay) * (dx / length))
    in_box = (
        (x >= min(ax, bx) - margin)
        & (x <= max(ax, bx) + margin)
        & (y >= min(ay, by) - margin)
        & (y <= max(ay, by) + margin)
    )
    found: list[int] = np.flatnonzero(in_box & (off <= 2 * margin)).tolist()
    return found


def _chain(
    ends: Sequence[Fraction], hot: Sequence[tuple[int, int]], candidates: Sequence[int]
) -> list[tuple[int, int]]:
    """Centres of hot pixels that a segment meets, in the order in which it does."""
    met = []
    for i in candidates:
        span = _within(ends, hot[i])
        if span is not None:
            met.append((span, hot[i]))
    return [centre for _, centre in sorted(met)]


def _within(ends: Sequence[Fraction], pixel: tuple[int, int]) -> tuple[Fraction, Fraction] | None:
    """From where to where, as parameters from 0 to 1, the segment is in the half-open pixel; None:
    nowhere."""
    low, high = Fraction(0), Fraction(1)
    low_is_out = high_is_out = False
    for k in (0, 1):
        a, d = ends[k], ends[k + 2] - ends[k]
        first, last = pixel[k] - _HALF, pixel[k] + _HALF
        if d == 0:
            if not first <= a < last:
                return None
            continue
        enters, leaves = (first - a) / d, (last - a) / d
        enters_out, leaves_out = False, True
        if d < 0:
            enters, leaves, enters_out, leaves_out = leaves, enters, True, False
        if enters > low:
            low, low_is_out = enters, enters_out
        elif enters == low:
            low_is_out = low_is_out or enters_out
        if leaves < high:
            high, high_is_out = leaves, leaves_out
        elif leaves == high:
            high_is_out = high_is_out or leaves_out
    if low > high or (low == high and (low_is_out or high_is_out)):
        return None
    return low, high
