"""Line work of whatever holds it."""

from __future__ import annotations

import pickle
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import geopandas
import numpy as np
import pandas as pd
import plumbline
import pytest
import shapely

TENTH = Fraction(0.1)


def test_numbers_of_any_kind_are_taken_exactly() -> None:
    row = (1, "1/3", Decimal("0.1"), Fraction(2, 7))
    assert plumbline.lines([row]).exact(0) == (
        (Fraction(1), Fraction(1, 3)),
        (Fraction(1, 10), Fraction(2, 7)),
    )


def test_a_float_is_the_number_that_it_is_unless_decimals_are_asked_for() -> None:
    array = np.array([[0.1, 0, 1, 1]])
    assert plumbline.lines(array).exact(0)[0][0] == TENTH
    assert plumbline.lines(array, numbers="decimals").exact(0)[0][0] == Fraction(1, 10)
    assert "doubles" in repr(plumbline.lines(array))


def test_text_is_what_is_written_unless_doubles_are_asked_for() -> None:
    text = "LINESTRING (0.1 0, 1 1)"
    assert plumbline.lines(text).exact(0)[0][0] == Fraction(1, 10)
    assert plumbline.lines(text, numbers="doubles").exact(0)[0][0] == TENTH


def test_arrays_of_objects_are_taken_exactly() -> None:
    third = Fraction(1, 3)
    for shape in ((1, 4), (1, 2, 2)):
        rows = np.array([0, third, "0.1", 1], dtype=object).reshape(shape)
        assert plumbline.lines(rows).exact(0) == (
            (Fraction(0), third),
            (Fraction(1, 10), Fraction(1)),
        )


def test_large_integers_are_not_rounded() -> None:
    n = 2**60 + 1
    assert plumbline.lines(np.array([[n, 0, 0, 1]])).exact(0)[0][0] == n


def test_geometries_know_their_items_ids_and_rings() -> None:
    geometries = [
        shapely.box(0, 0, 1, 1),
        shapely.MultiPolygon([shapely.box(5, 5, 6, 6), shapely.box(7, 7, 8, 8)]),
        shapely.Point(3, 3),
        None,
        shapely.LineString([(0, 0), (1, 0), (1, 1)]),
    ]
    lines = plumbline.lines(geometries, ids=["a", "b", "c", "d", "e"])
    assert lines.item.tolist() == [0] * 4 + [1] * 8 + [4] * 2
    assert lines.source(1).id == "b"
    assert [item.reason for item in lines.rejected] == ["points are not drawn"]


def test_coordinates_that_are_not_finite_are_listed_and_warned_of() -> None:
    with pytest.warns(plumbline.LossWarning, match="<array>:2 row"):
        lines = plumbline.lines(np.array([[0, 0, 1, 1], [0, 0, np.nan, 1]]))
    assert len(lines) == 1
    assert len(lines.rejected) == 1


@pytest.mark.parametrize(
    "bad",
    [np.zeros((3, 3)), 5, [(1, 2)], [(0, 0, "x", 1)], "what.is.that", object()],
)
def test_what_is_no_line_work_is_refused(bad: object) -> None:
    with pytest.raises(plumbline.Error):
        plumbline.lines(bad)


def test_errors_of_files_say_where() -> None:
    with pytest.raises(plumbline.Error, match="<wkt>:1") as caught:
        plumbline.lines("LINESTRING (0 0, 1 1")
    assert caught.value.line == 1
    with pytest.raises(OSError):
        plumbline.read("there-is-no-such-file.svg")


def test_pickling_keeps_everything() -> None:
    lines = plumbline.lines([(0, 0, "1/3", 0.1), (2, 2, 2, 2)], ids=["x", "y"])
    again = pickle.loads(pickle.dumps(lines))
    assert list(again) == list(lines)
    assert again.source_text(1) == lines.source_text(1)
    assert again.rejected == lines.rejected
    assert again.item.tolist() == lines.item.tolist()


def test_arrays_are_read_only() -> None:
    lines = plumbline.lines([(0, 0, 1, 1)])
    for array in (lines.coords, lines.item):
        with pytest.raises(ValueError):
            array[0] = 0


def test_warnings_point_to_the_line_that_called() -> None:
    with pytest.warns(plumbline.LossWarning) as caught:
        plumbline.arrange(np.array([[0, 0, 1, 1], [0, 0, np.nan, 1]]))
    assert caught[0].filename == __file__


@pytest.mark.parametrize(
    "infinite", [float("nan"), float("inf"), np.float64("nan"), Decimal("NaN")]
)
@pytest.mark.parametrize("other", [1, 1.0, "1"])
def test_what_is_not_finite_is_listed_whatever_stands_beside_it(
    infinite: object, other: object
) -> None:
    with pytest.warns(plumbline.LossWarning, match=":2 row: coordinate is not a finite number"):
        lines = plumbline.lines([(0, 0, 1, 1), (0, 0, infinite, other), (2, 2, 3, other)])
    assert lines.item.tolist() == [0, 2]
    assert len(lines.rejected) == 1


