"""Blocks of units done: drawings made, engines asked, answers judged."""

from __future__ import annotations

import hashlib
import math
import time
from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from plumbline import Arrangement

from study.dice import Dice
from study.engines import Adapter, Configuration, Limits, NotHere, Reply
from study.families import Case, Family, Unit, case_of
from study.outcomes import Judgement, Known, edges_of, faces_in, judgements
from study.results import Row
from study.schedule import Block
from study.truths import Truths

_SOME = 20  # drawings, after which it is known whether an engine is slow
_SLOW = 0.2  # seconds a drawing
_TIMEOUTS = 5  # in a row, after which an engine is asked nothing more of a block
_NO_GRID = ("grid", 0.0)
_OFF_TIES = 65 / 64  # times a ratio: else decimals are half way between points of a decimal grid
_FEWER_SWEPT = 10  # times fewer seeds of slow engines where each is given many tolerances


@dataclass(frozen=True)
class Bounds:
    """Of what a worker does."""

    limits: Limits
    both_engines: int
    """One drawing in so many is arranged by both exact engines."""
    until: float = math.inf
    """Asks no engine later, on `time.monotonic`."""
    slow_seeds: int = 50
    """Of engines that take long, so many seeds from the first."""
    first_seed: int = 0
    seconds_each: float = math.inf
    """Asks an engine nothing more when it has taken so many: the slow ones get fewer drawings."""


@dataclass(frozen=True)
class Engine:
    """A configuration and the program that runs it."""

    program: Path
    configuration: Configuration


class Worker:
    """Has a running adapter for each engine. A context manager."""

    def __init__(
        self,
        engines: Sequence[Engine],
        done: set[tuple[Any, ...]],
        bounds: Bounds,
    ) -> None:
        self._engines = engines
        self._done = done
        self._bounds = bounds
        self._taken = {e.configuration.key: 0.0 for e in engines}
        self._asked = {e.configuration.key: 0 for e in engines}
        self._stack = ExitStack()
        self._adapters = {
            e.configuration.key: self._stack.enter_context(
                Adapter(e.program, e.configuration.name, bounds.limits)
            )
            for e in engines
        }
        self._gone: set[tuple[str, str, str]] = set()
        self._swept = one_of_each_way([e.configuration for e in engines])

    def __enter__(self) -> Worker:
        return self

    def __exit__(self, *_: object) -> None:
        self._stack.close()

    def rows(self, block: Block) -> list[Row]:
        """Of the units that are not done, and the engines that are here."""
        result: list[Row] = []
        late: dict[tuple[str, str, str], int] = {}
        for unit in block.units:
            asked = [(e.configuration, ratio) for e in self._engines for ratio in block.ratios]
            missing = [a for a in asked if self._is_wanted(*a, block.family.group, unit, late)]
            if not missing or time.monotonic() > self._bounds.until:
                continue
            case = case_of(block.family, unit)
            if not case.segments:
                continue
            truths = Truths(case)
            both = self._compared(truths, unit)
            drawing = _drawing(block.family, case, truths, both)
            known: Known = {}
            for configuration, ratio in missing:
                of = _with_ratio(configuration, ratio, truths)
                if of is None or of.key in self._gone or late.get(of.key, 0) >= _TIMEOUTS:
                    continue
                start = time.monotonic()
                if start > self._bounds.until:
                    break
                tolerance = None if ratio is None else of.tolerance
                try:
                    reply = self._adapters[of.key].ask(case.segments, tolerance)
                except NotHere:
                    self._gone.add(of.key)
                    continue
                self._note(of.key, time.monotonic() - start, reply, late)
                found = judgements(case, truths, of, reply, block.truths, known)
                told = {**drawing, "ratio": ratio}
                result += [_row(told, of, truths, reply, name, j) for name, j in found.items()]
        return result

    def _is_wanted(
        self,
        of: Configuration,
        ratio: float | None,
        group: str,
        unit: Unit,
        late: dict[tuple[str, str, str], int],
    ) -> bool:
        key = of.key
        if key in self._gone or late.get(key, 0) >= _TIMEOUTS:
            return False
        if ratio is not None and (key not in self._swept or (of.tolerance_kind, ratio) == _NO_GRID):
            return False
        if self._taken[key] > self._bounds.seconds_each:
            return False
        count = self._asked[key]
        is_slow = count >= _SOME and self._taken[key] > _SLOW * count
        seeds = self._bounds.slow_seeds // (1 if ratio is None else _FEWER_SWEPT)
        if is_slow and unit.seed - self._bounds.first_seed >= seeds:
            return False
        return (*key, group, *asdict(unit).values(), ratio) not in self._done

    def _note(
        self,
        key: tuple[str, str, str],
        seconds: float,
        reply: Reply,
        late: dict[tuple[str, str, str], int],
    ) -> None:
        """What an engine took."""
        self._asked[key] += 1
        self._taken[key] += seconds
        late[key] = late.get(key, 0) + 1 if reply.ending == "timeout" else 0

    def _compared(self, truths: Truths, unit: Unit) -> bool:
        """Whether the exact side was computed by both exact engines."""
        if not self._is_compared(unit):
            return False
        truths.ensure_both_engines()
        return True

    def _is_compared(self, unit: Unit) -> bool:
        """One in so many is."""
        return Dice(f"both {unit}").between(1, self._bounds.both_engines) == 1


