"""Runs the study of repair tools, or reports one: see validation/study/repairs."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq

from repairing import report
from repairing.plans import NOTHING, OURS, Plan, plans
from repairing.rooms import OUTCOMES, Found, found, moved_far
from repairing.tools import Tools

SCHEMA = pa.schema(
    [
        ("tool", pa.string()),
        ("damage", pa.string()),
        ("ratio", pa.string()),
        ("seed", pa.int64()),
        ("size", pa.float64()),
        ("rooms", pa.int64()),
        ("outcome", pa.string()),
        ("lost", pa.int64()),
        ("merged", pa.int64()),
        ("invented", pa.int64()),
        ("reshaped", pa.int64()),
        ("harmed", pa.int64()),  # rooms that were there, and are not
        ("is_harm_unsaid", pa.bool_()),
        ("moved_far", pa.int64()),
        ("message", pa.string()),
    ]
)
_TOLD = 100  # plans, after which progress is told


def rows_of(plan: Plan, tools: Tools) -> list[dict[str, object]]:
    """A row for each tool. A room that was there before, and is not now, came to harm; no tool
    but ours says of any."""
    before = found(plan.lines, plan.rooms, plan.size)
    rows: list[dict[str, object]] = []
    for tool, result in tools.results(plan).items():
        row: dict[str, object] = {
            "tool": tool,
            "damage": plan.damage,
            "ratio": plan.ratio,
            "seed": plan.seed,
            "size": plan.size,
            "rooms": len(plan.rooms),
            "message": result.message,
        }
        if result.lines is None:
            rows.append(row | {"outcome": OUTCOMES[0], "harmed": 0, "is_harm_unsaid": False})
            continue
        after = before if tool == NOTHING else found(result.lines, plan.rooms, plan.size)
        harmed = len(before.there - after.there)
        rows.append(
            row
            | _counts(after)
            | {
                "harmed": harmed,
                "is_harm_unsaid": plan.is_harm_unsaid if tool == OURS else harmed > 0,
                "moved_far": moved_far(result.lines, plan.lines, plan.size),
            }
        )
    return rows


def _counts(of: Found) -> dict[str, object]:
    return {
        "outcome": of.outcome,
        "lost": of.lost,
        "merged": of.merged,
        "invented": of.invented,
        "reshaped": of.reshaped,
    }


def main() -> int:
    parser = argparse.ArgumentParser(prog="validation/study/repairs")
    how_much = parser.add_mutually_exclusive_group(required=True)
    how_much.add_argument("--quick", action="store_true")
    how_much.add_argument("--full", action="store_true")
    how_much.add_argument("--report", action="store_true", help="of results that are there")
    parser.add_argument("--plans", type=int, help="of each damage and size")
    parser.add_argument("--slow-plans", type=int, help="of tools that take 0.3 s a plan")
    parser.add_argument("--seed", type=int, default=1, help="the first one")
    parser.add_argument("--results", type=Path, required=True)
    parser.add_argument("--folder", type=Path, required=True, help="of the report")
    given = parser.parse_args()
    if not given.report:
        count = given.plans or (100 if given.full else 2)
        slow = given.slow_plans or (20 if given.full else 1)
        rows: list[dict[str, object]] = []
        with Tools(slow, given.seed) as tools:
            for done, plan in enumerate(plans(count, given.seed), 1):
                rows += rows_of(plan, tools)
                if done % _TOLD == 0:
                    print(f"{done} plans", file=sys.stderr)
        table = pa.Table.from_pylist(rows, schema=SCHEMA)
        given.results.parent.mkdir(parents=True, exist_ok=True)
        pq.write_table(table, given.results, compression="zstd")
        print(f"{len(table)} rows in {given.results}")
    given.folder.mkdir(parents=True, exist_ok=True)
    for name, text in report.files(pq.read_table(given.results, schema=SCHEMA)).items():
        (given.folder / name).write_text(text, encoding="utf-8")
    print(f"written: {given.folder / 'repairs.md'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
