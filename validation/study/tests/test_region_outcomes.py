"""Answers of engines of rings of known kinds."""

from __future__ import annotations

from typing import Any

import pytest
from study.engines import Configuration, Reply
from study.outcomes import Judgement
from study.region_outcomes import judge_contract, judge_region
from study.regions import region_of

Ring = list[tuple[float, float]]


def box(x: float, y: float, side: float = 4.0) -> Ring:
    return [(x, y), (x + side, y), (x + side, y + side), (x, y + side)]


RINGS = [box(0, 0), box(2, 2)]
UNION = [
    (0.0, 0.0),
    (4.0, 0.0),
    (4.0, 2.0),
    (6.0, 2.0),
    (6.0, 6.0),
    (2.0, 6.0),
    (2.0, 4.0),
    (0.0, 4.0),
]


def model(*polygons: list[Ring]) -> dict[str, Any]:
    places = [p for polygon in polygons for ring in polygon for p in ring]
    numbers = iter(range(len(places)))
    return {
        "V": [list(p) for p in places],
        "polygons": [[[next(numbers) for _ in ring] for ring in polygon] for polygon in polygons],
    }


def judged(of: dict[str, Any], rings: list[Ring], rule: str = "nonzero") -> Judgement:
    return judge_region(Reply("model", 0.1, of), region_of(rings, rule), 1e-8, 6.0)


def outcome(*polygons: list[Ring]) -> tuple[str, str]:
    found = judged(model(*polygons), RINGS)
    return found.outcome, found.kind


def beside(x: float, y: float) -> Ring:
    """The union with a vertex more, on its lower side or near it."""
    return [UNION[0], (x, y), *UNION[1:]]


@pytest.mark.parametrize(
    ("polygons", "expected"),
    [
        ([[UNION]], ("identical", "")),
        ([[UNION[::-1]]], ("identical", "")),
        ([[beside(2.0, 0.0)]], ("identical", "")),
        ([[beside(2.0, 1e-10)]], ("moved", "")),
        ([[beside(2.0, 1e-3)]], ("topology", "edge missing")),
        ([[[(1e-10, 0.0), *UNION[1:]]]], ("moved", "")),
        ([[[(1e-6, 0.0), *UNION[1:]]]], ("moved", "")),
        ([[[(1e-3, 0.0), *UNION[1:]]]], ("topology", "edge missing")),
        ([], ("topology", "part lost")),
        ([[box(0, 0)]], ("topology", "edge missing")),
        ([[UNION], [box(10, 10)]], ("topology", "part invented")),
        ([[UNION, box(1, 1, 1)]], ("topology", "hole invented")),
        ([[box(0, 0)], [box(2, 2)]], ("invalid", "rings overlap")),
        ([[UNION, box(10, 10)]], ("invalid", "turned over")),
        ([[beside(2.0, -1.0)[:2] + UNION]], ("invalid", "sides on each other")),
        ([[[(0.0, 0.0), (4.0, 4.0), (4.0, 0.0), (0.0, 4.0)]]], ("invalid", "turned over")),
    ],
)
def test_answers_of_known_kinds(polygons: list[list[Ring]], expected: tuple[str, str]) -> None:
    assert outcome(*polygons) == expected


def test_touching_is_no_fault() -> None:
    corner = judged(model([box(0, 0)], [box(4, 4)]), [box(0, 0), box(4, 4)])
    assert corner.outcome == "identical"
    pinched = [box(0, 0), [(0.0, 2.0), (2.0, 1.0), (2.0, 3.0)]]
    assert judged(model(pinched), pinched, "evenodd").outcome == "identical"


def test_rings_without_roles_are_even_odd() -> None:
    rings = {
        "V": [list(p) for p in [*box(0, 0), *box(1, 1, 2)]],
        "rings": [[0, 1, 2, 3], [4, 5, 6, 7]],
    }
    assert judged(rings, [box(0, 0), box(1, 1, 2)], "evenodd").outcome == "identical"
    crossing = {
        "V": [list(p) for p in [*box(0, 0), *box(2, 2)]],
        "rings": [[0, 1, 2, 3], [4, 5, 6, 7]],
    }
    found = judged(crossing, RINGS, "evenodd")
    assert (found.outcome, found.kind) == ("invalid", "rings cross")


def test_areas_are_of_what_differs() -> None:
    assert judged(model([box(0, 0)]), RINGS).area == 12
    assert judged(model(), RINGS).area == 28
    assert judged(model([UNION]), RINGS).area == 0


