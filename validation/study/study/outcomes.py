"""What an answer is, held against a truth: one of nine outcomes, exclusive, in this order.

Loud, where the engine itself says that something is wrong: *error*, *crash*, *timeout*, *memory*.
Silently wrong: *invalid*, where the answer by itself is no complex (edges cross, faces overlap or
leave gaps); *topology*, where it is one, but another one, or a vertex is further away than
`FURTHEST` tolerances. Right: *moved*, the same cells with vertices further away than doubles need,
or as near as that and yet with edges that cross when their ends are taken as what they are;
*identical*.
"""

from __future__ import annotations

import math
import warnings
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import plumbline
from plumbline import Arrangement, Comparison, Finding

from study.engines import Configuration, Reply
from study.families import Case, largest_coordinate
from study.truths import Numbers, Truths

_GRAVEST_FIRST = {
    ("face", "missing"): "face lost",
    ("face", "extra"): "face invented",
    ("face", "merged"): "faces merged",
    ("face", "split"): "face split",
    ("face", "wrong parent"): "wrong parent",
    ("hole", "wrong parent"): "wrong parent",
    ("hole", "missing"): "hole lost",
    ("hole", "extra"): "hole invented",
    ("edge", "missing"): "edge missing",
    ("edge", "extra"): "edge extra",
    ("vertex", "missing"): "vertex missing",
    ("vertex", "extra"): "vertex extra",
    ("vertex", "merged"): "vertices merged",
    ("vertex", "split"): "vertex split",
    ("edge", "merged"): "edges merged",
    ("edge", "split"): "edge split",
}
IDENTICAL = 2.0**-51  # of the largest coordinate: two units in its last place
FURTHEST = 1000.0
"""Tolerances that a vertex may be away from where it should be. Where sides are nearly parallel,
rounding their ends moves a crossing much further than the ends."""
_SHARE, _OF_LARGEST = 1e-9, 2.0**-46  # the tolerance that `plumbline.check` has by itself


@dataclass(frozen=True)
class Judgement:
    """Of one answer and one truth."""

    outcome: str
    kind: str = ""
    """Of an error its class; of what is invalid the broken invariant; of another topology the
    gravest difference."""
    all_kinds: str = ""
    """All of them with their numbers."""
    vertices: int = -1
    edges: int = -1
    faces: int = -1
    """Of the answer, bounded ones; -1 where there is none."""
    faces_wrong: int = 0
    area: float = 0.0
    """Of the symmetric difference of faces that correspond and do not agree."""
    displacement: float = 0.0
    tolerance: float = 0.0
    message: str = ""


def judge(
    reply: Reply, truth: Arrangement | Numbers, tolerance: float, largest: float
) -> Judgement:
    """`largest` coordinate of the drawing: what rounding is measured by."""
    if reply.ending != "model":
        kind = reply.message.partition(":")[0]
        return Judgement(reply.ending, kind, message=reply.message[:300])
    assert reply.model is not None
    if isinstance(truth, Numbers):
        return _judge_numbers(reply.model, truth)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", plumbline.LossWarning)
            comparison = plumbline.compare_result(reply.model, truth, tolerance)
    except plumbline.Error as error:
        return Judgement("invalid", "unreadable", message=str(error)[:300])
    return _judged(comparison, reply.model, largest)


def tolerance_of(case: Case, name: str, of: Configuration) -> float:
    """Within which vertices of an answer match those of a truth: what the engine may move, what
    rounding moved of what was meant, and no less than `plumbline.check` has by itself."""
    own = _own_tolerance(case)
    if name == "contract" and of.tolerance_kind == "grid":
        # On the grid's own points; a neighbour of the right one does not match.
        return max(of.tolerance / 4, _OF_LARGEST * largest_coordinate(case))
    return max(own, of.tolerance, 4 * _rounding(case) if name == "intended" else 0.0)


Known = dict[tuple[Any, ...], Judgement]
"""Judgements of one drawing by truth, tolerance and answer: engines often say the same."""


def judgements(
    case: Case, truths: Truths, of: Configuration, reply: Reply, names: Iterable[str], known: Known
) -> dict[str, Judgement]:
    """Of all truths that there are for this drawing and this engine. What is `known` already is not
    computed again; the rest is put there."""
    found: dict[str, Judgement] = {}
    largest = largest_coordinate(case)
    said = in_order(reply)
    for name in names:
        truth = truths.of(name, of)
        if truth is not None:
            tolerance = tolerance_of(case, name, of)
            key = (id(truth), tolerance, said)
            if key not in known:
                known[key] = judge(reply, truth, tolerance, largest)
            found[name] = known[key]
    return found


def in_order(reply: Reply) -> tuple[Any, ...]:
    """Equal for answers with the same vertices, edges and polygons, to the last digit, however they
    are listed."""
    model = reply.model
    if model is None:
        return reply.ending, reply.message
    if not model.keys() <= {"V", "EV", "polygons"}:
        return (repr(model),)
    try:
        places = dict(enumerate(tuple(p) for p in model["V"]))
        edges = [tuple(sorted((places[a], places[b]))) for a, b in model.get("EV", ())]
        polygons = [
            [_from_least([places[v] for v in ring]) for ring in polygon]
            for polygon in model.get("polygons", ())
        ]
        faces = sorted((outer, tuple(sorted(holes))) for outer, *holes in polygons)
    except (KeyError, TypeError, ValueError):
        return (repr(model),)  # unreadable
    return tuple(sorted(places.values())), tuple(sorted(edges)), tuple(faces), tuple(sorted(model))


