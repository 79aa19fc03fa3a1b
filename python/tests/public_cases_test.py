"""Public bug reports: what is right, by an oracle that compares all pairs in fractions, and what
shapely's floats give.

Of `data/public_cases.json`. There, `shapely` is what shapely.node and shapely.polygonize of
RECORDED gave: vertices, edges, faces, or the name of the exception.
"""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import oracle
import plumbline
import pytest
import shapely

RECORDED = "3.14.1"  # of GEOS, in shapely 2.2.0
CASES: list[dict[str, Any]] = json.loads(
    (Path(__file__).parent / "data" / "public_cases.json").read_text()
)
cases = pytest.mark.parametrize("case", CASES, ids=[case["name"] for case in CASES])


def lines_of(case: dict[str, Any]) -> plumbline.Lines:
    return plumbline.lines([shapely.from_wkt(text) for text in case["wkt"]])


@cases
def test_the_arrangement_is_right(case: dict[str, Any]) -> None:
    lines = lines_of(case)
    counts = plumbline.arrange(lines).counts
    assert (counts.vertices, counts.edges, counts.faces - 1) == oracle.counts(list(lines))


@cases
def test_its_polygons_are_valid_and_lose_nothing(case: dict[str, Any]) -> None:
    arrangement = plumbline.arrange(lines_of(case))
    polygons = arrangement.to_shapely()
    assert shapely.is_valid(polygons).all()
    outline = sum(arrangement.areas, Fraction(0))
    assert shapely.area(polygons).sum() == pytest.approx(float(outline), rel=1e-6, abs=1e-300)


def shapely_counts(lines: plumbline.Lines) -> list[int] | str:
    """Vertices, edges and faces as shapely has them, or its exception."""
    try:
        noded = shapely.get_parts(shapely.node(shapely.MultiLineString(list(lines.to_shapely()))))
    except shapely.GEOSException as error:
        return type(error).__name__
    coords, part = shapely.get_coordinates(noded, return_index=True)
    edges = {
        tuple(sorted((tuple(p), tuple(q))))
        for p, q, a, b in zip(coords[:-1], coords[1:], part[:-1], part[1:])
        if a == b
    }
    vertices = {p for edge in edges for p in edge}
    faces = shapely.get_parts(shapely.polygonize(list(noded)))
    return [len(vertices), len(edges), len(faces)]


@pytest.mark.skipif(shapely.geos_version_string != RECORDED, reason=f"recorded with {RECORDED}")
@cases
def test_shapely_gives_what_was_recorded(case: dict[str, Any]) -> None:
    assert shapely_counts(lines_of(case)) == case["shapely"]


def test_shapely_is_wrong_or_refuses_in_most_of_them() -> None:
    right = [case for case in CASES if case["shapely"] == list(oracle.counts(list(lines_of(case))))]
    assert [case["name"] for case in right] == [
        "coverage unmatched vertex",
        "hole on boundary",
        "build area",
        "one ulp",
    ]
