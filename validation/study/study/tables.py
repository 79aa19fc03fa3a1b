"""What the report counts, from the results alone. Ascending by names, so the same every time."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import pyarrow as pa
import pyarrow.compute as pc

from study.statistics import Share, holm, mcnemar
from study.words import LOUD, OUTCOMES, RIGHT, RINGS, SILENT, TRUTHS

_DRAWING = ("family", "size", "scale", "seed")
ENGINE = ("algorithm", "engine", "version", "configuration")
_NEAREST = -8  # decades of feature size to what vertices match within: below all doubles
_FAR_ABOVE = 3  # decades of feature size to that, beyond which all is one

Engine = tuple[str, str, str, str]


@dataclass(frozen=True)
class Table:
    """Rows of texts and numbers under names."""

    name: str
    title: str
    columns: tuple[str, ...]
    rows: list[tuple[Any, ...]]


class Study:
    """Results, and what is often asked of them. Names of tables and pictures begin with `prefix`,
    their titles with `subject`."""

    def __init__(self, all_results: pa.Table, prefix: str = "", subject: str = "") -> None:
        self.prefix = prefix
        self.subject = subject
        self.all = all_results
        own = pc.is_null(all_results["ratio"])
        self.results = results = all_results.filter(own)
        """Of engines with their own tolerances."""
        self.swept = all_results.filter(pc.invert(own))
        """Of the same drawings with tolerances of all sizes."""
        plain = pc.and_(pc.equal(results["order"], 0), pc.not_equal(results["group"], "ulp maps"))
        self.plain = results.filter(plain)
        """As drawn, without maps of neighbours: what shares are of."""
        self.engines = self._engines()

    def _engines(self) -> dict[Engine, dict[str, Any]]:
        told = ("title", "configuration_title", "tolerance_kind", "source")
        swept = self.swept.group_by([*ENGINE, *told]).aggregate([]).to_pylist()
        own = self.results.group_by([*ENGINE, *told, "tolerance"]).aggregate([]).to_pylist()
        keyed = {tuple(row[name] for name in ENGINE): row for row in (*swept, *own)}
        return {key: keyed[key] for key in sorted(keyed)}

    @property
    def truths(self) -> list[str]:
        present = set(pc.unique(self.all["truth"]).to_pylist())
        return [name for name in TRUTHS if name in present]

    @property
    def families(self) -> list[str]:
        """By group; the drawings of people together."""
        pairs = self.plain.group_by(["group", "family"]).aggregate([]).to_pylist()
        found = {(p["group"], family_title(p["group"], p["family"])) for p in pairs}
        return [family for _, family in sorted(found)]

    def of(self, engine: Engine) -> str:
        """What pictures call an engine."""
        e = self.engines[engine]
        return f"{e['title']} {engine[2]}: {e['configuration_title']}"

    def fair(self, truth: str) -> pa.Table:
        """Rows of drawings whose answer fits doubles: those that an engine can get right."""
        here = pc.and_(pc.equal(self.plain["truth"], truth), self.plain["fits_doubles"])
        return self.plain.filter(here)


def of_lines_and_rings(results: pa.Table) -> tuple[Study, Study]:
    """The two parts of a study: engines of line work, and engines of rings."""
    is_rings = pc.equal(results["group"], RINGS)
    rings = Study(results.filter(is_rings), "rings_", "Engines of rings: ")
    return Study(results.filter(pc.invert(is_rings))), rings


def family_title(group: str, family: str) -> str:
    return "drawings of people" if group == "drawings" else family


def counts(rows: pa.Table, by: Sequence[str]) -> dict[tuple[Any, ...], dict[str, int]]:
    """Numbers of outcomes by columns."""
    found: dict[tuple[Any, ...], dict[str, int]] = defaultdict(dict)
    grouped = rows.group_by([*by, "outcome"]).aggregate([("seed", "count")])
    for row in grouped.to_pylist():
        key = tuple(row[name] for name in by)
        found[key][row["outcome"]] = found[key].get(row["outcome"], 0) + row["seed_count"]
    return dict(found)


def share(numbers: dict[str, int], outcomes: Iterable[str]) -> Share:
    return Share(sum(numbers.get(o, 0) for o in outcomes), sum(numbers.values()))


def silent_by_family(study: Study, truth: str) -> dict[tuple[Engine, str], Share]:
    """Shares of silently wrong answers; keys are engines and families."""
    grouped: dict[tuple[Engine, str], dict[str, int]] = defaultdict(dict)
    rows = counts(study.fair(truth), (*ENGINE, "group", "family"))
    for key, numbers in rows.items():
        into = grouped[key[:4], family_title(*key[4:])]
        for outcome, n in numbers.items():
            into[outcome] = into.get(outcome, 0) + n
    return {key: share(grouped[key], SILENT) for key in sorted(grouped)}  # Arrow has no order


def family_table(study: Study, truth: str) -> Table:
    shares = silent_by_family(study, truth)
    rows = [
        (study.of(engine), family, s.k, s.n, *s.interval, str(s))
        for engine in study.engines
        for family in study.families
        if (s := shares.get((engine, family))) is not None
    ]
    columns = ("engine", "family", "silently wrong", "of", "low", "high", "share")
    return Table(f"silent_{truth}", f"Silently wrong, truth: {truth}", columns, rows)


def overview(study: Study) -> Table:
    """A row for each engine and truth."""
    by_truth = {t: counts(study.fair(t), ENGINE) for t in study.truths}
    rows = []
    for engine in study.engines:
        for truth in study.truths:
            numbers = by_truth[truth].get(engine)
            if numbers:
                shares = [share(numbers, o) for o in (RIGHT, SILENT, LOUD)]
                rows.append((study.of(engine), truth, shares[0].n, *map(str, shares)))
    columns = ("engine", "truth", "drawings", "right", "silently wrong", "says so")
    return Table("overview", "Engines and truths", columns, rows)


def outcome_table(study: Study, truth: str) -> Table:
    numbers = counts(study.fair(truth), ENGINE)
    rows = [
        (study.of(e), *(numbers[e].get(o, 0) for o in OUTCOMES))
        for e in study.engines
        if e in numbers
    ]
    return Table(f"outcomes_{truth}", f"Outcomes, truth: {truth}", ("engine", *OUTCOMES), rows)


def kind_table(study: Study) -> Table:
    """Of wrong answers over the doubles the gravest difference; also where none can be right."""
    rows = study.plain.filter(pc.equal(study.plain["truth"], "doubles"))
    rows = rows.filter(pc.is_in(rows["outcome"], pa.array(SILENT)))
    grouped = rows.group_by([*ENGINE, "fits_doubles", "outcome", "kind"])
    found = [
        (
            study.of(tuple(r[n] for n in ENGINE)),
            "yes" if r["fits_doubles"] else "no",
            r["outcome"],
            r["kind"],
            r["seed_count"],
            r["faces_wrong_sum"],
            r["area_sum"],
        )
        for r in grouped.aggregate(
            [("seed", "count"), ("faces_wrong", "sum"), ("area", "sum")]
        ).to_pylist()
    ]
    columns = ("engine", "fits doubles", "outcome", "kind", "drawings", "faces wrong", "area")
    return Table("kinds", "What is wrong, truth: doubles", columns, sorted(found))


def representable(study: Study) -> Table:
    """How many drawings have an answer that fits doubles, by family and truth."""
    rows = []
    drawings = study.plain.group_by(
        ["group", "family", *_DRAWING[1:], "truth", "fits_doubles"]
    ).aggregate([])
    numbers: dict[tuple[str, str], list[int]] = defaultdict(lambda: [0, 0])
    for r in drawings.filter(pc.not_equal(drawings["truth"], "contract")).to_pylist():
        into = numbers[family_title(r["group"], r["family"]), r["truth"]]
        into[0] += r["fits_doubles"]
        into[1] += 1
    for family in study.families:
        for truth in study.truths:
            if (family, truth) in numbers:
                rows.append((family, truth, *numbers[family, truth]))
    columns = ("family", "truth", "fit doubles", "of")
    return Table("representable", "Drawings whose answer fits doubles", columns, rows)


def differences(study: Study, truth: str = "doubles") -> Table:
    """Configurations of one engine against each other on the same drawings: McNemar's test of
    right answers, adjusted by Holm's rule over the table."""
    rows = study.fair(truth)
    right: dict[Engine, dict[tuple[Any, ...], bool]] = {}
    names = (*ENGINE, *_DRAWING, "outcome")
    for values in zip(*(rows[name].to_pylist() for name in names)):
        right.setdefault(values[:4], {})[values[4:8]] = values[8] in RIGHT
    found: list[tuple[str, str, int, int, int, float]] = []
    for a in right:
        for b in right:
            if a < b and a[0] == b[0]:
                both = [(right[a][d], right[b][d]) for d in right[a].keys() & right[b].keys()]
                first, second = sum(x > y for x, y in both), sum(x < y for x, y in both)
                p = mcnemar(first, second)
                found.append((study.of(a), study.of(b), len(both), first, second, p))
    adjusted = holm([row[-1] for row in found])
    full = sorted((*row, p) for row, p in zip(found, adjusted))
    columns = ("first", "second", "pairs", "only first right", "only second right", "p", "Holm p")
    return Table("differences", f"Configurations of one engine, truth: {truth}", columns, full)


