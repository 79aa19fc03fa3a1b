"""Rooms are told by areas and points; reports of repairs depend on results alone."""

from __future__ import annotations

import csv

import pytest

pytest.importorskip("shapely")
pytest.importorskip("matplotlib")

import pyarrow as pa
from repairing import report
from repairing.__main__ import SCHEMA
from repairing.plans import DAMAGES, LAR, OURS, RATIOS, Room, Rows
from repairing.rooms import OUTCOMES, found, moved_far
from study.dice import Dice

OUTSIDE: Rows = [[0, 0, 6, 0], [6, 0, 6, 3], [6, 3, 0, 3], [0, 3, 0, 0]]
WALL: Rows = [[2, 0, 2, 3]]
ROOMS = [Room(1, 1.5, 6, 10), Room(4, 1.5, 12, 14)]


def test_rooms_that_are_there_are_right() -> None:
    assert found(OUTSIDE + WALL, ROOMS, 0.1).outcome == "right"
    assert found(OUTSIDE + WALL, ROOMS, 0.1).there == {0, 1}
    # Loose ends do not count, nor a border that moved by the size.
    assert found([*OUTSIDE, [2.09, 0, 2.09, 3], [4, 0, 4, 1]], ROOMS, 0.1).outcome == "right"


@pytest.mark.parametrize(
    ("rows", "outcome", "there"),
    [
        (OUTSIDE[1:] + WALL, "rooms lost", set()),  # both: the lower wall is of both
        ([*OUTSIDE[1:], *WALL, [2, 0, 6, 0]], "rooms lost", {1}),
        (OUTSIDE, "rooms merged", set()),
        ([*OUTSIDE, [2, 0, 2, 2.9]], "rooms merged", set()),
        ([*OUTSIDE, *WALL, [5.5, 0, 5.5, 3]], "faces invented", {0}),
        ([*OUTSIDE, *WALL, [5.99, 0, 5.99, 3]], "faces invented", {0, 1}),
        ([*OUTSIDE, [3.5, 0, 3.5, 3]], "rooms reshaped", set()),
    ],
)
def test_what_is_wrong_has_a_name(rows: Rows, outcome: str, there: set[int]) -> None:
    assert found(rows, ROOMS, 0.1).outcome == outcome
    assert found(rows, ROOMS, 0.1).there == there


def test_vertices_are_held_against_all_that_was_drawn() -> None:
    assert moved_far(WALL, OUTSIDE + WALL, 0.1) == 0
    # A wall that was made longer by the size, and one that was made longer by more.
    assert moved_far([[2, -0.1, 2, 3]], OUTSIDE + WALL, 0.1) == 0
    assert moved_far([[2, -0.2, 2, 3], [-0.2, 1, 6.2, 1]], OUTSIDE + WALL, 0.1) == 3


def made() -> list[dict[str, object]]:
    dice = Dice("repairs")
    return [
        {
            "tool": tool,
            "damage": damage,
            "ratio": ratio,
            "seed": seed,
            "size": 0.1,
            "rooms": 4,
            "outcome": OUTCOMES[dice.between(0, len(OUTCOMES) - 1)],
            "harmed": dice.between(0, 1),
            "is_harm_unsaid": False,
        }
        for tool in ("b", OURS, "a", LAR)
        for damage in DAMAGES
        for ratio in RATIOS
        for seed in range(3)
    ]


def test_a_report_of_repairs_is_the_same_bytes_in_any_order_of_rows() -> None:
    rows = made()
    first = report.files(pa.Table.from_pylist(rows, schema=SCHEMA))
    Dice("another order").shuffle(rows)
    assert report.files(pa.Table.from_pylist(rows, schema=SCHEMA)) == first
    _, *lines = csv.reader(first["repairs.csv"].splitlines())
    cells = len(DAMAGES) * len(RATIOS)
    assert [line[0] for line in lines[::cells]] == [OURS, "a", "b", LAR]
    assert len(lines) == 4 * cells and {line[3] for line in lines} == {"3"}
