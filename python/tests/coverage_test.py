"""Coverages and valid polygons."""

from __future__ import annotations

from fractions import Fraction

import geopandas
import plumbline
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

# Three parcels: the first two overlap by 1, between the second and the third is a gap of 1 x 1,
# closed by the fourth and the fifth.
PARCELS = geopandas.GeoDataFrame(
    {"owner": list("abcde")},
    geometry=shapely.box([0, 3, 7, 3, 3], [0, 0, 0, -1, 1], [4, 6, 9, 9, 9], [1, 1, 1, 0, 2]),
)


def test_faults_are_said_with_exact_sizes() -> None:
    faults = plumbline.coverage_faults(PARCELS)
    places = [(f.kind, f.features, f.area) for f in faults if f.kind != "unmatched vertex"]
    assert places == [
        ("overlap", (0, 1), Fraction(1)),
        ("gap", (1, 2, 3, 4), Fraction(1)),
    ]
    assert faults[1].width == pytest.approx(1, rel=0.05)
    assert not plumbline.coverage_is_valid(PARCELS)


def test_gaps_count_up_to_a_width() -> None:
    closed = shapely.from_wkt(
        [
            "POLYGON ((0 0, 3 0, 3 3, 2 3, 2 1, 1 1, 0 1, 0 0))",
            "POLYGON ((0 1, 1 1, 1 2, 2 2, 2 3, 0 3, 0 1))",
        ]
    )
    # The gap is the square from (1, 1) to (2, 2), whose corner (2, 2) is within a side.
    matched = shapely.from_wkt(
        [
            "POLYGON ((0 0, 3 0, 3 3, 2 3, 2 2, 2 1, 1 1, 0 1, 0 0))",
            "POLYGON ((0 1, 1 1, 1 2, 2 2, 2 3, 0 3, 0 1))",
        ]
    )
    assert not plumbline.coverage_is_valid(closed)
    assert plumbline.coverage_is_valid(matched)
    assert plumbline.coverage_is_valid(matched, gap_width="1/2")
    assert not plumbline.coverage_is_valid(matched, gap_width=2)


@pytest.mark.parametrize("policy", ["longest-border", "largest", "smallest", "first"])
def test_clean_coverages_are_valid_and_cover_the_same(policy: str) -> None:
    made = plumbline.coverage_clean(PARCELS, policy=policy)  # type: ignore[arg-type]
    table = made.to_geopandas()
    assert table["owner"].tolist() == list("abcde")
    assert shapely.coverage_is_valid(table.geometry.to_numpy())
    assert plumbline.coverage_is_valid(table)
    assert sum(made.areas) == plumbline.union_all(PARCELS).area + 1
    assert [change.kind for change, _ in made.changes] == ["overlap", "gap"]
    assert made.vanished == [] and len(made) == len(made.polygons) == 5


def test_what_is_large_stays() -> None:
    made = plumbline.coverage_clean(PARCELS, area=Fraction(1, 2))
    assert made.changes == []
    with pytest.raises(plumbline.Error, match="a policy is"):
        plumbline.coverage_clean(PARCELS, policy="best")  # type: ignore[arg-type]


corners = st.lists(st.tuples(st.integers(0, 6), st.integers(0, 6)), min_size=4, max_size=8)


@settings(max_examples=150, deadline=None)
@given(corners)
def test_polygons_are_valid_as_by_shapely(points: list[tuple[int, int]]) -> None:
    polygon = shapely.Polygon(points)
    if len({*points}) < 2:
        return
    assert plumbline.is_valid([polygon]).tolist() == [bool(shapely.is_valid(polygon))]
    [made] = plumbline.make_valid([polygon])
    assert all(part.is_valid for part in made.to_shapely())
    assert made.equals(plumbline.union_all([polygon]))
    # Where a ring runs along itself GEOS takes a side that is drawn twice as one drawn once.
    if all(problem.until is None for problem in plumbline.validity([polygon])):
        assert float(made.area) == pytest.approx(shapely.make_valid(polygon).area)
    [nonzero] = plumbline.make_valid([polygon], method="nonzero")
    assert nonzero.equals(plumbline.union_all([polygon], rule="nonzero"))


def test_reasons_are_in_the_words_of_geos() -> None:
    layer = [
        shapely.box(0, 0, 1, 1),
        shapely.from_wkt("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (5 5, 6 5, 6 6, 5 5))"),
        shapely.LineString([(0, 0), (1, 1)]),
    ]
    assert plumbline.is_valid_reason(layer) == [
        "Valid Geometry",
        "Hole lies outside shell[5 5]",
        "No polygon",
    ]
    assert plumbline.is_valid(layer).tolist() == [True, False, False]
    assert [region.area for region in plumbline.make_valid(layer, method="structure")] == [1, 16, 0]
