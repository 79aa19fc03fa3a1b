"""Arrangements by hand: all pairs of segments, in fractions, with nothing but Python.

It shares no line with the project, and none with an engine: what it and a recorded answer disagree
about is wrong in the answer, or here, in the hundred lines that follow.

    python3 by_hand.py FINDING...    what is exact, what the engine said, and whether they agree
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cmp_to_key, partial
from itertools import pairwise
from pathlib import Path
from typing import Any

Point = tuple[Fraction, Fraction]
Segment = tuple[Point, Point]


def cross(o: Point, a: Point, b: Point) -> Fraction:
    """Twice the area of a triangle, positive where it turns left."""
    return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0])


def is_on(p: Point, s: Segment) -> bool:
    """Whether a point lies on a segment."""
    a, b = s
    inside = min(a[0], b[0]) <= p[0] <= max(a[0], b[0]) and min(a[1], b[1]) <= p[1] <= max(
        a[1], b[1]
    )
    return inside and cross(a, b, p) == 0


def meetings(s: Segment, t: Segment) -> set[Point]:
    """The points in which two segments cross; where they overlap, the ends of the overlap."""
    found = {p for p in t if is_on(p, s)} | {p for p in s if is_on(p, t)}
    (a, b), (c, d) = s, t
    one, two = cross(a, b, c), cross(a, b, d)
    if one * two < 0 and cross(c, d, a) * cross(c, d, b) < 0:
        part = one / (one - two)
        found.add((c[0] + part * (d[0] - c[0]), c[1] + part * (d[1] - c[1])))
    return found


@dataclass(frozen=True)
class Cells:
    """Vertices, edges, and twice the areas of the bounded faces, holes not subtracted."""

    vertices: frozenset[Point]
    edges: frozenset[Segment]
    areas: tuple[Fraction, ...]

    @property
    def numbers(self) -> tuple[int, int, int]:
        return len(self.vertices), len(self.edges), len(self.areas)


def arranged(segments: Iterable[Segment]) -> Cells:
    """The cells that segments cut the plane into."""
    drawn = sorted({(min(s), max(s)) for s in segments if s[0] != s[1]})
    edges: set[Segment] = set()
    for s in drawn:
        points = sorted({p for t in drawn for p in meetings(s, t)} | set(s))
        edges.update(pairwise(points))
    return Cells(frozenset(p for e in edges for p in e), frozenset(edges), areas(edges))


def areas(edges: Iterable[Segment]) -> tuple[Fraction, ...]:
    """Twice the area of each face, found by walking with the face on the left."""
    around: dict[Point, list[Point]] = {}
    for a, b in edges:
        around.setdefault(a, []).append(b)
        around.setdefault(b, []).append(a)
    for p, ends in around.items():
        ends.sort(key=cmp_to_key(partial(_turns, p)))
    left = {(a, b) for a, ends in around.items() for b in ends}
    found = []
    while left:
        first = here = min(left)
        twice = Fraction(0)
        while here in left:
            left.remove(here)
            a, b = here
            twice += a[0] * b[1] - a[1] * b[0]
            ends = around[b]
            here = (b, ends[ends.index(a) - 1])  # the next one clockwise
        assert here == first
        if twice > 0:
            found.append(twice)
    return tuple(sorted(found))


def _turns(p: Point, a: Point, b: Point) -> int:
    """Order by angle, from the direction of x on."""
    upper_a, upper_b = (q[1] < p[1] or (q[1] == p[1] and q[0] < p[0]) for q in (a, b))
    if upper_a != upper_b:
        return 1 if upper_a else -1
    return -1 if cross(p, a, b) > 0 else 1


def rounded(cells: Cells) -> Cells | None:
    """The same cells with every vertex at the nearest doubles; None where they are others then."""
    near = {p: (Fraction(float(p[0])), Fraction(float(p[1]))) for p in cells.vertices}
    moved = arranged((near[a], near[b]) for a, b in cells.edges)
    expected = frozenset((min(near[a], near[b]), max(near[a], near[b])) for a, b in cells.edges)
    return moved if moved.edges == expected and len(moved.areas) == len(cells.areas) else None


def exact(rows: Iterable[Sequence[float]]) -> list[Segment]:
    """Doubles as the fractions that they are."""
    return [((Fraction(ax), Fraction(ay)), (Fraction(bx), Fraction(by))) for ax, ay, bx, by in rows]


def numbers_said(model: dict[str, Any]) -> tuple[int, int, int | None]:
    """Vertices that edges have, edges, bounded faces of an answer; None: it has no faces."""
    pairs = {(min(e), max(e)) for e in model["EV"]}
    faces = next((len(model[name]) for name in ("polygons", "FV") if name in model), None)
    return len({v for e in pairs for v in e}), len(pairs), faces


@dataclass(frozen=True)
class Verdict:
    """Of one recorded answer."""

    right: tuple[int, int, int]
    said: tuple[int, int, int | None]
    fits: bool
    """Whether the nearest doubles hold a right answer."""

    @property
    def is_wrong(self) -> bool:
        """By numbers of cells alone: equal numbers prove nothing."""
        return any(s is not None and s != r for r, s in zip(self.right, self.said))


def verdict(finding: dict[str, Any]) -> Verdict:
    cells = arranged(exact(finding["segments"]))
    return Verdict(cells.numbers, numbers_said(finding["model"]), rounded(cells) is not None)


def main(files: list[str]) -> int:
    if not files or files[0] in ("-h", "--help"):
        print(__doc__)
        return 0 if files else 2
    for name in files:
        found = verdict(json.loads(Path(name).read_text(encoding="utf-8")))
        said = ", ".join("-" if n is None else str(n) for n in found.said)
        right = ", ".join(map(str, found.right))
        word = "wrong" if found.is_wrong else "no difference in numbers"
        fits = "" if found.fits else "; the nearest doubles do not hold the right answer"
        print(f"{name}: vertices, edges, faces: exact {right}; said {said}; {word}{fits}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
