"""Structs: what they come to, exactly, and as the original larstruct module recorded it."""

from __future__ import annotations

import json
import math
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import plumbline
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from plumbline import LarModel, Map, Struct, Structure, r, s, t

ORIGINAL_ERROR = 1e-6  # of the original's rotations of space, which go through float32

SQUARE = ([(0, 0), (0, 1), (1, 0), (1, 1)], [[0, 1, 3, 2]])
EDGE = ([(0, 0), (1, 0)], [[0, 1]])


def exact(*values: int | Fraction) -> tuple[Fraction, ...]:
    return tuple(map(Fraction, values))


def built(document: dict[str, Any]) -> Struct:
    """A recorded structure, of the maps, models and Structs that users make."""
    made: dict[str, Any] = {}

    def definition(name: str) -> Any:
        if name not in made:
            found = document["defs"][name]
            made[name] = struct(found, name) if "body" in found else model(found)
        return made[name]

    def struct(found: dict[str, Any], name: str) -> Struct:
        return Struct([item(part) for part in found["body"]], name)

    def model(found: dict[str, Any]) -> Any:
        if "shape" in found:
            cuboids = plumbline.lar.larCuboids(found["shape"], full=found.get("skeletons", False))
            return cuboids.boundary() if found.get("boundary") else cuboids
        return (found["V"], *(found[name] for name in ("CV", "FV", "EV") if name in found))

    def item(part: dict[str, Any]) -> Any:
        if "ref" in part:
            return definition(part["ref"])
        if "op" in part:
            return {"t": t, "s": s, "r": r}[part["op"]](*part["args"])
        if "mat" in part:
            return Map(part["mat"])
        return struct(part, "") if "body" in part else model(part)

    found = definition(document["root"])
    assert isinstance(found, Struct)
    return found


@pytest.fixture(scope="session")
def recorded(test_data: Path) -> dict[str, Any]:
    cases: dict[str, Any] = json.loads((test_data / "larstruct.json").read_text())
    return cases


def arrays_of(model: dict[str, Any]) -> list[list[list[int]]]:
    return [model[name] for name in ("CV", "FV", "EV") if name in model]


def as_sets(cells: list[list[int]]) -> list[list[int]]:
    return sorted(sorted(cell) for cell in cells)


def test_structs_evaluate_to_the_recorded_models_in_their_order(recorded: dict[str, Any]) -> None:
    cases = 0
    for name, case in recorded.items():
        if not isinstance(case.get("evalStruct"), list):
            continue
        models = plumbline.lar.evalStruct(built(case["input"]))
        assert len(models) == len(case["evalStruct"]), name
        for model, expected in zip(models, case["evalStruct"], strict=True):
            np.testing.assert_allclose(model.V, expected["V"], atol=ORIGINAL_ERROR)
            assert [a.tolist() for a in model.cells] == arrays_of(expected), name
        cases += 1
    assert cases >= 15


def test_struct2lar_published_has_the_recorded_vertices_and_cells(
    recorded: dict[str, Any],
) -> None:
    cases = 0
    for name, case in recorded.items():
        # The original loses what the last model has not (L8).
        if name == "mixed-triple-then-pair":
            continue
        for version, expected in case.get("struct2lar", {}).items():
            if "V" not in expected:
                continue
            once = version == "nov2015"
            model = plumbline.lar.struct2lar(built(case["input"]), "published", merge_cells=once)
            np.testing.assert_allclose(model.V, expected["V"], atol=1e-12)
            found = [a.tolist() for a in model.cells]
            assert list(map(as_sets, found)) == list(map(as_sets, arrays_of(expected))), name
            assert once or found == arrays_of(expected), name
            cases += 1
    assert cases >= 25


def test_boxes_are_those_of_the_vertices_where_the_original_maps_corners(
    recorded: dict[str, Any],
) -> None:
    wrong = 0
    for name, case in recorded.items():
        if not isinstance(case.get("true_box"), list) or name.startswith("mixed"):
            continue
        found = plumbline.box(built(case["input"]))
        assert found is not None
        np.testing.assert_allclose(
            np.array(found, dtype=float), case["true_box"], atol=ORIGINAL_ERROR
        )
        if isinstance(case["box"], list):
            wrong += not np.allclose(case["box"], case["true_box"], atol=ORIGINAL_ERROR)
    assert wrong >= 2


def test_twice_45_degrees_is_a_quarter_turn_exactly() -> None:
    half = Struct([r(degrees=45), SQUARE])
    twice = Struct([t(3, 5), Struct([r(degrees=45), s(2, 2), half])])
    assert plumbline.box(twice) == (exact(1, 5), exact(3, 7))
    quarter = Struct([t(3, 5), r(degrees=90), s(2, 2), SQUARE])
    assert plumbline.same(plumbline.evaluate(twice), plumbline.evaluate(quarter))
    assert plumbline.evaluate(twice).ledger == []


def test_a_half_of_it_is_an_isometry_and_says_what_it_stands_for() -> None:
    lines = plumbline.evaluate(Struct([r(degrees=45), EDGE]))
    (ax, ay), (bx, by) = lines.exact(0)
    assert (ax, ay) == exact(0, 0)
    assert bx * bx + by * by == 1
    assert abs(math.atan2(by, bx) - math.pi / 4) < 2e-15
    assert [item.bound.split()[1] for item in lines.ledger] == ["rad"]


