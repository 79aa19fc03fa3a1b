"""Repairs: what is edited, the proof, the way back, files."""

from __future__ import annotations

import json
import pickle
from collections import Counter
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import plumbline
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

# A rectangle of 10 x 8 whose lower right corner is open: one end goes too far, the other not far
# enough.
CORNER = [(0, 0, "10.03", 0), (10, "0.02", 10, 8), (10, 8, 0, 8), (0, 8, 0, 0)]
BOX = [(0, 0, 10, 0), (10, 0, 10, 8), (10, 8, 0, 8), (0, 8, 0, 0)]

DXF = """0
SECTION
2
ENTITIES
0
LINE
8
WALLS
62
3
10
0
20
0
11
10.03
21
0
0
LINE
8
WALLS
10
10
20
0.02
11
10
21
8
0
ARC
8
ROUND
10
3
20
3
40
1
50
0
51
180
0
ENDSEC
0
EOF
"""


def rounded_signature(lines: plumbline.Lines) -> str:
    """By which a drawing is known in every format."""
    return plumbline._core.rounded_signature(lines._core)


def kinds(repair: plumbline.Repair) -> list[str]:
    return [edit.kind for edit in repair.edits]


def test_an_open_corner_is_closed_and_the_dangle_goes() -> None:
    fixed = plumbline.repair(CORNER, tolerance="0.05")
    assert kinds(fixed) == ["grow", "trim"]
    assert [edit.squared_size for edit in fixed.edits] == [Fraction(1, 2500), Fraction(9, 10000)]
    assert [edit.size for edit in fixed.edits] == [0.02, 0.03]
    assert fixed.edits[0].where == (Fraction(10), Fraction(1, 50))
    assert plumbline.same(fixed.output, BOX)
    (closed,) = fixed.faces
    assert (closed.fate, closed.before, closed.edits) == ("closed", 0, [0])
    assert closed.area_before == 0
    assert closed.area_after == fixed.after.areas[closed.after] == 80
    assert fixed.refused == []


def test_every_line_knows_what_it_was_made_of() -> None:
    fixed = plumbline.repair(CORNER, tolerance="0.05")
    origins = {fixed.output.exact(i): of.tolist() for i, of in enumerate(fixed.origins)}
    wall = (Fraction(10), Fraction(0)), (Fraction(10), Fraction(8))
    assert origins[wall] == [1]
    grown = fixed.edits[0]
    assert [line.segments for line in grown.before] == [[1]]
    assert (grown.after[0].a, grown.after[0].b) == wall


@pytest.mark.parametrize("size", [0.018, "0.018", Decimal("0.018"), Fraction(9, 500)])
def test_a_tolerance_is_the_decimal_that_is_written(size: Any) -> None:
    used = plumbline.repair(CORNER, tolerance=size).tolerances
    assert [used.weld, used.grow, used.trim, used.sliver] == [Fraction(9, 500)] * 4
    assert [used.snap, used.simplify] == [0, 0]
    assert str(used).startswith("weld 0.018, grow 0.018, trim 0.018, sliver 0.018, snap off")
    assert used.doors is None


def test_what_is_said_of_one_operation_wins() -> None:
    used = plumbline.repair(CORNER, tolerance=0.05, weld=False, grow="1/30", snap=0.001).tolerances
    assert [used.weld, used.grow, used.trim] == [0, Fraction(1, 30), Fraction(1, 20)]
    assert used.snap == Fraction(1, 1000)
    off: Any
    for off in (0, False, "off"):
        assert kinds(plumbline.repair(CORNER, tolerance=off)) == []


def test_automatic_tolerances_have_reasons_and_are_what_they_say(examples: Path) -> None:
    """Recorded from `plumbline repair FILE`."""
    chosen = plumbline.repair(examples / "building.svg")
    used = chosen.tolerances
    assert str(used) == (
        "weld 0.001, grow 0.001, trim 0.331, sliver 0.001, snap off, simplify off, doors off"
    )
    assert len(chosen.reasons) == 4
    again = plumbline.repair(
        examples / "building.svg",
        weld=used.weld,
        grow=used.grow,
        trim=used.trim,
        sliver=used.sliver,
    )
    assert again.to_json().split('"edits"')[1] == chosen.to_json().split('"edits"')[1]
    assert again.reasons == []


@pytest.mark.parametrize(
    ("name", "edits", "refused", "fates"),
    [
        ("flat.dxf", {}, 0, {}),
        ("dwelling.svg", {}, 0, {}),
        ("hospital-ward.svg", {"merge": 5}, 0, {}),
        ("office-plan.svg", {"merge": 3, "grow": 3}, 2, {"closed": 1, "split": 2}),
    ],
)
def test_edits_are_those_that_the_tool_makes(
    examples: Path, name: str, edits: dict[str, int], refused: int, fates: dict[str, int]
) -> None:
    """Recorded from `plumbline repair FILE --json`."""
    fixed = plumbline.repair(examples / name)
    assert Counter(kinds(fixed)) == edits
    assert len(fixed.refused) == refused
    assert Counter(face.fate for face in fixed.faces) == fates
    assert fixed.verify() == []


