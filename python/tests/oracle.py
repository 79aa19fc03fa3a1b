"""An arrangement's numbers by comparing all pairs in fractions: slow, and independent of the
library."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from itertools import pairwise

Point = tuple[Fraction, Fraction]
Segment = tuple[Point, Point]


def counts(segments: Iterable[Segment]) -> tuple[int, int, int]:
    """Vertices, edges, bounded faces of the arrangement of the segments."""
    lines = [s for s in segments if s[0] != s[1]]
    edges: set[tuple[Point, Point]] = set()
    boxes = [_box(s) for s in lines]
    for s, box in zip(lines, boxes):
        cuts = set(s)
        for t, other in zip(lines, boxes):
            if (
                box[0] <= other[2]
                and other[0] <= box[2]
                and box[1] <= other[3]
                and other[1] <= box[3]
            ):
                cuts.update(_common_points(s, t))
        chain = sorted(cuts)
        edges.update(pairwise(chain))
    vertices = {p for edge in edges for p in edge}
    return len(vertices), len(edges), len(edges) - len(vertices) + _components(vertices, edges)


def _box(s: Segment) -> tuple[Fraction, Fraction, Fraction, Fraction]:
    (ax, ay), (bx, by) = s
    return min(ax, bx), min(ay, by), max(ax, bx), max(ay, by)


def _cross(p: Point, q: Point, r: Point) -> Fraction:
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def _on(p: Point, s: Segment) -> bool:
    return _cross(s[0], s[1], p) == 0 and min(s) <= p <= max(s)


def _common_points(s: Segment, t: Segment) -> set[Point]:
    """Where t cuts s: ends that lie on the other one, a crossing."""
    points = {p for p in t if _on(p, s)} | {p for p in s if _on(p, t)}
    c, d = _cross(s[0], s[1], t[0]), _cross(s[0], s[1], t[1])
    a, b = _cross(t[0], t[1], s[0]), _cross(t[0], t[1], s[1])
    if c * d < 0 and a * b < 0:
        u = a / (a - b)
        points.add((s[0][0] + u * (s[1][0] - s[0][0]), s[0][1] + u * (s[1][1] - s[0][1])))
    return points


def _components(vertices: set[Point], edges: set[tuple[Point, Point]]) -> int:
    parent = {v: v for v in vertices}

    def root(v: Point) -> Point:
        while parent[v] != v:
            parent[v] = parent[parent[v]]
            v = parent[v]
        return v

    for p, q in edges:
        parent[root(p)] = root(q)
    return sum(parent[v] == v for v in vertices)
