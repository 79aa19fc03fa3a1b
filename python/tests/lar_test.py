"""LAR's functions: as the original module recorded it, and exactly."""

from __future__ import annotations

import json
import pickle
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import plumbline
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from plumbline import lar

Case = dict[str, Any]
ROOM = [(0, 0, 7, 0), (7, 0, 7, 11), (7, 11, 0, 11), (0, 11, 0, 0), (0, 1, 7, 1)]
NESTED = [
    *[(0, 0, 9, 0), (9, 0, 9, 9), (9, 9, 0, 9), (0, 9, 0, 0)],
    *[(3, 3, 6, 3), (6, 3, 6, 6), (6, 6, 3, 6), (3, 6, 3, 3)],
]
NO_SEGMENT = "degenerate-point-segment"  # lines have no segments without length


@pytest.fixture(scope="session")
def recorded(test_data: Path) -> list[Case]:
    cases: list[Case] = json.loads((test_data / "inters.json").read_text())
    return [case for case in cases if case["case"] != NO_SEGMENT]


def test_lines2lar_published_is_the_original_in_its_order(recorded: list[Case]) -> None:
    cases = 0
    for case in recorded:
        expected = case["outputs"].get("lar")
        if expected is None or not expected["EV"]:
            continue
        V, EV = lar.lines2lar(case["lines"], "published")
        assert V.tolist() == expected["V"], case["case"]
        assert EV.tolist() == expected["EV"], case["case"]
        cases += 1
    assert cases >= 85


def test_larFromLines_published_is_the_original_in_its_order(recorded: list[Case]) -> None:
    cases = 0
    for case in recorded:
        expected = case["outputs"].get("larFromLines")
        if expected is None:
            with pytest.raises(plumbline.Error):
                lar.larFromLines(case["lines"], "published")
            continue
        V, FV, EV = lar.larFromLines(case["lines"], "published")
        assert V.tolist() == expected["V"], case["case"]
        assert FV.tolist() == expected["FV"], case["case"]
        assert EV.tolist() == expected["EV"], case["case"]
        cases += 1
    assert cases >= 55


def test_svg2lines_published_reads_as_the_original_read(test_data: Path, tmp_path: Path) -> None:
    cases = json.loads((test_data / "svg2lines.json").read_text())
    file = tmp_path / "drawing.svg"
    for case in cases:
        file.write_text(case["svg"])
        if case["errors"] is not None:
            with pytest.raises(plumbline.Error):
                lar.svg2lines(file, "published")
            continue
        for sides, name in ((True, "lines"), (False, "diagonals")):
            found = lar.svg2lines(file, "published", rect2lines=sides)
            with_length = [[*a, *b] for a, b in case[name] if a != b]
            assert found.coords.tolist() == with_length, case["case"]
    with pytest.raises(OSError):
        lar.svg2lines(tmp_path / "there-is-none.svg", "published")


def test_svg2lines_exact_keeps_the_drawing_s_arrangement(examples: Path) -> None:
    plan = examples / "office-plan.svg"
    unit = lar.svg2lines(plan)
    assert unit.coords.reshape(-1, 2).max() == 1
    assert plumbline.arrange(unit).counts == plumbline.arrange(plan).counts


def test_stages_are_those_of_the_original(recorded: list[Case]) -> None:
    for case in recorded[:40]:
        outputs = lar.stages(case["lines"], "published")["outputs"]
        for name in ("boxes", "buckets", "intersectionPoints", "params", "raw", "components"):
            if name in case["outputs"]:
                assert outputs[name] == case["outputs"][name], (case["case"], name)


def test_what_the_original_raised_is_in_the_message() -> None:
    with pytest.raises(plumbline.Error, match="None"):
        lar.larFromLines([(0, 0, 1, 1), (0, 1, 1, 0)], "published")
    with pytest.raises(plumbline.Error, match="IndexError"):
        lar.lines2lar([], "published")
    assert "buckets" in lar.stages([], "published")["errors"]


def test_an_aborted_walk_is_told(recorded: list[Case]) -> None:
    (case,) = [case for case in recorded if case["case"] == "divergence-merge-partial"]
    assert not lar.arrange(case["lines"], "published").complete
    assert lar.arrange(case["lines"], "repaired").complete


