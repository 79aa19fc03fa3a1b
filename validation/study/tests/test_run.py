"""A small study of engines that are here, twice: the second time nothing is left to do."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest
from study import results
from study.__main__ import engines_of, part_of, run
from study.engines import Limits
from study.families import Unit, made_families
from study.schedule import Block
from study.work import Bounds

pytest.importorskip("shapely")

ADAPTERS = Path(__file__).with_name("adapters")


def blocks() -> list[Block]:
    return [
        Block(f, tuple(Unit(f.name, 12, f.scales[0], seed) for seed in range(2)))
        for f in made_families((12,))
    ]


def test_a_study_is_resumed_where_it_ended(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", f"{Path(sys.executable).parent}:{os.environ['PATH']}")
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join(p for p in sys.path if p))
    engines = engines_of([ADAPTERS], [])
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
