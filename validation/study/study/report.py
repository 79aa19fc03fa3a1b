"""The report, from the file of results alone: Markdown, CSV, SVG and one page of HTML. The same
bytes from the same results: see validation/study/report."""

from __future__ import annotations

import argparse
import csv
import hashlib
import html
import io
import sys
from dataclasses import replace
from pathlib import Path

from study import responses, results, tables
from study.agreement import agreement
from study.pictures import pictures
from study.summary import in_page, summary
from study.tables import Study, Table

_STYLE = """body { font: 15px/1.5 sans-serif; max-width: 75rem; margin: 2rem auto; padding: 0 1rem }
table { border-collapse: collapse; font-size: 13px; margin: 1rem 0 }
th, td { padding: 2px 8px; border-bottom: 1px solid #ddd; text-align: left }
figure { margin: 1rem 0; overflow-x: auto } details { margin: 1rem 0 }"""

_PICTURES = {
    "silent": "Share of drawings on which an engine is wrong and does not say so, in per cent. A "
    "dot: none of more than 300. Drawings whose answer does not fit doubles are left out.",
    "outcomes": "What became of all drawings.",
    "tolerance": "Right and silently wrong answers of engines whose tolerance can be chosen, by "
    "its ratio to the least feature that was meant; bands are Wilson's intervals of right ones.",
    "loud": "Failures that are told against those that are not; versions of one engine are joined.",
    "times": "Left: performance profile over drawings that any engine got right. Right: time per "
    "segment and vertex.",
    "ulp": "Each place of a tile is a drawing in which one end point is another neighbouring "
    "double, held against the arrangement of these doubles.",
}


def all_tables(study: Study) -> list[Table]:
    found = [tables.overview(study), tables.representable(study)]
    for truth in study.truths:
        found += [
            tables.family_table(study, truth),
            tables.outcome_table(study, truth),
            responses.table(study, truth),
        ]
    found += [
        tables.kind_table(study),
        tables.nearness(study),
        tables.differences(study),
        tables.orders(study),
        tables.areas(study),
        tables.time_table(study),
    ]
    return [
        replace(t, name=f"{study.prefix}{t.name}", title=f"{study.subject}{t.title}")
        for t in found
        if t.rows
    ]


def files(study: Study, again: Study | None = None) -> dict[str, str]:
    """Contents by names; of engines of lines also what a run `again`, on other seeds, says."""
    parts = tables.of_lines_and_rings(study.all)
    made = [table for part in parts for table in all_tables(part)]
    if again:
        made.append(agreement(parts[0], tables.of_lines_and_rings(again.all)[0]))
    drawn = {name: svg for part in parts for name, svg in pictures(part).items()}
    found = {f"{table.name}.csv": _csv(table) for table in made}
    found |= {f"{name}.svg": text for name, text in drawn.items()}
    found["summary.md"] = f"{_summary(study)}\n\n{summary(parts[0])}"
    found["study.md"] = _markdown(study, made, drawn)
    found["index.html"] = _html(study, made, drawn)
    return found


def _summary(study: Study) -> str:
    units = study.all.group_by(list(results.DRAWING)).aggregate([])
    algorithms = {engine[0] for engine in study.engines}
    both = study.all.filter(study.all["both_engines"])
    drawings = both.group_by(list(results.DRAWING)).aggregate([])
    return (
        f"{len(study.engines)} configurations of {len(algorithms)} independent engines on "
        f"{len(units)} drawings: {len(study.all)} answers judged. Of {len(drawings)} drawings "
        "the exact side was computed by both exact engines, with the same result."
    )


def _cell(value: object) -> str:
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def _csv(table: Table) -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(table.columns)
    writer.writerows([[_cell(v) for v in row] for row in table.rows])
    return text.getvalue()


def _engines_markdown(study: Study) -> str:
    rows = [
        f"| {study.of(e)} | {e[0]} | {_tolerance(of)} | {of['source']} |"
        for e, of in study.engines.items()
    ]
    head = "| engine | algorithm | tolerance | its setting is that of |\n| --- | --- | --- | --- |"
    return "\n".join([head, *rows])


