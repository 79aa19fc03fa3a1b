"""Every adapter that is installed answers by the protocol; those of engines that are not say so.

PYTHONPATH=... python -m pytest validation/study/tests/test_adapters.py
"""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "toys"))

import acceptance
from adapters import FOLDER, NOT_HERE, Adapter, Stopped, engines
from drawings import drawings

SECONDS = 60.0
SQUARE = [[0.0, 0.0, 4.0, 0.0], [4.0, 0.0, 4.0, 4.0], [4.0, 4.0, 0.0, 4.0], [0.0, 4.0, 0.0, 0.0]]
DIAGONALS = [[0.0, 0.0, 4.0, 4.0], [0.0, 4.0, 4.0, 0.0]]
ISLAND = [[1.0, 2.0, 2.0, 1.0], [2.0, 1.0, 2.0, 2.0], [2.0, 2.0, 1.0, 2.0]]
BRIDGE = [[0.0, 0.0, 1.0, 2.0]]
POINT = [[1.0, 1.0, 1.0, 1.0]]

ENGINES = engines()
HERE = [(e.name, c) for e in ENGINES if not e.takes_rings for c in e.configurations]
OF_RINGS = [(e.name, c) for e in ENGINES if e.takes_rings for c in e.configurations]
EDGES_ALONE = {
    "boost_polygon",
    ("cgal", "triangulation-epeck"),
    ("cgal", "triangulation-epick"),
    ("cgal_checked", "triangulation-epick"),
}
FACES_ALONE = {"mapshaper"}
HOLES_UNSAID = {("lar", "published")}
ENDS_STAY = {("cdt", "try-resolve-1e-9")}
"""Vertices near an edge are put on it; those near another vertex stay."""


@pytest.fixture(scope="module", params=HERE, ids=lambda of: f"{of[0]}-{of[1]}")
def running(request: pytest.FixtureRequest) -> Iterator[tuple[tuple[str, str], Adapter]]:
    adapter = Adapter(*request.param)
    yield request.param, adapter
    adapter.close()


def model(
    adapter: Adapter, case: int, segments: list[list[float]], tolerance: float | None = None
) -> dict[str, Any]:
    answer = adapter.ask(case, segments, SECONDS, tolerance)
    assert answer["case"] == case
    assert "error" not in answer, answer
    assert answer["seconds"] >= 0
    result: dict[str, Any] = answer["model"]
    return result


def says_edges(of: tuple[str, str]) -> bool:
    return of[0] not in FACES_ALONE


def says_faces(of: tuple[str, str]) -> bool:
    return of[0] not in EDGES_ALONE and of not in EDGES_ALONE


def tolerance_kind(of: tuple[str, str]) -> str:
    [engine] = [e for e in ENGINES if e.name == of[0]]
    assert engine.listed is not None
    [kind] = [c["tolerance"]["kind"] for c in engine.listed["configurations"] if c["name"] == of[1]]
    return str(kind)


def points(of: dict[str, Any], indices: Iterable[int]) -> set[tuple[float, ...]]:
    return {tuple(round(c, 6) for c in of["V"][i]) for i in indices}


def test_there_are_adapters() -> None:
    assert len(ENGINES) >= 14


@pytest.mark.parametrize("engine", ENGINES, ids=lambda e: e.name)
def test_an_adapter_lists_its_engine_or_says_why_it_is_not_here(engine: Any) -> None:
    if engine.listed is None:
        assert engine.reason and not engine.reason.startswith("broken"), engine.reason
        return
    assert engine.listed["engine"] == engine.name
    assert all(engine.listed[key] for key in ("title", "version", "algorithm", "licence"))
    names = engine.configurations
    assert names and len(set(names)) == len(names)
    for configuration in engine.listed["configurations"]:
        tolerance = configuration["tolerance"]
        assert tolerance["kind"] in ("none", "grid", "snap", "relative")
        assert (tolerance["value"] == 0) == (tolerance["kind"] == "none")
        assert configuration["title"] and configuration["source"]


