"""Results held against the exact arrangement of their drawing."""

from __future__ import annotations

import gc
import html
import json
import pickle
import warnings
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from pathlib import Path
from typing import Any

import geopandas
import numpy as np
import plumbline
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

# GEOS issue 1525, "CoverageCleaner does not add a vertex": two overlapping polygons; the merge that
# is right, and the one that GEOS made, in whose second ring the vertex (1, 1) is missing.
OVERLAPPING = "POLYGON ((1 0, 1 1, 1 3, 4 0, 1 0))\nPOLYGON ((0 4, 1 3, 1 0, 0 4))"
RIGHT_MERGE = "POLYGON ((1 0, 1 1, 1 3, 4 0, 1 0))\nPOLYGON ((0 4, 1 3, 1 1, 1 0, 0 4))"

# Two rooms, and a wall that ends in the second one.
ROOMS = [(0, 0, 4, 0), (4, 0, 4, 2), (4, 2, 0, 2), (0, 2, 0, 0), (2, 0, 2, 2), (2, 1, 3, 1)]
V = [(0, 0), (0, 2), (2, 0), (2, 1), (2, 2), (3, 1), (4, 0), (4, 2)]
EV = [(0, 1), (0, 2), (1, 4), (2, 3), (2, 6), (3, 4), (3, 5), (4, 7), (6, 7)]
FV = [[0, 2, 3, 4, 1], [2, 6, 7, 4, 3]]
POLYGONS = [
    shapely.Polygon([(0, 0), (2, 0), (2, 1), (2, 2), (0, 2)]),
    shapely.Polygon([(2, 0), (4, 0), (4, 2), (2, 2), (2, 1)]),
]


def words(check: plumbline.Check) -> list[tuple[str, str]]:
    return [(f.kind, f.disagreement) for f in check.findings]


def test_the_merge_that_is_right_agrees() -> None:
    check = plumbline.check(RIGHT_MERGE, OVERLAPPING)
    assert check.agree
    assert bool(check)
    assert check.compared == "faces"
    assert check.exact.areas[1:] == (Fraction(3, 2), Fraction(9, 2))


def test_the_merge_of_geos_lacks_a_vertex() -> None:
    check = plumbline.check(OVERLAPPING, OVERLAPPING)
    assert not check
    vertex_on_edge = [f for f in check.findings if f.invariant == "vertex on edge"]
    assert {f.where for f in vertex_on_edge} == {(Fraction(1), Fraction(1))}


@pytest.mark.parametrize(
    ("result", "compared"),
    [
        ((V, EV), "graph"),
        ((np.array(V, dtype=float), np.array(EV), FV), "all"),
        ((V, EV, [sorted(face) for face in FV]), "all"),
        ((V, None, FV[:1]), "faces"),
        ({"V": V, "EV": EV}, "graph"),
        ({"V": V, "EV": [[a + 1, b + 1] for a, b in EV], "index_base": 1}, "graph"),
        (POLYGONS, "faces"),
        (geopandas.GeoSeries(POLYGONS), "faces"),
        (geopandas.GeoDataFrame({"name": ["a", "b"]}, geometry=POLYGONS), "faces"),
        (shapely.MultiPolygon(POLYGONS), "faces"),
        (shapely.GeometryCollection([*POLYGONS, shapely.LineString([(2, 1), (3, 1)])]), "all"),
        (shapely.node(shapely.MultiLineString([[s[:2], s[2:]] for s in ROOMS])), "graph"),
        ([[*V[a], *V[b]] for a, b in EV], "graph"),
        (np.array([[V[a], V[b]] for a, b in EV]), "graph"),
        (json.dumps({"V": V, "EV": EV}), "graph"),
        (shapely.to_geojson(shapely.MultiPolygon(POLYGONS)), "faces"),
        (shapely.to_wkt(shapely.MultiPolygon(POLYGONS)), "faces"),
    ],
)
def test_results_of_every_form_agree(result: Any, compared: str) -> None:
    some = compared == "faces" and isinstance(result, tuple)
    check = plumbline.check(result, ROOMS, some_faces=some)
    assert check.agree, str(check)
    assert check.compared == ("some faces" if some else compared)


