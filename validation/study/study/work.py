"""Blocks of units done: drawings made, engines asked, answers judged."""

from __future__ import annotations

import hashlib
import math
import time
from collections.abc import Sequence
from contextlib import ExitStack
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from plumbline import Arrangement

from study.dice import Dice
from study.engines import Adapter, Configuration, Limits, NotHere, Reply
from study.families import Case, Family, Unit, case_of
from study.outcomes import Judgement, edges_of, faces_in, judgements
from study.results import Row
from study.schedule import Block
from study.truths import Truths

_SOME = 20  # drawings, after which it is known whether an engine is slow
_SLOW = 0.2  # seconds a drawing
_TIMEOUTS = 5  # in a row, after which an engine is asked nothing more of a block


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

    def __enter__(self) -> Worker:
        return self

    def __exit__(self, *_: object) -> None:
        self._stack.close()

    def rows(self, block: Block) -> list[Row]:
        """Of the units that are not done, and the engines that are here."""
        result: list[Row] = []
        late: dict[tuple[str, str, str], int] = {}
        for unit in block.units:
            missing = [e for e in self._engines if self._is_wanted(e, unit, late)]
            if not missing or time.monotonic() > self._bounds.until:
                continue
            case = case_of(block.family, unit)
            if not case.segments:
                continue
            truths = Truths(case)
            both = self._compared(truths, unit)
            for engine in missing:
                of = engine.configuration
                start = time.monotonic()
                if start > self._bounds.until:
                    break
                try:
                    reply = self._adapters[of.key].ask(case.segments)
                except NotHere:
                    self._gone.add(of.key)
                    continue
                self._asked[of.key] += 1
                self._taken[of.key] += time.monotonic() - start
                late[of.key] = late.get(of.key, 0) + 1 if reply.ending == "timeout" else 0
                found = judgements(case, truths, of, reply, block.truths)
                drawing = _drawing(block.family, case, truths, both)
                result += [_row(drawing, of, truths, reply, name, j) for name, j in found.items()]
        return result

    def _is_wanted(self, engine: Engine, unit: Unit, late: dict[tuple[str, str, str], int]) -> bool:
        key = engine.configuration.key
        if key in self._gone or late.get(key, 0) >= _TIMEOUTS:
            return False
        if self._taken[key] > self._bounds.seconds_each:
            return False
        count = self._asked[key]
        is_slow = count >= _SOME and self._taken[key] > _SLOW * count
        if is_slow and unit.seed - self._bounds.first_seed >= self._bounds.slow_seeds:
            return False
        return (*key, *asdict(unit).values()) not in self._done

    def _compared(self, truths: Truths, unit: Unit) -> bool:
        """Whether the exact side was computed by both exact engines; one in so many is."""
        if Dice(f"both {unit}").between(1, self._bounds.both_engines) != 1:
            return False
        truths.ensure_both_engines()
        return True


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
    judged = asdict(found)
    judged["compare_tolerance"] = judged.pop("tolerance")
    truth = truths.of(name, of)
    assert truth is not None
    counts = truth.counts if isinstance(truth, Arrangement) else truth
    return {
        **drawing,
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
        "truth": name,
        "fits_doubles": truths.fits_doubles(truth),
        "exact_vertices": counts.vertices,
        "exact_edges": counts.edges,
        "exact_faces": counts.faces - 1,
        "answer": signature(reply),
        "seconds": reply.seconds,
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
