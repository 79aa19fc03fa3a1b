"""Blocks of rings done: as `study.work`, for engines that take rings."""

from __future__ import annotations

import time
from dataclasses import asdict
from functools import cached_property

import plumbline

from study.engines import Configuration, NotHere, Reply
from study.nearness import Nearness
from study.outcomes import Judgement, tolerance_within
from study.region_outcomes import judge_contract, judge_region
from study.regions import Region, region_of
from study.results import Row
from study.ring_families import RingCase, RingFamily, ring_case_of
from study.schedule import RingBlock
from study.truths import COARSE, Disagreement, fits_doubles, least_feature
from study.words import RINGS
from study.work import Worker, row_of, signature


class RingTruth:
    """The exact side of a case of rings."""

    def __init__(self, case: RingCase) -> None:
        self._case = case
        self.region: Region = region_of(case.rings, case.rule)

    @cached_property
    def fits_doubles(self) -> bool:
        """See `study.truths.fits_doubles`; of the boundary."""
        boundary = self.region.boundary_arrangement
        return boundary is None or fits_doubles(boundary)

    @cached_property
    def feature_size(self) -> float | None:
        """Of the boundary."""
        boundary = self.region.boundary_arrangement
        return None if boundary is None else least_feature(boundary, Nearness(boundary))

    def ensure_both_engines(self) -> None:
        """Throws: Disagreement."""
        of = self.region.arrangement
        if of is None:
            return
        other = plumbline.arrange(of.lines, exact_engine="cgal", threads=1)
        if other.signature != of.signature:
            raise Disagreement(f"{self._case.unit}: {of!r}, {other!r}")

    def judgements(self, of: Configuration, reply: Reply) -> dict[str, Judgement]:
        """By names of truths: the doubles, and the contract of a grid that doubles tell well."""
        case = self._case
        largest = case.largest_coordinate
        tolerance = _absolute_tolerance(of, case)
        within = tolerance_within(tolerance, case.longer_side, largest)
        found = {"doubles": judge_region(reply, self.region, within, largest)}
        if of.tolerance_kind == "grid" and tolerance >= COARSE * largest:
            found["contract"] = judge_contract(reply, self.region, case.rings, of)
        return found


def _absolute_tolerance(of: Configuration, case: RingCase) -> float:
    is_relative = of.tolerance_kind == "relative"
    return of.tolerance * case.longer_side if is_relative else of.tolerance


class RingWorker(Worker):
    """Has a running adapter for each engine of rings. A context manager."""

    def rows_of_rings(self, block: RingBlock) -> list[Row]:
        """Of the units that are not done, and the engines that take such rings."""
        result: list[Row] = []
        late: dict[tuple[str, str, str], int] = {}
        fit = [e for e in self._engines if block.family.takes in e.configuration.takes]
        for unit in block.units:
            missing = [e for e in fit if self._is_wanted(e.configuration, None, RINGS, unit, late)]
            if not missing or time.monotonic() > self._bounds.until:
                continue
            case = ring_case_of(block.family, unit)
            if not case.rings:
                continue
            truth = RingTruth(case)
            both = self._is_compared(unit)
            if both:
                truth.ensure_both_engines()
            drawing = _drawing(block.family, case, truth, both)
            for engine in missing:
                of = engine.configuration
                start = time.monotonic()
                if start > self._bounds.until:
                    break
                try:
                    reply = self._adapters[of.key].ask_rings(case.rings, case.rule)
                except NotHere:
                    self._gone.add(of.key)
                    continue
                self._note(of.key, time.monotonic() - start, reply, late)
                for name, found in truth.judgements(of, reply).items():
                    answered = {"truth": name, "answer": signature(reply), "seconds": reply.seconds}
                    result.append({**drawing, **row_of(of, found), **answered})
        return result


def _drawing(family: RingFamily, case: RingCase, truth: RingTruth, both: bool) -> Row:
    boundary = truth.region.boundary
    return {
        "group": RINGS,
        **asdict(case.unit),
        "segments": sum(map(len, case.rings)),
        "feature_size": truth.feature_size,
        "perimeter": truth.region.perimeter,
        "fits_doubles": truth.fits_doubles,
        "both_engines": both,
        "exact_vertices": len(boundary.places),
        "exact_edges": len(boundary.edges),
        "exact_faces": truth.region.parts_and_holes[0],
    }
