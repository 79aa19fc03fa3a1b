"""Drawings of the study. A unit (family, size, scale, seed, order) determines its drawing on every
machine.

A drawing comes three times: as it is *intended*, where the family knows that; as *authored*, the
decimals or fractions that a file would hold; and in the *doubles* that engines are given.
"""

from __future__ import annotations

import functools
import json
import math
import os
import subprocess
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import TypeVar

import plumbline

from study.dice import Dice

T = TypeVar("T")
ExactSegment = tuple[Fraction, Fraction, Fraction, Fraction]
Doubles = tuple[float, float, float, float]


@dataclass(frozen=True, order=True)
class Unit:
    """What names a drawing."""

    family: str
    size: int
    """About how many segments; 0: the family has a size of its own."""
    scale: str
    seed: int
    order: int = 0
    """0: as drawn; else the number of a permutation of the segments and their ends."""


@dataclass(frozen=True)
class Case:
    """A drawing, three times; segments without length are left out of each."""

    unit: Unit
    intended: list[ExactSegment] | None
    authored: list[ExactSegment]
    segments: list[Doubles]

    @property
    def authored_in_doubles(self) -> bool:
        """Whether the authored numbers are doubles, so that both drawings are the same."""
        return self.authored == [tuple(map(Fraction, s)) for s in self.segments]


@dataclass(frozen=True)
class Family:
    """How a kind of drawing is made."""

    name: str
    group: str
    make: Callable[[int, int], list[ExactSegment]]
    """Of a size and a seed; exactly what is meant, before rounding."""
    sizes: tuple[int, ...] = (0,)
    scales: tuple[str, ...] = ("unit",)
    is_rounded: bool = False
    """Whether authored numbers are rounded ones, and what was meant is therefore known."""
    grows_well: bool = True
    """Whether large ones have no more crossings than some for each segment."""
    most_seeds: int | None = None
    """Of a family with thousands of edges in each drawing, which take a minute with all engines."""
    decimals: int | None = None
    """Of authored numbers that are rounded; None: the shortest ones of nearest doubles."""


@dataclass(frozen=True)
class Scale:
    factor: Fraction
    offset: tuple[int, int]

    def __call__(self, s: ExactSegment) -> ExactSegment:
        f, (x, y) = self.factor, self.offset
        return (f * s[0] + x, f * s[1] + y, f * s[2] + x, f * s[3] + y)


SCALES = {
    "unit": Scale(Fraction(1), (0, 0)),
    "mm": Scale(Fraction(1000), (0, 0)),
    "UTM": Scale(Fraction(1), (500_000, 4_500_000)),
    "far": Scale(Fraction(1), (1_000_000_000, 1_000_000_000)),
    "small": Scale(Fraction(1, 1_000_000), (0, 0)),
}
"""Drawings in metres, in millimetres, in a national grid, 1e9 away, and a millionth as large."""


def nearest_double(value: Fraction) -> float:
    return value.numerator / value.denominator


def case_of(family: Family, unit: Unit) -> Case:
    """The drawing of a unit."""
    scale = SCALES[unit.scale]
    meant = [scale(s) for s in family.make(unit.size, unit.seed)]
    if unit.order:
        meant = permuted(meant, Dice(f"order {unit.family} {unit.seed} {unit.order}"))
    authored = meant
    if family.is_rounded:
        authored = [_rounded(s, family.decimals) for s in meant]
    doubles = [_four([nearest_double(c) for c in s]) for s in authored]
    return Case(
        unit,
        _with_length(meant) if family.is_rounded else None,
        _with_length(authored),
        [s for s in doubles if s[:2] != s[2:]],
    )


def largest_coordinate(case: Case) -> float:
    """Without its sign: what rounding is measured by."""
    return max((abs(c) for s in case.segments for c in s), default=0.0)


def permuted(segments: Sequence[ExactSegment], dice: Dice) -> list[ExactSegment]:
    """In another order, each in a direction of its own."""
    result = [s if dice.between(0, 1) else (*s[2:], *s[:2]) for s in segments]
    dice.shuffle(result)
    return result


def _rounded(s: ExactSegment, decimals: int | None) -> ExactSegment:
    if decimals is None:
        return _four([Fraction(repr(nearest_double(c))) for c in s])
    return _four([Fraction(round(c, decimals)) for c in s])


def _four(values: Sequence[T]) -> tuple[T, T, T, T]:
    a, b, c, d = values
    return (a, b, c, d)


def _with_length(segments: list[ExactSegment]) -> list[ExactSegment]:
    return [s for s in segments if s[:2] != s[2:]]


