"""Line work of whatever holds it."""

from __future__ import annotations

import pickle
from decimal import Decimal
from fractions import Fraction

import numpy as np
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
    [np.zeros((3, 3)), 5, [(1, 2)], [(0, 0, "x", 1)], [(0, 0, float("inf"), "1")], object()],
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
