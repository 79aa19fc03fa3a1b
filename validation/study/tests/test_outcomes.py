"""Answers of known kinds, and the truths that they are held against."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction as F
from typing import Any

import plumbline
import pytest
from study.engines import Configuration, Reply
from study.families import Case, Family, Unit, case_of, fan, tees, turned_grid, turned_rooms
from study.outcomes import in_order, judge, judgements
from study.snapping import snap_rounded, snap_rounded_down
from study.truths import Numbers, Truths

SQUARE = [(0.0, 0.0, 2.0, 0.0), (2.0, 0.0, 2.0, 2.0), (2.0, 2.0, 0.0, 2.0), (0.0, 2.0, 0.0, 0.0)]
DRAWING = [*SQUARE, (0.0, 0.0, 2.0, 2.0)]
RIGHT: dict[str, Any] = {
    "V": [[0, 0], [2, 0], [2, 2], [0, 2]],
    "EV": [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]],
    "polygons": [[[0, 1, 2]], [[0, 2, 3]]],
}


def outcome(model: dict[str, Any], tolerance: float = 1e-9) -> tuple[str, str]:
    truth = plumbline.arrange(DRAWING, numbers="doubles")
    found = judge(Reply("model", 0.1, model), truth, tolerance, 2.0)
    return found.outcome, found.kind


def changed(**members: Any) -> dict[str, Any]:
    return RIGHT | members


def test_right_answers_are_identical_or_moved() -> None:
    assert outcome(RIGHT) == ("identical", "")
    assert outcome(changed(V=[[0, 0], [2, 2**-51], [2, 2], [0, 2]])) == ("identical", "")
    moved = changed(V=[[0, 0], [2, 1e-10], [2, 2], [0, 2]])
    assert outcome(moved) == ("moved", "")
    assert outcome(changed(V=[[0, 0], [2, 1e-7], [2, 2], [0, 2]]), 1e-9) == ("moved", "")


def test_what_moved_by_more_than_a_thousand_tolerances_is_another_answer() -> None:
    assert outcome(changed(V=[[0, 0], [2, 0.99e-6], [2, 2], [0, 2]]), 1e-9) == ("moved", "")
    far = changed(V=[[0, 0], [2, 1.01e-6], [2, 2], [0, 2]])
    assert outcome(far, 1e-9) == ("topology", "vertex moved far")


@pytest.mark.parametrize(
    ("model", "kind"),
    [
        (changed(EV=RIGHT["EV"][:4], polygons=[[[0, 1, 2, 3]]]), "faces merged"),
        ({"V": RIGHT["V"], "EV": RIGHT["EV"][:4]}, "edge missing"),
        ({"V": RIGHT["V"], "EV": [*RIGHT["EV"][1:]]}, "edge missing"),
    ],
)
def test_other_topologies_have_the_gravest_difference(model: dict[str, Any], kind: str) -> None:
    assert outcome(model) == ("topology", kind)


def test_what_is_no_complex_is_invalid() -> None:
    assert outcome(changed(EV=[*RIGHT["EV"], [1, 3]]))[0] == "invalid"  # they cross
    assert outcome(changed(polygons=[[[0, 1, 2]], [[0, 1, 2]]]))[0] == "invalid"
    assert outcome(changed(polygons=[[[0, 1, 9]]])) == ("invalid", "unreadable")
    assert outcome(changed(V=[[0, 0], [2, float("nan")], [2, 2], [0, 2]]))[0] == "invalid"


def test_edges_that_cross_by_rounding_alone_are_right() -> None:
    ulp = 2.0**-51  # of the largest coordinate
    lines = [(0.0, 0.0, 2.0, 2.0), (1.0, 1.0 - ulp / 2, 3.0, 0.0)]
    truth = plumbline.arrange(lines, numbers="doubles")

    def ending(off: float, edges: list[list[int]]) -> tuple[str, str]:
        vertices = [[0, 0], [2, 2], [1, 1 - ulp / 2 + off], [3, 0]]
        found = judge(Reply("model", 0.1, {"V": vertices, "EV": edges}), truth, 1e-9, 3.0)
        return found.outcome, found.kind

    assert ending(0.0, [[0, 1], [2, 3]]) == ("identical", "")
    assert ending(ulp / 2, [[0, 1], [2, 3]]) == ("moved", "vertex on edge")
    assert ending(ulp, [[0, 1], [2, 3]]) == ("moved", "crossing")
    assert ending(1e-12, [[0, 1], [2, 3]]) == ("invalid", "crossing")
    assert ending(ulp, [[0, 2], [2, 1], [2, 3]])[0] == "topology"
    crossing = [(0.0, 0.0, 2.0, 2.0), (1.0, 1.0 + ulp / 2, 3.0, 0.0)]
    noded = plumbline.arrange(crossing, numbers="doubles")
    model = {"V": [[0, 0], [2, 2], [1, 1 + ulp / 2], [3, 0]], "EV": [[0, 1], [2, 3]]}
    assert judge(Reply("model", 0.1, model), noded, 1e-9, 3.0).outcome == "invalid"  # not noded


def test_what_is_loud_stays_so() -> None:
    truth = Numbers(4, 5, 3)
    for ending in ("error", "crash", "timeout", "memory"):
        found = judge(Reply(ending, message="Class: words"), truth, 0.0, 1.0)
        assert (found.outcome, found.kind) == (ending, "Class")


def test_numbers_alone_are_compared_where_nothing_else_is_known() -> None:
    reply = Reply("model", 0.1, RIGHT)
    assert judge(reply, Numbers(4, 5, 3), 0.0, 1.0).outcome == "moved"
    assert judge(reply, Numbers(3, 5, 3), 0.0, 1.0).kind == "numbers of cells"


def test_of_faces_alone_the_number_of_faces_is_compared() -> None:
    faces = Reply("model", 0.1, {"V": RIGHT["V"], "polygons": RIGHT["polygons"]})
    assert judge(faces, Numbers(6, 7, 3), 0.0, 1.0).outcome == "moved"  # a dangling edge, another
    assert judge(faces, Numbers(4, 5, 2), 0.0, 1.0).kind == "numbers of cells"
    assert judge(Reply("model", 0.1, RIGHT), Numbers(6, 7, 3), 0.0, 1.0).outcome == "topology"


def configuration(kind: str, value: float) -> Configuration:
    return Configuration("e", "E", "1", "e", "c", "C", kind, value, "")  # type: ignore[arg-type]


def of(family: Family, size: int = 12, scale: str = "unit", order: int = 0) -> Case:
    return case_of(family, Unit(family.name, size, scale, 3, order))


def test_three_truths_of_a_slanted_tee_differ() -> None:
    truths = Truths(of(Family("tees", "", tees, is_rounded=True)))
    assert truths.authored.signature == (truths.intended or truths.doubles).signature
    assert truths.authored.counts.faces == 5
    assert truths.doubles.counts.faces < 5
    truths.ensure_both_engines()


def test_a_turned_grid_is_known_exactly() -> None:
    truths = Truths(of(Family("grid", "", turned_grid, is_rounded=True), scale="UTM"))
    assert truths.intended is not None and len(truths.intended) == 25
    assert (
        len(Truths(of(Family("rooms", "", turned_rooms, is_rounded=True), 36)).intended or ()) == 9
    )
    assert truths.doubles.counts.vertices > truths.intended.counts.vertices


def test_an_order_changes_nothing_but_the_order() -> None:
    family = Family("fan", "", fan)
    plain, other = (of(family, order=k) for k in (0, 1))
    assert plain.segments != other.segments
    assert Truths(plain).doubles.signature == Truths(other).doubles.signature
    assert of(family, order=1) == other


def test_a_grid_promises_the_snap_rounded_complex() -> None:
    near = [(0.0, 0.0, 10.0, 3.0), (3.4, 1.01, 6.4, 5.0)]
    pieces = snap_rounded(near, F(1))
    assert (F(3), F(1), F(10), F(3)) in pieces  # bent at the pixel of the end
    upwards = snap_rounded([(0.5, 0.5, 1.5, -0.5)], F(1))
    assert upwards == [(F(1), F(1), F(2), F(0))]
    case = Case(Unit("near", 0, "unit", 0), None, [], near)
    truth = Truths(case).contract(configuration("grid", 1.0))
    assert isinstance(truth, plumbline.Arrangement)
    assert truth.signature == plumbline.arrange(pieces).signature
    coordinates_alone = replace(configuration("grid", 1.0), promise="some")
    assert Truths(case).contract(coordinates_alone) is None


def test_integers_promise_ends_on_the_grid_and_crossings_rounded_down() -> None:
    cross = [(0.0, 0.0, 3.0, 3.0), (0.0, 3.0, 3.0, 0.0)]  # at 1.5
    down = [(0, 0, 1, 1), (0, 3, 1, 1), (1, 1, 3, 0), (1, 1, 3, 3)]
    assert snap_rounded_down(cross, F(1)) == [tuple(map(F, s)) for s in down]
    # Ends are rounded first.
    near = [(0.4, 0.0, 3.0, 3.0), (-0.4, 0.0, 0.6, 0.0)]
    assert snap_rounded_down(near, F(1)) == [tuple(map(F, s)) for s in ((0, 0, 1, 0), (0, 0, 3, 3))]
    ties = snap_rounded_down([(-0.5, 0.5, 2.5, -1.5)], F(1))
    assert ties == [tuple(map(F, (-1, 1, 3, -2)))]  # away from 0, as std::round
    case = Case(Unit("cross", 0, "unit", 0), None, [], cross)
    of_integers = replace(configuration("grid", 1.0), promise="integers")
    truths = Truths(case)
    truth, nearest = truths.contract(of_integers), truths.contract(configuration("grid", 1.0))
    assert isinstance(truth, plumbline.Arrangement) and isinstance(nearest, plumbline.Arrangement)
    assert (F(1), F(1)) in truth.points and (F(2), F(2)) in nearest.points


def test_a_snap_distance_promises_what_all_readings_of_it_agree_about() -> None:
    drawing = [(0.0, 0.0, 2.0, 0.0), (2.01, 0.0, 4.0, 2.0), (4.0, 2.0, 0.0, 0.0)]
    truths = Truths(Case(Unit("gap", 0, "unit", 0), None, [], drawing))
    assert truths.contract(configuration("snap", 0.05)) == Numbers(3, 3, 2)
    for about_as_large in (0.03, 0.01, 0.003):
        assert truths.contract(configuration("snap", about_as_large)) is None
    assert truths.contract(configuration("snap", 0.002)) is truths.doubles
    some = replace(configuration("snap", 0.05), promise="some")
    assert truths.contract(some) is None
    assert truths.contract(replace(some, tolerance=0.002)) is truths.doubles
    assert truths.contract(configuration("none", 0)) is None
    assert truths.feature_size == pytest.approx(0.01)


def test_what_fits_doubles_keeps_its_cells_at_the_nearest_ones() -> None:
    above = F(4, 3) + F(1, 3 * 2**54)  # the edge at x = 2; the nearest double is below it
    truth = plumbline.arrange([(0, 0, 6, 4), (2, above, 2, 9)])
    assert truth.rounded().method == "nearest points"  # other doubles hold the same cells
    case = Case(Unit("past an edge", 0, "unit", 0), None, [], [])
    assert not Truths(case).fits_doubles(truth)
    assert Truths(case).fits_doubles(plumbline.arrange([(0, 0, 6, 4), (2, F(5, 3), 2, 9)]))


def test_each_truth_is_judged_once() -> None:
    case = of(Family("rooms", "", turned_rooms, is_rounded=True))
    truths = Truths(case)
    reply = Reply("model", 0.1, {"V": [], "EV": []})
    names = ("authored", "doubles", "intended", "contract")
    found = judgements(case, truths, configuration("none", 0), reply, names, {})
    assert list(found) == ["authored", "doubles", "intended"]
    assert {j.outcome for j in found.values()} == {"topology"}


def test_the_same_answer_is_told_however_it_is_listed() -> None:
    same: dict[str, Any] = {
        "V": [[2, 2], [0, 2], [0, 0], [2, 0]],
        "EV": [[2, 0], [0, 1], [3, 2], [3, 0], [2, 1]],
        "polygons": [[[0, 1, 2]], [[3, 0, 2]]],
    }
    assert in_order(Reply("model", 0.1, same)) == in_order(Reply("model", 0.2, RIGHT))
    others = [
        {"V": same["V"], "EV": same["EV"]},
        same | {"V": [[2, 2], [0, 2], [0, 0], [2, 2**-52]]},
        same | {"EV": same["EV"][:-1]},
        same | {"EV": [*same["EV"], [2, 1]]},
        same | {"polygons": [[[0, 1, 2]], [[3, 2, 0]]]},  # turned over
        same | {"polygons": [[[0, 1, 9]]]},
        same | {"polygons": [[[0, 1, -2]], [[-1, 0, 2]]]},
        same | {"polygons": [[]]},
        same | {"FV": []},
    ]
    told = [in_order(Reply("model", 0.1, model)) for model in others]
    assert in_order(Reply("model", 0.1, RIGHT)) not in told
    assert in_order(Reply("error", message="a")) != in_order(Reply("error", message="b"))