@pytest.mark.parametrize("dtype", [np.float16, np.float32])
def test_short_floats_are_the_decimals_that_they_print_as(dtype: type) -> None:
    rows: Any = np.array([[0.1, 0, 1, 1]], dtype=dtype)
    for values in (rows, list(rows), [tuple(rows[0])]):
        assert plumbline.lines(values, numbers="decimals").exact(0)[0][0] == Fraction(1, 10)
        doubles = plumbline.lines(values, numbers="doubles")
        assert doubles.exact(0)[0][0] == Fraction(float(dtype(0.1)))


def test_integers_beyond_the_doubles_are_exact_and_longdoubles_refused() -> None:
    least = np.iinfo(np.int64).min
    assert plumbline.lines(np.array([[least, 0, 0, 1]])).exact(0)[0][0] == least
    long = np.array([[0.1, 0, 0, 1]], dtype=np.longdouble)
    for values in (long, [tuple(long[0])]):
        with pytest.raises(plumbline.Error, match="double"):
            plumbline.lines(values)


def test_arrays_with_a_mask_are_refused_where_it_is_set() -> None:
    rows: Any = np.ma.masked_array([[0.0, 0, 1, 1], [5, 5, 6, 6]])
    assert len(plumbline.lines(rows)) == 2
    rows[1, 0] = np.ma.masked
    with pytest.raises(plumbline.Error, match="masked"):
        plumbline.lines(rows)


@pytest.mark.parametrize("option", ["ids", "layers"])
def test_ids_and_layers_of_what_has_its_own_are_refused(option: str, examples: Path) -> None:
    line = shapely.LineString([(0, 0), (1, 1)])
    for values in (
        examples / "rooms.wkt",
        str(examples / "rooms.wkt"),
        line.wkt,
        line.wkb,
        shapely.to_geojson(line),
        line.__geo_interface__,
    ):
        with pytest.raises(plumbline.Error, match=option):
            plumbline.lines(values, **{option: ["a"]})  # type: ignore[arg-type]


def test_missing_layers_are_none() -> None:
    line = shapely.LineString([(0, 0), (1, 1)])
    layers = ["a", None, float("nan"), pd.NA, pd.NaT]
    frame = geopandas.GeoDataFrame({"layer": layers}, geometry=[line] * 5)
    lines = plumbline.lines(frame)
    assert [lines.source(i).layer for i in range(5)] == ["a", "", "", "", ""]


class Interface:
    def __init__(self, mapping: dict[str, Any]) -> None:
        self.__geo_interface__ = mapping


def test_geometries_come_in_series_generators_and_as_interfaces() -> None:
    geometries = [shapely.LineString([(0, 0), (0.1, 1)]), shapely.box(2, 2, 3, 3)]
    mappings = [geometry.__geo_interface__ for geometry in geometries]
    wanted = plumbline.lines(geometries)
    for values in (
        pd.Series(geometries, index=["a", "b"]),
        (geometry for geometry in geometries),
        mappings,
        [Interface(mapping) for mapping in mappings],
        [Interface({"type": "Feature", "properties": None, "geometry": m}) for m in mappings],
        [{"type": "FeatureCollection", "features": [{"geometry": m}]} for m in mappings],
    ):
        lines = plumbline.lines(values)
        assert sorted(lines) == sorted(wanted)
        assert lines.item_count == 2
    named = plumbline.lines(mappings, ids=["x", "y"], layers=["k", "l"])
    assert [(named.source(i).id, named.source(i).layer) for i in (0, 1)] == [("x", "k"), ("y", "l")]
    assert plumbline.lines(pd.Series(geometries, index=["a", "b"])).source(1).id == "b"
    assert list(plumbline.lines(memoryview(geometries[0].wkb))) == list(wanted)[:1]
    assert len(plumbline.lines(row for row in [(0, 0, 1, 1)])) == 1


def test_a_file_is_read_whatever_its_name_looks_like(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    name = "POINT (1).wkt"
    Path(name).write_text("LINESTRING (0 0, 1 1)")
    assert len(plumbline.lines(name)) == 1
    assert plumbline.check(name, "LINESTRING (0 0, 1 1)")


def test_a_text_that_is_neither_file_nor_format_says_both() -> None:
    for take in (plumbline.lines, lambda text: plumbline.check(text, [(0, 0, 1, 1)])):
        with pytest.raises(plumbline.FileError, match=r"no such file.* no WKT"):
            take("LINE (0 0, 1 1)")
