"""Tables of times of the Python package, beside shapely in the same run: see validation/python/run.

Each time is the least of some runs on a clock, in seconds.
"""

from __future__ import annotations

import platform
import sys
import time
from collections.abc import Callable

import geopandas
import numpy as np
import plumbline
import shapely
from numpy.typing import NDArray
from plumbline import _core


def best(work: Callable[[], object], runs: int = 3) -> float:
    """The least time of some runs."""
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times)


def short_lines(count: int, length: float) -> NDArray[np.float64]:
    """Random lines of the unit square: many components, few faces, or many, by their length."""
    random = np.random.default_rng(1)
    start = random.random((count, 2))
    return np.hstack([start, start + random.normal(size=(count, 2)) * length])


def street_grid(side: int) -> NDArray[np.float64]:
    """Streets of a town: `side` blocks in each direction, every block's side a line."""
    ticks = np.arange(side + 1) * 100.0
    x, y = np.meshgrid(ticks, ticks, indexing="ij")
    jitter = np.random.default_rng(2).normal(size=(2, side + 1, side + 1)).round(3)
    nodes = np.dstack([x + jitter[0], y + jitter[1]])
    across = np.concatenate([nodes[:-1], nodes[1:]], axis=2).reshape(-1, 4)
    along = np.concatenate([nodes[:, :-1], nodes[:, 1:]], axis=2).reshape(-1, 4)
    return np.vstack([across, along])


def frame_of(rows: NDArray[np.float64]) -> geopandas.GeoDataFrame:
    return geopandas.GeoDataFrame(geometry=shapely.linestrings(rows.reshape(-1, 2, 2)))


def overhead(count: int) -> None:
    """What the package adds to the library's own work, of which _core is a bare call."""
    rows = short_lines(count, 0.5 / np.sqrt(count))
    lines = plumbline.lines(rows)
    items = _core.Items("<array>", "row", None, len(rows), [], [], None)
    reading = best(lambda: _core.SegmentSet.of_doubles(rows, items, False))
    arranging = best(lambda: _core.arrange(lines._core, False, 0, None))
    whole = best(lambda: plumbline.arrange(rows))
    a = plumbline.arrange(lines)
    arrays = best(lambda: (plumbline.Arrangement(a._core, lines).edges, a.cycles, a.halfedge_face))
    print(f"| {count:,} | {reading:.3f} | {arranging:.3f} | {whole:.3f} ", end="")
    print(f"| {100 * (whole / (reading + arranging) - 1):.1f} % | {1e6 * arrays:.0f} |")


def rooms(name: str, rows: NDArray[np.float64]) -> None:
    """From a GeoDataFrame of lines to one of faces."""
    frame = frame_of(rows)
    sourced = best(lambda: plumbline.arrange(frame).to_geopandas())
    bare = best(lambda: plumbline.arrange(frame).to_geopandas(sources=False))

    def by_shapely() -> int:
        faces = shapely.polygonize([shapely.union_all(frame.geometry.array)])
        return len(geopandas.GeoDataFrame(geometry=list(faces.geoms)))

    theirs = best(by_shapely, 1)
    print(
        f"| {name} | {len(rows):,} | {len(plumbline.arrange(frame)):,} | {by_shapely():,} ", end=""
    )
    print(f"| {sourced:.2f} | {bare:.2f} | {theirs:.2f} | {theirs / sourced:.1f} |", flush=True)


def main() -> None:
    scale = 10 if "--quick" in sys.argv else 1
    print(f"Python {platform.python_version()}, NumPy {np.__version__}, shapely ", end="")
    print(f"{shapely.__version__} (GEOS {shapely.geos_version_string}), geopandas ", end="")
    print(f"{geopandas.__version__}, plumbline {plumbline.__version__}\n")
    print("| segments | lines | arrange | plumbline.arrange | overhead | arrays, us |")
    print("| ---: | ---: | ---: | ---: | ---: | ---: |")
    for count in (100_000 // scale, 1_000_000 // scale):
        overhead(count)
    print("\n| drawing | lines | faces | shapely's | with sources | without | shapely | ratio |")
    print("| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |")
    count = 100_000 // scale
    rooms("short lines, few faces", short_lines(count, 0.5 / np.sqrt(count)))
    rooms("longer lines, many faces", short_lines(count, 1.5 / np.sqrt(count)))
    rooms("streets", street_grid(round(np.sqrt(count / 2))))


if __name__ == "__main__":
    main()