@pytest.mark.parametrize("engine", [e.name for e in ENGINES])
def test_an_unknown_configuration_is_bad_usage(engine: str) -> None:
    run = subprocess.run(
        [FOLDER / engine / "adapter", "no-such"], capture_output=True, text=True, check=False
    )
    assert run.returncode in (2, NOT_HERE) and run.stderr and not run.stdout


def test_a_square_is_one_face(running: tuple[tuple[str, str], Adapter]) -> None:
    of, adapter = running
    answer = model(adapter, 3, SQUARE)
    assert acceptance.bounded_faces(answer) == 1
    assert points(answer, range(len(answer["V"]))) == {(0, 0), (4, 0), (4, 4), (0, 4)}
    if says_edges(of):
        assert len(answer["EV"]) == 4
    if "polygons" in answer:
        [[ring]] = answer["polygons"]
        assert len(ring) == 4 and points(answer, ring) == {(0, 0), (4, 0), (4, 4), (0, 4)}
    assert says_faces(of) == ("polygons" in answer or "FV" in answer)


def test_crossing_lines_are_cut(running: tuple[tuple[str, str], Adapter]) -> None:
    of, adapter = running
    answer = model(adapter, 1, SQUARE + DIAGONALS)
    assert acceptance.bounded_faces(answer) == 4
    assert (2, 2) in points(answer, range(len(answer["V"])))
    if says_edges(of):
        assert len(answer["V"]) == 5
        assert sorted(map(sorted, answer["EV"])) == sorted(
            {tuple(sorted(e)): sorted(e) for e in answer["EV"]}.values()
        )
        assert len(answer["EV"]) == 8 and all(a != b for a, b in answer["EV"])


def test_an_island_is_a_hole(running: tuple[tuple[str, str], Adapter]) -> None:
    of, adapter = running
    answer = model(adapter, 2, SQUARE + ISLAND)
    if of in HOLES_UNSAID:
        return
    assert acceptance.bounded_faces(answer) == 2
    if "polygons" in answer:
        assert sorted(len(rings) for rings in answer["polygons"]) == [1, 2]
        [outer, hole] = max(answer["polygons"], key=len)
        assert points(answer, outer) == {(0, 0), (4, 0), (4, 4), (0, 4)}
        assert points(answer, hole) == {(1, 2), (2, 1), (2, 2)}


def test_a_bridge_to_an_island_is_in_no_ring(running: tuple[tuple[str, str], Adapter]) -> None:
    _, adapter = running
    answer = model(adapter, 2, SQUARE + ISLAND + BRIDGE)
    if "polygons" in answer:
        assert sorted(len(rings) for rings in answer["polygons"]) == [1, 2]
        [outer, hole] = max(answer["polygons"], key=len)
        assert len(outer) == 4 and points(answer, outer) == {(0, 0), (4, 0), (4, 4), (0, 4)}
        assert len(hole) == 3 and points(answer, hole) == {(1, 2), (2, 1), (2, 2)}


def test_nothing_is_nothing(running: tuple[tuple[str, str], Adapter]) -> None:
    _, adapter = running
    for segments in ([], POINT):
        answer = model(adapter, 0, segments)
        assert acceptance.bounded_faces(answer) == 0
        assert answer["V"] == [] and answer.get("EV", []) == []


def test_one_line_is_one_edge(running: tuple[tuple[str, str], Adapter]) -> None:
    of, adapter = running
    answer = adapter.ask(4, [[0.0, 0.0, 1.0, 2.0]], SECONDS)
    if of == ("lar", "published"):
        assert answer["error"]["class"]  # without a cycle it fails
        return
    assert acceptance.bounded_faces(answer["model"]) == 0
    if says_edges(of):
        assert answer["model"]["EV"] == [[0, 1]]


def test_a_case_may_have_a_tolerance(running: tuple[tuple[str, str], Adapter]) -> None:
    of, adapter = running
    kind = tolerance_kind(of)
    answer = adapter.ask(8, SQUARE, SECONDS, tolerance=0.02)
    if kind == "none":
        assert answer["case"] == 8 and answer["error"]["class"] == "BadTolerance"
    else:
        assert acceptance.bounded_faces(answer["model"]) == 1
    wrongs: list[float | str] = [-1.0, "wide"]
    if kind == "grid":
        wrongs.append(0.0)
    for wrong in wrongs:
        answer = adapter.ask(9, SQUARE, SECONDS, tolerance=wrong)
        assert answer["error"]["class"] == "BadTolerance" and answer["error"]["message"]
    assert acceptance.bounded_faces(model(adapter, 10, SQUARE)) == 1  # its own one again


