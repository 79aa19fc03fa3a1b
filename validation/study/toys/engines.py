"""Prints a table of engines, versions and configurations."""

from __future__ import annotations

import json
import sys

from adapters import Listed, engines


def table(found: list[Listed]) -> str:
    rows = ["| engine | version | licence | configurations |", "| --- | --- | --- | --- |"]
    for engine in found:
        if engine.listed is None:
            rows.append(f"| {engine.name} | not here | | {engine.reason} |")
            continue
        of = engine.listed
        named = ", ".join(f"`{name}`" for name in engine.configurations)
        rows.append(
            f"| {of['title']} (`{engine.name}`) | {of['version']} | {of['licence']} | {named} |"
        )
    here = [engine.listed for engine in found if engine.listed]
    algorithms = {of["algorithm"] for of in here}
    count = sum(len(of["configurations"]) for of in here)
    rows += [
        "",
        f"{len(here)} of {len(found)} engines are here: {len(algorithms)} independent ones, "
        f"{count} configurations.",
    ]
    return "\n".join(rows)


if __name__ == "__main__":
    found = engines()
    if sys.argv[1:] == ["--json"]:
        print(json.dumps([e.listed or {"engine": e.name, "not_here": e.reason} for e in found]))
    else:
        print(table(found))