def test_an_arrangement_is_a_result_with_its_exact_coordinates() -> None:
    thirds = [("1/3", 0, "1/3", 1), (0, "1/7", 1, "1/7")]
    check = plumbline.check(plumbline.arrange(thirds), thirds, tolerance=0)
    assert check.agree
    assert check.largest_displacement == 0
    assert not plumbline.check(plumbline.arrange(thirds[:1]), thirds)


def test_a_result_in_memory_is_what_it_is_as_a_file(tmp_path: Path) -> None:
    moved = [(x + (0.1 if i == 3 else 0), y) for i, (x, y) in enumerate(V)]
    file = tmp_path / "result.json"
    file.write_text(json.dumps({"V": moved, "EV": EV, "FV": FV}))
    of_file, of_lists = plumbline.check(file, ROOMS), plumbline.check((moved, EV, FV), ROOMS)
    assert [f.message for f in of_file.findings] == [f.message for f in of_lists.findings]
    assert of_file.answer.title == str(file)


def test_a_shifted_vertex_is_found_and_told_exactly() -> None:
    shifted = [(x, y + (0.25 if i == 5 else 0)) for i, (x, y) in enumerate(V)]
    check = plumbline.check((shifted, EV), ROOMS, tolerance="0.3")
    assert check.agree
    assert check.largest_displacement == 0.25
    check = plumbline.check((shifted, EV), ROOMS, tolerance=Fraction(1, 5))
    assert check.tolerance == 0.2
    moved = check.findings[0]
    assert (moved.kind, moved.disagreement) == ("vertex", "moved")
    assert moved.squared_distance == Fraction(1, 16)
    assert moved.where == (Fraction(3), Fraction(1))
    assert check.exact.points[moved.exact_cells[0]] == moved.where
    assert check.answer.vertices[moved.answer_cells[0]].tolist() == [3, 1.25]
    assert [ROOMS[s] for s in moved.segments] == [ROOMS[5]]


EMPTY_RESULTS: list[Any] = [
    [],
    np.empty((0, 4)),
    ([], []),
    ([], [], []),
    geopandas.GeoSeries([]),
    shapely.Polygon(),
    "GEOMETRYCOLLECTION EMPTY",
    {"type": "FeatureCollection", "features": []},
    lambda segments: [],
]


@pytest.mark.parametrize("result", EMPTY_RESULTS)
def test_an_empty_result_never_agrees(result: Any) -> None:
    check = plumbline.check(result, ROOMS)
    assert not check.agree
    assert not check
    assert ("vertex", "missing") in words(check)


@pytest.mark.parametrize("drawing", [[], np.empty((0, 4)), [(1, 1, 1, 1)]])
def test_of_an_empty_drawing_nothing_is_said(drawing: Any) -> None:
    with pytest.raises(plumbline.Error, match="nothing is drawn"):
        plumbline.check([], drawing)
    with pytest.raises(plumbline.Error, match="nothing is drawn"):
        plumbline.cross_check(drawing)


BAD_RESULTS: list[Any] = [
    5,
    None,
    object(),
    ([(0, 0), (1, float("nan"))], [(0, 1)]),
    ([(0, 0), (1, 1)], [(0, 2**40)]),
    ([(0, 0), (1, 1)], [(0, -1)]),
    ([(0, 0), (1, 1)], [0, 1]),
    ([(0, 0), (1,)], [(0, 1)]),
    ([(0, 0), ("x", 1)], [(0, 1)]),
    np.array([[0, 0, np.inf, 1]]),
    np.zeros((2, 3)),
    {"EV": EV},
    {"V": V, "EV": object()},
    [shapely.Point(0, 0).buffer(1), 7],
    "no-such-file.json",
    "{",
    "POLYGON ((0 0, 1",
]


@pytest.mark.parametrize("result", BAD_RESULTS)
def test_what_is_no_result_is_refused(result: Any) -> None:
    with pytest.raises(plumbline.Error):
        plumbline.check(result, ROOMS)