def test_the_apartment_keeps_its_rooms_when_doubled_walls_are_welded(test_data: Path) -> None:
    welded = plumbline.repair(test_data / "apartment.svg", tolerance=0, weld=0.018)
    assert (welded.before.counts.faces, welded.after.counts.faces) == (221, 152)
    for arrangement in (welded.before, welded.after):
        assert sum(area > 100 for area in arrangement.areas) == 86
    assert max(edit.size for edit in welded.edits) <= 0.036  # twice, where lines are met again
    rules = {rule.rule: rule for rule in welded.compare_rules()}
    assert (rules["as drawn"].faces, rules["repair"].faces) == (220, 151)
    assert rules["as drawn"].moved == 0


def test_a_door_is_closed_by_a_virtual_line() -> None:
    lines = [(0, 0, 12, 0), (12, 0, 12, 6), (12, 6, 0, 6), (0, 6, 0, 0)]
    walls = [*lines, (6, 0, 6, "2.5"), (6, "3.4", 6, 6)]
    closed = plumbline.repair(walls, tolerance=0, doors=(0.6, 1.2))
    assert kinds(closed) == ["door"]
    assert closed.tolerances.doors == (Fraction(3, 5), Fraction(6, 5))
    assert closed.edits[0].after[0].segments == []
    virtual = closed.to_geopandas("lines").query("virtual == 1")
    assert virtual["layer"].tolist() == ["plumbline-virtual"]
    assert virtual.geometry.length.tolist() == pytest.approx([0.9])
    assert closed.after.areas[1:] == (Fraction(36), Fraction(36))
    assert [change.before for change in closed.changes] == [[]]


def test_what_cannot_be_decided_is_refused_with_a_reason() -> None:
    three = [(0, 0, 5, 0), ("5.02", "0.03", 10, "0.03"), ("5.02", "-0.03", 10, "-0.03")]
    refused = plumbline.repair(three, tolerance=0, grow=0.1)
    assert refused.edits == []
    assert refused.refused[-1].kind == "joint"
    assert all(refusal.reason for refusal in refused.refused)


def test_anchored_layers_and_excepted_elements_stay() -> None:
    lines = plumbline.lines(CORNER, layers=["A", "B", "A", "A"], ids=["r", "s", "t", "u"])
    anchored = plumbline.repair(lines, tolerance=0.05, anchors="B")
    assert anchored.anchored == [1]
    assert "grow" not in kinds(anchored)
    assert kinds(plumbline.repair(lines, tolerance=0.05, except_=["r"])) == ["grow"]
    with pytest.raises(plumbline.Error, match="no such layer"):
        plumbline.repair(lines, anchors=["no such layer"])
    with pytest.raises(plumbline.Error, match="no such id"):
        plumbline.repair(lines, except_=["no such id"])


def test_common_sides_and_layers_stay_drawn_twice_unless_that_is_not_wanted() -> None:
    boxes = [shapely.box(0, 0, 1, 1), shapely.box(1, 0, 2, 1)]
    assert kinds(plumbline.repair(boxes, tolerance=0)) == []
    assert kinds(plumbline.repair(boxes, tolerance=0, keeps_common_sides=False)) == ["merge"]
    twice = plumbline.lines([(0, 0, 1, 0), (0, 0, 1, 0)], layers=["A", "B"])
    assert kinds(plumbline.repair(twice, tolerance=0)) == []
    assert kinds(plumbline.repair(twice, tolerance=0, keeps_layers=False)) == ["merge"]


def test_a_repair_is_proven_for_its_drawing_and_for_no_other() -> None:
    fixed = plumbline.repair(CORNER, tolerance=0.05)
    assert fixed.verify() == []
    other = [*CORNER[:3], (0, 8, 0, "0.5")]
    forged = plumbline.Repair(fixed._core, plumbline.lines(other))
    breaches = forged.verify()
    assert breaches
    assert breaches[0].message
    assert len(breaches[0].where) == 2


def test_ends_at_fractions_are_counted_and_exact_in_lines(tmp_path: Path) -> None:
    slanted = plumbline.repair([(0, 0, 3, 1), (1, 1, 1, "0.34")], tolerance=0, grow=0.01)
    assert slanted.rounded_lines == 1
    slanted.write(tmp_path / "slanted.lines")
    assert plumbline.same(tmp_path / "slanted.lines", slanted.output)
    assert plumbline.repair(CORNER, tolerance=0.05).rounded_lines == 0