def nearness(study: Study) -> Table:
    """Of engines without a tolerance, silently wrong answers by how near things are in a drawing:
    by decades of its feature size to the distance within which vertices match, which is 1e-9 of the
    longer side, or 64 units in the last place of the largest coordinate if that is more."""
    rows = study.fair("doubles")
    rows = rows.filter(
        pc.and_(pc.equal(rows["tolerance_kind"], "none"), pc.greater(rows["feature_size"], 0))
    )
    names = (*_DRAWING, *ENGINE, "feature_size", "compare_tolerance", "outcome")
    listed = list(zip(*(rows[name].to_pylist() for name in names)))
    within = {values[:4]: values[9] for values in listed if values[9]}  # none of loud failures
    numbers: dict[tuple[Engine, int], dict[str, int]] = defaultdict(lambda: defaultdict(int))
    for values in listed:
        if values[:4] in within:
            decade = math.floor(math.log10(values[8]) - math.log10(within[values[:4]]))
            decade = min(max(decade, _NEAREST), _FAR_ABOVE)
            numbers[values[4:8], decade][values[10]] += 1
    found = []
    for (engine, decade), of in sorted(numbers.items()):
        s = share(of, SILENT)
        found.append((study.of(engine), f"1e{decade}", s.k, s.n, str(s)))
    columns = ("engine", "feature size / matching distance from", "silently wrong", "of", "share")
    return Table("nearness", "How near things are, truth: doubles", columns, found)