def test_a_tolerance_decides_what_is_one_point(running: tuple[tuple[str, str], Adapter]) -> None:
    """A gap of 0.3 is closed by a grid of 1, and by a snap distance of 0.5."""
    of, adapter = running
    kind = tolerance_kind(of)
    if kind == "none" or of in ENDS_STAY:
        return
    with_gap = [*SQUARE[:3], [0.0, 4.0, 0.0, 0.3]]
    tolerance = 1.0 if kind == "grid" else 0.5
    assert acceptance.bounded_faces(model(adapter, 11, with_gap, tolerance)) == 1
    if of != ("lar", "published"):  # without a cycle it fails
        assert acceptance.bounded_faces(model(adapter, 12, with_gap, tolerance / 100)) == 0


def test_ways_are_named_where_tolerances_can_be_chosen() -> None:
    for engine in ENGINES:
        if engine.takes_rings:
            continue  # their cases have no tolerances
        for c in engine.listed["configurations"] if engine.listed else ():
            tolerance = c["tolerance"]
            assert (tolerance["kind"] == "none") == (not tolerance.get("way"))


@pytest.mark.parametrize("program", sorted(FOLDER.glob("*/repairs")), ids=lambda p: p.parent.name)
def test_a_repair_closes_gaps_within_its_tolerance(program: Path) -> None:
    """Of a square whose last side ends 0.01 before the first; where faces alone are repaired, a gap
    between two squares instead."""
    run = subprocess.run([program, "--list"], capture_output=True, text=True, check=False)
    if run.returncode == NOT_HERE:
        pytest.skip(run.stderr.strip())
    open_square = [*SQUARE[:3], [0.0, 4.0, 0.0, 0.01]]
    left, right = (
        [[x, 0.0, x + 4, 0.0], [x + 4, 0.0, x + 4, 4.0], [x + 4, 4.0, x, 4.0], [x, 4.0, x, 0.0]]
        for x in (0.0, 4.01)
    )
    for configuration in json.loads(run.stdout)["configurations"]:
        name = configuration["name"]
        segments = left + right if name == "coverage-clean" else open_square
        cases = [
            json.dumps({"case": k, "segments": segments, "tolerance": tolerance})
            for k, tolerance in enumerate((0.02, 0.005))
        ]
        said = subprocess.run(
            [program, name], input="\n".join(cases), capture_output=True, text=True, check=True
        )
        repaired, left_alone = (json.loads(line)["model"] for line in said.stdout.splitlines())
        if name == "coverage-clean":
            assert [len(m["V"]) for m in (repaired, left_alone)] == [6, 8]
        else:
            assert [acceptance.bounded_faces(m) for m in (repaired, left_alone)] == [1, 0]


def test_answers_come_in_the_order_of_cases(running: tuple[tuple[str, str], Adapter]) -> None:
    _, adapter = running
    for case in (9, 4, 7):
        assert adapter.ask(case, SQUARE, SECONDS)["case"] == case


BOX, OTHER = ([(x, x), (x + 4.0, x), (x + 4.0, x + 4.0), (x, x + 4.0)] for x in (0.0, 2.0))
WITHIN = [(1.0, 1.0), (2.0, 1.0), (1.0, 2.0)]


