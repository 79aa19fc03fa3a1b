"""Whether a case is as its suite expects, and if not, who is right."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import by_slabs
import plumbline
from cases import Case, Layer

MOST = 3_000_000  # steps of by_slabs that a case may take

HOLDS: dict[str, Callable[[bool, bool], bool]] = {
    "intersection": lambda a, b: a and b,
    "union": lambda a, b: a or b,
    "difference": lambda a, b: a and not b,
    "symmetric_difference": lambda a, b: a != b,
}


@dataclass
class Verdict:
    """What became of a case."""

    kind: str  # "equal", "rounded", "expectation wrong", "laws", "ours wrong"
    reason: str = ""
    by_slabs: bool = False  # whether that confirmed our result, to the last digit
    same_rings: bool | None = None  # whether there are as many as is expected; None: nothing is


def text_of(layer: Layer) -> str:
    """A geometry a line; the rings of a shape have one winding number together."""
    texts = []
    for shape in layer:
        rings = [ring if ring[0] == ring[-1] else [*ring, ring[0]] for ring in shape if ring]
        parts = ["((" + ", ".join(f"{x} {y}" for x, y in ring) + "))" for ring in rings]
        texts.append(f"MULTIPOLYGON ({', '.join(parts)})" if parts else "POLYGON EMPTY")
    return "\n".join(texts)


def region_of(layer: Layer, rule: str) -> Any:
    """What a layer covers."""
    return plumbline.union_all(text_of(layer), rule=rule) if layer else plumbline.union_all([])


def computed(case: Case) -> Any:
    """Our result."""
    a, b = lines_of(case.a), lines_of(case.b)
    return getattr(plumbline, case.operation)(a, b, rule=case.rule)


def lines_of(layer: Layer) -> Any:
    return plumbline.lines(text_of(layer) if layer else [], numbers="decimals")


def exact_layer(region: Any) -> list[Any]:
    """Its polygons as `by_slabs` takes them."""
    return [
        [[(str(x), str(y)) for x, y in ring[:-1]] for ring in polygon]
        for polygon in region.polygons
    ]


def perimeter(region: Any) -> float:
    total = 0.0
    for polygon in region.polygons:
        for ring in polygon:
            for (ax, ay), (bx, by) in zip(ring, ring[1:]):
                total += math.hypot(float(bx - ax), float(by - ay))
    return total


def unit_of(case: Case, expected: Layer) -> float:
    """What the last digit of the expected corners is worth: 1 for libraries that have integers, of
    decimals that of the longest ones, but no less than what doubles are apart there."""
    if case.rounded_to_one:
        return 1.0
    texts = [c for shape in expected for ring in shape for point in ring for c in point]
    decimals = max((len(t.partition(".")[2]) for t in texts if "e" not in t.lower()), default=0)
    largest = max((abs(float(t)) for t in texts), default=0.0)
    return max(10.0**-decimals if decimals else 0.0, math.ulp(largest))


def judged(case: Case) -> Verdict:
    if case.operation == "valid":
        return _judged_valid(case)
    ours = computed(case)
    slabs = _confirmed(case, ours)
    if slabs is False:
        return Verdict("ours wrong", "slabs have another area")
    laws = _broken_law(case, ours)
    if laws:
        return Verdict("ours wrong", laws)
    if case.area is not None:
        verdict = _judged_area(case, ours)
    elif case.expected:
        verdict = _judged_polygons(case, ours)
    else:
        verdict = Verdict("laws")
    verdict.by_slabs = bool(slabs)
    if case.rings is not None:
        verdict.same_rings = case.rings == sum(len(polygon) for polygon in ours.polygons)
    if verdict.kind == "expectation wrong" and not slabs:
        verdict = Verdict("not decided", verdict.reason)
    return verdict


def _judged_valid(case: Case) -> Verdict:
    text = case.text
    is_binary = all(c in "0123456789abcdefABCDEF" for c in text)
    lines = plumbline.lines(bytes.fromhex(text) if is_binary else text)
    if not len(lines):
        return Verdict(
            "equal" if case.valid else "not decided",
            "nothing is left of it that could be valid or not",
        )
    valid = not plumbline.validity(lines)
    return Verdict("equal") if valid == case.valid else Verdict("ours wrong", f"valid: {valid}")


def _confirmed(case: Case, ours: Any) -> bool | None:
    """Whether slabs find nothing that is in our result alone or in the right one alone; None where
    that is too much work."""
    holds = HOLDS[case.operation]
    layers, rules = [case.a, case.b, exact_layer(ours)], [case.rule, case.rule, "evenodd"]
    try:
        wrong, area = by_slabs.areas(
            layers,
            rules,
            [lambda a, b, ours: holds(a, b) != ours, lambda a, b, _: holds(a, b)],
            MOST,
        )
    except by_slabs.TooLarge:
        return None
    return wrong == 0 and Fraction(int(area.numerator), int(area.denominator)) == ours.area


def _broken_law(case: Case, ours: Any) -> str:
    a, b = lines_of(case.a), lines_of(case.b)
    part = {
        how: (ours if how == case.operation else getattr(plumbline, how)(a, b, rule=case.rule)).area
        for how in HOLDS
    }
    of_a, of_b = (plumbline.union_all(x, rule=case.rule).area for x in (a, b))
    if part["union"] + part["intersection"] != of_a + of_b:
        return "area(A | B) + area(A & B) is not area A + area B"
    if part["difference"] + part["intersection"] != of_a:
        return "area(A - B) + area(A & B) is not area A"
    if part["symmetric_difference"] + part["intersection"] != part["union"]:
        return "area(A ^ B) + area(A & B) is not area(A | B)"
    return ""


def _judged_area(case: Case, ours: Any) -> Verdict:
    expected = Fraction(case.area or 0)
    off = abs(ours.area - expected)
    if off == 0:
        return Verdict("equal")
    unit = 1.0 if case.rounded_to_one else math.ulp(float(ours.area)) * 2**10
    bound = perimeter(ours) * unit * math.sqrt(2) / 2 + unit / 2 if case.rounded_to_one else unit
    if off <= bound:
        return Verdict("rounded")
    return Verdict(
        "expectation wrong",
        f"area {case.area} instead of {float(ours.area):.12g}, off by more than {bound:.3g}",
    )


def _judged_polygons(case: Case, ours: Any) -> Verdict:
    best: tuple[float, float] | None = None
    for expected in case.expected:
        region = region_of(expected, "evenodd")
        off = plumbline.symmetric_difference(ours, region).area
        if off == 0:
            return Verdict("equal")
        # A corner that is rounded is moved by at most half a unit in x and y.
        bound = max(perimeter(ours), perimeter(region)) * unit_of(case, expected) * math.sqrt(2) / 2
        if best is None or float(off) - bound < best[0] - best[1]:
            best = float(off), bound
    assert best is not None
    off_by, bound = best
    if off_by <= bound:
        return Verdict("rounded")
    return Verdict(
        "expectation wrong", f"{off_by:.3g} of the area is otherwise, rounding explains {bound:.3g}"
    )
