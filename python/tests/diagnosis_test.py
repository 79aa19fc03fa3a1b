"""Defects of line work, and polygons that are not valid."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import plumbline
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

# A contour that looks closed: its gap is the root of 2e-6.
OPEN_CONTOUR = [(0, 0, 10, 0), (10, 0, 10, 10), (10, 10, 0, 10), (0, 10, "-0.001", "0.001")]


def test_a_gap_has_its_exact_width_and_the_area_that_it_leaves_open() -> None:
    diagnosis = plumbline.diagnose(OPEN_CONTOUR)
    [gap] = diagnosis.defects
    assert gap.kind == "gap"
    assert gap.squared_size == Fraction(2, 10**6)
    assert gap.size == pytest.approx(2**0.5 / 1000)
    assert gap.open_area == pytest.approx(100, rel=1e-3)
    assert gap.proposed_tolerance is not None
    assert gap.proposed_tolerance >= gap.size
    assert diagnosis.within == Fraction(10001, 10**6)
    assert diagnosis.counts == {"gap": 1}
    assert diagnosis.tips == 2
    assert len(diagnosis) == 1
    assert diagnosis


def test_the_search_distance_decides_what_is_near() -> None:
    assert plumbline.diagnose(OPEN_CONTOUR, within="0.0001").counts == {"dangle": 1}
    assert "gap" in plumbline.diagnose(OPEN_CONTOUR, within=Fraction(1, 50)).counts


def test_repetitions_are_counted_also_where_they_are_not_listed() -> None:
    drawing = [(0, i, 5, i) for i in range(7) for _ in range(2)]
    diagnosis = plumbline.diagnose(drawing, most_listed=3)
    assert diagnosis.counts["duplicate"] == 7
    assert sum(d.kind == "duplicate" for d in diagnosis.defects) == 3
    assert {len(d.segments) for d in diagnosis.defects if d.kind == "duplicate"} == {2}


def test_what_leaves_a_face_open_comes_first() -> None:
    drawing = [*OPEN_CONTOUR, (2, 2, 3, 3), (2, 2, 3, 3)]
    assert next(d.kind for d in plumbline.diagnose(drawing).by_effect) == "gap"


def test_doors_are_openings_and_no_defects() -> None:
    drawing = [(0, 0, 4, 0), (5, 0, 10, 0), (10, 0, 10, 8), (10, 8, 0, 8), (0, 8, 0, 0)]
    [opening] = plumbline.diagnose(drawing, doors=("0.8", "1.2")).openings
    assert opening.squared_width == 1
    assert opening.where == (Fraction(9, 2), Fraction(0))
    assert plumbline.diagnose(drawing, doors=(2, 3)).openings == []


def test_a_clean_drawing_has_no_defects() -> None:
    diagnosis = plumbline.diagnose("POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))")
    assert not diagnosis
    assert repr(diagnosis) == "<Diagnosis: no defects; 0 openings>"
    assert len(diagnosis.to_geopandas()) == 0


@pytest.mark.parametrize(
    "arguments",
    [
        {"within": -1},
        {"within": "near"},
        {"within": float("nan")},
        {"doors": 1},
        {"doors": (2, 1)},
        {"doors": (1, 2, 3)},
        {"most_listed": -1},
    ],
)
def test_bad_arguments_of_diagnoses_are_refused(arguments: Any) -> None:
    with pytest.raises(plumbline.Error):
        plumbline.diagnose(OPEN_CONTOUR, **arguments)


def test_of_nothing_nothing_is_said() -> None:
    with pytest.raises(plumbline.Error, match="nothing drawn"):
        plumbline.diagnose([])
    with pytest.raises(plumbline.Error, match="no polygon"):
        plumbline.validity([])
    with pytest.raises(plumbline.Error, match="no polygon"):
        plumbline.validity([(0, 0, 1, 1)])


# Counts: what `plumbline info FILE --diagnose` of version 0.1.0 says of the example.
def test_a_diagnosis_is_as_the_tool_says(examples: Path) -> None:
    diagnosis = plumbline.diagnose(plumbline.read(examples / "building.svg"))
    assert diagnosis.counts == {
        "duplicate": 10,
        "overlap": 155,
        "gap": 1,
        "undershoot": 1,
        "overshoot": 2,
        "near-miss": 20,
        "sliver": 130,
        "short edge": 87,
    }
    assert diagnosis.tips == 4
    said = json.loads(diagnosis.to_json())
    assert len(said["defects"]) == len(diagnosis.defects)
    assert diagnosis.to_svg().startswith("<svg")
    assert diagnosis.to_text().count("\n") < 40
    assert diagnosis._written("json") == diagnosis.to_json()
    frame = diagnosis.to_geopandas()
    assert len(frame) == len(diagnosis.defects) + len(diagnosis.openings)
    assert frame["kind"].tolist()[: len(diagnosis.defects)] == [d.kind for d in diagnosis.defects]
    assert sorted(frame["rank"].dropna()) == list(range(1, len(diagnosis.defects) + 1))
    ranked = frame.dropna(subset="rank").sort_values("rank")
    assert ranked["message"].tolist() == [d.message for d in diagnosis.by_effect]


# Validity.


def test_all_problems_of_all_polygons_are_told() -> None:
    bow = shapely.Polygon([(0, 0), (2, 2), (2, 0), (0, 2)])
    hole_outside = shapely.Polygon(
        [(5, 0), (9, 0), (9, 4), (5, 4)], [[(20, 0), (21, 0), (21, 1), (20, 1)]]
    )
    good = shapely.box(30, 0, 31, 1)
    problems = plumbline.validity([bow, good, hole_outside])
    assert [(p.item, p.jts_name) for p in problems] == [
        (0, "Self-intersection"),
        (2, "Hole lies outside shell"),
    ]
    assert problems[0].where == (Fraction(1), Fraction(1))
    assert problems[0].fault == "crossing"
    assert "geometry" in problems[0].message
    assert repr(problems[0]) == f"<InvalidRing: {problems[0].message}>"
    assert problems[1].other_item == 2


def test_a_pinch_that_doubles_cannot_tell_from_a_crossing_is_told_exactly() -> None:
    square = [(0, 0), (10, 0), (10, 10), (5, 0), (0, 10)]
    [problem] = plumbline.validity([shapely.Polygon(square)])
    assert problem.where == (Fraction(5), Fraction(0))
    assert problem.jts_name == shapely.is_valid_reason(shapely.Polygon(square)).partition("[")[0]


corner = st.tuples(st.integers(0, 6), st.integers(0, 6))


@settings(max_examples=200, deadline=None)
@given(st.lists(corner, min_size=3, max_size=8, unique=True))
def test_polygons_with_integer_corners_are_valid_just_if_shapely_says_so(corners: Any) -> None:
    polygon = shapely.Polygon(corners)
    problems = plumbline.validity([polygon])
    assert (problems == []) == polygon.is_valid


def test_invalid_rings_are_defects_too() -> None:
    bow = shapely.Polygon([(0, 0), (2, 2), (2, 0), (0, 2)])
    rings = [d.ring for d in plumbline.diagnose([bow]).defects if d.kind == "invalid ring"]
    assert [r.jts_name for r in rings if r is not None] == ["Self-intersection"]


def test_arrays_of_arrangements_are_what_defects_name() -> None:
    diagnosis = plumbline.diagnose(OPEN_CONTOUR)
    places = diagnosis.arrangement.vertices[diagnosis.defects[0].vertices]
    assert places.tolist() == [[-0.001, 0.001], [0, 0]]
