"""Regions of rings in Fractions, by a way of its own that uses nothing of the project: between two
neighbouring vertices or crossings in x, sides do not meet, so a region is trapezoids there."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import pairwise

Side = tuple[Fraction, Fraction, Fraction, Fraction, int]
"""From left to right, and 1 if the ring runs so, else -1."""
Trapezoid = tuple[Fraction, Fraction, Fraction, Fraction]
"""Lower and upper ends on the left, then on the right."""
FAR = Fraction(10**12)
FILLED: dict[str, Callable[[int], bool]] = {
    "evenodd": lambda winding: winding % 2 == 1,
    "nonzero": lambda winding: winding != 0,
}


def area_and_parts(
    rings: Sequence[Sequence[Sequence[float]]], rule: str
) -> tuple[Fraction, int, int]:
    """The area, the number of pieces, and of pieces of what is outside without the unbounded one.
    Pieces that touch at a point are two."""
    sides = [side for ring in rings for side in _sides(ring)]
    cuts = sorted({x for s in sides for x in (s[0], s[2])} | _crossings(sides))
    area = Fraction(0)
    pieces = _Pieces()
    beyond: list[tuple[Trapezoid, bool, int]] = [((-FAR, FAR, -FAR, FAR), False, 0)]
    slabs = [(*cut, _slab(sides, *cut, rule, pieces)) for cut in pairwise(cuts)]
    before = beyond
    for left, right, here in [*slabs, (FAR, FAR, beyond)]:
        area += sum(_area(t, left, right) for t, inside, _ in here if inside)
        for t, inside, piece in here:
            for old, was_inside, other in before:
                if inside == was_inside and max(t[0], old[2]) < min(t[1], old[3]):
                    pieces.join(piece, other)
        before = here
    return area, *pieces.counted()


class _Pieces:
    """Trapezoids that hang together; 0 is the unbounded outside."""

    def __init__(self) -> None:
        self._root = [0]
        self._inside = [False]

    def add(self, inside: bool) -> int:
        self._root.append(len(self._root))
        self._inside.append(inside)
        return len(self._root) - 1

    def find(self, k: int) -> int:
        while self._root[k] != k:
            k = self._root[k]
        return k

    def join(self, a: int, b: int) -> None:
        a, b = sorted((self.find(a), self.find(b)))
        self._root[b] = a

    def counted(self) -> tuple[int, int]:
        roots = [k for k in range(len(self._root)) if self._root[k] == k]
        inside = sum(self._inside[k] for k in roots)
        return inside, len(roots) - inside - 1


def _sides(ring: Sequence[Sequence[float]]) -> list[Side]:
    exact = [(Fraction(x), Fraction(y)) for x, y in ring]
    found = []
    for a, b in zip(exact, [*exact[1:], *exact[:1]]):
        if a[0] != b[0]:
            found.append((*a, *b, 1) if a < b else (*b, *a, -1))
    return found


def _crossings(sides: list[Side]) -> set[Fraction]:
    found = set()
    for i, (ax, ay, bx, by, _) in enumerate(sides):
        for cx, cy, dx, dy, _ in sides[:i]:
            cross = (bx - ax) * (dy - cy) - (by - ay) * (dx - cx)
            if cross:
                t = ((cx - ax) * (dy - cy) - (cy - ay) * (dx - cx)) / cross
                x = ax + t * (bx - ax)
                if max(ax, cx) <= x <= min(bx, dx):
                    found.add(x)
    return found


def _height(s: Side, x: Fraction) -> Fraction:
    return s[1] + (s[3] - s[1]) * (x - s[0]) / (s[2] - s[0])


def _slab(
    sides: list[Side], left: Fraction, right: Fraction, rule: str, pieces: _Pieces
) -> list[tuple[Trapezoid, bool, int]]:
    """Trapezoids between sides, each with whether it is inside, and its piece. Above and below all
    is the outside, a trapezoid that is high enough for whatever is beside it."""
    heights = sorted(
        (_height(s, left), _height(s, right), s[4]) for s in sides if s[0] <= left and right <= s[2]
    )
    found: list[tuple[Trapezoid, bool, int]] = []
    low, winding, piece, inside = (-FAR, -FAR), 0, 0, False
    for at_left, at_right, direction in [*heights, (FAR, FAR, 0)]:
        if (at_left, at_right) != low:
            is_filled = FILLED[rule](winding)
            is_end = at_left == FAR or low[0] == -FAR
            if not found or is_filled != inside:
                piece = 0 if is_end else pieces.add(is_filled)
            elif is_end:
                pieces.join(piece, 0)
            inside = is_filled
            found.append(((low[0], at_left, low[1], at_right), is_filled, piece))
            low = (at_left, at_right)
        winding += direction
    return found


def _area(t: Trapezoid, left: Fraction, right: Fraction) -> Fraction:
    return (t[1] - t[0] + t[3] - t[2]) * (right - left) / 2