def _from_least(ring: list[Any]) -> tuple[Any, ...]:
    k = ring.index(min(ring)) if ring else 0
    return (*ring[k:], *ring[:k])


def _judged(comparison: Comparison, model: dict[str, Any], largest: float) -> Judgement:
    findings = comparison.findings
    wrong = [f for f in findings if f.disagreement not in ("moved", "reshaped", "invalid")]
    invalid = [f for f in findings if f.disagreement == "invalid"]
    displacement = comparison.largest_displacement
    for f in findings:
        if f.disagreement == "moved":
            displacement = max(displacement, f.distance or 0.0)
    if invalid:
        outcome, kind = "invalid", str(invalid[0].invariant)
        if _is_rounding(findings, displacement, largest):
            outcome = "moved"
    elif wrong:
        outcome, kind = "topology", gravest({(f.kind, f.disagreement) for f in wrong})
    elif displacement > FURTHEST * comparison.tolerance:
        outcome, kind = "topology", "vertex moved far"
    else:
        is_moved = bool(findings) or displacement > IDENTICAL * largest
        outcome, kind = "moved" if is_moved else "identical", ""
    counts = Counter(f"{f.kind} {f.disagreement}" for f in findings)
    areas = [f.area for f in findings if f.area is not None]
    return Judgement(
        outcome,
        kind,
        ", ".join(f"{name} {n}" for name, n in sorted(counts.items())),
        comparison.answer_counts.vertices,
        comparison.answer_counts.edges,
        faces_in(model),
        _faces_wrong(wrong),
        float(sum(areas, Fraction(0))),
        displacement,
        comparison.tolerance,
    )


def _is_rounding(findings: list[Finding], displacement: float, largest: float) -> bool:
    """Whether edges cross, or vertices lie on them, by no more than the last places of
    coordinates: all cells correspond, and each vertex is where it should be. Engines do not promise
    to round each coordinate to the nearest double."""
    by_rounding = ("crossing", "vertex on edge")
    only = all(f.disagreement == "invalid" and f.invariant in by_rounding for f in findings)
    return bool(findings) and only and displacement <= IDENTICAL * largest


def edges_of(model: dict[str, Any]) -> set[tuple[int, int]]:
    """Pairs of vertices, the lesser one first; of a model of faces alone their sides."""
    rings = (ring for polygon in model.get("polygons", ()) for ring in polygon)
    sides = (side for ring in rings for side in zip(ring, [*ring[1:], ring[0]]))
    return {(min(e), max(e)) for e in model.get("EV", sides)}


def faces_in(model: dict[str, Any]) -> int:
    """Bounded ones; -1 where the engine says nothing of faces."""
    for name in ("polygons", "FV"):
        if name in model:
            return len(model[name])
    return -1


def gravest(kinds: set[tuple[str, str]]) -> str:
    """Of kinds of cells with disagreements."""
    named = [name for kind, name in _GRAVEST_FIRST.items() if kind in kinds]
    return named[0] if named else " ".join(min(kinds))


def _faces_wrong(wrong: list[Finding]) -> int:
    """Exact faces that are not there as they should be, and faces that should not be there."""
    exact: set[int] = set()
    extra = 0
    for f in wrong:
        if f.kind == "face":
            exact.update(f.exact_cells)
            extra += f.disagreement == "extra"
    return len(exact - {0}) + extra


def _judge_numbers(model: dict[str, Any], truth: Numbers) -> Judgement:
    pairs = edges_of(model)
    vertices = len({v for edge in pairs for v in edge})
    edges, faces = len(pairs), faces_in(model)
    # Faces alone have no edge that ends within a face, nor one that bounds none.
    same = "EV" not in model or (vertices, edges) == (truth.vertices, truth.edges)
    same = same and faces in (-1, truth.faces - 1)
    # Numbers say nothing of places: the better word is not theirs to give.
    kind = "" if same else "numbers of cells"
    return Judgement("moved" if same else "topology", kind, "", vertices, edges, faces)


def _own_tolerance(case: Case) -> float:
    if not case.segments:
        return 0.0
    x = [c for s in case.segments for c in (s[0], s[2])]
    y = [c for s in case.segments for c in (s[1], s[3])]
    side = max(max(x) - min(x), max(y) - min(y))
    return tolerance_within(0.0, side, largest_coordinate(case))


def tolerance_within(own: float, side: float, largest: float) -> float:
    """An engine's own, and no less than `plumbline.check` has by itself for a drawing with this
    longer side and this largest coordinate."""
    return max(own, _SHARE * side, _OF_LARGEST * largest)


def _rounding(case: Case) -> float:
    """How far what was meant is from what was authored, at most."""
    if case.intended is None or len(case.intended) != len(case.authored):
        return 0.0
    pairs = zip(case.intended, case.authored)
    off = max((abs(a - b) for s, t in pairs for a, b in zip(s, t)), default=Fraction(0))
    return math.sqrt(2) * float(off)
