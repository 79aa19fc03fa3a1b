"""Structures pickled, as what they were made of."""

from __future__ import annotations

import os
import pickle
import threading
from pathlib import Path

import plumbline
import pytest
from plumbline import LarModel, Struct, Structure, r, t
from structure_test import EDGE, SQUARE


def test_pickling_and_json_keep_structs_maps_and_models() -> None:
    struct = Struct([t("1/3", 0), SQUARE, Struct([r(degrees=30), EDGE], "b", "block")], "a")
    for again in (
        pickle.loads(pickle.dumps(struct)),
        Structure.from_json(struct.structure.to_json()).root,
    ):
        assert plumbline.same(plumbline.evaluate(again), plumbline.evaluate(struct))
        assert again.name == "a"
        block = again.body[2]
        assert isinstance(block, Struct)
        assert block.category == "block"
    model = LarModel([("1/3", 0, 7)], [[0]])
    for one in (t("1/3", 0), r(degrees=45), r(1, 2, 3), model):
        assert pickle.loads(pickle.dumps(one)) == one


def test_a_pickled_drawing_keeps_its_hierarchy(examples: Path) -> None:
    drawing = plumbline.read(examples / "flat.dxf")
    again = pickle.loads(pickle.dumps(drawing))
    assert list(again) == list(drawing)
    assert [(x.name, x.category) for x in again.structs] == [
        (x.name, x.category) for x in drawing.structs
    ]


@pytest.mark.parametrize(
    "name", ["flat.dxf", "office-plan.svg", "rooms.json", "rooms.geojson", "rooms.wkb", "rooms.csv"]
)
def test_a_pickled_structure_is_the_same_and_evaluates_to_the_same(
    examples: Path, name: str
) -> None:
    drawing = plumbline.read(examples / name)
    structure = pickle.loads(pickle.dumps(drawing.structure))
    assert structure == drawing.structure
    assert structure.files == drawing.structure.files
    assert list(structure.evaluate()) == list(drawing)
    again = pickle.loads(pickle.dumps(pickle.loads(pickle.dumps(drawing))))
    assert list(again) == list(drawing)
    assert again.structure == structure
    of_layer = drawing.structs[0]
    assert list(plumbline.evaluate(pickle.loads(pickle.dumps(of_layer)))) == list(
        plumbline.evaluate(of_layer)
    )


def test_a_pickled_structure_does_not_need_its_file(tmp_path: Path) -> None:
    path = tmp_path / "a.wkt"
    path.write_text("LINESTRING (0 0, 1 0.1)")
    structure = plumbline.read(path).structure
    pickled = pickle.dumps(structure)
    path.unlink()
    again = pickle.loads(pickled)
    assert again == structure
    assert pickle.loads(pickle.dumps(again)) == structure


def test_a_structure_whose_file_changed_is_not_pickled_as_another_one(tmp_path: Path) -> None:
    path = tmp_path / "a.wkt"
    path.write_text("LINESTRING (0 0, 1 0.1)")
    structure = plumbline.read(path).structure
    path.write_text("LINESTRING (0 0, 1 0.2)")
    with pytest.raises(TypeError, match="cannot be pickled"):
        pickle.dumps(structure)
    path.unlink()
    with pytest.raises(TypeError, match="cannot be pickled"):
        pickle.dumps(structure)


def test_pickled_structs_and_structures_of_them_are_the_same(examples: Path) -> None:
    inner = Struct([t("1/3", 0), SQUARE], "inner", "chair")
    drawing = plumbline.read(examples / "flat.dxf")
    struct = Struct([inner, r(degrees=30), inner, plumbline.lines([(0, 0, 1, 1)]), drawing], "all")
    again = pickle.loads(pickle.dumps(struct))
    assert again.body[0] is again.body[2]
    assert again.structure == struct.structure
    for one in (struct.structure, struct.structure.of_category("chair")):
        assert pickle.loads(pickle.dumps(one)) == one


def test_what_was_saved_and_read_can_be_pickled(tmp_path: Path) -> None:
    path = tmp_path / "saved.json"
    Struct([t(1, 0), SQUARE], "a").structure.save(path)
    for structure in (plumbline.read(path).structure, Structure.read(path)):
        assert pickle.loads(pickle.dumps(structure)) == structure


def test_a_pipe_is_read_once(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe.wkt"
    os.mkfifo(pipe)
    writer = threading.Thread(target=pipe.write_text, args=("LINESTRING (0 0, 1 1)",))
    writer.start()
    drawing = plumbline.read(pipe)
    writer.join()
    assert len(drawing) == 1
    with pytest.raises(TypeError, match="pipe"):
        pickle.dumps(drawing)


def test_a_file_in_another_encoding_is_pickled(tmp_path: Path) -> None:
    path = tmp_path / "latin.dxf"
    texts = "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\nW\xe4nde\n10\n0\n20\n0\n11\n1\n21\n1\n"
    path.write_bytes((texts + "0\nENDSEC\n0\nEOF\n").encode("latin-1"))
    structure = plumbline.read(path).structure
    assert pickle.loads(pickle.dumps(structure)) == structure