def one_of_each_way(configurations: Sequence[Configuration]) -> set[tuple[str, str, str]]:
    """Of those whose tolerance can be chosen; of several that differ by it alone the first."""
    found: dict[tuple[str, str, str], tuple[str, str, str]] = {}
    for c in configurations:
        if c.tolerance_kind != "none":
            found.setdefault((c.engine, c.version, c.way or c.name), c.key)
    return set(found.values())


def _with_ratio(of: Configuration, ratio: float | None, truths: Truths) -> Configuration | None:
    """With the tolerance that has this ratio to the least feature that was meant; None where that
    is not known."""
    if ratio is None:
        return of
    if truths.meant_size is None:
        return None
    return replace(
        of,
        tolerance=ratio * _OFF_TIES * truths.meant_size,
        configuration_title=of.way or of.configuration_title,
    )


def _drawing(family: Family, case: Case, truths: Truths, both: bool) -> Row:
    return {
        "group": family.group,
        **asdict(case.unit),
        "segments": len(case.segments),
        "feature_size": truths.feature_size,
        "both_engines": both,
    }


def _row(
    drawing: Row, of: Configuration, truths: Truths, reply: Reply, name: str, found: Judgement
) -> Row:
    truth = truths.of(name, of)
    assert truth is not None
    counts = truth.counts if isinstance(truth, Arrangement) else truth
    return {
        **drawing,
        **row_of(of, found),
        "truth": name,
        "fits_doubles": truths.fits_doubles(truth),
        "exact_vertices": counts.vertices,
        "exact_edges": counts.edges,
        "exact_faces": counts.faces - 1,
        "answer": signature(reply),
        "seconds": reply.seconds,
    }


def row_of(of: Configuration, found: Judgement) -> Row:
    """What a row says of the engine and of its answer."""
    judged = asdict(found)
    judged["compare_tolerance"] = judged.pop("tolerance")
    return {
        **judged,
        "engine": of.engine,
        "version": of.version,
        "configuration": of.name,
        "title": of.title,
        "algorithm": of.algorithm,
        "configuration_title": of.configuration_title,
        "tolerance_kind": of.tolerance_kind,
        "tolerance": of.tolerance,
        "source": of.source,
    }


def signature(reply: Reply) -> str:
    """The same for answers with the same edges and as many polygons, to the last digit, however
    they are listed."""
    if reply.model is None:
        return reply.ending
    places = [tuple(p) for p in reply.model["V"]]
    try:
        pairs = edges_of(reply.model)
        edges = sorted(tuple(sorted((places[i], places[j]))) for i, j in pairs)
    except (IndexError, TypeError, ValueError):
        return "unreadable"
    text = f"{edges} {faces_in(reply.model)}"
    return hashlib.sha256(text.encode()).hexdigest()[:16]