def test_radians_of_a_quarter_turn_are_one_and_others_are_in_the_ledger() -> None:
    assert r(math.pi / 2) == Map([[0, -1, 0], [1, 0, 0]])
    assert r(0, 0, -math.pi / 2).apply((1, 0, 0)) == exact(0, -1, 0)
    lines = plumbline.evaluate(Struct([r(1), EDGE]))
    assert [item.what for item in lines.ledger] == ["r(1)"]


def test_floats_are_decimals_unless_doubles_are_asked_for() -> None:
    tenth = Fraction(0.1)
    assert t(0.1, 0).apply((0, 0)) == exact(Fraction(1, 10), 0)
    assert t(0.1, 0, numbers="doubles").apply((0, 0)) == exact(tenth, 0)
    assert LarModel(np.array([[0.1, 0]])).exact(0)[0] == Fraction(1, 10)
    assert LarModel(np.array([[0.1, 0]]), numbers="doubles").exact(0)[0] == tenth
    model = Struct([([(0.1, 0)], [])], numbers="doubles").body[0]
    assert isinstance(model, LarModel)
    assert model.exact(0)[0] == tenth


def test_evaluating_as_doubles_rounds_before_it_maps() -> None:
    struct = Struct([t("1/3", 0), EDGE])
    third = Fraction(1 / 3)
    assert plumbline.evaluate(struct).exact(0)[1][0] == Fraction(4, 3)
    assert plumbline.evaluate(struct, numbers="doubles").exact(0)[1][0] == third + 1


numbers = st.fractions(-9, 9, max_denominator=50)
plane_maps = st.one_of(
    st.tuples(numbers, numbers).map(lambda v: t(*v)),
    st.tuples(numbers, numbers).map(lambda v: s(*v)),
    st.integers(-7, 7).map(lambda k: r(degrees=90 * k)),
    st.lists(numbers, min_size=6, max_size=6).map(lambda m: Map([m[:3], m[3:]])),
)


@settings(max_examples=60, deadline=None)
@given(st.lists(plane_maps, max_size=4), numbers, numbers)
def test_maps_in_a_body_are_their_product(maps: list[Map], x: Fraction, y: Fraction) -> None:
    product = t(0, 0)
    for one in maps:
        product = product @ one
    (model,) = plumbline.lar.evalStruct(Struct([*maps, ([(x, y)], [[0]])]))
    assert model.exact(0) == product.apply((x, y))
    rows = [a * x + b * y + c for a, b, c in product.exact]
    assert [*model.exact(0), 1] == rows


@settings(max_examples=40, deadline=None)
@given(plane_maps, numbers, numbers)
def test_an_inverse_leads_back(one: Map, x: Fraction, y: Fraction) -> None:
    (a, c, _), (b, d, _), _ = one.exact
    if a * d == b * c:
        with pytest.raises(plumbline.Error, match="invertible"):
            one.inverse()
    else:
        assert one.inverse().apply(one.apply((x, y))) == (x, y)


def test_a_struct_that_is_used_often_is_stored_once() -> None:
    struct = Struct([EDGE])
    for _ in range(40):
        struct = Struct([struct, t(1, 0), struct])
    assert len(struct.structure) == 41
    assert struct.structure.instances == 2**40
    assert plumbline.box(struct) == (exact(0, 0), exact(41, 0))


def test_depth_is_limited_by_memory_alone() -> None:
    struct = Struct([EDGE])
    for _ in range(20 * sys.getrecursionlimit()):
        struct = Struct([t(1, 0), struct])
    (model,) = plumbline.lar.evalStruct(struct)
    assert model.exact(0) == exact(20 * sys.getrecursionlimit(), 0)


def test_models_of_any_dimension_unpack_as_tuples_do() -> None:
    V, CV = LarModel(np.eye(5), [[0, 1, 2], [3, 4]])
    assert V.shape == (5, 5)
    assert CV.tolist() == [[0, 1, 2], [3, 4]]
    with pytest.raises(ValueError):
        V[0] = 1
    with pytest.raises(plumbline.Error, match="dimension"):
        plumbline.evaluate(Struct([EDGE, ([(0, 0, 0)], [[0]])]))


@pytest.mark.parametrize(
    "bad",
    [
        lambda: Struct([5]),
        lambda: Struct([([(0, 0)], [[1]])]),
        lambda: Struct([([(0, 0), (1,)], [])]),
        lambda: LarModel([("x", 0)]),
        lambda: LarModel(np.array([[math.inf, 0]])),
        lambda: LarModel([(0, 0)], [[-1]]),
        lambda: LarModel([(0, 0)], [[0.5]]),
        lambda: LarModel([(0, 0)], numbers="exact"),  # type: ignore[arg-type]
        lambda: t(),
        lambda: t("x"),
        lambda: r(1, 2),
        lambda: r(1, degrees=1),
        lambda: r(degrees="x"),
        lambda: Map([[1, 0], [0, 1], [0, 0]]),
        lambda: Map([[1, 0, 0], [0, 1, 0], [0, 0, 2]]),
        lambda: t(1).apply((1, 2)),
        lambda: t(1, 2) @ t(1),
        lambda: plumbline.evaluate(Struct([]), category="layer"),
        lambda: plumbline.evaluate(LarModel(np.eye(3), [[0, 1]])),
    ],
)
def test_what_makes_no_struct_is_refused(bad: Any) -> None:
    with pytest.raises(plumbline.Error):
        bad()


