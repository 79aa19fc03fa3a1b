"""Regions, overlays and dissolved polygons."""

from __future__ import annotations

import pickle
from fractions import Fraction
from typing import Any

import geopandas
import plumbline
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

# The example of GeoPandas' manual, "Set operations with overlay": two layers of two squares each.
FIRST = geopandas.GeoDataFrame(
    {"name": ["a", "b"], "n": [1, 2]}, geometry=shapely.box([0, 2], [0, 2], [2, 4], [2, 4])
)
SECOND = geopandas.GeoDataFrame(
    {"zone": ["x", "y"], "n": [3, 4]}, geometry=shapely.box([1, 3], [1, 3], [3, 5], [3, 5])
)
HOWS = ("intersection", "union", "identity", "symmetric_difference", "difference")

numbers = st.integers(-8, 8)
corners = st.lists(st.tuples(numbers, numbers), min_size=3, max_size=7)


def ring(points: list[tuple[int, int]]) -> str:
    """A polygon of any corners, which need not be valid."""
    return f"POLYGON (({', '.join(f'{x} {y}' for x, y in [*points, points[0]])}))"


def areas(a: str, b: str, rule: Any) -> dict[str, Fraction]:
    functions = [
        plumbline.union,
        plumbline.intersection,
        plumbline.difference,
        plumbline.symmetric_difference,
    ]
    return {f.__name__: f(a, b, rule=rule).area for f in functions}


@settings(max_examples=60, deadline=None)
@given(corners, corners, st.sampled_from(["evenodd", "nonzero", "positive", "negative"]))
def test_areas_add_up(a: list[tuple[int, int]], b: list[tuple[int, int]], rule: Any) -> None:
    one, other = ring(a), ring(b)
    if len({*a}) < 2 or len({*b}) < 2:
        return
    of = areas(one, other, rule)
    of_one, of_other = (plumbline.union_all(x, rule=rule).area for x in (one, other))
    assert of["union"] + of["intersection"] == of_one + of_other
    assert of["difference"] + of["intersection"] == of_one
    assert of["symmetric_difference"] + of["intersection"] == of["union"]


@settings(max_examples=40, deadline=None)
@given(corners, corners, corners)
def test_results_go_on_exactly(
    a: list[tuple[int, int]], b: list[tuple[int, int]], c: list[tuple[int, int]]
) -> None:
    if any(len({*points}) < 2 for points in (a, b, c)):
        return
    one, two, three = ring(a), ring(b), ring(c)
    at_once = plumbline.union_all("\n".join([one, two, three]))
    by_steps = plumbline.union(plumbline.union(three, two), one)
    assert at_once.equals(by_steps)
    rest = plumbline.difference(one, plumbline.union(two, three))
    assert rest.equals(plumbline.difference(plumbline.difference(one, two), three))
    assert not len(plumbline.symmetric_difference(rest, rest))


@pytest.mark.parametrize("how", HOWS)
def test_overlays_are_those_of_geopandas(how: str) -> None:
    made = plumbline.overlay(FIRST, SECOND, how=how)
    table = made.to_geopandas()
    theirs = geopandas.overlay(FIRST, SECOND, how=how)
    assert len(table) == len(theirs) == len(made)
    assert set(theirs.columns) <= set(table.columns)
    assert made.area == Fraction(theirs.area.sum())

    def rows(frame: Any) -> list[str]:
        columns = [c for c in theirs.columns if c != "geometry"]
        texts = frame[columns].astype(object).where(frame[columns].notna(), "-").to_numpy().tolist()
        return sorted(
            f"{text} {geometry.area}" for text, geometry in zip(texts, frame.geometry, strict=True)
        )

    assert rows(table) == rows(theirs)
    assert table.geometry.is_valid.all()


def test_where_features_of_one_layer_overlap_a_piece_is_there_once() -> None:
    first = geopandas.GeoDataFrame(
        {"n": [1, 2]}, geometry=shapely.box([0, 1], [0, 0], [2, 3], [1, 1]), index=["p", "q"]
    )
    made = plumbline.overlay(first, "POLYGON ((0 0, 3 0, 3 1, 0 1, 0 0))", how="identity")
    assert [piece.first for piece in made] == [(0,), (0, 1), (1,)]
    assert [piece.area for piece in made] == [1, 1, 1]
    table = made.to_geopandas()
    assert table["first"].tolist() == [["p"], ["p", "q"], ["q"]]
    assert table["n"].tolist() == [1, [1, 2], 2]


