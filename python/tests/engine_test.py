"""Functions as engines."""

from __future__ import annotations

from typing import Any

import numpy as np
import plumbline
import pytest
import shapely
from check_test import ROOMS, words
from hypothesis import given, settings
from hypothesis import strategies as st


def test_a_function_is_an_engine() -> None:
    def polygonize(segments: np.ndarray[Any, Any]) -> list[shapely.Polygon]:
        segments *= 1  # the array is its own
        lines = shapely.union_all(shapely.linestrings(segments.reshape(-1, 2, 2)))
        return list(shapely.get_parts(shapely.polygonize(shapely.get_parts(lines))))

    engine: plumbline.Engine = polygonize
    check = plumbline.check(engine, ROOMS)
    assert check.agree
    assert check.answer.engine == "polygonize"
    assert repr(check).startswith("<Check of polygonize: agree (the result has polygons alone")


def test_causes_name_the_function() -> None:
    def as_it_is(segments: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
        return segments

    check = plumbline.check(as_it_is, ROOMS)
    assert not check
    assert {cause.stage for cause in check.causes} == {"as_it_is"}


def test_a_crash_of_an_engine_is_told_with_its_name() -> None:
    def breaks(segments: np.ndarray[Any, Any]) -> None:
        raise ZeroDivisionError("of two parallel lines")

    with pytest.raises(plumbline.Error, match="breaks failed: ZeroDivisionError: of two") as caught:
        plumbline.check(breaks, ROOMS)
    assert isinstance(caught.value.__cause__, ZeroDivisionError)
    with pytest.raises(plumbline.Error, match="nothing_at_all returned no result"):
        plumbline.check(nothing_at_all, ROOMS)


def nothing_at_all(segments: np.ndarray[Any, Any]) -> None:
    pass


coordinate = st.integers(0, 6)


integer_segments = st.lists(
    st.tuples(coordinate, coordinate, coordinate, coordinate).filter(lambda s: s[:2] != s[2:]),
    min_size=1,
    max_size=12,
)


@settings(max_examples=60, deadline=None)
@given(integer_segments)
def test_node_and_polygonize_of_shapely_agree_on_integer_drawings(
    segments: list[tuple[int, int, int, int]],
) -> None:
    noded = shapely.node(shapely.MultiLineString([[s[:2], s[2:]] for s in segments]))
    check = plumbline.check(noded, segments)
    assert check.agree, str(check)
    faces = shapely.get_parts(shapely.polygonize(shapely.get_parts(noded)))
    if len(faces):
        assert plumbline.check(faces, segments).agree


@settings(max_examples=40, deadline=None)
@given(integer_segments, st.data())
def test_an_edge_that_is_left_out_is_found(
    segments: list[tuple[int, int, int, int]], data: st.DataObject
) -> None:
    exact = plumbline.arrange(segments)
    vertices, edges = exact.vertices, exact.edges.tolist()
    assert plumbline.check((vertices, edges), segments).agree
    del edges[data.draw(st.integers(0, len(edges) - 1))]
    check = plumbline.check((vertices, edges), exact)
    assert ("edge", "missing") in words(check)