def test_an_empty_struct_has_no_lines_and_no_box() -> None:
    assert len(plumbline.evaluate(Struct())) == 0
    assert plumbline.box(Struct()) is None
    assert Struct().dimension == 0


def test_the_paths_of_lines_name_the_structs_above_them() -> None:
    lines = plumbline.evaluate(Struct([Struct([EDGE], "chair")], "room"))
    assert lines.source(0).path == "chair"


def test_a_drawing_has_its_hierarchy_as_a_tree(examples: Path) -> None:
    drawing = plumbline.read(examples / "flat.dxf")
    assert {struct.category for struct in drawing.structs} == {"", "layer", "block"}
    assert drawing.structure.tree().splitlines()[1:] == [
        "  WALLS (layer)  8 elements of 29 segments",
        "  DOORS (layer)",
        "    DOOR (block) x 2  2 elements of 14 segments",
        "  FURNITURE (layer)",
        "    TABLE (block)  2 elements of 32 segments",
        "      CHAIR (block) x 2  1 element of 17 segments",
        "    CHAIR (block) x 6  1 element of 17 segments",
    ]
    assert drawing.structure.tree(depth=1).splitlines()[1:] == [
        "  WALLS (layer)  8 elements of 29 segments",
        "  DOORS (layer)",
        "  FURNITURE (layer)",
    ]
    assert drawing.structure.tree(lines=3).splitlines()[-1] == "  ... 5 more lines"


def test_a_drawing_in_a_struct_is_the_drawing(examples: Path) -> None:
    drawing = plumbline.read(examples / "flat.dxf")
    twice = plumbline.evaluate(Struct([drawing, t(100000, 0), drawing]))
    assert len(twice) == 2 * len(drawing)
    assert plumbline.same(plumbline.evaluate(Struct([drawing])), drawing)
    assert twice.source(0).line == drawing.source(0).line
    assert twice.files[twice.source(0).file] == drawing.files[0]
    assert (twice.unit is None) == (drawing.unit is None)


def test_lines_in_a_struct_keep_items_layers_and_rejections() -> None:
    lines = plumbline.lines([(0, 0, 1, 0), (2, 2, 2, 2)], ids=["a", "b"], layers=["W", "W"])
    placed = plumbline.evaluate(Struct([t(0, "1/3"), lines]))
    assert placed.exact(0) == (exact(0, Fraction(1, 3)), exact(1, Fraction(1, 3)))
    assert placed.source(0).id == "a"
    assert placed.source(0).layer == "W"
    assert [item.source.id for item in placed.rejected] == ["b"]
    with pytest.raises(plumbline.Error, match="isolated points"):
        plumbline.evaluate(Struct([plumbline.lines([(0, 0, 1, 0)], points=[(5, 5)])]))


def test_the_layers_of_a_drawing_can_be_taken_apart(examples: Path) -> None:
    drawing = plumbline.read(examples / "flat.dxf")
    layer = next(struct for struct in drawing.structs if struct.category == "layer" and len(struct))
    alone = plumbline.evaluate(layer)
    assert len(layer.structure) < len(drawing.structs)
    elements = [item for item in layer if not isinstance(item, (Struct, Map))]
    again = plumbline.evaluate(Struct(elements))
    assert 0 < len(alone) < len(drawing)
    assert len(again) <= len(alone)
    blocks = drawing.of_category("block")
    assert 0 < len(blocks) < len(drawing)
    with pytest.raises(plumbline.Error, match="layer"):
        drawing.of_category("storey")


def test_a_matrix_beyond_the_doubles_is_infinite() -> None:
    assert t("1e400", "-1e400").matrix[:2, 2].tolist() == [math.inf, -math.inf]


def test_structures_of_space_are_read_and_looked_at_from_aside(examples: Path) -> None:
    cubes = Structure.read(examples.parent / "structures" / "cubes.json")
    assert cubes.dimension == 3
    assert cubes.instances == len(cubes.models())
    cube = Struct([plumbline.lar.larCuboids([1, 1, 1], full=True)])
    assert {x for line in cube.structure.view() for x, _ in line} == {
        Fraction(n, 2) for n in range(4)
    }
    with pytest.raises(plumbline.Error, match="dimension"):
        plumbline.evaluate(cubes)


def test_the_tables_of_the_examples_are_the_same_flat_and_nested(examples: Path) -> None:
    folder = examples.parent / "structures"
    flat, local = (plumbline.read(folder / f"table_{name}.json") for name in ("flat", "local"))
    assert {struct.name for struct in local.structs} >= {"table", "chair"}
    assert plumbline.same(flat, local)
