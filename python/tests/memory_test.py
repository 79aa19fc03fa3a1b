"""Arrays are not copied, memory does not grow, threads do not disturb each other."""

from __future__ import annotations

import gc
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import plumbline
import pytest

COUNT = 1_000_000


@pytest.fixture(scope="module")
def many() -> plumbline.Arrangement:
    """As many lines that do not meet."""
    rows = np.arange(float(COUNT))
    return plumbline.arrange(np.column_stack([0 * rows, rows, 0 * rows + 1, rows]))


def resident() -> int:
    """Bytes of memory that the process has."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * 4096


def test_arrays_of_a_million_lines_are_views(many: plumbline.Arrangement) -> None:
    before, start = resident(), time.process_time()
    for _ in range(100):
        arrays = [many._core.edges(), many._core.halfedge_face(), *many._core.edge_sources()]
    assert time.process_time() - start < 0.1
    assert resident() - before < 1_000_000
    for array in arrays:
        assert len(array) >= COUNT and array.base is not None and not array.flags.writeable
    assert np.shares_memory(many.edges, many._core.edges())


def test_views_outlive_what_they_are_of() -> None:
    a = plumbline.arrange([(0, 0, 1, 0), (1, 0, 0, 1), (0, 1, 0, 0)])
    edges, image = a.edges, a.rounded().edge_image
    del a
    gc.collect()
    assert edges.tolist() == [[0, 1], [0, 2], [1, 2]]
    assert image.tolist() == [[0], [2], [4]]


def test_memory_does_not_grow() -> None:
    rows = np.array([[0, 0, 2, 2], [0, 2, 2, 0], [0, 0, 0, 2.0]])

    def all_of_it() -> None:
        a = plumbline.arrange(rows)
        a.to_shapely()
        _ = a.rounded(1).changes, a.points[2], a.areas, a.sources, a.to_arrow(), a.to_wkt()
        with pytest.raises(plumbline.Error):
            plumbline.lines([(0, 0, "x", 1)])

    for _ in range(200):
        all_of_it()
    gc.collect()
    before = resident()
    for _ in range(1000):
        all_of_it()
    gc.collect()
    assert resident() - before < 1_000_000


def test_threads_give_the_same() -> None:
    rng = np.random.default_rng(2)
    drawings = [rng.uniform(0, 1, (150, 4)) for _ in range(6)]

    def work(rows: np.typing.NDArray[np.float64]) -> tuple[str, str]:
        a = plumbline.arrange(rows)
        return a.signature, a.to_wkt()

    with ThreadPoolExecutor(4) as threads:
        assert list(threads.map(work, drawings)) == [work(rows) for rows in drawings]


def test_a_cached_value_is_computed_beside_another_one_and_kept_once() -> None:
    from plumbline._cached import cached

    both = threading.Barrier(2, timeout=5)

    class Slow:
        @cached
        def value(self) -> object:
            """Waits until it is computed for another instance, too."""
            both.wait()
            return object()

    slow = [Slow(), Slow()]
    with ThreadPoolExecutor(2) as pool:
        values = list(pool.map(lambda one: one.value, slow))
    assert [one.value for one in slow] == values
    assert Slow.value.__doc__ == "Waits until it is computed for another instance, too."
