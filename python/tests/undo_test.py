"""Repaired drawings in their files, and undone."""

from __future__ import annotations

import json
import pickle
from pathlib import Path

import plumbline
import pytest
from repair_test import BOX, CORNER, DXF, rounded_signature


def test_undoing_gives_the_drawing_back_with_its_sources() -> None:
    thirds = [(0, 0, 3, "0.0001"), (1, 1, 2, "-0.99"), (0, 5, 2, 5), (2, "1/3", 2, "5.001")]
    lines = plumbline.lines(thirds, ids=["a", "b", "c", "d"])
    fixed = plumbline.repair(lines, tolerance=0.01)
    assert fixed.edits
    for log in (fixed, fixed.to_json(), json.loads(fixed.to_json())):
        back = plumbline.undo(fixed.output, log)
        assert plumbline.same(back, lines)
        assert sorted(back.source(i).id for i in back.item.tolist()) == ["a", "b", "c", "d"]
    # Doubles are enough to know the lines by.
    back = plumbline.undo(fixed.output.coords, fixed)
    assert rounded_signature(back) == rounded_signature(lines)


def test_another_drawing_is_not_undone_nor_by_what_is_no_log(tmp_path: Path) -> None:
    fixed = plumbline.repair(CORNER, tolerance=0.05)
    with pytest.raises(plumbline.Error, match="not the drawing that the repair of the log made"):
        plumbline.undo(CORNER, fixed)
    with pytest.raises(plumbline.Error, match="not a log") as caught:
        plumbline.undo(fixed.output, '{"format": "plumbline rooms 1"}')
    assert (caught.value.file, caught.value.line) == ("<log>", 1)
    assert str(caught.value).startswith("<log>:1")
    with pytest.raises(plumbline.FileError):
        plumbline.undo(fixed.output, tmp_path / "there-is-no-such.json")


def test_a_dxf_keeps_its_arcs_and_colours_and_is_undone_to_what_it_was(tmp_path: Path) -> None:
    plan, fixed, log = (tmp_path / name for name in ("plan.dxf", "fixed.dxf", "log.json"))
    plan.write_text(DXF)
    repair = plumbline.repair(str(plan), tolerance=0.05, weld=0)
    repair.write(fixed)
    repair.write(log)
    kept = fixed.read_text()
    assert "\nARC\n" in kept
    assert "\nWALLS\n62\n3\n" in kept
    again = plumbline.read(fixed)
    assert rounded_signature(again) == rounded_signature(repair.output)
    assert plumbline.repair(again, tolerance=0.05, weld=0).edits == []
    back = plumbline.undo(again, log)
    assert rounded_signature(back) == rounded_signature(plumbline.read(plan))
    back.write(tmp_path / "back.dxf")
    assert "\nARC\n" in (tmp_path / "back.dxf").read_text()
    assert plumbline.same(tmp_path / "back.dxf", plan)
    with pytest.raises(plumbline.Error, match="overwrite"):
        repair.write(plan)
    with pytest.warns(plumbline.LossWarning, match="lines alone are written"):
        repair.write(tmp_path / "fixed.svg")
    assert plumbline.read(tmp_path / "fixed.svg").coords.shape == repair.output.coords.shape


def test_the_function_write_keeps_the_same_file_and_patches_it_as_the_methods_do(
    tmp_path: Path,
) -> None:
    plan, fixed = tmp_path / "plan.dxf", tmp_path / "fixed.dxf"
    plan.write_text(DXF)
    repair = plumbline.repair(plan, tolerance=0.05, weld=0)
    with pytest.raises(plumbline.Error, match="overwrite"):
        plumbline.write(repair, plan)
    assert plan.read_text() == DXF
    plumbline.write(repair, fixed)
    undone = plumbline.undo(plumbline.read(fixed), repair)
    with pytest.raises(plumbline.Error, match="overwrite"):
        plumbline.write(undone, fixed)
    plumbline.write(undone, tmp_path / "back.dxf")
    assert "\nARC\n" in (tmp_path / "back.dxf").read_text()
    pickle.loads(pickle.dumps(undone)).write(tmp_path / "again.dxf")
    assert (tmp_path / "again.dxf").read_bytes() == (tmp_path / "back.dxf").read_bytes()


def test_a_pickled_drawing_is_patched_as_long_as_its_file_is_there(tmp_path: Path) -> None:
    plan, fixed = tmp_path / "plan.dxf", tmp_path / "fixed.dxf"
    plan.write_text(DXF)
    repair = pickle.loads(pickle.dumps(plumbline.repair(plan, tolerance=0.05, weld=0)))
    repair.write(fixed)
    assert "\nARC\n" in fixed.read_text()
    plan.unlink()
    with pytest.warns(plumbline.LossWarning, match="lines alone"):
        repair.write(fixed)


def test_an_svg_stays_as_it_is_but_for_what_is_edited(tmp_path: Path) -> None:
    plan, fixed = tmp_path / "plan.svg", tmp_path / "fixed.svg"
    plan.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg"><rect width="9" height="9"/><path id="wall" '
        'stroke="red" d="M3 0V8.98"><title>Hall</title></path><circle cx="6" cy="5" r="1"/></svg>'
    )
    plumbline.repair(plan, grow=0.05).write(fixed)
    assert '<circle cx="6" cy="5" r="1"/>' in fixed.read_text()
    assert '<path id="wall" stroke="red" d="M3 0L3 9"><title>Hall' in fixed.read_text()


@pytest.mark.parametrize("ending", ["lines", "geojson", "csv", "wkt", "wkb", "dxf"])
def test_what_is_written_is_read_as_the_repaired_drawing(tmp_path: Path, ending: str) -> None:
    fixed = plumbline.repair(CORNER, tolerance=0.05)
    fixed.write(tmp_path / f"fixed.{ending}")
    assert plumbline.same(tmp_path / f"fixed.{ending}", BOX)


def test_an_svg_shows_y_upwards_where_the_drawing_has_it_so(tmp_path: Path) -> None:
    plumbline.repair(CORNER, tolerance=0.05).write(tmp_path / "fixed.svg")
    assert plumbline.same(tmp_path / "fixed.svg", [(a, -b, c, -d) for a, b, c, d in BOX])
