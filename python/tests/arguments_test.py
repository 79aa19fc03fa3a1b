"""Arguments that make no sense are refused with an Error that has them in its text."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import geopandas
import numpy as np
import plumbline
import pytest
import shapely

SQUARE = [(0, 0, 1, 0), (1, 0, 1, 1), (1, 1, 0, 1), (0, 1, 0, 0)]
DEEP = "[" * 100_000


def nested() -> dict[str, Any]:
    """A mapping that is nested as deep."""
    result: dict[str, Any] = {"type": "GeometryCollection", "geometries": []}
    for _ in range(5000):
        result = {"type": "GeometryCollection", "geometries": [result]}
    return result


@pytest.mark.parametrize(
    "points",
    [
        None,
        "00",
        5,
        [(0, None)],
        [(0, float("nan"))],
        [(0, "x")],
        [(0, 0, 0)],
        [None],
        np.zeros((2, 3)),
        np.zeros((2, 2, 2)),
        np.zeros(4),
        np.array([[0, np.nan]]),
        np.array([["0", "0"]]),
        np.array([[0, 1j]]),
        np.zeros((1, 2), dtype=np.longdouble),
        np.ma.masked_array([[0.0, 0.0]], mask=[[True, False]]),
    ],
)
def test_points_that_are_none_are_refused(points: Any) -> None:
    with pytest.raises(plumbline.Error):
        plumbline.arrange(SQUARE).locate(points)


@pytest.mark.parametrize("points", [5, [(0, None)], [(0, float("nan"))], [(0, "x")], [(0, 0, 0)]])
def test_isolated_points_that_are_none_are_refused(points: Any) -> None:
    with pytest.raises(plumbline.Error):
        plumbline.arrange(SQUARE, points=points)


def test_points_are_located_exactly_in_all_their_forms() -> None:
    n = 2**60
    far = plumbline.arrange([(n, 0, n + 3, 0), (n + 3, 0, n, 3), (n, 3, n, 0)])
    assert far.locate(np.array([[n + 1, 1], [n + 3, 1], [n - 1, 1]])).tolist() == [1, 0, 0]
    square = plumbline.arrange(SQUARE)
    half = Fraction(1, 2)
    forms: list[Any] = [[(half, half)], (0.5, 0.5), ("1/2", "0.5"), np.array([0.5, 0.5])]
    for points in forms:
        assert square.locate(points).tolist() == [1]
    assert square.locate([]).tolist() == []
    assert square.locate(np.zeros((0, 2))).tolist() == []


@pytest.mark.parametrize("threads", [True, 1.0, "2", -1, np.float64(1)])
def test_threads_are_whole_numbers(threads: Any) -> None:
    calls: list[Callable[..., object]] = [
        plumbline.arrange,
        plumbline.rooms,
        plumbline.cross_check,
        plumbline.lar.arrange,
        lambda lines, **options: plumbline.check(np.array(lines), lines, **options),
        lambda lines, **options: plumbline.lar.arrange(lines, "published", **options),
    ]
    for call in calls:
        with pytest.raises(plumbline.Error, match="threads is a"):
            call(SQUARE, threads=threads)
        for good in (None, 0, 1, np.int64(2), 2**70):
            call(SQUARE, threads=good)


def test_decimals_are_whole_numbers_of_numpy_too() -> None:
    a = plumbline.arrange([(0, 0, 3, 1), (0, 1, 3, 0)])
    one: Any = np.int8(1)
    assert a.rounded(one) == a.rounded(1)
    assert repr(a.rounded(one)) == repr(a.rounded(1))
    wrongs: list[Any] = [True, 1.0, "1", -1, 19]
    for wrong in wrongs:
        with pytest.raises(plumbline.Error, match="decimals"):
            plumbline.snap_round(a, decimals=wrong)
        with pytest.raises(plumbline.Error, match="decimals"):
            plumbline.lar.arrange(SQUARE, "published", decimals=wrong)


def test_functions_of_arrangements_take_line_work() -> None:
    a = plumbline.arrange(SQUARE)
    assert plumbline.snap_round(SQUARE) == plumbline.snap_round(a)
    assert plumbline.triangulate(SQUARE).vertices.tolist() == [[0, 2, 1], [1, 2, 3]]
    assert plumbline.validate(SQUARE) == []
    functions: list[Callable[[Any], object]] = [
        plumbline.snap_round,
        plumbline.triangulate,
        plumbline.validate,
    ]
    for function in functions:
        with pytest.raises(plumbline.Error):
            function(5)


def test_faces_are_whole_numbers() -> None:
    a = plumbline.arrange(SQUARE)
    wrongs: list[Any] = [True, 1.0, "1", None, 0, 2]
    for wrong in wrongs:
        with pytest.raises(plumbline.Error, match="face"):
            a.interior_point(wrong)


def test_json_that_is_nested_too_deep_is_refused() -> None:
    fixed = plumbline.repair(SQUARE)
    calls: list[Callable[[], object]] = [
        lambda: plumbline.check('{"type":' + DEEP, SQUARE),
        lambda: plumbline.check(nested(), SQUARE),
        lambda: plumbline.lines(nested()),
        lambda: plumbline.lines('{"type":' + DEEP),
        lambda: plumbline.undo(fixed.output, nested()),
        lambda: plumbline.lines({"type": "LineString", "coordinates": object()}),
    ]
    for call in calls:
        with pytest.raises(plumbline.Error):
            call()


def test_radii_beyond_the_doubles_are_refused() -> None:
    with pytest.raises(plumbline.Error, match="1e400"):
        plumbline.lar.arrange(SQUARE, radius="1e400")
    with pytest.raises(plumbline.Error, match="1e400"):
        plumbline.lar.arrange(SQUARE, "published", radius="1e400")
    with pytest.raises(plumbline.Error, match="1e400"):
        plumbline.cross_check(SQUARE, radius="1e400")


def test_texts_that_are_no_unicode_are_refused() -> None:
    wrong = "a\ud800"
    with pytest.raises(plumbline.Error, match="ud800"):
        plumbline.lines(SQUARE, ids=[wrong] * 4)
    with pytest.raises(plumbline.Error, match="ud800"):
        plumbline.lines(SQUARE, layers=[wrong] * 4)
    with pytest.raises(plumbline.Error):
        plumbline.lines("LINESTRING (0 0, 1 1) " + wrong)
    single: Any = 5
    with pytest.raises(plumbline.Error, match="ids"):
        plumbline.lines(SQUARE, ids=single)


def test_formats_are_names(tmp_path: Path) -> None:
    path = tmp_path / "a.wkt"
    path.write_text("LINESTRING (0 0, 1 1)")
    calls: list[Callable[[Any], object]] = [
        lambda format: plumbline.read(path, format=format),
        lambda format: plumbline.write(plumbline.arrange(SQUARE), path, format=format),
        lambda format: plumbline.repair(SQUARE).write(path, format=format),
    ]
    for call in calls:
        with pytest.raises(plumbline.Error, match="format"):
            call(5)


def test_counts_may_be_large_and_are_not_negative() -> None:
    assert plumbline.diagnose(SQUARE, most_listed=2**70).defects == []
    assert len(plumbline.ladder(SQUARE, max_steps=2**70)) > 0
    results: list[Any] = [
        plumbline.rooms(SQUARE),
        plumbline.repair(SQUARE),
        plumbline.cross_check(SQUARE),
    ]
    for result in results:
        assert result.to_text(2**70)
        for wrong in (-1, 1.5, "1"):
            with pytest.raises(plumbline.Error, match="listed"):
                result.to_text(wrong)


def test_a_series_is_no_table(tmp_path: Path) -> None:
    series = geopandas.GeoSeries([shapely.Point(0, 0)])
    for ending in ("geojson", "gpkg", "parquet", "svg"):
        with pytest.raises(plumbline.Error, match="GeoSeries"):
            plumbline.write(series, tmp_path / f"a.{ending}")


def test_different_reference_systems_are_refused_and_unknown_ones_are_not() -> None:
    box = [shapely.box(0, 0, 1, 1)]
    one, other, unknown = (geopandas.GeoSeries(box, crs=crs) for crs in (4326, 3857, None))
    text = geopandas.GeoSeries(box, crs=one.crs.to_wkt())
    functions: list[Callable[[Any, Any], object]] = [
        plumbline.check,
        plumbline.compare,
        plumbline.same,
    ]
    for function in functions:
        for a, b in ((one, other), (plumbline.arrange(one), other), (one, plumbline.lines(other))):
            with pytest.raises(plumbline.Error, match="different reference systems"):
                function(a, b)
        for a, b in ((one, one), (one, unknown), (unknown, other), (one, text)):
            assert function(a, b)


def test_lists_have_what_lists_have() -> None:
    lists = plumbline.arrange(SQUARE).cycles
    first = lists[0]
    assert first in lists
    assert first.tolist() in lists
    assert [0] not in lists
    assert "a" not in lists
    assert [[0, 1], [0]] not in lists
    assert lists.index(lists[1]) == 1
    assert lists.count(first) == 1
    with pytest.raises(ValueError, match="no such list"):
        lists.index([7])
    one: Any = np.uint32(1)
    assert lists[one].tolist() == lists[-1].tolist()


def test_what_is_kept_cannot_be_changed() -> None:
    a = plumbline.arrange([*SQUARE, (0, 0, -1, -1)])
    with pytest.raises(ValueError, match="read-only"):
        a.antennas[0] = 7
    assert isinstance(a.areas, tuple)
    sourced = plumbline.polygonize(SQUARE)
    with pytest.raises(ValueError, match="read-only"):
        sourced.geometries[0] = None
    for lists in (a.cycles, sourced.sources):
        for array in (lists.indptr, lists.indices, lists[0]):
            with pytest.raises(ValueError, match="read-only"):
                array[0] = 0
    cycles: Any = a.cycles
    with pytest.raises(AttributeError):
        cycles.indices = cycles.indptr
