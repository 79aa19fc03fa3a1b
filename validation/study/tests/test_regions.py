"""Regions of rings by facts from elsewhere: areas by hand, shapely on integers, laws."""

from __future__ import annotations

from fractions import Fraction as F
from functools import reduce
from itertools import pairwise

import pytest
from slabs import area_and_parts
from study.dice import Dice
from study.families import Unit
from study.regions import Region, difference, region_of
from study.ring_families import RingFamily, is_simple, ring_case_of, ring_families

shapely = pytest.importorskip("shapely")

Ring = list[tuple[float, float]]


def box(x: float, y: float, side: float = 4.0) -> Ring:
    return [(x, y), (x + side, y), (x + side, y + side), (x, y + side)]


PENTAGRAM = [(0.0, 3.0), (-2.0, -3.0), (3.0, 1.0), (-3.0, 1.0), (2.0, -3.0)]
EIGHT = [(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)]


@pytest.mark.parametrize(
    ("rings", "rule", "area", "parts_and_holes", "edges"),
    [
        ([], "nonzero", 0, (0, 0), 0),
        ([box(0, 0), box(2, 2)], "nonzero", 28, (1, 0), 8),
        ([box(0, 0), box(2, 2)], "evenodd", 24, (2, 1), 12),
        ([box(0, 0), box(1, 1, 2)], "nonzero", 16, (1, 0), 4),
        ([box(0, 0), box(1, 1, 2)], "evenodd", 12, (1, 1), 8),
        ([box(0, 0), box(1, 1, 2)[::-1]], "nonzero", 12, (1, 1), 8),
        ([box(0, 0), box(4, 0)], "nonzero", 32, (1, 0), 4),
        ([box(0, 0), box(4, 1)], "nonzero", 32, (1, 0), 8),
        ([box(0, 0), box(4, 4)], "nonzero", 32, (2, 0), 8),
        ([EIGHT], "nonzero", 2, (2, 0), 6),
        ([EIGHT], "evenodd", 2, (2, 0), 6),
        ([[*box(0, 0), (0.0, 2.0), (-3.0, 2.0), (0.0, 2.0)]], "nonzero", 16, (1, 0), 4),
        ([[p for p in box(0, 0) for _ in range(2)]], "evenodd", 16, (1, 0), 4),
        ([[(0.0, 0.0), (1.0, 1.0)]], "nonzero", 0, (0, 0), 0),
    ],
)
def test_areas_by_hand(
    rings: list[Ring], rule: str, area: int, parts_and_holes: tuple[int, int], edges: int
) -> None:
    found = region_of(rings, rule)
    assert found.area == area and found.parts_and_holes == parts_and_holes
    assert len(found.boundary.edges) == edges


def test_a_pentagram_has_its_middle_by_one_rule_alone() -> None:
    full, hollow = (region_of([PENTAGRAM], rule) for rule in ("nonzero", "evenodd"))
    assert full.parts_and_holes == (1, 0) and hollow.parts_and_holes == (5, 1)
    middle = shapely.Polygon()
    for a, b in pairwise([*PENTAGRAM, PENTAGRAM[0]]):
        # The middle is what lies on one side of all sides.
        far = [(a[0] + 100 * (b[0] - a[0]), a[1] + 100 * (b[1] - a[1]))]
        back = [(a[0] - 100 * (b[0] - a[0]), a[1] - 100 * (b[1] - a[1]))]
        turn = (-(b[1] - a[1]) * 100, (b[0] - a[0]) * 100)
        half = [*back, *far, *((p[0] + turn[0], p[1] + turn[1]) for p in (*far, *back))]
        plane = shapely.Polygon(half)
        middle = plane if middle.is_empty else middle & plane
    assert float(full.area - hollow.area) == pytest.approx(middle.area)


def polygons(dice: Dice) -> list[Ring]:
    """Simple polygons of small integers, which shapely can unite exactly, but for crossings."""
    found: list[Ring] = []
    while len(found) < 6:
        ring = [(float(dice.between(0, 12)), float(dice.between(0, 12))) for _ in range(5)]
        if is_simple(ring):
            found.append(ring)
    return found


