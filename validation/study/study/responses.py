"""Right answers by the ratio of a tolerance to the least feature that was meant, from the rows of
the sweep of tolerances."""

from __future__ import annotations

from collections import defaultdict
from typing import Any

import pyarrow.compute as pc

from study.statistics import Share
from study.tables import ENGINE, Engine, Study, Table
from study.words import LOUD, RIGHT, SILENT

_GROUPS = {
    "plan": "plans as drawn",
    "plan, turned": "plans, turned",
    "plan with doors, turned": "plans, turned",
    "plan, turned, 3 decimals": "plans, turned,\n3 decimals",
    "tees on a slant": "ends on lines",
    "T-junctions": "ends on lines",
    "T-junctions on slants": "ends on lines",
    "near-concurrent fans": "fans",
}
_REFUSED = "BadTolerance"  # the adapter's word for a tolerance that an engine cannot have

Counts = dict[str, int]
Response = dict[float, Counts]
"""Numbers of outcomes by ratio."""


class Responses:
    """Of one truth. Drawings that no answer in doubles fits are left out, and tolerances that an
    engine cannot have."""

    def __init__(self, study: Study, truth: str) -> None:
        rows = study.swept
        here = pc.and_(pc.equal(rows["truth"], truth), rows["fits_doubles"])
        rows = rows.filter(pc.and_(here, pc.not_equal(rows["kind"], _REFUSED)))
        told = ("title", "configuration_title", "tolerance_kind")
        names = (*ENGINE, *told, "family", "ratio", "outcome")
        found = rows.group_by(list(names)).aggregate([("seed", "count")]).to_pylist()
        self.titles: dict[Engine, str] = {}
        self.kinds: dict[Engine, str] = {}
        self._of_family: dict[tuple[str, Engine], Response] = defaultdict(dict)
        self._of_group: dict[tuple[str, Engine], Response] = defaultdict(dict)
        for row in sorted(found, key=lambda row: tuple(row[name] for name in names)):
            engine: Engine = tuple(row[name] for name in ENGINE)
            self.titles[engine] = f"{row['title']} {engine[2]}: {row['configuration_title']}"
            self.kinds[engine] = row["tolerance_kind"]
            family = row["family"]
            group = _GROUPS.get(family, family)
            for response in (self._of_family[family, engine], self._of_group[group, engine]):
                counts = response.setdefault(row["ratio"], {})
                counts[row["outcome"]] = counts.get(row["outcome"], 0) + row["seed_count"]

    @property
    def families(self) -> list[str]:
        return sorted({family for family, _ in self._of_family})

    @property
    def groups(self) -> list[str]:
        """Families that have the same to tell."""
        present = {group for group, _ in self._of_group}
        known = list(dict.fromkeys(_GROUPS.values()))
        return [g for g in known if g in present] + sorted(present - set(known))

    @property
    def engines(self) -> list[Engine]:
        """Grids first."""
        return sorted(self.titles, key=lambda e: (self.kinds[e], e))

    def of_family(self, family: str, engine: Engine) -> Response:
        """By ascending ratio."""
        return dict(sorted(self._of_family.get((family, engine), {}).items()))

    def of_group(self, group: str, engine: Engine) -> Response:
        """By ascending ratio."""
        return dict(sorted(self._of_group.get((group, engine), {}).items()))


def share(counts: Counts, outcomes: tuple[str, ...]) -> Share:
    return Share(sum(counts.get(o, 0) for o in outcomes), sum(counts.values()))


def table(study: Study, truth: str) -> Table:
    found = Responses(study, truth)
    rows: list[tuple[Any, ...]] = []
    for family in found.families:
        for engine in found.engines:
            for ratio, counts in found.of_family(family, engine).items():
                right, *others = (share(counts, o) for o in (RIGHT, SILENT, LOUD))
                numbers = (right.n, right.k, *(s.k for s in others), *right.interval)
                named = (family, found.kinds[engine], found.titles[engine], f"{ratio:g}")
                rows.append((*named, *numbers))
    columns = (
        *("family", "kind", "engine", "tolerance / feature size", "drawings"),
        *("right", "silently wrong", "says so", "right from", "to"),
    )
    return Table(f"tolerance_{truth}", f"Tolerance response, truth: {truth}", columns, rows)
