"""Runs the study: see validation/study/run."""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from dataclasses import replace
from math import inf
from multiprocessing.util import Finalize
from pathlib import Path
from typing import Any

from study import results
from study.engines import Limits, NotHere, listing
from study.results import Row
from study.ring_work import RingWorker
from study.schedule import (
    FULL,
    QUICK,
    Amount,
    Block,
    RingBlock,
    at_most,
    blocks,
    ring_blocks,
    sweeps,
)
from study.work import Bounds, Engine, Worker

_HERE = Path(__file__).resolve().parents[1]
_PIECE = 20_000  # rows that are written at a time
_QUICK = 0.8  # minutes, so that a quick run with whatever engines takes one
_SHARE = 0.5  # of that time for engines; the rest is for judging
_AT_MOST = 30.0  # seconds of work that are lost where a run is ended
_EVERY = 10.0  # seconds, at which progress is told

_INTERRUPTED = 130  # the exit code that shells have for it

AnyBlock = Block | RingBlock
_workers: tuple[Worker, RingWorker] | None = None  # of this process


def engines_of(folders: Sequence[Path], chosen: Sequence[str]) -> list[Engine]:
    """All configurations of all adapters that are here; says which are not."""
    found: list[Engine] = []
    for program in sorted(p for folder in folders for p in folder.glob("*/adapter")):
        if chosen and program.parent.name not in chosen:
            continue
        try:
            found += [Engine(program, c) for c in listing(program)]
        except NotHere as reason:
            print(f"{program.parent.name}: not here: {reason}", file=sys.stderr)
    return found


def blocks_for(engines: Sequence[Engine], amount: Amount, drawings: Path) -> Iterator[AnyBlock]:
    """Those of line work and of rings, where any engine takes such."""
    if any(e.configuration.takes for e in engines):
        yield from ring_blocks(amount)
    if not all(e.configuration.takes for e in engines):
        yield from blocks(amount, drawings)


def part_of(all_blocks: Iterator[AnyBlock], part: tuple[int, int]) -> list[AnyBlock]:
    """Every n-th block, from the k-th on."""
    k, n = part
    return [block for i, block in enumerate(all_blocks) if i % n == k - 1]


def _begin(engines: list[Engine], done: set[tuple[Any, ...]], bounds: Bounds) -> None:
    global _workers
    of_lines = Worker([e for e in engines if not e.configuration.takes], done, bounds)
    of_rings = RingWorker([e for e in engines if e.configuration.takes], done, bounds)
    _workers = of_lines, of_rings
    # Adapters are no children of this process's group: they must be ended by it.
    for worker in _workers:
        Finalize(None, worker.__exit__, exitpriority=0)


def _rows(block: AnyBlock) -> list[Row]:
    assert _workers
    of_lines, of_rings = _workers
    return of_rings.rows_of_rings(block) if isinstance(block, RingBlock) else of_lines.rows(block)


def run(
    todo: Sequence[AnyBlock],
    engines: list[Engine],
    path: Path,
    jobs: int,
    bounds: Bounds,
) -> None:
    """Does blocks in worker processes."""
    done = results.units_done(results.gather(path))
    rows: list[Row] = []
    told = written = time.monotonic()
    count = 0
    arguments = (engines, done, bounds)
    with ProcessPoolExecutor(jobs, initializer=_begin, initargs=arguments) as pool:
        waiting: set[Future[list[Row]]] = set()
        left = iter(todo)
        try:
            while True:
                while len(waiting) < 2 * jobs and time.monotonic() < bounds.until:
                    block = next(left, None)
                    if block is None:
                        break
                    waiting.add(pool.submit(_rows, block))
                if not waiting:
                    break
                ready, waiting = wait(waiting, return_when=FIRST_COMPLETED)
                for future in ready:
                    rows += future.result()
                    count += 1
                if len(rows) >= _PIECE or time.monotonic() > written + _AT_MOST:
                    results.write_piece(path, rows)
                    rows, written = [], time.monotonic()
                if time.monotonic() > told + _EVERY:
                    told = time.monotonic()
                    print(f"{count} of {len(todo)} blocks", file=sys.stderr)
        finally:
            if rows:
                results.write_piece(path, rows)
    table = results.gather(path)
    left_out = len(todo) - count
    print(f"{len(table)} rows in {path}" + (f"; {left_out} blocks left" if left_out else ""))


def _part(text: str) -> tuple[int, int]:
    k, _, n = text.partition("/")
    if not (k.isdigit() and n.isdigit() and 1 <= int(k) <= int(n)):
        raise argparse.ArgumentTypeError(f"a part is K/N, as 1/2: {text}")
    return int(k), int(n)


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="validation/study/run")
    how_much = parser.add_mutually_exclusive_group()
    how_much.add_argument("--quick", action="store_true")
    how_much.add_argument("--full", action="store_true")
    parser.add_argument("--engine", action="append", default=[], metavar="E")
    parser.add_argument("--part", type=_part, default=(1, 1), metavar="K/N")
    parser.add_argument("--seed", type=int, default=0, help="the first one")
    parser.add_argument("--seeds", type=int, help="of each family, at most")
    parser.add_argument("--slow-seeds", type=int, default=5)
    parser.add_argument("--ulp-side", type=int)
    parser.add_argument("--tolerances", action="store_true", help="the sweep of tolerances alone")
    parser.add_argument("--minutes", type=float, help="begins no block later")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--timeout", type=float, default=10.0, help="seconds for each case")
    parser.add_argument("--memory", type=float, default=4.0, help="gigabytes for each engine")
    parser.add_argument("--adapters", type=Path, action="append", default=[])
    parser.add_argument("--drawings", type=Path, default=_HERE.parents[1] / "examples" / "data")
    parser.add_argument("--results", type=Path, required=True)
    return parser.parse_args()


def main() -> int:
    begun = time.monotonic()
    given = _arguments()
    base = FULL if given.full else QUICK
    amount = replace(base, first_seed=given.seed)
    if given.seeds is not None:
        amount = at_most(amount, given.seeds)
    if given.ulp_side is not None:
        amount = replace(amount, ulp_side=given.ulp_side)
    engines = engines_of([_HERE / "adapters", *given.adapters], given.engine)
    if not engines:
        print("no engine is here", file=sys.stderr)
        return 2
    planned = sweeps(amount) if given.tolerances else blocks_for(engines, amount, given.drawings)
    todo = part_of(planned, given.part)
    limits = Limits(given.timeout, memory=int(given.memory * 2**30))
    bounds = Bounds(limits, 1 if given.full else 4, inf, given.slow_seeds, given.seed)
    if not given.full:
        bounds = replace(bounds, seconds_each=_SHARE * 60 * _QUICK / len(engines))
    minutes = given.minutes if given.minutes is not None else (inf if given.full else _QUICK)
    bounds = replace(bounds, until=begun + 60 * minutes)
    try:
        run(todo, engines, given.results, given.jobs, bounds)
    except KeyboardInterrupt:
        print("ended; the next run goes on", file=sys.stderr)
        return _INTERRUPTED
    return 0


if __name__ == "__main__":
    sys.exit(main())