def test_geometries_that_are_not_finite_are_named() -> None:
    with np.errstate(invalid="ignore"):
        line = shapely.LineString([(0, 0), (np.nan, 1)])
    with pytest.raises(plumbline.Error, match="geometry 1"):
        plumbline.check([POLYGONS[0], line], ROOMS)


@pytest.mark.parametrize(
    "tolerance",
    [-1, "-1e-9", float("nan"), float("inf"), "wide", "1/0", "1e999999999", 10**400, True],
)
def test_bad_tolerances_are_refused(tolerance: Any) -> None:
    with pytest.raises(plumbline.Error, match="tolerance"):
        plumbline.check((V, EV), ROOMS, tolerance=tolerance)


def test_points_of_a_result_are_told_and_do_not_count() -> None:
    check = plumbline.check([*POLYGONS, shapely.Point(1, 1)], ROOMS)
    assert check.agree


number = st.floats(min_value=-1e99, max_value=1e99)


@settings(max_examples=50, deadline=None)
@given(
    st.lists(
        st.tuples(number, number),
        min_size=2,
        max_size=5,
        unique=True,
    )
)
def test_coordinates_of_geometries_cross_unchanged(points: list[tuple[float, float]]) -> None:
    line = shapely.LineString(points)
    answer = plumbline.check(line, ROOMS).answer
    assert {tuple(p) for p in answer.vertices.tolist()} == set(points)


@pytest.fixture(scope="module")
def wrong() -> plumbline.Check:
    return plumbline.check((V, EV[:-2]), plumbline.arrange(ROOMS))


def test_a_check_tells_counts_of_both_sides(wrong: plumbline.Check) -> None:
    assert (wrong.exact_counts.vertices, wrong.answer_counts.vertices) == (8, 8)
    assert (wrong.exact_counts.edges, wrong.answer_counts.edges) == (9, 7)
    assert wrong.matched[1] == 7
    assert wrong.own_findings == 0
    assert wrong.doubles == wrong.exact
    assert wrong.conversion_findings == []
    assert [n for group in wrong.groups for n in group.findings] == [1, 2]
    assert len(wrong.causes) == len(wrong.findings) == 2


def test_the_arrangement_in_doubles_has_lines_of_its_own() -> None:
    tee = [("0", 0, "0.9", "0.3"), ("0.3", "0.2", "0.3", "0.1"), ("1e-400", 0, 0, 0)]
    check = plumbline.cross_check(tee)
    assert {f.kind for f in check.conversion_findings} >= {"vertex", "edge"}
    assert len(check.doubles.lines) == 2
    assert check.doubles == plumbline.arrange(np.array(tee, dtype=float), numbers="doubles")
    assert plumbline.validate(check.doubles) == []
    assert pickle.loads(pickle.dumps(check.doubles)) == check.doubles
    assert check.doubles.lines.source_text(1) == check.exact.lines.source_text(1)


def test_findings_outlive_their_check() -> None:
    findings = plumbline.check((V, EV[:-2]), ROOMS).findings
    faces = plumbline.cross_check([(0, 0, 8, 0), (0, "0.001", 8, 0)]).groups
    gc.collect()
    assert [f.kind for f in findings] == ["edge", "edge"]
    assert faces[0].lead == 1


def test_texts_pictures_and_pages_are_of_this_check(wrong: plumbline.Check) -> None:
    assert str(wrong) == wrong.to_text()
    assert repr(wrong).startswith("<Check of <LAR model>: disagree: 2 findings")
    assert "\n" not in repr(wrong)
    said = json.loads(wrong.to_json())
    assert said["verdict"] == "disagree"
    assert len(said["findings"]) == 2
    assert wrong.to_svg().startswith("<svg")
    assert wrong.to_html().lower().startswith("<!doctype html")


