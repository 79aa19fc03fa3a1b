"""The protocol of adapters, for engines that Python calls: cases in, models out.

An adapter is an `Engine`; `serve` does the rest. ../README.md has the protocol.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NoReturn, TextIO

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.integer[Any]]
Model = dict[str, Any]

NOT_HERE = 3
"""The exit code of an adapter whose engine is not installed."""


class Clock:
    """The time that an engine takes: ``with clock: engine(...)``. What an adapter does before and
    after is not the engine's."""

    def __init__(self) -> None:
        self.seconds = 0.0

    def __enter__(self) -> None:
        self._began = time.perf_counter()

    def __exit__(self, *_: object) -> None:
        self.seconds += time.perf_counter() - self._began


class EngineError(Exception):
    """What an engine says of itself that failed, with the engine's own word for it."""

    def __init__(self, kind: str, message: str) -> None:
        super().__init__(message)
        self.kind = kind


class BadTolerance(EngineError):
    """A tolerance that an engine cannot have."""

    def __init__(self, message: str) -> None:
        super().__init__("BadTolerance", message)


@dataclass(frozen=True)
class Rings:
    """What an engine of rings gets: per ring its points, the first one not again, and the rule,
    evenodd or nonzero."""

    rings: list[Floats]
    rule: str


@dataclass(frozen=True)
class Configuration:
    """One way to call an engine.

    `run` gets segments, rows ax, ay, bx, by, of which none is of length 0, or `Rings` where the
    engine takes these, and a tolerance, and returns a model. `tolerance` is ("none", 0), ("grid",
    its distance) or ("snap", the distance); `source` says where the engine's own documentation has
    this way; `promise`, if it is not empty, what the tolerance promises, as ../README.md has it;
    `way` what is called, without the tolerance.
    """

    name: str
    title: str
    tolerance: tuple[str, float]
    source: str
    run: Callable[[Any, Clock, float | None], Model]
    promise: str = ""
    way: str = ""
    is_automatic: bool = False
    """The engine chooses its tolerance: where a case has none, `run` gets None."""


@dataclass(frozen=True)
class Engine:
    """`algorithm` is what counts as one independent engine: wrappers of one share it. `repairs`
    are ways to repair a drawing, apart from those that take it as it is. `takes` is of engines of
    rings: kinds of rings and fill rules, as "simple nonzero"."""

    engine: str
    title: str
    version: str
    algorithm: str
    licence: str
    configurations: Sequence[Configuration]
    repairs: Sequence[Configuration] = ()
    takes: Sequence[str] = ()

    def listed(self, chosen: Sequence[Configuration]) -> dict[str, Any]:
        """What ``adapter --list`` prints."""
        configurations = [
            {
                "name": c.name,
                "title": c.title,
                "tolerance": {"kind": c.tolerance[0], "value": c.tolerance[1], "way": c.way}
                | ({"promise": c.promise} if c.promise else {}),
                "source": c.source,
            }
            for c in chosen
        ]
        rings = {"input": "rings", "takes": list(self.takes)} if self.takes else {}
        return rings | {
            "engine": self.engine,
            "title": self.title,
            "version": self.version,
            "algorithm": self.algorithm,
            "licence": self.licence,
            "configurations": configurations,
        }


def not_here(reason: str) -> NoReturn:
    """Ends an adapter whose engine is not installed."""
    print(reason, file=sys.stderr)
    sys.exit(NOT_HERE)


def serve(engine: Engine) -> None:
    """Runs an adapter: lists it, or answers the cases of standard input."""
    arguments = argparse.ArgumentParser(description=f"{engine.title}, as an engine of the study")
    arguments.add_argument("configuration", nargs="?")
    arguments.add_argument("--list", action="store_true", help="print what there is, as JSON")
    arguments.add_argument("--repairs", action="store_true", help="ways to repair instead")
    options = arguments.parse_args()
    configurations = engine.repairs if options.repairs else engine.configurations
    if options.list:
        print(json.dumps(engine.listed(configurations)))
        return
    chosen = [c for c in configurations if c.name == options.configuration]
    if not chosen:
        arguments.error(f"one of {', '.join(c.name for c in configurations)}")
    answers = _own_output()
    for line in sys.stdin:
        print(json.dumps(_answer(chosen[0], json.loads(line))), file=answers, flush=True)


def _own_output() -> TextIO:
    """Standard output, for answers alone: what an engine prints goes to standard error."""
    answers = os.fdopen(os.dup(1), "w", encoding="ascii")
    os.dup2(2, 1)
    return answers


def _answer(configuration: Configuration, case: dict[str, Any]) -> dict[str, Any]:
    clock = Clock()
    try:
        tolerance = _tolerance(configuration, case)
        given = _rings(case) if "rings" in case else _segments(case)
        model = configuration.run(given, clock, tolerance)
        if not np.isfinite(np.array(model["V"], dtype=np.float64)).all():
            raise EngineError("NotFinite", "coordinates of the result are not finite")
    except EngineError as error:
        return _failed(case, clock, error.kind, str(error))
    except Exception as error:
        return _failed(case, clock, type(error).__name__, str(error))
    return {"case": case["case"], "seconds": clock.seconds, "model": model}


def _tolerance(configuration: Configuration, case: dict[str, Any]) -> float | None:
    kind, value = configuration.tolerance
    if "tolerance" not in case:
        return None if configuration.is_automatic else value
    wanted = case["tolerance"]
    if kind == "none":
        raise BadTolerance("this configuration has no tolerance")
    if not isinstance(wanted, (int, float)) or not math.isfinite(wanted) or wanted < 0:
        raise BadTolerance("a tolerance is a number, not below 0")
    if kind == "grid" and wanted == 0:
        raise BadTolerance("a grid has a distance above 0")
    return float(wanted)


def _segments(case: dict[str, Any]) -> Floats:
    segments: Floats = np.array(case["segments"], dtype=np.float64).reshape(-1, 4) + 0.0  # no -0.0
    return segments[(segments[:, :2] != segments[:, 2:]).any(axis=1)]


def _rings(case: dict[str, Any]) -> Rings:
    rings = [np.array(ring, dtype=np.float64).reshape(-1, 2) + 0.0 for ring in case["rings"]]
    return Rings(rings, case["rule"])


def _failed(case: dict[str, Any], clock: Clock, kind: str, message: str) -> dict[str, Any]:
    error = {"class": kind, "message": message.strip()[:500]}
    return {"case": case["case"], "seconds": clock.seconds, "error": error}


def distinct(points: Floats) -> tuple[Floats, Ints]:
    """The points, each once, and for every point given its index among them."""
    points = np.asarray(points, dtype=np.float64).reshape(-1, 2) + 0.0  # -0.0 is 0.0
    vertices, index = np.unique(points, axis=0, return_inverse=True)
    return vertices, index.reshape(-1).astype(np.int64)


def edges_once(pairs: Ints) -> list[list[int]]:
    """Pairs of vertices, each once in either direction, without those of one vertex alone."""
    pairs = np.sort(np.asarray(pairs, dtype=np.int64).reshape(-1, 2), axis=1)
    pairs = pairs[pairs[:, 0] != pairs[:, 1]]
    once: list[list[int]] = np.unique(pairs, axis=0).tolist()
    return once


def endpoints(segments: Floats) -> tuple[Floats, Ints]:
    """Segments as points, each once, and pairs of their indices."""
    vertices, index = distinct(segments.reshape(-1, 2))
    return vertices, index.reshape(-1, 2)
