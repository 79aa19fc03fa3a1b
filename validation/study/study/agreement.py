"""Whether a run on other seeds says the same."""

from __future__ import annotations

from typing import Any

from study.statistics import Share
from study.tables import Study, Table, silent_by_family


def agreement(first: Study, second: Study) -> Table:
    """Of cells that both runs have, an engine on a family held against a truth: in how many the
    share of silently wrong answers of one run lies within the other's interval, and the intervals
    overlap."""
    rows: list[tuple[Any, ...]] = []
    for truth in first.truths:
        there, here = (silent_by_family(study, truth) for study in (first, second))
        pairs = [(there[cell], here[cell]) for cell in there.keys() & here.keys()]
        within = sum(_is_within(b, a) for a, b in pairs), sum(_is_within(a, b) for a, b in pairs)
        rows.append((truth, len(pairs), *within, sum(_do_overlap(a, b) for a, b in pairs)))
    _, *numbers = zip(*rows) if rows else [()] * 5
    total = ("all", *map(sum, numbers))
    columns = (
        *("truth", "cells", "second share within first's interval"),
        *("first share within second's interval", "intervals overlap"),
    )
    return Table("agreement", "The same on other seeds", columns, [*rows, total])


def _is_within(share: Share, other: Share) -> bool:
    low, high = other.interval
    return low <= share.value <= high


def _do_overlap(a: Share, b: Share) -> bool:
    return max(a.interval[0], b.interval[0]) <= min(a.interval[1], b.interval[1])