# Families that are made here. Turns have rational sines and cosines, so that what is meant is
# known exactly.


def _turned(segments: list[ExactSegment], dice: Dice) -> list[ExactSegment]:
    """About the origin, by an angle whose half has the tangent k / 1000."""
    t = Fraction(dice.between(20, 980), 1000)
    c, s = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    return [
        (c * ax - s * ay, s * ax + c * ay, c * bx - s * by, s * bx + c * by)
        for ax, ay, bx, by in segments
    ]


def _integers(rows: list[tuple[int, int, int, int]]) -> list[ExactSegment]:
    return [_four([Fraction(c) for c in row]) for row in rows]


def turned_grid(size: int, seed: int) -> list[ExactSegment]:
    """Lines of a square grid, turned."""
    m = max(1, size // 2 - 1)
    rows = [(0, i, m, i) for i in range(m + 1)] + [(i, 0, i, m) for i in range(m + 1)]
    return _turned(_integers(rows), Dice(f"grid {size} {seed}"))


def turned_rooms(size: int, seed: int) -> list[ExactSegment]:
    """Square rooms, four walls each, so that walls between rooms are drawn twice; turned."""
    m = max(1, math.isqrt(size // 4))
    rows = [
        wall
        for x in range(m)
        for y in range(m)
        for wall in (
            (x, y, x + 1, y),
            (x + 1, y, x + 1, y + 1),
            (x + 1, y + 1, x, y + 1),
            (x, y + 1, x, y),
        )
    ]
    return _turned(_integers(rows), Dice(f"rooms {size} {seed}"))


def tees(size: int, seed: int) -> list[ExactSegment]:
    """Ends on a slanted line, at decimals; each with the one before bounds a face."""
    dice = Dice(f"tees {size} {seed}")
    tenth = Fraction(1, 10)
    x, y = dice.between(0, 9) * tenth, dice.between(0, 9) * tenth
    dx, dy = dice.between(1, 9) * tenth, dice.between(1, 9) * tenth
    n = max(2, size // 2)
    result = [(x, y, x + n * dx, y + n * dy)]
    before: tuple[Fraction, Fraction] | None = None
    for k in range(1, n):
        foot = (x + k * dx, y + k * dy)
        result.append((*foot, foot[0] + 1, foot[1]))
        if before is not None:
            result.append((foot[0] + 1, foot[1], *before))
        before = foot
    return result


def fan(size: int, seed: int) -> list[ExactSegment]:
    """Lines that nearly go through one point: they miss it by 1e-9, 1e-12 or 1e-15."""
    dice = Dice(f"fan {size} {seed}")
    off = Fraction(1, 10 ** (3 * dice.between(3, 5)))
    result = []
    for k in range(size):
        t = Fraction(2 * k + 1, size) - 1
        c, s = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
        ends = [e + off * (2 * dice.unit() - 1) for e in (c, s, -c, -s)]
        result.append(_four([Fraction(nearest_double(e)) for e in ends]))
    return result


def random_segments(size: int, seed: int) -> list[ExactSegment]:
    """In the unit square, on six decimals, each crossing a few others."""
    dice = Dice(f"random {size} {seed}")
    length = Fraction(3, 1 + math.isqrt(size))
    result = []
    for _ in range(size):
        x, y = dice.unit(), dice.unit()
        dx, dy = (length * (2 * dice.unit() - 1) for _ in range(2))
        ends = (x, y, x + dx, y + dy)
        result.append(_four([Fraction(round(c, 6)) for c in ends]))
    return result


# Neighbours of an end point: a drawing for each cell of a square map.


def _neighbour(value: float, steps: int) -> Fraction:
    return Fraction(value) + steps * Fraction(math.ulp(value))


def ulp_tee(side: int, cell: int) -> list[ExactSegment]:
    """A slanted line, one that crosses it, and one that closes a triangle if it ends on the first
    or beyond; that end is moved by some units in the last place, up to half of `side` in x and y.
    """
    x, y = (k - side // 2 for k in (cell % side, cell // side))
    foot = (_neighbour(0.7, x), _neighbour(1.6, y))
    far, other = (Fraction(1.7), Fraction(1.6)), (Fraction(0.1), Fraction(0.9))
    line = _four([Fraction(c) for c in (0.1, 0.2, 1.3, 3.0)])
    return [line, (*foot, *far), (*far, *other)]


def ulp_fan(side: int, cell: int) -> list[ExactSegment]:
    """Four lines through the origin, where doubles are fine enough for what happens, and one that
    goes through it or passes it, since an end of it is moved likewise."""
    x, y = (k - side // 2 for k in (cell % side, cell // side))
    rows = [_four([Fraction(c) for c in (px, py, -px, -py)]) for px, py in _DIRECTIONS]
    moved = (Fraction(-0.9), Fraction(-0.4), _neighbour(0.9, x), _neighbour(0.4, y))
    return [*rows, moved]


_DIRECTIONS = ((1.0, 1.0), (1.0, -1.0), (0.3, 1.0), (1.0, 0.7))


# Families that plumbline_study_inputs makes, and drawings of people.


def _program() -> str:
    program = os.environ.get("PLUMBLINE_STUDY_INPUTS")
    if not program:
        raise SystemExit("PLUMBLINE_STUDY_INPUTS names the program of that name")
    return program


@functools.cache
def campaign_names() -> tuple[str, ...]:
    """All that the program makes."""
    run = subprocess.run([_program(), "--list"], check=True, capture_output=True, text=True)
    return tuple(run.stdout.splitlines())


_AT_ONCE = 64


@functools.lru_cache(maxsize=8)
def _seeds_at_once(name: str, first: int) -> list[list[ExactSegment]]:
    command = [_program(), name, str(first), str(_AT_ONCE)]
    run = subprocess.run(command, check=True, capture_output=True, text=True)
    return [
        [_four([Fraction(c) for c in row]) for row in json.loads(line)["segments"]]
        for line in run.stdout.splitlines()
    ]


def of_program(name: str, is_turned: bool, size: int, seed: int) -> list[ExactSegment]:
    """A drawing that the program makes, or that turned; the families have sizes of their own."""
    first = seed // _AT_ONCE * _AT_ONCE
    segments = _seeds_at_once(name, first)[seed - first]
    return _turned(segments, Dice(f"{name} {seed}")) if is_turned else segments


@functools.cache
def _read(path: Path) -> list[ExactSegment]:
    return [(*a, *b) for a, b in plumbline.read(path)]


def of_file(path: Path, size: int, seed: int) -> list[ExactSegment]:
    """A drawing of people, whatever the size and the seed."""
    return _read(path)


_PLANS = {"rooms": "plan", "rooms with doors": "plan with doors"}
_PLAN_SCALES = ("unit", "mm", "UTM")


def made_families(sizes: tuple[int, ...]) -> list[Family]:
    """Those that are made here, in these sizes."""
    scaled = functools.partial(Family, sizes=sizes, scales=tuple(SCALES), is_rounded=True)
    return [
        scaled("turned grid", "grids", turned_grid, grows_well=False),
        scaled("turned rooms", "grids", turned_rooms),
        scaled("tees on a slant", "junctions", tees),
        Family("fan of many", "junctions", fan, sizes=sizes, grows_well=False),
        Family("random", "random", random_segments, sizes=sizes, scales=("unit", "UTM")),
    ]


def plan_families() -> list[Family]:
    """Floor plans with known rooms: as drawn, turned, and turned with three decimals as CAD files
    have them."""
    result = []
    for name, title in _PLANS.items():
        drawn, turned = (functools.partial(of_program, name, t) for t in (False, True))
        result += [
            Family(title, "plans", drawn, scales=_PLAN_SCALES, is_rounded=True),
            Family(f"{title}, turned", "plans", turned, scales=_PLAN_SCALES, is_rounded=True),
            Family(f"{title}, turned, 3 decimals", "plans", turned, is_rounded=True, decimals=3),
        ]
    return result


_MOST_SEEDS = {"near pencils": 3}


def campaign_families() -> list[Family]:
    """Small inputs that hurt an arrangement, each family in its own way."""
    names = [name for name in campaign_names() if name not in _PLANS]
    return [
        Family(
            name,
            "campaign",
            functools.partial(of_program, name, False),
            most_seeds=_MOST_SEEDS.get(name),
        )
        for name in names
    ]


def drawing_families(folder: Path) -> list[Family]:
    """Drawings of people below a folder, by the names of their files."""
    files = sorted(p for p in folder.rglob("*") if p.suffix in (".svg", ".dxf", ".lines"))
    return [
        Family(
            f"drawing {p.relative_to(folder)}",
            "drawings",
            functools.partial(of_file, p),
            scales=("unit", "UTM"),
        )
        for p in files
    ]


def ulp_maps() -> list[Family]:
    return [
        Family("ulp map of a tee", "ulp maps", ulp_tee),
        Family("ulp map of a fan", "ulp maps", ulp_fan),
    ]