def test_checks_are_written_in_all_their_forms(wrong: plumbline.Check, tmp_path: Path) -> None:
    def written(ending: str) -> str:
        plumbline.write(wrong, tmp_path / f"check.{ending}")
        return (tmp_path / f"check.{ending}").read_text()

    assert written("json") == wrong.to_json()
    assert written("html") == wrong.to_html()
    assert len(json.loads(written("geojson"))["features"]) == 2
    assert written("csv").count("\n") == 3
    with pytest.raises(plumbline.Error, match="a check is written as"):
        written("obj")
    with pytest.raises(plumbline.Error, match="without options: cells"):
        plumbline.write(wrong, tmp_path / "check.json", cells="faces")


def test_notebooks_show_the_page_in_a_sandbox(wrong: plumbline.Check) -> None:
    shown = wrong._repr_html_()
    assert shown is not None
    assert 'sandbox="allow-scripts"' in shown
    page = shown.partition('srcdoc="')[2].partition('"')[0]
    assert html.unescape(page) == wrong.to_html()


def test_findings_go_to_geopandas(wrong: plumbline.Check) -> None:
    frame = wrong.to_geopandas()
    assert frame["number"].tolist() == [1, 2]
    assert frame["group"].tolist() == [1, 2]
    assert frame["disagreement"].tolist() == ["missing", "missing"]
    places = [tuple(map(float, f.where)) for f in wrong.findings]
    assert shapely.get_coordinates(frame.geometry).tolist() == [list(p) for p in places]
    agreeing = plumbline.check((V, EV), ROOMS).to_geopandas()
    assert list(agreeing.columns) == list(frame.columns)
    assert len(agreeing) == 0


def test_findings_keep_the_reference_system() -> None:
    lines = geopandas.GeoSeries(
        shapely.linestrings(np.array(ROOMS, dtype=float).reshape(-1, 2, 2)), crs="EPSG:25832"
    )
    assert plumbline.check(POLYGONS[:1], lines).to_geopandas().crs == "EPSG:25832"


def test_a_check_says_why_it_cannot_be_pickled(wrong: plumbline.Check) -> None:
    with pytest.raises(TypeError, match="a Check cannot be pickled"):
        pickle.dumps(wrong)


def test_lost_parts_of_a_result_are_warned_of_and_are_no_agreement() -> None:
    text = json.dumps(
        {
            "type": "GeometryCollection",
            "geometries": [
                shapely.geometry.mapping(POLYGONS[0]),
                shapely.geometry.mapping(POLYGONS[1]),
                {"type": "Curve", "coordinates": [[0, 0], [1, 1]]},
            ],
        }
    )
    with pytest.warns(plumbline.LossWarning, match="of the result cannot be read"):
        check = plumbline.check(text, ROOMS)
    assert check.agree
    assert not check


def test_several_threads_may_check_at_once() -> None:
    drawing = plumbline.arrange(ROOMS)
    with ThreadPoolExecutor(4) as pool:
        checks = pool.map(lambda _: plumbline.cross_check(drawing).to_json(), range(12))
    assert len(set(checks)) == 1


def test_there_are_no_warnings_where_all_is_read() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        plumbline.check((V, EV, FV), ROOMS)


def test_an_arrangement_in_lar_s_words_agrees_with_itself() -> None:
    frame = [(0, 0, 9, 0), (9, 0, 9, 9), (9, 9, 0, 9), (0, 9, 0, 0)]
    hole = [(2, 2, 4, 2), (4, 2, 4, 4), (4, 4, 2, 4), (2, 4, 2, 2)]
    drawing = [*frame, *hole, (0, 5, 1, 6), (6, 6, 7, 7)]
    a = plumbline.arrange(drawing)
    assert a.FV.lengths.tolist() == [9, 4]
    assert plumbline.check((a.V, a.EV, a.FV), drawing)


@pytest.mark.parametrize("seed", range(40))
def test_faces_as_sets_of_vertices_are_understood(seed: int) -> None:
    random = np.random.default_rng(seed)
    rows = random.integers(0, 9, size=(10, 4))
    a = plumbline.arrange(rows)
    sets = [sorted(set(face.tolist())) for face in a.FV]
    assert plumbline.check((a.V, a.EV, sets), a)