def test_the_room_that_the_original_does_not_part_is_parted() -> None:
    for variant, faces in (("exact", 2), ("repaired", 2), ("published", 1)):
        _, FV, _ = lar.larFromLines(ROOM, variant)  # type: ignore[arg-type]
        assert len(FV) == faces


def test_holes_are_lost_in_the_original_alone() -> None:
    for variant, length in (("exact", 8), ("repaired", 8), ("published", 4)):
        _, FV, _ = lar.larFromLines(NESTED, variant)  # type: ignore[arg-type]
        assert max(FV.lengths) == length


def area_of_walks(V: Any, cycles: list[list[int]]) -> Fraction:
    twice = Fraction(0)
    for walk in cycles:
        for a, b in zip(walk, walk[1:] + walk[:1], strict=True):
            twice += V[a][0] * V[b][1] - V[b][0] * V[a][1]
    return twice / 2


@settings(max_examples=40, deadline=None)
@given(st.lists(st.tuples(*[st.integers(0, 6)] * 4), min_size=3, max_size=9))
def test_faces_as_they_are_walked_have_their_areas(rows: list[tuple[int, ...]]) -> None:
    rows = [row for row in rows if row[:2] != row[2:]]
    a = plumbline.arrange(rows)
    _, FV, _ = lar.larFromLines(rows)
    points = list(a.points)
    for face, walk in enumerate(FV.tolist(), start=1):
        assert {*walk} <= {*a.FV[face - 1].tolist()}
        if not len(a.face_holes[face]):
            assert area_of_walks(points, [walk]) == a.areas[face]


@settings(max_examples=40, deadline=None)
@given(st.lists(st.tuples(*[st.integers(0, 6)] * 4), min_size=3, max_size=9))
def test_the_boundary_of_a_boundary_is_nothing(rows: list[tuple[int, ...]]) -> None:
    rows = [row for row in rows if row[:2] != row[2:]]
    V, copEV, copFE = lar.planar_arrangement(rows)
    assert copEV.shape == (copFE.shape[1], len(V))
    assert (copFE @ copEV).count_nonzero() == 0


def test_the_coboundary_of_edges_is_that_of_the_arrangement() -> None:
    _, copEV, copFE = lar.planar_arrangement(ROOM)
    _, FV, EV = lar.larFromLines(ROOM)
    assert (lar.coboundary_0(EV) - copEV).count_nonzero() == 0
    # Both faces are convex, for which the rule of vertices is right.
    assert (lar.coboundary_1(FV, EV) - abs(copFE)).count_nonzero() == 0


def test_repaired_is_what_the_cell_complex_says() -> None:
    result = lar.arrange(NESTED)
    assert result.radius == pytest.approx(0.009)
    assert sorted(result.FE.lengths) == [4, 8]
    exact = plumbline.arrange(NESTED)
    assert result.V.tolist() == exact.V.tolist()
    assert result.EV.tolist() == exact.EV.tolist()
    assert result.FE.tolist() == exact.FE.tolist()


def test_edges_of_published_faces_are_their_sides() -> None:
    result = lar.arrange(NESTED, "published")
    for walk, edges in zip(result.FV.tolist(), result.FE.tolist(), strict=True):
        assert {v for e in edges for v in result.EV[e].tolist()} == set(walk)
        assert len(edges) == len(walk)


def test_radii_are_numbers_or_presets() -> None:
    assert lar.arrange(ROOM, radius="larlib").radius == pytest.approx(0.011)
    assert lar.arrange(ROOM, radius="plasm").radius == 1e-8
    assert lar.arrange(ROOM, radius="1/8").radius == 0.125
    assert lar.arrange(ROOM, "published", radius="plasm").radius == 1e-8
    gap = [(0, 0, 1, 0), ("1.01", 0, 2, 0)]
    assert len(lar.lines2lar(gap, "repaired", radius=0.1)[0]) == 3
    assert len(lar.lines2lar(gap, "repaired", radius=0.001)[0]) == 4


