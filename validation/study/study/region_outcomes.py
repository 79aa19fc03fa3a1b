"""What an answer of an engine of rings is, held against the exact region: outcomes as in
`study.outcomes`.

*invalid*: the answer by itself is no region. Its outer rings counter-clockwise and its holes
clockwise, a point is to be within 1 or 0 of them; rings that cross, overlap, or are holes of
nothing make it 2 or -1. Sides that lie on each other bound nothing. Touching is permitted. Rings
of which an engine does not say what they are count as even-odd, and cross nowhere.
*topology*: it is a region, but another one: pieces, holes or boundary edges lost or invented.
*moved* and *identical*: the same pieces, holes, boundary vertices and edges; *moved* also where
rings cross by no more than the last places of coordinates.

Vertices of two edges that are one line are left out of both sides, so that it does not matter
whether an engine keeps them.
"""

from __future__ import annotations

import math
import warnings
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np
import plumbline
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from study.engines import Configuration, Reply
from study.outcomes import FURTHEST, IDENTICAL, Judgement, gravest
from study.regions import (
    Difference,
    ExactPoint,
    ExactSide,
    Graph,
    Ints,
    Point,
    Region,
    Side,
    arranged,
    difference,
    directions,
    jumps,
    sides_of,
    winding_numbers,
)

Floats = NDArray[np.float64]
_FACTORS = (10.0, 100.0, FURTHEST)
_REACH = 4.0
"""Grid distances within which an answer on a grid has to stay. Rounding a point moves it by 0.71 of
one: ends first, and crossings then. Sides that are cut and bent several times may move further."""


@dataclass(frozen=True)
class Answer:
    """A region as an engine says it, and what is wrong with it by itself."""

    region: Region
    fault: str


class Unreadable(Exception):
    """A model that is none."""


def answer_of(model: dict[str, Any], grid: Fraction | None = None) -> Answer:
    """Of points of a grid, but for rounding, the doubles stand for these. Throws: Unreadable."""
    rings = _oriented_rings(model, grid)
    sides = [side for ring in rings for side in sides_of(ring)]
    is_doubles = grid is None
    arrangement = arranged(sides) if is_doubles else _arranged_exactly(list(map(_exact, sides)))
    if arrangement is None:
        return Answer(Region(None, np.zeros(1, dtype=bool)), "")
    jump = jumps(arrangement, directions(sides))
    if "rings" in model:
        return _even_odd(arrangement, jump, sides)
    winding = winding_numbers(arrangement, jump)
    fault = ""
    if winding.max() > 1:
        fault = "rings overlap"
    elif winding.min() < 0:
        fault = "turned over"
    elif not jump.all():
        fault = "sides on each other"
    return Answer(Region(arrangement, winding > 0), fault)


def _even_odd(arrangement: plumbline.Arrangement, jump: Ints, sides: list[Side]) -> Answer:
    """Of rings that are said without what they are: those that cross each other have vertices
    which no ring has."""
    inside = winding_numbers(arrangement, jump, 2) == 1
    ends = {tuple(map(Fraction, end)) for s in sides for end in (s[:2], s[2:])}
    fault = "" if (jump % 2).all() else "sides on each other"
    if not ends.issuperset(tuple(p) for p in arrangement.points):
        fault = "rings cross"
    return Answer(Region(arrangement, inside), fault)


def _exact(side: Side) -> ExactSide:
    a, b, c, d = side
    return Fraction(a), Fraction(b), Fraction(c), Fraction(d)


def _arranged_exactly(sides: Sequence[ExactSide]) -> plumbline.Arrangement | None:
    return plumbline.arrange(sides, threads=1) if sides else None


def _oriented_rings(model: dict[str, Any], grid: Fraction | None) -> list[list[Point]]:
    """Outer rings counter-clockwise, holes clockwise, where the model says which is which."""
    try:
        places: list[Point] = [(float(x), float(y)) for x, y in model["V"]]
        if not np.isfinite(np.array(places, dtype=np.float64)).all():
            raise Unreadable("coordinates are not finite")
        if grid is not None:
            places = _on_grid(places, grid)
        if "rings" in model:
            return [[places[_index(v)] for v in ring] for ring in model["rings"]]
        result = []
        for polygon in model["polygons"]:
            for k, ring in enumerate(polygon):
                points = [places[_index(v)] for v in ring]
                is_right = (_twice_area(points) > 0) == (k == 0)
                result.append(points if is_right else points[::-1])
        return result
    except (IndexError, KeyError, TypeError, ValueError) as error:
        raise Unreadable(repr(error)) from error


def _index(v: Any) -> int:
    if not isinstance(v, int) or v < 0:
        raise ValueError(f"no index: {v!r}")
    return v


def _on_grid(places: list[Point], grid: Fraction) -> list[Point]:
    """The points of the grid that doubles were rounded from, if all of them were."""
    nearest = [tuple(round(Fraction(c) / grid) * grid for c in place) for place in places]
    largest = max((abs(c) for place in places for c in place), default=0.0)
    pairs = zip(nearest, places)
    is_rounding = all(abs(n - c) <= IDENTICAL * largest for at, p in pairs for n, c in zip(at, p))
    return [(x, y) for x, y in nearest] if is_rounding else places


