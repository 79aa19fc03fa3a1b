"""Progress of long work."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Union

Progress = Union[bool, Callable[[float], object], None]
"""None or False: nothing is told. A function is told which part of the work is done, from 0 to 1.
True: a bar of tqdm, where that is installed."""


@contextmanager
def told(progress: Progress, what: str) -> Iterator[Callable[[float], object] | None]:
    """What the library tells, for as long as the work goes on."""
    if not progress:
        yield None
        return
    if callable(progress):
        yield progress
        return
    try:
        from tqdm.auto import tqdm
    except ImportError:
        yield None
        return
    with tqdm(total=100, desc=what, unit="%", leave=False) as bar:
        yield lambda part: bar.update(int(100 * part) - bar.n)
