"""Arrangements by hand, against textbooks and the package, which shares nothing with them."""

from __future__ import annotations

import json
import random
from fractions import Fraction
from pathlib import Path

import by_hand
import numpy as np
import plumbline
import pytest

_FINDINGS = sorted((Path(by_hand.__file__).parent).glob("*/finding.json"))


def square(x: float, y: float, side: float) -> list[list[float]]:
    corners = [(x, y), (x + side, y), (x + side, y + side), (x, y + side)]
    return [[*a, *b] for a, b in zip(corners, corners[1:] + corners[:1])]


def test_two_squares_that_overlap_have_three_faces() -> None:
    cells = by_hand.arranged(by_hand.exact(square(0, 0, 2) + square(1, 1, 2)))
    assert cells.numbers == (10, 12, 3)
    assert [a / 2 for a in cells.areas] == [1, 3, 3]


def test_a_square_within_another_one_is_a_face_of_its_own() -> None:
    cells = by_hand.arranged(by_hand.exact(square(0, 0, 3) + square(1, 1, 1)))
    assert cells.numbers == (8, 8, 2)


def test_overlaps_and_double_lines_count_once() -> None:
    rows = [[0, 0, 3, 0], [1, 0, 2, 0], [3, 0, 0, 0], [2, 0, 5, 0]]
    assert by_hand.arranged(by_hand.exact(rows)).numbers == (5, 4, 0)


def test_a_crossing_that_no_double_holds_is_exact() -> None:
    cells = by_hand.arranged(by_hand.exact([[0, 0, 3, 1], [0, 1, 3, 0], [1, 0, 1, 1]]))
    assert (Fraction(3, 2), Fraction(1, 2)) in cells.vertices
    assert (Fraction(1), Fraction(1, 3)) in cells.vertices


@pytest.mark.parametrize("seed", range(40))
def test_cells_are_those_of_the_package(seed: int) -> None:
    dice = random.Random(seed)
    grid = dice.choice([4, 10, 1000])
    rows = [
        [dice.randint(0, grid) / dice.choice([1, 3, 7]) for _ in range(4)]
        for _ in range(dice.randint(2, 12))
    ]
    rows = [r for r in rows if r[:2] != r[2:]]
    counts = plumbline.arrange(np.array(rows).reshape(-1, 4), numbers="doubles").counts
    assert by_hand.arranged(by_hand.exact(rows)).numbers == (
        counts.vertices,
        counts.edges,
        counts.faces - 1,
    )


@pytest.mark.parametrize("file", _FINDINGS, ids=lambda p: p.parent.name)
def test_a_finding_is_wrong_by_hand_and_could_be_right(file: Path) -> None:
    found = json.loads(file.read_text(encoding="utf-8"))
    verdict = by_hand.verdict(found)
    assert verdict.is_wrong
    assert verdict.fits