def test_the_unit_square_has_its_top_at_1() -> None:
    result = lar.arrange([(0, 0, 200, 0), (200, 0, 0, 100), (0, 100, 0, 0)], unit_square=True)
    assert result.V.min(axis=0).tolist() == [0, 0.5]
    assert result.V.max(axis=0).tolist() == [1, 1]


def test_a_trace_is_in_the_result_where_it_is_asked_for() -> None:
    assert lar.arrange(ROOM).trace is None
    trace = lar.arrange(ROOM, trace=True).trace
    assert trace is not None
    assert trace == lar.stages(ROOM)
    assert trace["outputs"]["larFromLines"]["V"] == lar.arrange(ROOM).V.tolist()


def test_larSimplify_merges_what_is_near() -> None:
    near = ([(0, 0), (1, 0), (1 + 2**-10, 0), (2, 0)], [[0, 1], [1, 2], [2, 3]])
    V, EV = lar.larSimplify(near)
    assert V.tolist() == [[0, 0], [1 + 2**-11, 0], [2, 0]]
    assert EV.tolist() == [[0, 1], [1, 2]]
    V, EV = lar.larSimplify(near, variant="published")
    assert V.tolist() == [[0, 0], [1 + 2**-11, 0], [2, 0]]
    assert sorted(EV.tolist()) == [[0, 1], [1, 2]]
    V, FV, EV = lar.larSimplify((near[0], [[0, 1, 2, 3]], near[1]), 0.5)
    assert FV.tolist() == [[0, 1, 2]]


def test_facets_of_a_grid_bound_two_cells_or_one() -> None:
    grid = lar.larCuboids([3, 2], full=True)
    squares, edges, _ = grid.cells
    operator = lar.larBoundary(squares, edges)
    assert operator.shape == (len(edges), 6)
    assert sorted(operator.sum(axis=1).tolist()) == [1] * 10 + [2] * 7
    assert len(lar.boundaryCells(squares, edges)) == 10
    assert grid.boundary_cells().tolist() == lar.boundaryCells(squares, edges)
    assert lar.larCuboids([1, 1, 1, 1], full=True).V.shape == (16, 4)


def test_larEmbed_and_embedStruct_are_inverse_to_what_drops_coordinates() -> None:
    square = lar.larCuboids([1, 1])
    assert lar.larEmbed(-1)(lar.larEmbed(1)(square)) == square
    struct = lar.Struct([lar.t(1, 2), square])
    up = lar.embedStruct(1)(struct)
    assert up.dimension == 3
    low, high = up.box or ((), ())
    assert [*map(int, low)] == [1, 2, 0]
    assert [*map(int, high)] == [2, 3, 0]
    assert lar.embedStruct(-1)(up).box == struct.box
    with pytest.raises(plumbline.Error):
        lar.larEmbed(-2)(square)


def test_larApply_takes_maps_and_matrices() -> None:
    square = lar.larCuboids([1, 1])
    assert lar.larApply(lar.s(2, 3))(square) == lar.larApply([[2, 0, 0], [0, 3, 0], [0, 0, 1]])(
        square
    )
    assert lar.s(2, 3)(square) == lar.larApply(lar.s(2, 3).matrix)(square)


def test_checkStruct_refuses_mixed_dimensions() -> None:
    assert lar.checkStruct([lar.t(1, 2, 3), lar.larCuboids([1, 1, 1])]) == 3
    with pytest.raises(plumbline.Error):
        lar.checkStruct([lar.t(1, 2), lar.larCuboids([1, 1, 1])])


def test_julia_s_conventions_lead_there_and_back() -> None:
    grid = lar.larCuboids([2, 1], full=True)
    assert lar.from_julia(*lar.to_julia(grid)) == grid
    V, *cells = lar.to_julia(grid)
    assert V.shape == (2, 6)
    assert min(v for array in cells for cell in array for v in cell) == 1


def test_random_lines_are_the_same_for_a_seed() -> None:
    first = plumbline.random_lines(50, 0.2, seed=3)
    assert np.array_equal(first, plumbline.random_lines(50, 0.2, seed=3))
    assert not np.array_equal(first, plumbline.random_lines(50, 0.2, seed=4))
    assert first.min() == 0
    assert lar.randomLines(numberOfLines=7).shape == (7, 4)