@pytest.mark.parametrize("of", OF_RINGS, ids=lambda of: f"{of[0]}-{of[1]}")
@pytest.mark.parametrize(
    ("rings", "rule", "twice_area", "count"),
    [
        ([], "nonzero", 0, 0),
        ([BOX], "nonzero", 32, 1),
        ([BOX, OTHER], "nonzero", 56, 1),
        ([BOX, OTHER], "evenodd", 48, None),
        ([BOX, WITHIN], "nonzero", 32, 1),
        ([BOX, WITHIN], "evenodd", 31, 2),
        ([BOX, BOX], "evenodd", 0, 0),
        ([BOX, BOX], "nonzero", 32, 1),
    ],
)
def test_rings_are_united_by_their_rule(
    of: tuple[str, str],
    rings: list[list[tuple[float, float]]],
    rule: str,
    twice_area: float,
    count: int | None,
) -> None:
    adapter = Adapter(*of)
    try:
        answer = adapter.ask_rings(1, rings, rule, SECONDS)
    finally:
        adapter.close()
    assert answer["case"] == 1 and "error" not in answer
    model = answer["model"]
    polygons = model.get("polygons", [[ring] for ring in model.get("rings", ())])
    found = [ring for polygon in polygons for ring in polygon]
    assert count in (None, len(found))
    sides = {tuple(sorted(s)) for ring in found for s in zip(ring, [*ring[1:], ring[0]])}
    assert sides == {tuple(e) for e in model["EV"]}
    sizes = [[abs(_twice_area(model["V"], ring)) for ring in polygon] for polygon in polygons]
    if "polygons" in model:
        assert sum(outer - sum(holes) for outer, *holes in sizes) == pytest.approx(twice_area)
    elif count is not None:  # the second one, if any, is a hole
        assert sum(
            (-1) ** k * size for k, [size] in enumerate(sorted(sizes, reverse=True))
        ) == pytest.approx(twice_area)


def _twice_area(vertices: list[list[float]], ring: list[int]) -> float:
    places = [vertices[v] for v in ring]
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(places, [*places[1:], places[0]]))


@pytest.mark.parametrize(
    ("of", "segments", "kind"),
    [
        (("jsts", "unary-union"), "tees 40", "TopologyException"),
        (("jts_1_19", "mcindex-validated"), "fan 1e-15", "TopologyException"),
        (("cdt", "try-resolve"), "tees 40", "RuntimeError"),
        (("postgis_topology", "tolerance-0"), "fan 1e-12", "InternalError_"),
        (("boost_polygon", "scale-1e8"), "tees 40", "OutOfRange"),
    ],
    ids=lambda value: value[0] if isinstance(value, tuple) else None,
)
def test_what_an_engine_says_of_failing_is_an_error(
    of: tuple[str, str], segments: str, kind: str
) -> None:
    if of not in HERE:
        pytest.skip(f"{of[0]} is not here")
    toys = {toy.name: toy.segments for toy in drawings()}
    adapter = Adapter(*of)
    try:
        answer = adapter.ask(5, toys[segments], SECONDS)
        assert answer["case"] == 5 and "model" not in answer
        assert answer["error"]["class"] == kind and answer["error"]["message"]
        assert acceptance.bounded_faces(model(adapter, 6, SQUARE)) == 1  # it goes on
    finally:
        adapter.close()


def test_an_adapter_that_hangs_or_ends_is_noticed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("adapters.FOLDER", tmp_path)
    for name, body in (("hangs", "sleep 100"), ("ends", "exit 7"), ("crashes", "kill -SEGV $$")):
        (tmp_path / name).mkdir()
        program = tmp_path / name / "adapter"
        program.write_text(f"#!/bin/bash\n{body}\n")
        program.chmod(0o755)
        adapter = Adapter(name, "any")
        with pytest.raises(
            Stopped, match={"hangs": "timeout", "ends": "code 7"}.get(name, "SIGSEGV")
        ):
            adapter.ask(1, SQUARE, 0.5 if name == "hangs" else SECONDS)
        adapter.kill()


def test_answers_are_read_as_results() -> None:
    """plumbline.check takes models as they are."""
    plumbline = pytest.importorskip("plumbline")
    if ("shapely", "node") not in HERE:
        pytest.skip("shapely is not here")
    adapter = Adapter("shapely", "node")
    try:
        answer = json.loads(json.dumps(model(adapter, 1, SQUARE + DIAGONALS + ISLAND)))
        assert plumbline.check(answer, SQUARE + DIAGONALS + ISLAND).agree
    finally:
        adapter.close()
