"""The eight toy drawings by which an adapter is accepted, and how many bounded faces they have.

Segments are rows [ax, ay, bx, by] of doubles, the same on every machine but for the last digits of
its sine and cosine.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from dataclasses import dataclass

Segments = list[list[float]]

ANGLE = 0.3
"""By which drawings are turned: one whose sine and cosine are no short decimals."""


@dataclass(frozen=True)
class Drawing:
    """`intended` is what its author meant; `over_doubles` what its doubles say, counted exactly."""

    name: str
    segments: Segments
    intended: int
    over_doubles: int


def turned(segments: Segments) -> Segments:
    """Computed in doubles, so that what met may just miss."""
    c, s = math.cos(ANGLE), math.sin(ANGLE)
    return [
        [c * ax - s * ay, s * ax + c * ay, c * bx - s * by, s * bx + c * by]
        for ax, ay, bx, by in segments
    ]


def grid(n: int) -> Segments:
    """n by n squares of lines from side to side."""
    across = [[0.0, float(i), float(n), float(i)] for i in range(n + 1)]
    return across + [[float(i), 0.0, float(i), float(n)] for i in range(n + 1)]


def rooms(n: int) -> Segments:
    """n by n rooms with four walls each, so that inner walls are drawn twice."""
    walls: Segments = []
    for x in range(n):
        for y in range(n):
            corners = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]
            for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1]):
                walls.append([float(ax), float(ay), float(bx), float(by)])
    return walls


def scattered(n: int, dice: random.Random) -> Segments:
    """n segments up to 0.2 long, of six decimals."""
    segments: Segments = []
    for _ in range(n):
        x, y = dice.random(), dice.random()
        angle = 2 * math.pi * dice.random()
        length = 0.2 * dice.random()
        ends = [x, y, x + length * math.cos(angle), y + length * math.sin(angle)]
        segments.append([round(c, 6) for c in ends])
    return segments


def fan(n: int, off: float, dice: random.Random) -> Segments:
    """n lines all but through the origin."""
    segments: Segments = []
    for k in range(n):
        angle = math.pi * k / n
        c, s = math.cos(angle), math.sin(angle)
        segments.append([x + off * dice.uniform(-1, 1) for x in (-c, -s, c, s)])
    return segments


def tees(n: int) -> Segments:
    """A slanted line on which n - 1 level lines end, and what joins their other ends."""
    segments = [[0.1, 0.2, 0.1 + 0.3 * n, 0.2 + 0.7 * n]]
    before: tuple[float, float] | None = None
    for k in range(1, n):
        x, y = round(0.1 + 0.3 * k, 10), round(0.2 + 0.7 * k, 10)
        segments.append([x, y, x + 1, y])
        if before is not None:
            segments.append([x + 1, y, *before])
        before = (x + 1, y)
    return segments


def drawings() -> list[Drawing]:
    """In the order of the recorded table. Dice are shared, so the order matters."""
    dice = random.Random(7)
    make: list[tuple[str, Callable[[], Segments], int, int]] = [
        ("grid10", lambda: grid(10), 100, 100),
        ("grid10 turned", lambda: turned(grid(10)), 100, 85),
        ("rooms10 turned", lambda: turned(rooms(10)), 100, 100),
        ("random 300", lambda: scattered(300, dice), 42, 42),
        ("random 1000", lambda: scattered(1000, dice), 1664, 1664),
        ("fan 1e-12", lambda: fan(40, 1e-12, dice), 741, 741),
        ("fan 1e-15", lambda: fan(40, 1e-15, dice), 741, 741),
        ("tees 40", lambda: tees(40), 38, 20),
    ]
    return [Drawing(name, segments(), meant, exact) for name, segments, meant, exact in make]