def test_random_lines_are_those_of_the_tool() -> None:
    # plumbline random 3
    assert plumbline.random_lines(3).tolist() == [
        [0.2504, 0.389, 0.2822, 0.37739999999999996],
        [0, 0, 0.009800000000000003, 0.05600000000000005],
        [0.2259, 0.27359999999999995, 0.18879999999999997, 0.2764],
    ]


def test_results_can_be_pickled() -> None:
    result = lar.arrange(ROOM)
    again = pickle.loads(pickle.dumps(result))
    assert again.FV == result.FV
    assert again.V.tolist() == result.V.tolist()


@pytest.mark.parametrize(
    "bad",
    [
        lambda: lar.arrange(ROOM, "exact"),  # type: ignore[arg-type]
        lambda: lar.larFromLines(ROOM, "best"),  # type: ignore[arg-type]
        lambda: lar.lines2lar(ROOM, "best"),  # type: ignore[arg-type]
        lambda: lar.stages(ROOM, "exact"),  # type: ignore[arg-type]
        lambda: lar.larFromLines(ROOM, radius=0.1),
        lambda: lar.lines2lar(ROOM, decimals=3),
        lambda: lar.arrange(ROOM, decimals=3),
        lambda: lar.arrange(ROOM, radius=-1),
        lambda: lar.arrange(ROOM, radius="near"),
        lambda: lar.arrange(ROOM, "published", decimals=13),
        lambda: lar.arrange(ROOM, "published", radius=0),
        lambda: lar.struct2lar(lar.larCuboids([1]), "repaired"),  # type: ignore[arg-type]
        lambda: lar.larSimplify(lar.larCuboids([1, 1])),
        lambda: lar.larSimplify(lar.larCuboids([1])),
        lambda: lar.coboundary_0([[0, 1, 2]]),
        lambda: lar.larBoundary([[0, 1]], [[-1]]),
        lambda: lar.larCuboids([]),
        lambda: lar.larCuboids([-1]),
        lambda: lar.random_lines(-1),
        lambda: lar.random_lines(5, float("nan")),
        lambda: lar.evalStruct(5),  # type: ignore[arg-type]
    ],
)
def test_what_cannot_be_done_is_refused(bad: Any) -> None:
    with pytest.raises(plumbline.Error):
        bad()


def test_bool2d_of_a_grid_and_its_turned_copy_is_what_shapely_has() -> None:
    import shapely

    grid = lar.larCuboids([3, 2])
    turned = lar.Struct([lar.t(1.5, 0.25), lar.r(0.4), grid])
    W, copEV, copFE, matrix = lar.bool2d(lar.Struct([grid, turned]))
    edges, faces = copEV.toarray(), copFE.toarray()
    areas = {}
    for name, chain in {"A": matrix[:, 0], "B": matrix[:, 1], "A & B": matrix.all(axis=1)}.items():
        boundary = faces.T @ np.asarray(chain, dtype=np.int8)
        tails, heads = (edges == -1).argmax(axis=1), (edges == 1).argmax(axis=1)
        (ax, ay), (bx, by) = W[tails].T, W[heads].T
        areas[name] = float((boundary * (ax * by - bx * ay)).sum() / 2)
    a = shapely.box(0, 0, 3, 2)
    corners = [np.array(c) for c in ((0, 0), (3, 0), (3, 2), (0, 2))]
    turn = np.array([[np.cos(0.4), -np.sin(0.4)], [np.sin(0.4), np.cos(0.4)]])
    b = shapely.Polygon([turn @ c + (1.5, 0.25) for c in corners])
    expected = {"A": a.area, "B": b.area, "A & B": shapely.intersection(a, b).area}
    assert areas == pytest.approx(expected, rel=1e-12)
    assert matrix.any(axis=1).all()  # inner sides of the grids part nothing


def test_bool2d_refuses_nothing() -> None:
    with pytest.raises(plumbline.Error, match="without models"):
        lar.bool2d(lar.Struct([]))