def test_edits_are_points_in_a_frame_and_in_files(tmp_path: Path) -> None:
    fixed = plumbline.repair(CORNER, tolerance=0.05)
    frame = fixed.to_geopandas()
    assert frame["kind"].tolist() == ["grow", "trim"]
    assert [(p.x, p.y) for p in frame.geometry] == [(10, 0.02), (10, 0)]
    fixed.write(tmp_path / "edits.geojson", edits=True)
    features = json.loads((tmp_path / "edits.geojson").read_text())["features"]
    assert [feature["properties"]["kind"] for feature in features] == ["grow", "trim"]
    with pytest.raises(plumbline.Error, match="'svg'"):
        fixed.write(tmp_path / "edits.svg", edits=True)
    assert not (tmp_path / "edits.svg").exists()


def test_texts_pictures_and_pages() -> None:
    fixed = plumbline.repair(CORNER, tolerance=0.05)
    assert "2 edits: 1 end grown by 0.02, 1 dangle of 0.03 trimmed" in str(fixed)
    assert repr(fixed).startswith("<Repair: 2 edits: ")
    assert ">closed 80<" in fixed.to_svg()
    page = fixed._repr_html_()
    assert page is not None and 'sandbox="allow-scripts"' in page and "<script" not in page
    assert fixed._written("html") == fixed.to_html()
    assert json.loads(str(fixed._written("json")))["format"] == "plumbline repair 1"


def test_rules_are_compared_at_the_largest_tolerance_of_the_drawing_that_was_repaired() -> None:
    fixed = plumbline.repair(CORNER, tolerance=0.05)
    rules = {rule.rule: rule for rule in plumbline.compare_rules(CORNER, fixed)}
    assert (rules["repair"].faces, rules["repair"].area) == (1, 80)
    assert rules["as drawn"].faces == 0
    assert rules["LAR pruning"].faces == 1
    with pytest.raises(plumbline.Error, match="another drawing"):
        plumbline.compare_rules(BOX, fixed)
    with pytest.raises(plumbline.Error, match="tolerance of 0"):
        plumbline.repair(CORNER, tolerance=0).compare_rules()


def test_pickling_keeps_the_repair() -> None:
    fixed = plumbline.repair(CORNER, tolerance=0.05)
    again = pickle.loads(pickle.dumps(fixed))
    assert again.to_json() == fixed.to_json()
    undone = plumbline.undo(fixed.output, fixed)
    assert list(pickle.loads(pickle.dumps(undone))) == list(undone)


def test_no_lines_have_no_edits() -> None:
    nothing = plumbline.repair(np.zeros((0, 4)))
    assert (nothing.edits, nothing.refused, len(nothing.output)) == ([], [], 0)
    assert nothing.verify() == []
    assert "<svg" in nothing.to_svg()


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"tolerance": -1}, "tolerance.*-1"),
        ({"grow": "wide"}, "grow.*'wide'"),
        ({"trim": float("inf")}, "trim.*inf"),
        ({"weld": True}, "weld.*True"),
        ({"sliver": "1/0"}, "sliver.*'1/0'"),
        ({"snap": "auto"}, "snap has no automatic size"),
        ({"doors": 1}, "doors.*1"),
        ({"doors": (2, 1)}, "door"),
        ({"walls": ["no such layer"], "doors": (1, 2)}, "no such layer"),
    ],
)
def test_what_makes_no_sense_is_refused(arguments: dict[str, Any], says: str) -> None:
    with pytest.raises(plumbline.Error, match=says):
        plumbline.repair(CORNER, **arguments)


hundredths = st.integers(-2, 2)
walls = st.lists(
    st.tuples(st.integers(0, 4), st.integers(0, 4), st.integers(1, 3), hundredths, st.booleans()),
    min_size=2,
    max_size=8,
)


def sloppy(plan: list[tuple[int, int, int, int, bool]]) -> list[tuple[Fraction, ...]]:
    """Walls on a lattice, most of them a bit off."""
    result: list[tuple[Fraction, ...]] = []
    for along, across, length, off, upright in plan:
        a, b = along + Fraction(off, 100), along + length + Fraction(off, 200)
        y = Fraction(across)
        result.append((y, a, y, b) if upright else (a, y, b, y))
    return result


@settings(max_examples=40, deadline=None)
@given(walls, st.randoms(use_true_random=False))
def test_repairs_keep_their_promises_and_depend_on_the_geometry_alone(
    plan: list[tuple[int, int, int, int, bool]], random: Any
) -> None:
    lines = sloppy(plan)
    fixed = plumbline.repair(lines, tolerance=0.03)
    assert fixed.verify() == []
    assert plumbline.same(plumbline.undo(fixed.output, fixed), lines)
    assert plumbline.repair(fixed.output, tolerance=0.03).edits == []
    others = [(c, d, a, b) for a, b, c, d in lines] + lines[:1]
    random.shuffle(others)
    assert plumbline.same(plumbline.repair(others, tolerance=0.03).output, fixed.output)