def _twice_area(ring: list[Point]) -> Fraction:
    exact = [(Fraction(x), Fraction(y)) for x, y in ring]
    pairs = zip(exact, [*exact[1:], *exact[:1]])
    return sum((a[0] * b[1] - a[1] * b[0] for a, b in pairs), Fraction(0))


def judge_region(reply: Reply, truth: Region, tolerance: float, largest: float) -> Judgement:
    """`largest` coordinate of the rings: what rounding is measured by."""
    if reply.ending != "model":
        kind = reply.message.partition(":")[0]
        return Judgement(reply.ending, kind, message=reply.message[:300])
    assert reply.model is not None
    try:
        answer = answer_of(reply.model)
    except Unreadable as error:
        return Judgement("invalid", "unreadable", message=str(error)[:300])
    off = difference(truth.boundary, answer.region.boundary).area
    parts, holes = answer.region.parts_and_holes
    edges = len(answer.region.boundary.edges)
    told = partial(Judgement, vertices=len(answer.region.boundary.places), edges=edges, faces=parts)
    told = partial(told, area=off, tolerance=tolerance)
    if answer.fault:
        rounding = IDENTICAL * largest
        is_right = off <= rounding * truth.perimeter and _is_rounding(reply.model, truth, rounding)
        return told("moved" if is_right else "invalid", answer.fault)
    counts, displacement = _compared(truth, answer.region, tolerance)
    all_kinds = ", ".join(f"{' '.join(kind)} {n}" for kind, n in sorted(counts.items()))
    told = partial(told, all_kinds=all_kinds, displacement=displacement)
    kind = _other_structure(truth.parts_and_holes, (parts, holes))
    wrong = Compared(counts).wrong
    if kind or wrong:
        return told("topology", kind or gravest(wrong))
    rounding = IDENTICAL * largest
    is_moved = bool(counts) or displacement > rounding or off > rounding * truth.perimeter
    return told("moved" if is_moved else "identical")


def _is_rounding(model: dict[str, Any], truth: Region, rounding: float) -> bool:
    """Whether the rings' own vertices and sides are those of the exact boundary, each vertex where
    it should be but for the last places of coordinates; their directions do not matter."""
    sides = [_exact(side) for ring in _oriented_rings(model, None) for side in sides_of(ring)]
    number = {place: k for k, place in enumerate({p for s in sides for p in (s[:2], s[2:])})}
    pairs = [(number[s[:2]], number[s[2:]]) for s in sides]
    if len({frozenset(pair) for pair in pairs}) != len(pairs):
        return False  # sides on each other
    said = Graph({k: place for place, k in number.items()}, _split(pairs, list(number), rounding))
    exact, said = _comparable(truth.boundary, said, rounding)
    if len(exact.places) != len(said.places) or not exact.places:
        return False
    there, here = (_rounded(of.places.values()) for of in (exact, said))
    distances, nearest = (np.atleast_1d(x) for x in cKDTree(there).query(here))
    numbers = list(exact.places)
    of = {v: numbers[int(k)] for v, k in zip(said.places, nearest)}
    edges = {frozenset((of[a], of[b])) for a, b in said.edges}
    is_near = bool((distances <= rounding).all()) and len(set(of.values())) == len(of)
    return is_near and edges == {frozenset(e) for e in exact.edges}


def _split(
    pairs: list[tuple[int, int]], places: list[ExactPoint], rounding: float
) -> list[tuple[int, int]]:
    """Sides at vertices that touch them, but for rounding."""
    points = _rounded(places)
    result: list[tuple[int, int]] = []
    for a, b in pairs:
        d = points[b] - points[a]
        along = (points - points[a]) @ d / (d @ d)
        across = np.hypot(*(points - points[a] - np.outer(along, d)).T)
        touching = np.flatnonzero((across <= rounding) & (along > 0) & (along < 1))
        inner = [int(v) for v in touching[np.argsort(along[touching])] if v not in (a, b)]
        result += pairwise([a, *inner, b])
    return result


def _other_structure(exact: tuple[int, int], said: tuple[int, int]) -> str:
    for name, there, here in zip(("part", "hole"), exact, said):
        if there != here:
            return f"{name} lost" if here < there else f"{name} invented"
    return ""


def _compared(
    truth: Region, answer: Region, tolerance: float
) -> tuple[Counter[tuple[str, str]], float]:
    """Findings of two boundaries by kind and disagreement, and the largest displacement.

    Where the cells are the same ones if vertices match within more, up to `FURTHEST` times the
    tolerance, they are moved.
    """
    first = _compared_within(truth, answer, tolerance)
    furthest = _FACTORS[-1] * tolerance
    if not first.wrong and first.displacement > furthest:
        return first.counts + Counter({("vertex", "moved far"): 1}), first.displacement
    if first.wrong and truth.parts_and_holes == answer.parts_and_holes:
        for factor in _FACTORS:
            found = _compared_within(truth, answer, factor * tolerance)
            if not found.wrong and found.displacement <= furthest:
                return Counter({("vertex", "moved"): 1}), found.displacement
    return first.counts, first.displacement


