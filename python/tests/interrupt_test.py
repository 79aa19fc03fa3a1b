"""Ctrl-C ends long work, and leaves nothing broken."""

from __future__ import annotations

import signal
import time
from collections.abc import Callable, Iterator

import numpy as np
import plumbline
import pytest
from numpy.typing import NDArray


@pytest.fixture
def interrupted() -> Iterator[Callable[[float], None]]:
    """Raises KeyboardInterrupt after so many seconds, as Ctrl-C does."""

    def interrupt(signum: int, frame: object) -> None:
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    yield lambda seconds: signal.setitimer(signal.ITIMER_REAL, seconds) and None
    signal.setitimer(signal.ITIMER_REAL, 0)
    signal.signal(signal.SIGALRM, before)


def short_lines(count: int) -> NDArray[np.float64]:
    random = np.random.default_rng(3)
    start = random.random((count, 2))
    return np.hstack([start, start + random.normal(size=(count, 2)) / np.sqrt(count)])


def plan(side: int) -> NDArray[np.float64]:
    """Rooms in rows, with a wall too short in each."""
    i, j = (m.ravel() for m in np.mgrid[0:side, 0:side] * 4)
    outlines = [(i, j, i + 4, j), (i, j, i, j + 4), (i + 2, j, i + 2, j + 3.99)]
    return np.concatenate([np.column_stack(line) for line in outlines]).astype(float)


@pytest.mark.parametrize(
    ("work", "rows"),
    [(plumbline.arrange, short_lines(200_000)), (plumbline.repair, plan(60))],
    ids=["arrange", "repair"],
)
def test_ctrl_c_ends_it(
    work: Callable[[plumbline.Lines], object],
    rows: NDArray[np.float64],
    interrupted: Callable[[float], None],
) -> None:
    lines = plumbline.lines(rows)
    start, used = time.perf_counter(), time.process_time()
    work(lines)
    whole, used = time.perf_counter() - start, time.process_time() - used
    interrupted(whole / 10)
    start = time.process_time()  # which does not depend on what else runs
    with pytest.raises(KeyboardInterrupt):
        work(lines)
    assert time.process_time() - start < 0.8 * used
    assert work(plumbline.lines([(0, 0, 1, 1)])) is not None


def test_a_progress_function_that_raises_ends_the_work() -> None:
    def refuse(part: float) -> None:
        raise RuntimeError(f"at {part:g}")

    with pytest.raises(RuntimeError, match="at "):
        plumbline.arrange(short_lines(200_000), progress=refuse)
