"""Regions of rings, exactly: which faces of an arrangement a fill rule fills, and their boundary.

The winding number of each face follows from that of the unbounded one, 0, over the edges: each
ring's side that covers an edge adds 1 to the face on its left. No point within a face is needed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from typing import Any

import numpy as np
import plumbline
from numpy.typing import NDArray
from plumbline import Arrangement
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

Ints = NDArray[np.int64]
Mask = NDArray[np.bool_]
Floats = NDArray[np.float64]
Point = tuple[Any, Any]
"""Of doubles or fractions."""
Side = tuple[Any, Any, Any, Any]
ExactPoint = tuple[Fraction, Fraction]
ExactSide = tuple[Fraction, Fraction, Fraction, Fraction]
Rule = str
"""evenodd or nonzero."""

FILLED: dict[Rule, Callable[[Ints], Mask]] = {
    "evenodd": lambda winding: winding % 2 != 0,
    "nonzero": lambda winding: winding != 0,
}


class Inconsistent(Exception):
    """Winding numbers do not agree around a vertex: a fault of this project."""


def sides_of(ring: Sequence[Point]) -> list[Side]:
    """Without those of no length, which repeated vertices make."""
    return [(*a, *b) for a, b in zip(ring, [*ring[1:], *ring[:1]]) if tuple(a) != tuple(b)]


def arranged(sides: Sequence[Side]) -> Arrangement | None:
    """None where there is nothing."""
    return plumbline.arrange(sides, numbers="doubles", threads=1) if sides else None


def directions(sides: Iterable[Side]) -> Ints:
    """1 for sides that run as the edges which they cover, from the lesser end to the greater one;
    -1 for others."""
    return np.array([1 if s[:2] < s[2:] else -1 for s in sides], dtype=np.int64)


def jumps(of: Arrangement, weights: Ints) -> Ints:
    """Per edge by how much a winding number on its left is greater than that on its right, of
    sides with weights: their directions, or 0 for those that do not count."""
    covering = of.edge_segments
    counts: Ints = np.diff(covering.indptr).astype(np.int64)
    edge = np.repeat(np.arange(len(of.edges)), counts)
    result = np.zeros(len(of.edges), dtype=np.int64)
    np.add.at(result, edge, weights[covering.indices])
    return result


def winding_numbers(of: Arrangement, jump: Ints, modulo: int | None = None) -> Ints:
    """Per face, from the unbounded one on. Throws: Inconsistent."""
    left, right = _left_and_right(of)
    neighbours: list[list[tuple[int, int]]] = [[] for _ in range(of.counts.faces)]
    for a, b, j in zip(left.tolist(), right.tolist(), jump.tolist()):
        neighbours[b].append((a, j))
        neighbours[a].append((b, -j))
    winding: dict[int, int] = {0: 0}
    waiting = [0]
    while waiting:
        face = waiting.pop()
        for other, j in neighbours[face]:
            there = winding[face] + j if modulo is None else (winding[face] + j) % modulo
            if other not in winding:
                winding[other] = there
                waiting.append(other)
            elif winding[other] != there:
                raise Inconsistent(f"face {other} of {of!r}")
    return np.array([winding[face] for face in range(of.counts.faces)], dtype=np.int64)


def _left_and_right(of: Arrangement) -> tuple[Ints, Ints]:
    faces = of.halfedge_face.astype(np.int64)
    return faces[::2], faces[1::2]


@dataclass(frozen=True)
class Region:
    """Some faces of an arrangement, which is None where nothing is drawn."""

    arrangement: Arrangement | None
    is_inside: Mask
    """Per face; the unbounded one is not."""

    @cached_property
    def is_boundary(self) -> Mask:
        """Per edge, whether the region is on one side of it alone."""
        if self.arrangement is None:
            return np.zeros(0, dtype=bool)
        left, right = _left_and_right(self.arrangement)
        return np.asarray(self.is_inside[left] != self.is_inside[right])

    @cached_property
    def area(self) -> Fraction:
        if self.arrangement is None:
            return Fraction(0)
        areas = self.arrangement.areas
        return sum((areas[f] for f in np.flatnonzero(self.is_inside)), Fraction(0))

    @cached_property
    def parts_and_holes(self) -> tuple[int, int]:
        """Numbers of pieces of the region, and of what is left of the plane without the unbounded
        piece. Faces that share an edge are of one piece; those that share a vertex need not be."""
        if self.arrangement is None:
            return 0, 0
        left, right = _left_and_right(self.arrangement)
        within = ~self.is_boundary
        count = self.arrangement.counts.faces
        ones = np.ones(int(within.sum()))
        graph = coo_array((ones, (left[within], right[within])), shape=(count, count))
        _, piece = connected_components(graph, directed=False)
        inside = np.unique(piece[self.is_inside])
        return len(inside), len(np.unique(piece[~self.is_inside])) - 1

    @cached_property
    def boundary(self) -> Graph:
        """Its boundary edges, exactly, without vertices at which they go on straight."""
        if self.arrangement is None:
            return Graph({}, [])
        vertices = self.arrangement.points
        edges = self.arrangement.edges[self.is_boundary].tolist()
        return Graph({v: vertices[v] for v in {v for e in edges for v in e}}, edges).straightened()

    @cached_property
    def boundary_arrangement(self) -> Arrangement | None:
        """None where there is none."""
        sides = self.boundary.sides
        return plumbline.arrange(sides, threads=1) if sides else None

    @cached_property
    def perimeter(self) -> float:
        return sum(_length(*side) for side in self.boundary.sides)


class Graph:
    """Vertices at exact places and edges between them."""

    def __init__(self, places: dict[int, ExactPoint], edges: Iterable[Sequence[int]]) -> None:
        self.places = dict(places)
        self._neighbours: dict[int, set[int]] = {v: set() for v in places}
        for a, b in edges:
            self._neighbours[a].add(b)
            self._neighbours[b].add(a)

    @property
    def edges(self) -> list[tuple[int, int]]:
        return [(a, b) for a, of in self._neighbours.items() for b in of if a < b]

    @property
    def sides(self) -> list[ExactSide]:
        return [(*self.places[a], *self.places[b]) for a, b in self.edges]

    def straightened(self) -> Graph:
        """Without vertices between two edges that are one line."""
        return self.without(self.places, _is_between)

    def without(
        self,
        vertices: Iterable[int],
        is_needless: Callable[[ExactPoint, ExactPoint, ExactPoint], bool],
    ) -> Graph:
        """Without those of the vertices that have two edges and are needless between the other
        ends of these, as they are then; these are joined, unless they are already."""
        candidates = [v for v in vertices if len(self._neighbours[v]) == 2]
        if not candidates:
            return self
        result = Graph(self.places, self.edges)
        joined, places = result._neighbours, result.places
        for v in candidates:
            if len(joined[v]) != 2:
                continue
            a, b = joined[v]
            if b in joined[a] or not is_needless(places[a], places[v], places[b]):
                continue
            joined[a].remove(v)
            joined[b].remove(v)
            joined[a].add(b)
            joined[b].add(a)
            del joined[v], places[v]
        return result


def _is_between(a: ExactPoint, v: ExactPoint, b: ExactPoint) -> bool:
    (ax, ay), (vx, vy), (bx, by) = a, v, b
    cross = (vx - ax) * (by - vy) - (vy - ay) * (bx - vx)
    return cross == 0 and (vx - ax) * (bx - vx) + (vy - ay) * (by - vy) > 0


def _length(ax: Any, ay: Any, bx: Any, by: Any) -> float:
    return float(np.hypot(float(bx - ax), float(by - ay)))


def region_of(rings: Iterable[Sequence[Point]], rule: Rule) -> Region:
    """What rings of doubles fill under a rule."""
    sides = [side for ring in rings for side in sides_of(ring)]
    arrangement = arranged(sides)
    if arrangement is None:
        return Region(None, np.zeros(1, dtype=bool))
    winding = winding_numbers(arrangement, jumps(arrangement, directions(sides)))
    return Region(arrangement, FILLED[rule](winding))


@dataclass(frozen=True)
class Difference:
    """Of two regions the faces that are of one alone: areas and perimeters, rounded."""

    areas: Floats
    perimeters: Floats

    @property
    def area(self) -> float:
        return float(self.areas.sum())


def difference(first: Graph, second: Graph) -> Difference:
    """Of the regions with these boundaries: arranged together, exactly."""
    both = [first.sides, second.sides]
    if not any(both):
        return Difference(np.zeros(0), np.zeros(0))
    together = plumbline.arrange([*both[0], *both[1]], threads=1)
    is_of_first = np.repeat([1, 0], [len(of) for of in both])
    # Sides count without directions: who crosses a boundary goes in or out.
    inside = [
        winding_numbers(together, jumps(together, w), 2) for w in (is_of_first, 1 - is_of_first)
    ]
    found = inside[0] != inside[1]
    return Difference(together.area[found], together.perimeter[found])