@dataclass(frozen=True)
class Compared:
    counts: Counter[tuple[str, str]]
    displacement: float = 0.0

    @property
    def wrong(self) -> set[tuple[str, str]]:
        return {kind for kind in self.counts if kind[1] not in ("moved", "reshaped")}


def _compared_within(truth: Region, answer: Region, tolerance: float) -> Compared:
    exact, said = _comparable(truth.boundary, answer.boundary, tolerance)
    if not exact.edges or not said.edges:
        found = {("edge", "missing"): len(exact.edges), ("edge", "extra"): len(said.edges)}
        return Compared(Counter({kind: n for kind, n in found.items() if n}))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", plumbline.LossWarning)
        arrangements = [
            of.boundary_arrangement if graph is of.boundary else _arranged_exactly(graph.sides)
            for graph, of in ((exact, truth), (said, answer))
        ]
        assert arrangements[0] is not None and arrangements[1] is not None
        check = plumbline.check(arrangements[1], arrangements[0], tolerance=tolerance, threads=1)
    moved = [f.distance or 0.0 for f in check.findings if f.disagreement == "moved"]
    displacement = max([check.largest_displacement, *moved])
    return Compared(Counter((f.kind, f.disagreement) for f in check.findings), displacement)


def _comparable(exact: Graph, said: Graph, tolerance: float) -> tuple[Graph, Graph]:
    """Without vertices of two edges that are nearly one line and that the other one does not have:
    whether they are exactly straight is a matter of rounding."""
    needless = partial(_is_nearly_between, tolerance=tolerance)
    alone = _without_like(exact, said, tolerance), _without_like(said, exact, tolerance)
    return exact.without(alone[0], needless), said.without(alone[1], needless)


def _without_like(of: Graph, others: Graph, tolerance: float) -> list[int]:
    """Vertices that have none of the others within the tolerance."""
    if not others.places:
        return list(of.places)
    distances, _ = cKDTree(_rounded(others.places.values())).query(_rounded(of.places.values()))
    return [v for v, d in zip(of.places, np.atleast_1d(distances)) if d > tolerance]


def _rounded(points: Iterable[Point]) -> Floats:
    return np.array([(float(x), float(y)) for x, y in points], dtype=np.float64).reshape(-1, 2)


def _is_nearly_between(a: Point, v: Point, b: Point, tolerance: float) -> bool:
    ends = _rounded([a, b]) - _rounded([v])
    return _least_distance(np.zeros(2), ends[None]) <= tolerance


def judge_contract(
    reply: Reply, truth: Region, rings: Iterable[Sequence[Point]], of: Configuration
) -> Judgement:
    """Of an engine on a grid: whether its answer may be what comes of moving sides no further than
    the grid's reach. *topology* is proven: a vertex that is further away from all sides of the
    rings, or a face of the difference whose area is more than its boundary times that distance."""
    if reply.ending != "model":
        return judge_region(reply, truth, 0.0, 0.0)
    assert reply.model is not None
    is_binary = math.frexp(of.tolerance)[0] == 0.5
    grid = Fraction(of.tolerance if is_binary else repr(of.tolerance))
    try:
        answer = answer_of(reply.model, grid)
    except Unreadable as error:
        return Judgement("invalid", "unreadable", message=str(error)[:300])
    reach = _REACH * of.tolerance
    off = difference(truth.boundary, answer.region.boundary)
    sides = [side for ring in rings for side in sides_of(ring)]
    furthest = _furthest(answer.region.boundary, sides)
    parts, _ = answer.region.parts_and_holes
    boundary = answer.region.boundary
    told = partial(Judgement, vertices=len(boundary.places), edges=len(boundary.edges), faces=parts)
    told = partial(told, area=off.area, displacement=furthest, tolerance=reach)
    if answer.fault:
        return told("invalid", answer.fault)
    if furthest > reach or _is_beyond(off, reach):
        return told("topology", "beyond the grid")
    return told("moved" if off.area else "identical")


def _is_beyond(off: Difference, reach: float) -> bool:
    return bool((off.areas > reach * off.perimeters).any())


def _furthest(of: Graph, sides: Sequence[Side]) -> float:
    """Of the vertices from the sides."""
    if not of.places or not sides:
        return 0.0
    origin = np.array(sides[0][:2])
    points = _rounded(of.places.values()) - origin
    ends = np.array(sides).reshape(-1, 2, 2) - origin
    return max(_least_distance(p, ends) for p in points)


def _least_distance(point: Floats, ends: Floats) -> float:
    a, d = ends[:, 0], ends[:, 1] - ends[:, 0]
    off = point - a
    squared = (d * d).sum(axis=1)
    along = np.clip((off * d).sum(axis=1) / np.where(squared > 0, squared, 1.0), 0, 1)
    across = off - along[:, None] * d
    return float(np.hypot(across[:, 0], across[:, 1]).min())