def orders(study: Study) -> Table:
    """Whether the order of lines decides: drawings with more than one answer among their
    permutations, to the last digit, and with other numbers of cells or another outcome."""
    permuted = study.results.filter(pc.greater(study.results["order"], 0))
    units = {
        tuple(r.values())
        for r in permuted.select(_DRAWING).group_by(list(_DRAWING)).aggregate([]).to_pylist()
    }
    rows = study.results.filter(
        pc.and_(
            pc.equal(study.results["truth"], "doubles"),
            pc.is_in(study.results["family"], pc.unique(permuted["family"])),
        )
    )
    answers: dict[Engine, dict[tuple[Any, ...], list[tuple[Any, ...]]]] = {}
    names = (*ENGINE, *_DRAWING, "answer", "outcome", "vertices", "edges", "faces")
    for values in zip(*(rows[name].to_pylist() for name in names)):
        if values[4:8] in units:
            of = answers.setdefault(values[:4], {})
            of.setdefault(values[4:8], []).append(values[8:])
    found = []
    for e in study.engines:
        sets = [set(all_of) for all_of in answers.get(e, {}).values() if len(all_of) > 1]
        if sets:
            digits = Share(sum(len({a[0] for a in s}) > 1 for s in sets), len(sets))
            cells = Share(sum(len({a[1:] for a in s}) > 1 for s in sets), len(sets))
            found.append((study.of(e), len(sets), str(digits), str(cells)))
    columns = ("engine", "drawings", "answers with other digits", "with other cells or outcome")
    return Table("orders", "The order of lines decides", columns, found)


def times(study: Study) -> dict[Engine, dict[tuple[Any, ...], tuple[float, int]]]:
    """Of right answers: seconds, and the size n + K of the drawing (segments and vertices)."""
    rows = study.fair("doubles")
    rows = rows.filter(pc.and_(pc.is_valid(rows["seconds"]), pc.greater(rows["seconds"], 0)))
    rows = rows.filter(pc.is_in(rows["outcome"], pa.array(RIGHT)))
    found: dict[Engine, dict[tuple[Any, ...], tuple[float, int]]] = {e: {} for e in study.engines}
    names = (*ENGINE, *_DRAWING, "seconds", "segments", "exact_vertices")
    for values in zip(*(rows[name].to_pylist() for name in names)):
        found[values[:4]][values[4:8]] = (values[8], values[9] + values[10])
    return {e: of for e, of in found.items() if of}


def time_table(study: Study) -> Table:
    rows = []
    for e, of in times(study).items():
        each = sorted(1e6 * seconds / size for seconds, size in of.values())
        rows.append((study.of(e), len(each), each[len(each) // 2], each[-1 - len(each) // 20]))
    columns = ("engine", "right answers", "median us per n + K", "19 of 20 below")
    return Table("times", "Times of right answers", columns, rows)


def areas(study: Study) -> Table:
    """Of engines of rings the area by which an answer and the exact region differ, over what moving
    the boundary by the tolerance makes: tolerance times perimeter."""
    rows = study.fair("doubles")
    rows = rows.filter(pc.greater(rows["perimeter"], 0))
    names = (*ENGINE, "outcome", "area", "compare_tolerance", "perimeter")
    found: dict[Engine, dict[bool, list[float]]] = {}
    for *engine, outcome, area, tolerance, perimeter in zip(*(rows[n].to_pylist() for n in names)):
        if outcome not in LOUD and tolerance:
            into = found.setdefault(tuple(engine), {True: [], False: []})
            into[outcome in RIGHT].append(area / (tolerance * perimeter))
    table = []
    for e in study.engines:
        of = found.get(e)
        if of:
            cells = [_middle_and_largest(of[is_right]) for is_right in (True, False)]
            table.append((study.of(e), *cells[0], *cells[1]))
    columns = ("engine", "right", "median", "largest", "silently wrong", "median", "largest")
    title = "Area of the difference over tolerance times perimeter"
    return Table("areas", title, columns, table)


def _middle_and_largest(values: list[float]) -> tuple[int, float | str, float | str]:
    ordered = sorted(values)
    if not ordered:
        return 0, "-", "-"
    return len(ordered), ordered[len(ordered) // 2], ordered[-1]
