"""Findings: wrong answers of a study's engines, each brought down to a few segments.

    make.py RESULTS [--engine E] [--each N] [--seconds S]

Of each engine it takes silently wrong answers to drawings whose exact answer doubles can hold, the
gravest kinds first and of each the smallest drawing, lets `plumbline minimise` reduce it, asks the
engine once more, and keeps what is wrong by hand (`by_hand.py`), in a folder of its own:

    drawing.lines, finding.json (what was asked and answered), issue.md and picture.svg

It sends nothing to anybody. Run by `validation/study/findings/make`.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

import by_hand
import pyarrow.compute as pc
import pyarrow.parquet as pq
from study import families
from study.engines import Adapter, Configuration, listing
from study.families import Family, Unit, case_of
from study.outcomes import edges_of
from study.words import RINGS, SILENT

_HERE = Path(__file__).resolve().parent
_ADAPTERS = _HERE.parent / "adapters"
_GRAVEST = ("face lost", "face invented", "faces merged", "face split", "wrong parent")
_MOST_SEGMENTS = 120  # of a drawing that is worth reducing
_TRIES = 12  # drawings of an engine, of which some reduce to nothing that is wrong by hand

Row = dict[str, Any]


def candidates(results: Path, engine: str) -> list[Row]:
    """Silently wrong answers of an engine, the most telling first: one of each configuration and
    kind, over doubles, where these can hold the right one."""
    table = pq.read_table(results, filters=pc.field("engine") == engine).to_pylist()
    wrong = [row for row in table if row["outcome"] in SILENT and row["order"] == 0]
    # Of engines with tolerances those that break their own promise, too.
    broken = {_drawing(row) for row in wrong if row["truth"] == "contract"}
    rows = [
        row
        for row in wrong
        if row["truth"] == "doubles"
        and row["group"] != RINGS  # which are no line work
        and row["fits_doubles"]
        and row["segments"] <= _MOST_SEGMENTS
        and (row["tolerance_kind"] == "none" or _drawing(row) in broken)
    ]
    first: dict[tuple[str, str], Row] = {}
    for row in sorted(rows, key=_telling):
        first.setdefault((row["configuration"], row["kind"]), row)
    return sorted(first.values(), key=_telling)


def _drawing(row: Row) -> tuple[Any, ...]:
    return tuple(row[name] for name in ("configuration", "family", "size", "scale", "seed"))


def _telling(row: Row) -> tuple[Any, ...]:
    kind = row["kind"]
    grave = _GRAVEST.index(kind) if kind in _GRAVEST else len(_GRAVEST)
    # Who merges nothing has no excuse.
    return row["tolerance_kind"] != "none", grave, row["segments"], row["family"], row["seed"]


def families_by_name(drawings: Path) -> dict[str, list[Family]]:
    every = [
        *families.campaign_families(),
        *families.plan_families(),
        *families.made_families((12, 40)),
        *families.drawing_families(drawings),
        *families.ulp_maps(),
    ]
    found: dict[str, list[Family]] = {}
    for family in every:
        found.setdefault(family.name, []).append(family)
    return found


def segments_of(row: Row, known: dict[str, list[Family]]) -> list[tuple[float, ...]]:
    unit = Unit(row["family"], row["size"], row["scale"], row["seed"], row["order"])
    return list(case_of(known[row["family"]][0], unit).segments)


def reduced(row: Row, segments: list[tuple[float, ...]], folder: Path, seconds: float) -> bool:
    """Writes the reduced drawing, the issue and the picture; False where it is not wrong to the
    tool, which matches by its own tolerance."""
    given = folder / "given.lines"
    given.write_text("".join(f"{ax!r},{ay!r},{bx!r},{by!r}\n" for ax, ay, bx, by in segments))
    command = [
        os.environ.get("PLUMBLINE", "plumbline"),
        "minimise",
        "given.lines",
        "--engine",
        str(_ADAPTERS / row["engine"] / "adapter"),
        "--set",
        f"configuration={row['configuration']}",
        "--seconds",
        str(seconds),
        "-o",
        "drawing.lines",
        "--report",
        "issue.md",
        "--picture",
        "picture.svg",
    ]
    run = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    given.unlink()
    if run.returncode != 1 or not (folder / "drawing.lines").exists():
        print(f"  {row['configuration']}, {row['kind']}: {(run.stderr or run.stdout)[:200]}",
              file=sys.stderr)  # fmt: skip
        return False
    return True


def rows_of(drawing: Path) -> Iterator[list[float]]:
    for line in drawing.read_text(encoding="utf-8").splitlines():
        numbers = re.sub(r"#.*", "", line).replace(",", " ").split()
        if numbers:
            yield [float(Fraction(n)) for n in numbers]


def finding(row: Row, of: Configuration, drawing: Path) -> Row | None:
    """What the engine answers to the reduced drawing; None where that is not wrong by hand."""
    segments = list(rows_of(drawing))
    with Adapter(_ADAPTERS / row["engine"] / "adapter", row["configuration"]) as adapter:
        reply = adapter.ask(segments)
    if reply.model is None:
        return None
    model = dict(reply.model)
    model["EV"] = [list(e) for e in sorted(edges_of(model))]
    found = {
        "engine": of.engine,
        "title": of.title,
        "version": of.version,
        "configuration": of.name,
        "source": of.source,
        "tolerance": {"kind": of.tolerance_kind, "value": of.tolerance},
        "kind": row["kind"],
        "family": row["family"],
        "segments": segments,
        "model": model,
    }
    said = by_hand.verdict(found)
    return found if said.is_wrong and said.fits else None


def make(results: Path, engine: str, each: int, seconds: float, drawings: Path) -> int:
    """Findings of one engine. Returns how many."""
    of = {c.name: c for c in listing(_ADAPTERS / engine / "adapter")}
    known = families_by_name(drawings)
    made = 0
    kinds: set[str] = set()
    for row in candidates(results, engine)[:_TRIES]:
        if made == each:
            break
        if row["configuration"] not in of or (made and row["kind"] in kinds):
            continue
        with tempfile.TemporaryDirectory() as text:
            folder = Path(text)
            if not reduced(row, segments_of(row, known), folder, seconds):
                continue
            found = finding(row, of[row["configuration"]], folder / "drawing.lines")
            if found is None:
                continue
            made += 1
            kinds.add(row["kind"])
            (folder / "finding.json").write_text(_json(found), encoding="utf-8")
            name = re.sub(
                r"[^a-z0-9]+", "-", f"{engine} {row['configuration']} {row['kind']}".lower()
            )
            shutil.rmtree(_HERE / name, ignore_errors=True)
            shutil.copytree(folder, _HERE / name)
            print(f"{name}: {len(found['segments'])} segments of {row['segments']}", flush=True)
    return made


def _json(found: Row) -> str:
    """A line for each member."""
    members = (f" {json.dumps(key)}: {json.dumps(value)}" for key, value in found.items())
    return "{\n" + ",\n".join(members) + "\n}\n"


def main() -> int:
    parser = argparse.ArgumentParser(prog="validation/study/findings/make")
    parser.add_argument("results", type=Path)
    parser.add_argument("--engine", action="append", default=[], metavar="E")
    parser.add_argument("--each", type=int, default=2, help="findings of an engine")
    parser.add_argument("--seconds", type=float, default=60.0, help="for reducing each of them")
    parser.add_argument("--drawings", type=Path, default=_HERE.parents[2] / "examples" / "data")
    given = parser.parse_args()
    names = pc.unique(pq.read_table(given.results, columns=["engine"])["engine"]).to_pylist()
    count = 0
    for engine in sorted(given.engine or names):
        count += make(given.results, engine, given.each, given.seconds, given.drawings)
    print(f"{count} findings")
    return 0


if __name__ == "__main__":
    sys.exit(main())
