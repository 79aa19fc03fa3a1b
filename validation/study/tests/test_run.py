"""A small study of engines that are here, twice: the second time nothing is left to do."""

from __future__ import annotations

import os
import sys
from dataclasses import replace
from pathlib import Path

import pytest
from study import results
from study.__main__ import blocks_for, engines_of, part_of, run
from study.engines import Configuration, Limits
from study.families import Unit, case_of, made_families
from study.schedule import QUICK, Block
from study.truths import Truths
from study.words import RINGS
from study.work import Bounds, Engine, one_of_each_way

pytest.importorskip("shapely")

ADAPTERS = Path(__file__).with_name("adapters")


def blocks() -> list[Block]:
    return [
        Block(f, tuple(Unit(f.name, 12, f.scales[0], seed) for seed in range(2)))
        for f in made_families((12,))
    ]


def adapters(monkeypatch: pytest.MonkeyPatch, names: list[str]) -> list[Engine]:
    monkeypatch.setenv("PATH", f"{Path(sys.executable).parent}:{os.environ['PATH']}")
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(p for p in sys.path if p))
    return engines_of([ADAPTERS], names)


def test_a_sweep_is_of_tolerances_by_feature_size(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    engines = adapters(monkeypatch, ["plumbline-lar", "shapely"])
    [family] = [f for f in made_families((12,)) if f.name == "random"]
    ratios = (0.0, 1e-3, 10.0)
    swept = Block(family, (Unit(family.name, 12, "unit", 5),), ("doubles",), ratios)
    path = tmp_path / "results.parquet"
    for _ in range(2):
        run([swept], engines, path, 1, Bounds(Limits(), both_engines=1))
    table = results.load(path)
    found = {(r["configuration"], r["ratio"]): r for r in table.to_pylist()}
    assert len(found) == len(table)
    # What has no tolerance is not asked, nor a grid for one of nothing.
    assert {name for name, _ in found} == {"grid-1e-6", "repaired-1e-8", "published"}
    assert [ratio for name, ratio in found if name == "grid-1e-6"] == [1e-3, 10.0]
    assert [ratio for name, ratio in found if name == "published"] == list(ratios)
    for (_, ratio), row in found.items():
        assert row["tolerance"] == pytest.approx(ratio * row["feature_size"], rel=0.02)
    assert found["repaired-1e-8", 1e-3]["outcome"] in ("identical", "moved")
    assert found["repaired-1e-8", 10.0]["outcome"] == "topology"
    run([replace(swept, ratios=(None,))], engines, path, 1, Bounds(Limits(), both_engines=1))
    own = [r for r in results.load(path).to_pylist() if r["ratio"] is None]
    assert {r["configuration"] for r in own} > {"node", "grid-1e-6"}  # other units than these
    assert len(results.load(path)) == len(table) + len(own)


def test_tolerances_are_by_what_was_meant() -> None:
    """Ends that are meant to be on a line miss it by rounding alone."""
    [family] = [f for f in made_families((12,)) if f.name == "tees on a slant"]
    truths = Truths(case_of(family, Unit(family.name, 12, "unit", 1)))
    assert truths.meant_size is not None and truths.meant_size > 0.01
    assert truths.feature_size is not None and truths.feature_size < 1e-12


def test_of_ways_that_differ_by_tolerance_one_is_swept() -> None:
    one = Configuration("e", "E", "1", "e", "a", "A 1e-3", "grid", 1e-3, "", way="A")
    others = [
        replace(one, name="b", tolerance=1e-6),
        replace(one, name="c", tolerance_kind="none", tolerance=0.0, way=""),
        replace(one, name="d", way="D"),
        replace(one, engine="f"),
    ]
    swept = one_of_each_way([one, *others])
    assert swept == {("e", "1", "a"), ("e", "1", "d"), ("f", "1", "a")}


def test_a_study_is_resumed_where_it_ended(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    engines = adapters(monkeypatch, ["plumbline-lar", "shapely"])
    assert [e.configuration.name for e in engines][:2] == ["repaired-1e-8", "published"]
    path = tmp_path / "results.parquet"
    halves = [part_of(iter(blocks()), part) for part in ((1, 2), (2, 2))]
    assert [len(half) for half in halves] == [3, 2]
    for half in halves:
        run(half, engines, path, 1, Bounds(Limits(), both_engines=1))
    table = results.load(path)
    doubles = [r for r in table.to_pylist() if r["truth"] == "doubles"]
    assert len(doubles) == 2 * 5 * len(engines)
    assert all(r["both_engines"] for r in doubles)
    node = [r for r in doubles if r["configuration"] == "node" and r["fits_doubles"]]
    assert node and {r["outcome"] for r in node} == {"identical"}
    run(blocks(), engines, path, 1, Bounds(Limits(), both_engines=1))
    assert results.load(path).equals(table)  # seconds, too: nothing was asked again


def test_rings_are_put_to_engines_that_take_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    engines = adapters(monkeypatch, ["shapely", "shapely-rings"])
    amount = replace(QUICK, rings=((10, 2),))
    asked = blocks_for([e for e in engines if e.configuration.takes], amount, tmp_path)
    todo = [b for b in asked if b.family.name.startswith("turned squares")]
    assert {b.family.name for b in todo} == {"turned squares, union", "turned squares, xor"}
    path = tmp_path / "results.parquet"
    run([*todo, *blocks()[:1]], engines, path, 1, Bounds(Limits(), both_engines=1))
    rows = results.load(path).to_pylist()
    rings = [r for r in rows if r["group"] == RINGS]
    assert {(r["engine"], r["family"]) for r in rings} == {
        ("shapely-rings", "turned squares, union")
    }
    assert len(rings) == 2 * 2 * 3 and all(r["both_engines"] for r in rings)
    by_way = {c: [r for r in rings if r["configuration"] == c] for c in ("union", "first")}
    assert {r["outcome"] for r in by_way["union"]} <= {"identical", "moved"}
    assert {r["outcome"] for r in by_way["first"]} == {"topology"}
    assert all(r["area"] > 1e-3 and r["perimeter"] > 4 for r in by_way["first"])
    assert {r["engine"] for r in rows if r["group"] != RINGS} == {"shapely"}
