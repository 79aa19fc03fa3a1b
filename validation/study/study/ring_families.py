"""Rings of the study, and rules under which they are filled. A unit (family, size, scale, seed)
determines them on every machine; sizes are about how many sides. They are doubles.

*Simple* rings are counter-clockwise and touch themselves nowhere, though vertices may be repeated:
their union is what the nonzero rule fills, their symmetric difference what the even-odd rule does.
Those that rounding to doubles has made cross themselves are left out.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from functools import partial

from study.dice import Dice
from study.families import SCALES, Unit, nearest_double
from study.regions import Rule, region_of

ExactPoint = tuple[Fraction, Fraction]
ExactRing = list[ExactPoint]
Ring = list[tuple[float, float]]
_SCALES = ("unit", "mm", "UTM")
_THICKEST, _THINNEST = 5, 12  # slivers, 10 to the power of minus that thick
_NEAREST, _FURTHEST = 15, 9  # edges miss a point by 10 to the power of minus that
_CORNERS = ((0, 0), (1, 0), (1, 1), (0, 1))


@dataclass(frozen=True)
class RingFamily:
    name: str
    kind: str
    """simple or crossing."""
    rule: Rule
    make: Callable[[int, Dice], list[ExactRing]]
    scales: tuple[str, ...] = _SCALES
    most: int = 1000
    """Sides, beyond which they cross too often."""

    @property
    def takes(self) -> str:
        """What an engine has to take, as its list says it."""
        return f"{self.kind} {self.rule}"


@dataclass(frozen=True)
class RingCase:
    unit: Unit
    rings: list[Ring]
    rule: Rule

    @property
    def coordinates(self) -> list[float]:
        return [c for ring in self.rings for p in ring for c in p]

    @property
    def largest_coordinate(self) -> float:
        return max(map(abs, self.coordinates), default=0.0)

    @property
    def longer_side(self) -> float:
        axes = [[p[k] for ring in self.rings for p in ring] for k in (0, 1)]
        return max((max(axis) - min(axis) for axis in axes if axis), default=0.0)


def ring_case_of(family: RingFamily, unit: Unit) -> RingCase:
    # The same shapes for both rules, so that they can be compared.
    shape = family.make.func.__name__ if isinstance(family.make, partial) else family.make.__name__
    made = family.make(unit.size, Dice(f"rings {shape} {unit.size} {unit.seed}"))
    scale = SCALES[unit.scale]
    rings = []
    for exact in made:
        scaled = [scale((x, y, x, y))[:2] for x, y in exact]
        rings.append([(nearest_double(x), nearest_double(y)) for x, y in scaled])
    if family.kind == "simple":
        rings = [ring for ring in rings if is_simple(ring)]
    return RingCase(unit, rings, family.rule)


def is_simple(ring: Ring) -> bool:
    """Whether it is counter-clockwise and touches itself nowhere; vertices may be repeated."""
    corners = [p for p, q in zip(ring, [*ring[1:], ring[0]]) if p != q]
    if len(corners) < 3 or len(set(corners)) != len(corners):
        return False
    region = region_of([corners], "nonzero")
    assert region.arrangement is not None
    counts = region.arrangement.counts
    is_cycle = (counts.vertices, counts.edges) == (len(corners), len(corners))
    is_cycle = is_cycle and bool(region.is_boundary.all())
    pairs = zip(corners, [*corners[1:], corners[0]])
    exact = ((Fraction(a[0]), Fraction(a[1]), Fraction(b[0]), Fraction(b[1])) for a, b in pairs)
    return is_cycle and sum(ax * by - bx * ay for ax, ay, bx, by in exact) > 0


# Shapes. Turns have rational sines and cosines, so that equal points stay equal.


def _turn(dice: Dice) -> Callable[[ExactPoint], ExactPoint]:
    return _turn_by(Fraction(dice.between(20, 980), 1000))


def _turn_by(t: Fraction) -> Callable[[ExactPoint], ExactPoint]:
    """By the angle whose half has the tangent t."""
    c, s = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    return lambda p: (c * p[0] - s * p[1], s * p[0] + c * p[1])


def _spread(dice: Dice, span: int) -> ExactPoint:
    """A point in a square, on six decimals."""
    return Fraction(round(span * dice.unit(), 6)), Fraction(round(span * dice.unit(), 6))


def _root(count: int) -> int:
    return max(1, math.isqrt(count))


def _direction(k: int, n: int) -> ExactPoint:
    """The k-th of n points around the unit circle, counter-clockwise, at nearly equal angles, with
    rational coordinates: a half turn is halved by the tangents -1 to 1 of a quarter."""
    turns = Fraction(2 * k, n)
    side, v = (1, 2 * turns - 1) if turns < 1 else (-1, 2 * turns - 3)
    t = v * (7 + 2 * v * v) / 9
    return side * -2 * t / (1 + t * t), side * (1 - t * t) / (1 + t * t)


def turned_squares(size: int, dice: Dice) -> list[ExactRing]:
    """Squares anywhere, each turned on its own; most overlap others."""
    count = max(2, size // 4)
    rings = []
    for _ in range(count):
        (x, y), turn = _spread(dice, _root(count)), _turn(dice)
        corners = [turn((Fraction(a), Fraction(b))) for a, b in _CORNERS]
        rings.append([(x + a, y + b) for a, b in corners])
    return rings


def random_polygons(size: int, dice: Dice) -> list[ExactRing]:
    """Polygons of ten vertices that their centre sees, with in turn long and short radii."""
    count = max(2, size // 10)
    rings = []
    for _ in range(count):
        x, y = _spread(dice, _root(count))
        radii = [Fraction(3, 10) + dice.unit() for _ in range(10)]
        points = (_direction(k, 10) for k in range(10))
        rings.append([(x + r * a, y + r * b) for r, (a, b) in zip(radii, points)])
    return rings


def stars(size: int, dice: Dice) -> list[ExactRing]:
    """Stars of seven points, which wind around their centre three times."""
    count = max(1, size // 7)
    rings = []
    for _ in range(count):
        (x, y), turn = _spread(dice, _root(count)), _turn(dice)
        points = [turn(_direction(3 * k % 7, 7)) for k in range(7)]
        rings.append([(x + a, y + b) for a, b in points])
    return rings


def scribble(size: int, dice: Dice) -> list[ExactRing]:
    """One ring of steps in any direction, folded back into a square."""
    span = _root(size)
    x, y = _spread(dice, span)
    ring = []
    for _ in range(size):
        ring.append((x, y))
        dx, dy = (4 * dice.unit() - 2 for _ in range(2))
        x, y = (min(max(c, Fraction(0)), Fraction(span)) for c in (x + dx, y + dy))
    return [ring]


def slivers(size: int, dice: Dice) -> list[ExactRing]:
    """Quadrangles 1 long and 1e-5 to 1e-12 thick, crossing each other."""
    count = max(2, size // 4)
    rings = []
    for _ in range(count):
        (x, y), turn = _spread(dice, 1 + _root(count) // 2), _turn(dice)
        thick = Fraction(1, 10 ** dice.between(_THICKEST, _THINNEST))
        corners = (turn((Fraction(a) - Fraction(1, 2), b * thick)) for a, b in _CORNERS)
        rings.append([(x + a, y + b) for a, b in corners])
    return rings


def _squares(cells: list[tuple[int, int]], dice: Dice) -> list[ExactRing]:
    """Squares of a grid that is turned; where they meet, their corners are the same doubles."""
    turn = _turn(dice)
    return [[turn((Fraction(x + a), Fraction(y + b))) for a, b in _CORNERS] for x, y in cells]


def touching_vertices(size: int, dice: Dice) -> list[ExactRing]:
    """Every second square of a turned grid: they touch at corners alone."""
    m = max(2, _root(size // 2))
    return _squares([(x, y) for x in range(m) for y in range(m) if (x + y) % 2 == 0], dice)


def turned_rooms(size: int, dice: Dice) -> list[ExactRing]:
    """All squares of a turned grid: neighbours share sides."""
    m = max(1, _root(size // 4))
    return _squares([(x, y) for x in range(m) for y in range(m)], dice)


def turned_bricks(size: int, dice: Dice) -> list[ExactRing]:
    """Bricks in turned rows, each above the joint of two: corners are meant to lie on sides."""
    m = max(2, _root(size // 4))
    turn = _turn(dice)
    rows = [(2 * x + y % 2, y) for y in range(m) for x in range(m)]
    return [[turn((Fraction(x + 2 * a), Fraction(y + b))) for a, b in _CORNERS] for x, y in rows]


def nested(size: int, dice: Dice) -> list[ExactRing]:
    """Squares about one centre, each a bit larger than the one within it and turned a bit."""
    count = max(2, size // 4)
    rings = []
    for k in range(1, count + 1):
        turn = _turn_by(Fraction(dice.between(-9, 9), 100 * k))
        half = Fraction(k * 4, 5)
        rings.append([turn((half * (2 * a - 1), half * (2 * b - 1))) for a, b in _CORNERS])
    return rings


def near_concurrent(size: int, dice: Dice) -> list[ExactRing]:
    """Triangles of which a side misses the origin by 1e-9 to 1e-15."""
    count = max(3, size // 3)
    off = Fraction(1, 10 ** dice.between(_FURTHEST, _NEAREST))
    rings = []
    for _ in range(count):
        turn = _turn_by(Fraction(dice.between(-999, 999), 1000))
        shift = off * (2 * dice.unit() - 1)
        tip = Fraction(1, 4) + dice.unit() / 2
        corners = ((Fraction(1), shift), (Fraction(0), tip), (Fraction(-1), shift))
        rings.append([turn(p) for p in corners])
    return rings


def spirals(size: int, dice: Dice) -> list[ExactRing]:
    """Two bands that wind about one centre, the second shifted so that it crosses the first."""
    steps = max(4, size // 4)
    outline = []
    for width in (Fraction(0), Fraction(2, 5)):
        arm = []
        for k in range(steps):
            a, b = _direction(k % 12, 12)
            r = 1 + Fraction(k, 12) + width
            arm.append((r * a, r * b))
        outline.append(arm)
    band = [*outline[1], *reversed(outline[0])]
    x, y = _spread(dice, 1)
    turn = _turn(dice)
    return [[turn(p) for p in band], [(x + a, y + b) for a, b in band]]


def strips(size: int, dice: Dice) -> list[ExactRing]:
    """Strips side by side with gaps, and others across: under the even-odd rule a checkerboard."""
    m = max(1, size // 8)
    turn = _turn(dice)
    rings = []
    for k in range(m):
        along = [(2 * m * a, 2 * k + b) for a, b in _CORNERS]
        rings.append([turn((Fraction(x), Fraction(y))) for x, y in along])
        rings.append([turn((Fraction(y), Fraction(x))) for x, y in reversed(along)])
    return rings


def repeated(size: int, dice: Dice) -> list[ExactRing]:
    """Turned squares, each with some of its vertices repeated."""
    return [
        [p for p in ring for _ in range(dice.between(1, 3))]
        for ring in turned_squares(size // 2, dice)
    ]


def spikes(size: int, dice: Dice) -> list[ExactRing]:
    """Turned squares with a way out and back at a corner, which bounds nothing."""
    rings = []
    for ring in turned_squares(size * 2 // 3, dice):
        (x, y), (dx, dy) = ring[0], _spread(dice, 2)
        rings.append([ring[0], (x + dx - 1, y + dy - 1), *ring])
    return rings


def ring_families() -> list[RingFamily]:
    simple, crossing = partial(RingFamily, kind="simple"), partial(RingFamily, kind="crossing")
    union, parity = "nonzero", "evenodd"
    return [
        simple("turned squares, union", rule=union, make=turned_squares),
        simple("turned squares, xor", rule=parity, make=turned_squares),
        simple("random polygons, union", rule=union, make=random_polygons),
        simple("slivers, union", rule=union, make=slivers),
        simple("touching vertices, union", rule=union, make=touching_vertices),
        simple("turned rooms, union", rule=union, make=turned_rooms),
        simple("turned bricks, union", rule=union, make=turned_bricks),
        simple("nested squares, xor", rule=parity, make=nested),
        simple("near-concurrent, union", rule=union, make=near_concurrent, most=100),
        simple("near-concurrent, xor", rule=parity, make=near_concurrent, most=100),
        simple("spirals, union", rule=union, make=spirals),
        simple("strips, xor", rule=parity, make=strips, most=100),
        simple("repeated vertices, union", rule=union, make=repeated),
        crossing("stars, nonzero", rule=union, make=stars),
        crossing("stars, even-odd", rule=parity, make=stars),
        crossing("scribble, nonzero", rule=union, make=scribble),
        crossing("scribble, even-odd", rule=parity, make=scribble),
        crossing("spikes, nonzero", rule=union, make=spikes),
    ]