@pytest.mark.parametrize(
    "of",
    [
        {"V": [[0, 0]], "polygons": [[[0, 1, 2]]]},
        {"V": [[0, 0], [1, 0], [0, 1]], "polygons": [[[0, 1, -1]]]},
        {"V": [[0, 0], [1, 0], [0, float("nan")]], "polygons": [[[0, 1, 2]]]},
        {"V": [[0, 0], [1, 0], [0, 1]], "EV": [[0, 1]]},
    ],
)
def test_what_cannot_be_read_is_invalid(of: dict[str, Any]) -> None:
    assert judged(of, RINGS).kind == "unreadable"


def test_what_is_loud_stays_so() -> None:
    reply = Reply("crash", message="SIGABRT: no")
    assert judge_region(reply, region_of(RINGS, "nonzero"), 1e-8, 6.0).outcome == "crash"


def on_grid(grid: float, *polygons: list[Ring]) -> tuple[str, str]:
    of = Configuration("e", "E", "1", "e", "c", "C", "grid", grid, "")
    reply = Reply("model", 0.1, model(*polygons))
    found = judge_contract(reply, region_of(RINGS, "nonzero"), RINGS, of)
    return found.outcome, found.kind


def test_a_grid_may_move_sides_by_some_of_its_distance() -> None:
    assert on_grid(0.125, [UNION]) == ("identical", "")
    assert on_grid(0.125, [beside(2.0, 0.25)]) == ("moved", "")
    assert on_grid(0.125, [beside(2.0, 0.75)]) == ("topology", "beyond the grid")
    assert on_grid(0.125, [box(0, 0)]) == ("topology", "beyond the grid")
    assert on_grid(0.125) == ("topology", "beyond the grid")
    # A crack along a side is within reach of it.
    crack = [(4.0, 2.0), (4.0, 3.0), (4.125, 2.5)]
    assert on_grid(0.125, [UNION, crack]) == ("moved", "")


def test_doubles_stand_for_the_grids_points_that_they_were_rounded_from() -> None:
    # On tenths the vertex is on the side; as a double it is beside it, and the ring crosses.
    slanted = [(0.0, 0.0), (0.9, 0.3), (0.9, 2.0), (0.0, 2.0)]
    hole = [(0.3, 0.1), (0.6, 0.9), (0.3, 0.9)]
    truth = region_of([slanted, hole], "evenodd")
    of = Configuration("e", "E", "1", "e", "c", "C", "grid", 0.1, "")
    reply = Reply("model", 0.1, model([slanted, hole]))
    assert judge_contract(reply, truth, [slanted, hole], of).outcome != "invalid"
    inside = region_of([slanted], "nonzero")
    assert judge_region(reply, inside, 1e-9, 2.0).kind in ("turned over", "hole invented")


def test_rings_that_cross_by_rounding_alone_are_moved() -> None:
    """A vertex that touches a side, but for the last place of its coordinates."""
    slanted = [(0.0, 0.0), (3.0, 1.0), (3.0, 5.0), (0.0, 5.0)]
    inner = [(1.5, 0.5), (2.0, 3.0), (1.0, 3.0)]
    for off, expected in ((0.0, "identical"), (2.0**-53, "moved"), (2.0**-40, "invalid")):
        found = [(1.5, 0.5 - off), *inner[1:]]
        assert judged(model([slanted, found]), [slanted, inner], "evenodd").outcome == expected


def test_a_wrong_role_is_no_rounding() -> None:
    ring = [box(0, 0), box(1, 1, 2)]
    assert judged(model(ring), ring, "evenodd").outcome == "identical"
    assert judged(model(ring[:1], ring[1:]), ring, "evenodd").outcome == "invalid"
    eight = [
        (0.0, 0.0),
        (4.0, 0.0),
        (4.0, 4.0),
        (4.0, 8.0),
        (8.0, 8.0),
        (8.0, 4.0),
        (4.0, 4.0),
        (0.0, 4.0),
    ]
    assert judged(model([eight]), [box(0, 0), box(4, 4)]).kind == "turned over"


def test_the_same_cells_far_away_are_others() -> None:
    long = [(x + 50.0, y) if x > 3 else (x, y) for x, y in UNION]
    found = judged(model([long]), RINGS)
    assert found.outcome == "topology" and found.area > 100
