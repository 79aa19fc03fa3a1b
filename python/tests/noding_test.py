"""Shapely's functions, exactly."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import numpy as np
import pandas as pd
import plumbline
import pytest
import shapely
from drawings import polylines, segments, undirected
from hypothesis import given, settings
from shapely import LineString, MultiLineString, Point


def same_polygons(ours: Any, theirs: Any) -> bool:
    return bool(shapely.normalize(ours.geometry) == shapely.normalize(theirs))


# Examples of shapely's documentation, and what it shows.


def test_node_gives_what_shapely_documents() -> None:
    line = LineString([(0, 0), (1, 1), (0, 1), (1, 0)])
    assert repr(plumbline.node(line)) == (
        "<MULTILINESTRING ((0 0, 0.5 0.5), (0.5 0.5, 1 1, 0 1, 0.5 0.5), (0.5 0.5, 1 0))>"
    )
    assert repr(plumbline.node(Point(1, 1))) == "<MULTILINESTRING EMPTY>"


def test_polygonize_gives_what_shapely_documents() -> None:
    lines = [
        LineString([(0, 0), (1, 1)]),
        LineString([(0, 0), (0, 1)]),
        LineString([(0, 1), (1, 1)]),
    ]
    documented = shapely.from_wkt("GEOMETRYCOLLECTION (POLYGON ((1 1, 0 0, 0 1, 1 1)))")
    assert same_polygons(plumbline.polygonize(lines), documented)
    assert shapely.polygonize(lines) == documented


OVERLAPPING = [
    LineString([(0, 0), (1, 1)]),
    LineString([(0, 0), (0, 1), (1, 1)]),
    LineString([(0, 1), (1, 1)]),
]


def test_polygonize_full_of_lines_joined_at_ends_gives_what_shapely_documents() -> None:
    polygons, cuts, dangles, invalid = plumbline.polygonize_full(OVERLAPPING, noded=True)
    documented = shapely.from_wkt("GEOMETRYCOLLECTION (POLYGON ((1 1, 0 0, 0 1, 1 1)))")
    assert same_polygons(polygons, documented)
    assert (repr(cuts), repr(invalid)) == ("<GEOMETRYCOLLECTION EMPTY>",) * 2
    assert repr(dangles) == "<GEOMETRYCOLLECTION (LINESTRING (0 1, 1 1))>"
    assert dangles.sources.tolist() == [[2]]


def test_polygonize_full_takes_a_line_on_another_for_a_part_of_it() -> None:
    polygons, cuts, dangles, invalid = plumbline.polygonize_full(OVERLAPPING)
    assert polygons.sources.tolist() == [[0, 1, 2]]
    assert [len(cuts), len(dangles), len(invalid)] == [0, 0, 0]
    noded = shapely.get_parts(shapely.node(MultiLineString(OVERLAPPING)))
    its_dangles = shapely.polygonize_full(noded)[2]  # of lines that it noded itself
    assert shapely.get_num_geometries(its_dangles) == 0


# Against shapely, where doubles suffice for it.


@pytest.mark.parametrize("seed", range(60))
def test_node_gives_the_lines_of_shapely(seed: int) -> None:
    lines = polylines(seed)
    ours = plumbline.node(MultiLineString(lines))
    theirs = shapely.node(MultiLineString(lines))
    assert undirected(ours) == undirected(theirs.geoms)


@pytest.mark.parametrize("seed", range(60))
def test_polygonize_full_gives_what_shapely_makes_of_noded_lines(seed: int) -> None:
    lines = polylines(seed)
    noded = shapely.get_parts(shapely.node(MultiLineString(lines)))
    theirs: Any = shapely.polygonize_full(noded)
    for noded_already in (False, True):
        given = noded if noded_already else lines
        ours = plumbline.polygonize_full(given, noded=noded_already)
        assert same_polygons(ours[0], theirs[0])
        for mine, its in zip(ours[1:3], theirs[1:3]):
            assert undirected(mine) == undirected(its.geoms)
        assert theirs[3].is_empty and not len(ours[3])
    assert same_polygons(plumbline.polygonize(lines), theirs[0])


def test_node_needs_no_second_time_where_shapely_does() -> None:
    rng = np.random.default_rng(5)
    ends = rng.uniform(0, 1, (150, 4))
    ours = plumbline.node(ends)
    again = plumbline.node(ours)
    assert undirected(again) == undirected(ours)
    once = shapely.node(MultiLineString(list(ends.reshape(-1, 2, 2))))
    assert len(shapely.node(once).geoms) != len(once.geoms) or len(ours) == len(once.geoms)


@settings(deadline=None, max_examples=60)
@given(segments)
def test_node_holds_where_doubles_are_coarse(drawing: list[tuple[str, ...]]) -> None:
    far = 2**51  # doubles are 1/2 apart there
    rows = [[far + 3 * float(c) for c in row] for row in drawing]
    noded = plumbline.node(rows)
    assert undirected(plumbline.node(noded)) == undirected(noded)
    given_lines: Any = shapely.linestrings(np.array(rows).reshape(-1, 2, 2))
    for line, sources in zip(noded, noded.sources):
        assert len(sources)
        assert (shapely.distance(given_lines[sources], shapely.get_point(line, 0)) <= 0.5).all()


def test_repeated_points_make_no_lines_without_length() -> None:
    line = LineString([(0, 0), (1, 0), (1, 0), (1, 0), (2, 1)])
    assert plumbline.node(line).wkt == "MULTILINESTRING ((0 0, 1 0, 2 1))"


# Sources.


def test_sources_are_all_parents() -> None:
    lines = [LineString([(0, 0), (3, 0)]), LineString([(2, 0), (1, 0)]), Point(9, 9)]
    noded = plumbline.node(lines)
    assert [line.wkt for line in noded] == [
        "LINESTRING (0 0, 1 0)",
        "LINESTRING (1 0, 2 0)",
        "LINESTRING (2 0, 3 0)",
    ]
    assert noded.sources.tolist() == [[0], [0, 1], [0]]


def test_a_single_collection_has_its_parts_for_items() -> None:
    net = plumbline.node(shapely.GeometryCollection([Point(0, 0), shapely.box(0, 0, 1, 1)]))
    assert net.sources.tolist() == [[1]]
    assert net.geometry.geoms[0].is_closed


def test_segments_that_are_not_geometries_have_items_too() -> None:
    noded = plumbline.node([(0, 0, 2, 2), (0, 2, 2, 0)])
    assert noded.sources.tolist() == [[0], [0], [1], [1]]
    thirds = plumbline.polygonize([(0, 0, "1/3", 0), ("1/3", 0, 0, 1), (0, 1, 0, 0)])
    assert thirds.sources.tolist() == [[0, 1, 2]]
    assert thirds.area == pytest.approx(float(Fraction(1, 6)))


def test_what_bounds_a_polygon_is_named_and_what_ends_in_it() -> None:
    square = shapely.box(0, 0, 4, 4)
    dangling = LineString([(1, 2), (4, 2)])
    bridge = LineString([(5, 5), (4, 4)])
    polygons, cuts, dangles, _ = plumbline.polygonize_full(
        [square, dangling, bridge, shapely.box(5, 5, 6, 6)]
    )
    assert polygons.sources.tolist() == [[0, 1], [3]]
    assert [line.wkt for line in cuts] == ["LINESTRING (5 5, 4 4)"]
    assert dangles.sources.tolist() == [[1]]


def test_lines_that_cross_are_refused_as_noded_ones() -> None:
    crossing = [LineString([(0, 0), (2, 2), (2, 0), (0, 2), (0, 0)])]
    with pytest.raises(plumbline.Error, match="geometry 0 meets others"):
        plumbline.polygonize_full(crossing, noded=True)
    with pytest.raises(plumbline.Error, match="geometry 0 meets others"):
        plumbline.polygonize_full([shapely.box(0, 0, 1, 1).exterior] * 2, noded=True)
    with pytest.raises(plumbline.Error, match="noded lines are geometries"):
        plumbline.polygonize_full([(0, 0, 1, 1)], noded=True)


def test_results_are_taken_by_shapely_and_geopandas() -> None:
    import geopandas

    noded = plumbline.node([(0, 0, 2, 2), (0, 2, 2, 0)])
    assert shapely.length(noded).sum() == pytest.approx(noded.length)
    assert len(geopandas.GeoSeries(noded)) == 4
    assert shapely.get_num_geometries(noded.geometry) == 4
    assert noded.__geo_interface__["type"] == "MultiLineString"
    assert noded == noded.geometry
    assert pickle.loads(pickle.dumps(noded)) == noded
    for nothing in ([], np.array([], dtype=object), geopandas.GeoSeries([]), [None]):
        assert plumbline.polygonize(nothing).is_empty


@pytest.mark.parametrize("infinite", [float("nan"), float("inf")])
def test_noded_lines_that_are_not_finite_are_warned_of(infinite: float) -> None:
    with np.errstate(invalid="ignore"):
        lines = [shapely.box(0, 0, 1, 1), shapely.LineString([(0, 0), (infinite, 1)])]
    with pytest.warns(plumbline.LossWarning, match="geometry 1: coordinate is not a finite number"):
        polygons, cuts, dangles, _ = plumbline.polygonize_full(lines, noded=True)
    assert (len(polygons), len(cuts), len(dangles)) == (1, 0, 0)


def test_geometries_in_generators_and_series_are_those_in_lists() -> None:
    boxes = [shapely.box(0, 0, 2, 2), shapely.box(1, 1, 3, 3)]
    functions: list[Callable[[Any], plumbline.Sourced]] = [
        plumbline.node,
        plumbline.polygonize,
        lambda values: plumbline.polygonize_full(values)[0],
        lambda values: plumbline.polygonize_full(values, noded=True)[0],
    ]
    for function in functions:
        one = boxes[:1]
        assert function(box for box in one) == function(one)
        assert function(pd.Series(one)) == function(one)
    assert plumbline.node(box for box in boxes) == plumbline.node(boxes)