@pytest.mark.parametrize("seed", range(40))
def test_of_integers_shapely_says_the_same(seed: int) -> None:
    rings = polygons(Dice(f"integers {seed}"))
    shapes = [shapely.Polygon(ring) for ring in rings]
    found = region_of(rings, "nonzero")
    assert float(found.area) == pytest.approx(shapely.union_all(shapes).area, rel=1e-12)
    parity = reduce(shapely.symmetric_difference, shapes)
    found = region_of(rings, "evenodd")
    assert float(found.area) == pytest.approx(parity.area, rel=1e-12)


@pytest.mark.parametrize("seed", range(40))
def test_of_boxes_shapely_says_the_same_parts_and_holes(seed: int) -> None:
    dice = Dice(f"boxes {seed}")
    boxes = [box(dice.between(0, 9), dice.between(0, 9), dice.between(1, 4)) for _ in range(12)]
    shapes = [shapely.Polygon(ring) for ring in boxes]
    union, parity = shapely.union_all(shapes), reduce(shapely.symmetric_difference, shapes)
    for rule, expected in (("nonzero", union), ("evenodd", parity)):
        found = region_of(boxes, rule)
        assert found.area == F(expected.area)
        outside = shapely.box(-1, -1, 20, 20) - expected
        numbers = tuple(len(shapely.get_parts(s)) for s in (expected, outside))
        assert found.parts_and_holes == (numbers[0], numbers[1] - 1)
        assert found.perimeter == expected.length


def test_simple_rings_touch_themselves_nowhere() -> None:
    spiked = [(6.0, 6.0), (8.0, 1.0), (8.0, 6.0), (6.0, 11.0), (6.0, 3.0)]
    touching = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 0.0), (0.0, 4.0)]
    for ring in (PENTAGRAM, EIGHT, spiked, touching, box(0, 0)[::-1], box(0, 0)[:2]):
        assert not is_simple(ring)
    assert is_simple(box(0, 0)) and is_simple([p for p in box(0, 0) for _ in range(3)])


def same(a: Region, b: Region) -> bool:
    return a.boundary_arrangement == b.boundary_arrangement


@pytest.mark.parametrize("family", ring_families(), ids=lambda f: f.name)
def test_laws_of_rules(family: RingFamily) -> None:
    of = family
    case = ring_case_of(of, Unit(of.name, 40, "mm", 5))
    assert case == ring_case_of(of, Unit(of.name, 40, "mm", 5))
    assert len(case.rings) >= 1
    if of.kind == "simple":
        assert all(map(is_simple, case.rings))
    odd, filled = (region_of(case.rings, rule) for rule in ("evenodd", "nonzero"))
    assert region_of([*case.rings, *case.rings], "evenodd").area == 0
    assert same(region_of([*case.rings, *case.rings], "nonzero"), filled)
    turned = [ring[::-1] for ring in case.rings]
    assert same(region_of(turned, "evenodd"), odd) and same(region_of(turned, "nonzero"), filled)
    assert same(region_of([*turned[:1], *case.rings[1:]], "evenodd"), odd)
    assert odd.area <= filled.area
    assert difference(odd.boundary, filled.boundary).area == pytest.approx(
        float(filled.area - odd.area)
    )


def test_differences_are_of_faces() -> None:
    found = difference(
        region_of([box(0, 0)], "nonzero").boundary, region_of([box(3, 3)], "nonzero").boundary
    )
    assert sorted(found.areas) == [15, 15] and sorted(found.perimeters) == [16, 16]


def test_a_vertex_on_a_straight_way_is_none_but_one_beside_it_is() -> None:
    off = 2.0**-60
    for y, count in ((0.0, 4), (-off, 5), (off, 5)):
        assert (
            len(region_of([[(0.0, 0.0), (2.0, y), *box(0, 0)[1:]]], "nonzero").boundary.edges)
            == count
        )
    assert region_of([[(0.0, 0.0), (2.0, -off), *box(0, 0)[1:]]], "nonzero").area == 16 + 2 * F(off)


@pytest.mark.parametrize("family", ring_families(), ids=lambda f: f.name)
@pytest.mark.parametrize("scale", ["unit", "UTM"])
def test_slabs_in_fractions_say_the_same(family: RingFamily, scale: str) -> None:
    case = ring_case_of(family, Unit(family.name, 24, scale, 3))
    found = region_of(case.rings, case.rule)
    assert area_and_parts(case.rings, case.rule) == (found.area, *found.parts_and_holes)
