"""Puts the toy drawings to every adapter; holds the numbers of bounded faces against recorded.json.

Prints a Markdown table, and what differs from the study's first table, with the reasons that
explained.json has. Fails where a row is not the recorded one, or where a difference has no reason.
"""

from __future__ import annotations

import argparse
import json
import platform
import sys
from pathlib import Path
from typing import Any

from adapters import Answer, Listed, Stopped, engines, running
from drawings import Drawing, drawings

HERE = Path(__file__).resolve().parent
RECORDED = HERE / "recorded.json"
EXPLAINED = HERE / "explained.json"
SECONDS = 60.0
"""For one drawing, the slowest engine's start included."""

Row = list[Any]
"""What an engine says of each drawing: a number of faces, or a word for what came instead."""


def bounded_faces(model: dict[str, Any]) -> int:
    """As many as the engine says, or, where it says edges alone, as Euler's formula has it."""
    for faces in ("polygons", "FV"):
        if faces in model:
            return len(model[faces])
    return len(model["EV"]) - len(model["V"]) + _components(len(model["V"]), model["EV"])


def _components(count: int, edges: list[list[int]]) -> int:
    root = list(range(count))

    def find(v: int) -> int:
        while root[v] != v:
            root[v] = root[root[v]]
            v = root[v]
        return v

    for a, b in edges:
        root[find(a)] = find(b)
    return sum(find(v) == v for v in range(count))


def word_of(answer: Answer) -> Any:
    if "error" in answer:
        return f"error: {answer['error']['class']}"
    return bounded_faces(answer["model"])


def row_of(engine: str, configuration: str, toys: list[Drawing]) -> Row:
    """An adapter for all drawings; after a crash or a timeout another one for the rest."""
    row: Row = []
    while len(row) < len(toys):
        try:
            with running(engine, configuration) as adapter:
                for case, toy in enumerate(toys[len(row) :], start=len(row)):
                    row.append(word_of(adapter.ask(case, toy.segments, SECONDS)))
        except Stopped as stopped:
            row.append(str(stopped))
    return row


def rows_of(found: list[Listed], toys: list[Drawing]) -> dict[str, dict[str, Any]]:
    """By engine and configuration, with versions."""
    rows: dict[str, dict[str, Any]] = {}
    for engine in found:
        for configuration in engine.configurations:
            assert engine.listed is not None
            print(f"{engine.name} {configuration}", file=sys.stderr)
            rows[f"{engine.name} {configuration}"] = {
                "version": engine.listed["version"],
                "faces": row_of(engine.name, configuration, toys),
            }
    return rows


def table(rows: dict[str, dict[str, Any]], toys: list[Drawing]) -> list[str]:
    names = [toy.name for toy in toys]
    lines = [f"| engine, configuration | version | {' | '.join(names)} |"]
    lines.append("| --- " * (len(names) + 2) + "|")
    lines.append(f"| **intended** | | {' | '.join(str(t.intended) for t in toys)} |")
    lines.append(f"| **over the doubles** | | {' | '.join(str(t.over_doubles) for t in toys)} |")
    for name, row in rows.items():
        lines.append(f"| {name} | {row['version']} | {' | '.join(map(str, row['faces']))} |")
    return lines


def explanations(rows: dict[str, dict[str, Any]], toys: list[Drawing]) -> list[str]:
    """What differs from the study's first table."""
    first: dict[str, dict[str, Any]] = json.loads(EXPLAINED.read_text())
    lines = ["| engine, configuration | drawing | first table | here | why |", "| --- " * 5 + "|"]
    for name, row in rows.items():
        for toy, here in zip(toys, row["faces"]):
            before = first.get(name, {}).get("first", {}).get(toy.name)
            if before not in (None, here, str(here).partition(":")[0]):
                why = first[name].get("why", {}).get(toy.name, "**unexplained**")
                lines.append(f"| {name} | {toy.name} | {before} | {here} | {why} |")
    return lines


def changes(rows: dict[str, dict[str, Any]], toys: list[Drawing]) -> list[str]:
    """What differs from the recorded rows, of the same versions."""
    recorded = json.loads(RECORDED.read_text())["rows"] if RECORDED.exists() else {}
    lines: list[str] = []
    for name, row in rows.items():
        before = recorded.get(name)
        if before is None:
            lines.append(f"- {name}: not recorded")
        elif before["version"] != row["version"]:
            lines.append(f"- {name}: recorded of {before['version']}, this is {row['version']}")
        else:
            for toy, then, now in zip(toys, before["faces"], row["faces"]):
                if then != now:
                    lines.append(f"- {name}, {toy.name}: recorded {then}, now {now}")
    return lines


def record(rows: dict[str, dict[str, Any]], toys: list[Drawing]) -> None:
    """Rows of engines that are not here now stay as they were."""
    before = json.loads(RECORDED.read_text())["rows"] if RECORDED.exists() else {}
    content = {
        "drawings": [toy.name for toy in toys],
        "machine": platform.machine(),
        "rows": dict(sorted({**before, **rows}.items())),
    }
    RECORDED.write_text(json.dumps(content, indent=1) + "\n")


def main() -> int:
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--engine", help="this one alone")
    arguments.add_argument("--record", action="store_true", help="write recorded.json")
    options = arguments.parse_args()
    toys = drawings()
    found = [e for e in engines() if options.engine in (None, e.name) and not e.takes_rings]
    rows = rows_of(found, toys)
    print("\n".join(["## Bounded faces", "", *table(rows, toys)]))
    for engine in found:
        if engine.listed is None:
            print(f"\nNot here: {engine.name}: {engine.reason}")
    different = explanations(rows, toys)
    print("\n".join(["", "## What differs from the first table", "", *different]))
    changed = changes(rows, toys)
    if options.record:
        record(rows, toys)
        changed = []
    print("\n".join(["", "## What differs from the recorded rows", "", *(changed or ["Nothing."])]))
    return 1 if changed or any("**unexplained**" in line for line in different) else 0


if __name__ == "__main__":
    sys.exit(main())
