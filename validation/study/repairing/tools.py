"""Tools that repair drawings within a distance: programs by the study's protocol, this project's
two, and nothing done."""

from __future__ import annotations

import sys
import time
from contextlib import ExitStack
from dataclasses import dataclass, replace
from pathlib import Path

from study.engines import Adapter, Configuration, Limits, NotHere, Reply, listing
from study.outcomes import edges_of

from repairing.plans import LAR, NOTHING, OURS, Plan, Rows

_ADAPTERS = Path(__file__).resolve().parents[1] / "adapters"
_PROGRAMS = (
    ("grass", "repairs"),
    ("mapshaper", "repairs"),
    ("shapely", "repairs"),
    ("jts", "adapter"),
    ("opencascade", "adapter"),
    ("postgis_topology", "adapter"),
)
_KIND = "snap"
_SOME = 10  # plans, after which it is known whether a tool is slow
_SLOW = 0.3  # seconds a plan


@dataclass(frozen=True)
class Result:
    """What a tool made of a plan: lines; None where it failed, with its words."""

    lines: Rows | None
    message: str = ""


@dataclass
class _Program:
    title: str
    adapter: Adapter
    asked: int = 0
    seconds: float = 0.0


class Tools:
    """All that are here. A context manager."""

    def __init__(self, slow_seeds: int, first_seed: int) -> None:
        self._slow_seeds = slow_seeds
        self._first_seed = first_seed
        self._stack = ExitStack()
        self._programs = [p for names in _PROGRAMS for p in self._of(*names)]

    def __enter__(self) -> Tools:
        return self

    def __exit__(self, *_: object) -> None:
        self._stack.close()

    def _of(self, engine: str, name: str) -> list[_Program]:
        program = _ADAPTERS / engine / name
        try:
            listed = listing(program)
        except NotHere as reason:
            print(f"{engine}: not here: {reason}", file=sys.stderr)
            return []
        # Of ways that differ by tolerance alone one.
        ways: dict[str, Configuration] = {}
        for c in listed:
            if c.tolerance_kind == _KIND:
                ways.setdefault(c.way, c)
        return [
            _Program(
                f"{c.title} {c.version}: {c.way}",
                self._stack.enter_context(Adapter(program, c.name, replace(Limits(), seconds=60))),
            )
            for c in ways.values()
        ]

    def results(self, plan: Plan) -> dict[str, Result]:
        """By title. Slow tools have the first seeds alone."""
        found = {
            NOTHING: Result(plan.lines),
            OURS: Result(plan.repaired),
            LAR: Result(plan.by_lar),
        }
        for p in self._programs:
            is_slow = p.asked >= _SOME and p.seconds > _SLOW * p.asked
            if is_slow and plan.seed - self._first_seed >= self._slow_seeds:
                continue
            began = time.monotonic()
            try:
                reply = p.adapter.ask(plan.lines, plan.size)
            except NotHere as reason:
                print(f"{p.title}: not here: {reason}", file=sys.stderr)
                continue
            p.asked += 1
            p.seconds += time.monotonic() - began
            found[p.title] = _result(reply)
        return found


def _result(reply: Reply) -> Result:
    if reply.model is None:
        return Result(None, f"{reply.ending}: {reply.message[:200]}")
    places = reply.model["V"]
    return Result([[*places[i], *places[j]] for i, j in sorted(edges_of(reply.model))])
