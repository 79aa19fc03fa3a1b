"""Tables and a picture of the study of repair tools, from its results alone: the same bytes from
the same results."""

from __future__ import annotations

import csv
import io
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import pyarrow as pa
from matplotlib import pyplot
from matplotlib.figure import Figure
from study.pictures import svg
from study.statistics import Share

from repairing.plans import DAMAGES, LAR, NOTHING, OURS, RATIOS
from repairing.rooms import OUTCOMES

_COLOURS = ("#737373", "#67000d", "#ef6548", "#fdbb84", "#c6dbef", "#3182bd")
_COLUMNS = (
    *("tool", "damage", "size", "plans", "right", "right from", "to"),
    *OUTCOMES[:-1],
    *("harmed", "harmed without a word", "moved further"),
)

_INTRODUCTION = """# Tools that repair drawings, on plans that were damaged in known ways

Made by `validation/study/repairs`. Plans and damages are those of `validation/repair/run`: floor
plans in metres with known rooms; one wall to half of the walls damaged, each by less than *size*
times the plan's least detail. Each tool is given the damaged plan in doubles and a tolerance just
above the damage; `plumbline repair` gets it in exact numbers, and the same tolerance for each of
its operations. Tools that are slow have fewer plans. Doors are left out: they have another width
than damages have.

A plan is *right* where each room is alone in a face, with its area but for a border moved by the
tolerance, and there is no other face. Else it counts under the first of: the tool *failed* and
said so; *rooms lost*, open to the outside; *rooms merged*; *faces invented*; *rooms reshaped*. All
results are judged alike, noded on a grid of 1e-8, whatever made them. *Harmed*: plans with a room
that was there before the repair, and is not after it; *without a word*: nothing says so, as with
all tools but ours, which lists refusals and changed faces. *Moved further*: plans with a vertex
that is further than the tolerance from all that was drawn. *Nothing* is the damaged plan as it is.
Shares have Wilson's 95 % intervals.
"""


@dataclass(frozen=True)
class Cell:
    """Plans of one damage and size, by one tool."""

    outcomes: dict[str, int]
    harmed: int
    unsaid: int
    moved: int

    @property
    def plans(self) -> int:
        return sum(self.outcomes.values())

    @property
    def right(self) -> Share:
        return Share(self.outcomes.get(OUTCOMES[-1], 0), self.plans)


def cell(rows: Sequence[dict[str, Any]]) -> Cell:
    return Cell(
        {o: n for o in OUTCOMES if (n := sum(r["outcome"] == o for r in rows))},
        sum(r["harmed"] > 0 for r in rows),
        sum(r["is_harm_unsaid"] for r in rows),
        sum((r["moved_far"] or 0) > 0 for r in rows),
    )


class Results:
    def __init__(self, table: pa.Table) -> None:
        self._rows: dict[tuple[str, str, str], list[dict[str, Any]]] = defaultdict(list)
        for row in table.to_pylist():
            self._rows[row["tool"], row["damage"], row["ratio"]].append(row)
        present = {tool for tool, _, _ in self._rows}
        ours = [name for name in (OURS, LAR, NOTHING) if name in present]
        self.tools = [*ours[:1], *sorted(present - set(ours)), *ours[1:]]

    def of(self, tool: str, damages: Sequence[str], ratio: str) -> Cell:
        return cell([row for d in damages for row in self._rows.get((tool, d, ratio), ())])


def files(table: pa.Table) -> dict[str, str]:
    """Contents by names."""
    results = Results(table)
    figure = picture(results)
    drawn = svg(figure)
    pyplot.close(figure)
    return {
        "repairs.csv": _csv(results),
        "repairs.md": _markdown(results),
        "repairs.svg": drawn,
    }


def _csv(results: Results) -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(_COLUMNS)
    for tool in results.tools:
        for damage in DAMAGES:
            for ratio in RATIOS:
                of = results.of(tool, [damage], ratio)
                if not of.plans:
                    continue
                low, high = of.right.interval
                counts = [of.outcomes.get(o, 0) for o in OUTCOMES[:-1]]
                right = (of.plans, of.right.k, f"{low:.4f}", f"{high:.4f}")
                writer.writerow(
                    [tool, damage, ratio, *right, *counts, of.harmed, of.unsaid, of.moved]
                )
    return text.getvalue()


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(row)} |" for row in lines)


def _markdown(results: Results) -> str:
    parts = [_INTRODUCTION]
    for ratio in RATIOS:
        rows = []
        for tool in results.tools:
            all_of = results.of(tool, DAMAGES, ratio)
            if not all_of.plans:
                continue
            by_damage = [results.of(tool, [d], ratio).right for d in DAMAGES]
            shares = [f"{100 * s.value:.0f}" if s.n else "-" for s in by_damage]
            plans = [str(all_of.plans), str(all_of.right)]
            others = [str(n) for n in (all_of.harmed, all_of.unsaid, all_of.moved)]
            rows.append([tool, *plans, *shares, *others])
        head = ["tool", "plans", "right", *DAMAGES, *_COLUMNS[-3:]]
        parts.append(
            f"## Size {ratio}\n\nPer cent of plans right by damage.\n\n{_table(head, rows)}\n"
        )
    parts.append("Numbers by tool, damage and size: [repairs.csv](repairs.csv).\n")
    parts.append("![Outcomes by tool, damage and size](repairs.svg)\n")
    return "\n".join(parts)


def picture(results: Results) -> Figure:
    """Outcomes as stacked bars, a bar for each tool; a row of plots for each damage, a column for
    each size."""
    tools = results.tools
    figure, grid = pyplot.subplots(
        len(DAMAGES), len(RATIOS), figsize=(13, 1 + 0.19 * len(DAMAGES) * (len(tools) + 2)),
        sharex=True, sharey=True, squeeze=False,
    )  # fmt: skip
    for line, damage in zip(grid, DAMAGES):
        for axes, ratio in zip(line, RATIOS):
            cells = [results.of(tool, [damage], ratio) for tool in tools]
            left = np.zeros(len(tools))
            for outcome, colour in reversed(list(zip(OUTCOMES, _COLOURS))):
                widths = np.array([c.outcomes.get(outcome, 0) / max(1, c.plans) for c in cells])
                axes.barh(range(len(tools)), widths, left=left, color=colour, label=outcome)
                left += widths
            for k, c in enumerate(cells):
                if c.plans:
                    low, high = c.right.interval
                    axes.plot([low, high], [k, k], color="black", linewidth=1)
                if c.harmed:
                    axes.text(1.01, k, f"{c.harmed}", fontsize=6, va="center")
            axes.set_title(f"{damage}, size {ratio}", fontsize=8, loc="left")
            axes.tick_params(labelsize=7)
    grid[0, 0].set_yticks(range(len(tools)), tools)
    grid[0, 0].invert_yaxis()
    grid[0, 0].set_xlim(0, 1)
    handles, labels = grid[0, 0].get_legend_handles_labels()
    figure.tight_layout(rect=(0, 0.03, 1, 0.97))
    figure.legend(handles, labels, loc="lower center", ncols=len(OUTCOMES), frameon=False)
    figure.suptitle(
        "What became of damaged plans; line: Wilson's interval of right ones; at the end: plans "
        "in which a room came to harm",
        fontsize=10,
    )
    return figure