def test_pieces_have_exact_corners_which_neighbours_share() -> None:
    made = plumbline.overlay(
        "POLYGON ((0 0, 3 0, 0 1, 0 0))", "POLYGON ((0 0, 1 0, 0 3, 0 0))", how="union"
    )
    assert len(made) == 3
    meeting = (Fraction(3, 4), Fraction(3, 4))
    assert all(any(meeting in ring for ring in polygons[0]) for polygons in made.polygons)
    assert made.region.equals(
        plumbline.union("POLYGON ((0 0, 3 0, 0 1, 0 0))", "POLYGON ((0 0, 1 0, 0 3, 0 0))")
    )
    interface = made.__geo_interface__
    assert [f["properties"]["first"] for f in interface["features"]] == [
        list(piece.first) for piece in made
    ]
    again = pickle.loads(pickle.dumps(made))
    assert list(again) == list(made)


def test_geos_1525_has_no_intersection() -> None:
    a, b = "POLYGON ((1 0, 1 1, 1 3, 4 0, 1 0))", "POLYGON ((0 4, 1 3, 1 0, 0 4))"
    assert len(plumbline.intersection(a, b)) == 0
    assert plumbline.union_all([shapely.from_wkt(a), shapely.from_wkt(b)]).area == 6


def test_regions_are_shapely_s_and_keep_holes() -> None:
    frame = plumbline.difference(shapely.box(0, 0, 3, 3), shapely.box(1, 1, 2, 2))
    assert frame.area == 8 and len(frame) == 1
    [polygon] = frame.to_shapely()
    assert polygon.is_valid and len(polygon.interiors) == 1
    assert shapely.geometry.shape(frame).area == 8
    assert frame.to_geopandas()["area_exact"].tolist() == ["8"]
    assert [len(ring) for ring in frame.polygons[0]] == [5, 5]
    assert pickle.loads(pickle.dumps(frame)).equals(frame)
    assert plumbline.arrange(frame).counts.faces == 3


def test_select_takes_layers_and_says_what_is_wrong() -> None:
    squares = shapely.box([0, 1], [0, 1], [2, 3], [2, 3])
    plan = geopandas.GeoDataFrame({"layer": ["A", "B"]}, geometry=squares)
    assert plumbline.select(plan, "A ^ B").area == 6
    with pytest.raises(plumbline.Error, match="no region has this name"):
        plumbline.select(plan, "A - C")
    with pytest.raises(plumbline.Error, match="fill rule"):
        plumbline.select(plan, "A", rule="odd")  # type: ignore[arg-type]


def test_dissolve_is_that_of_geopandas() -> None:
    layer = geopandas.GeoDataFrame(
        {"zone": ["b", "a", "b", None], "n": [1, 2, 3, 4]},
        geometry=shapely.box([0, 5, 1, 9], [0] * 4, [2, 6, 3, 10], [1] * 4),
        crs="EPSG:3857",
    )
    made = plumbline.dissolve(layer, by="zone")
    theirs = layer.dissolve(by="zone")
    assert list(made) == ["a", "b"] == theirs.index.tolist()
    assert made["b"].area == 3 and made.members("b") == [0, 2]
    table = made.to_geopandas()
    assert table.index.tolist() == theirs.index.tolist()
    assert table["n"].tolist() == theirs["n"].tolist()
    assert table.crs == layer.crs
    assert table.area.tolist() == theirs.area.tolist()
    assert plumbline.dissolve(layer)[0].area == 5


def test_what_is_no_polygon_is_refused_or_said() -> None:
    with pytest.raises(plumbline.Error, match="none of these lines is a polygon"):
        plumbline.union_all([(0, 0, 1, 1)])
    with pytest.warns(plumbline.LossWarning, match="1 segment is part of no polygon"):
        made = plumbline.union(
            [shapely.box(0, 0, 1, 1), shapely.LineString([(5, 5), (6, 6)])], shapely.box(0, 0, 2, 1)
        )
    assert made.area == 2
    with pytest.raises(plumbline.Error, match="how is one of"):
        plumbline.overlay(FIRST, SECOND, how="xor")


def test_nothing_is_a_layer() -> None:
    empty = plumbline.union_all([])
    assert empty.area == 0 and len(empty) == 0 and empty.to_shapely().tolist() == []
    assert plumbline.union(empty, shapely.box(0, 0, 1, 2)).area == 2
    assert len(plumbline.overlay(FIRST, FIRST.iloc[:0])) == 0
    assert plumbline.overlay(FIRST.iloc[:0], SECOND).to_geopandas().empty


def test_two_reference_systems_are_refused() -> None:
    with pytest.raises(plumbline.Error, match="different reference systems"):
        plumbline.overlay(FIRST.set_crs("EPSG:3857"), SECOND.set_crs("EPSG:4326"))


def test_floats_are_what_is_said() -> None:
    boxes = shapely.box([0] * 3, [0] * 3, [0.1, 0.2, 0.3], [1] * 3)
    assert plumbline.union_all(boxes, numbers="decimals").area == Fraction(3, 10)
    assert plumbline.union_all(boxes).area == Fraction(0.3)