def _tolerance(of: dict[str, object]) -> str:
    kind = of["tolerance_kind"]
    if kind == "none":
        return "none"
    return f"{kind} {of['tolerance']:g}" if "tolerance" in of else f"{kind}, of all sizes"


_LONG = (
    "silent_",
    "tolerance_",
    "representable",
    "kinds",
    "nearness",
)  # in Markdown as links alone


def _markdown(study: Study, made: list[Table], drawn: dict[str, str]) -> str:
    parts = ["# Engines against exact arrangements", _summary(study), _engines_markdown(study)]
    for table in made:
        link = f"[{table.name}.csv]({table.name}.csv)"
        if table.name.removeprefix("rings_").startswith(_LONG):
            parts.append(f"## {table.title}\n\n{len(table.rows)} rows: {link}")
            continue
        lines = [
            f"| {' | '.join(table.columns)} |",
            f"| {' | '.join('---' for _ in table.columns)} |",
            *(f"| {' | '.join(_cell(v) for v in row)} |" for row in table.rows),
        ]
        parts.append(f"## {table.title}\n\n{link}\n\n" + "\n".join(lines))
    parts += [f"![{name}]({name}.svg)" for name in drawn]
    return "\n\n".join(parts) + "\n"


def _html(study: Study, made: list[Table], drawn: dict[str, str]) -> str:
    parts = [
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">',
        f"<title>Engines against exact arrangements</title><style>{_STYLE}</style></head><body>",
        f"<h1>Engines against exact arrangements</h1><p>{html.escape(_summary(study))}</p>",
    ]
    for name, svg in drawn.items():
        text = html.escape(_PICTURES[name.removeprefix("rings_").split("_")[0]])
        inline = svg[svg.index("<svg") :]
        # Names of clip paths and glyphs are the same in all pictures of one page.
        prefixed = inline.replace('id="', f'id="{name}-').replace("url(#", f"url(#{name}-")
        prefixed = prefixed.replace('href="#', f'href="#{name}-')
        parts.append(f"<figure>{prefixed}<figcaption>{text}</figcaption></figure>")
    for table in made:
        head = "".join(f"<th>{html.escape(c)}</th>" for c in table.columns)
        body = "".join(
            "<tr>" + "".join(f"<td>{html.escape(_cell(v))}</td>" for v in row) + "</tr>\n"
            for row in table.rows
        )
        title = html.escape(table.title)
        parts.append(
            f"<details><summary>{title}: {len(table.rows)} rows</summary>"
            f"<table><tr>{head}</tr>\n{body}</table></details>"
        )
    return "\n".join([*parts, "</body></html>"]) + "\n"


def main() -> int:
    parser = argparse.ArgumentParser(prog="validation/study/report")
    parser.add_argument("results", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--page", type=Path, help="where the summary is put between its marks")
    parser.add_argument("--again", type=Path, help="results of the same on other seeds")
    given = parser.parse_args()
    table = results.gather(given.results)
    if not len(table):
        print(f"no results in {given.results}", file=sys.stderr)
        return 2
    given.folder.mkdir(parents=True, exist_ok=True)
    found = files(Study(table), Study(results.gather(given.again)) if given.again else None)
    digest = hashlib.sha256(given.results.read_bytes()).hexdigest()
    found["summary.md"] += f"\nThe file of results has the SHA-256 {digest}.\n"
    for name, text in found.items():
        (given.folder / name).write_text(text, encoding="utf-8")
    if given.page:
        try:
            page = in_page(given.page.read_text(encoding="utf-8"), found["summary.md"])
        except ValueError as error:
            print(f"{given.page}: {error}", file=sys.stderr)
            return 2
        given.page.write_text(page, encoding="utf-8")
    print(f"written: {given.folder / 'index.html'}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
