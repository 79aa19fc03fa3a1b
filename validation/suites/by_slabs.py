"""Areas of combinations of regions, by vertical slabs between all corners and crossings, in
fractions: every pair of sides is intersected, no code of the library takes part."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from gmpy2 import mpq

Number = Any  # an mpq
Side = tuple[Number, Number, Number, Number, int, int, int]  # from left to right; layer, shape, way
INSIDE: dict[str, Callable[[int], bool]] = {
    "evenodd": lambda w: w % 2 != 0,
    "nonzero": lambda w: w != 0,
    "positive": lambda w: w > 0,
    "negative": lambda w: w < 0,
}


class TooLarge(Exception):
    """More work than is worth it."""


def sides_of(layers: Sequence[Sequence[Sequence[Sequence[Any]]]]) -> list[Side]:
    """The sides of all rings that are not vertical."""
    sides = []
    for n, layer in enumerate(layers):
        for s, shape in enumerate(layer):
            for ring in shape:
                points = [(mpq(x), mpq(y)) for x, y in ring]
                for (ax, ay), (bx, by) in zip(points, points[1:] + points[:1]):
                    if ax < bx:
                        sides.append((ax, ay, bx, by, n, s, 1))
                    elif ax > bx:
                        sides.append((bx, by, ax, ay, n, s, -1))
    return sides


def _crossings(sides: list[Side]) -> set[Number]:
    """The x of all points where two sides cross."""
    found = set()
    by_left = sorted(sides)
    for i, (ax, ay, bx, by, *_) in enumerate(by_left):
        low, high = min(ay, by), max(ay, by)
        for cx, cy, dx, dy, *_ in by_left[i + 1 :]:
            if cx >= bx:
                break
            if max(cy, dy) < low or min(cy, dy) > high:
                continue
            ux, uy, vx, vy = bx - ax, by - ay, dx - cx, dy - cy
            cross = ux * vy - uy * vx
            if cross == 0:
                continue
            x = ax + ux * ((cx - ax) * vy - (cy - ay) * vx) / cross
            if max(ax, cx) < x < min(bx, dx):
                found.add(x)
    return found


def areas(
    layers: Sequence[Any], rules: Sequence[str], wanted: Sequence[Callable[..., bool]], most: int
) -> list[Number]:
    """Per function of (is in the first layer, is in the second, ...) the area of where it is true.
    A layer is where any of its shapes is. TooLarge for more than `most` steps."""
    sides = sides_of(layers)
    if len(sides) ** 2 > 40 * most:
        raise TooLarge
    events = sorted(_crossings(sides) | {side[0] for side in sides} | {side[2] for side in sides})
    sides.sort()
    sums = [mpq(0) for _ in wanted]
    active: list[Side] = []
    next_side = steps = 0
    for left, right in zip(events, events[1:]):
        active = [side for side in active if side[2] > left]
        while next_side < len(sides) and sides[next_side][0] <= left:
            active.append(sides[next_side])
            next_side += 1
        steps += len(active)
        if steps > most:
            raise TooLarge
        _add_slab(active, left, right, rules, wanted, sums)
    return sums


def _add_slab(
    active: list[Side],
    left: Number,
    right: Number,
    rules: Sequence[str],
    wanted: Sequence[Callable[..., bool]],
    sums: list[Number],
) -> None:
    def height(side: Side, x: Number) -> Number:
        ax, ay, bx, by = side[:4]
        return ay + (by - ay) * (x - ax) / (bx - ax)

    middle = (left + right) / 2  # no sides cross within the slab: trapezoids by their middles
    rows = sorted((height(side, middle), side[4:]) for side in active)
    winding: dict[tuple[int, int], int] = {}
    count = [0] * len(rules)
    for i, (y, (layer, shape, way)) in enumerate(rows):
        was = INSIDE[rules[layer]](winding.get((layer, shape), 0))
        winding[layer, shape] = winding.get((layer, shape), 0) + way
        count[layer] += INSIDE[rules[layer]](winding[layer, shape]) - was
        if i + 1 == len(rows) or rows[i + 1][0] == y:
            continue
        holds = [n > 0 for n in count]
        part = (rows[i + 1][0] - y) * (right - left)
        for k, function in enumerate(wanted):
            if function(*holds):
                sums[k] += part
