"""shapely's union of polygons, with the GEOS of its wheel; even-odd by symmetric difference."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial, reduce
from typing import Any

import numpy as np
import shapely
from geometries import model_of
from study_adapter import Clock, Configuration, Engine, Model, Rings, serve

GRID = 1e-9
_MANUAL = "shapely manual"


def combined_by(
    combine: Callable[[Any, str], Any],
) -> Callable[[Rings, Clock, float | None], Model]:
    """The way to run it: polygons of a ring each, combined."""

    def run(given: Rings, clock: Clock, _: float | None) -> Model:
        polygons = np.array([shapely.polygons(r) for r in given.rings if len(r) > 2], dtype=object)
        with clock:
            region = areas_of(combine(polygons, given.rule))
        parts = shapely.get_parts(region)
        return model_of(shapely.get_rings(parts), parts)

    return run


def areas_of(shape: Any) -> Any:
    """Without the lines and points that are beside polygons."""
    parts = shapely.get_parts(shapely.get_parts(shape))  # of collections, too
    is_area = (shapely.get_dimensions(parts) == 2) & ~shapely.is_empty(parts)
    return shapely.multipolygons(parts[is_area])


def floating(polygons: Any, rule: str) -> Any:
    if rule == "nonzero":
        return shapely.union_all(polygons)
    return reduce(shapely.symmetric_difference, polygons, shapely.Polygon())


def on_grid(polygons: Any, rule: str) -> Any:
    if rule == "nonzero":
        return shapely.union_all(polygons, grid_size=GRID)
    on = partial(shapely.symmetric_difference, grid_size=GRID)
    return reduce(on, polygons, shapely.Polygon())


CONFIGURATIONS = [
    Configuration(
        "union-all",
        "union_all, symmetric_difference",
        ("none", 0),
        f"{_MANUAL}, union_all: of many at once; symmetric_difference",
        combined_by(floating),
    ),
    Configuration(
        "grid-1e-9",
        "union_all, symmetric_difference, grid 1e-9",
        ("grid", GRID),
        f"{_MANUAL}, union_all: with grid_size all coordinates are snapped to that grid",
        combined_by(on_grid),
    ),
]

if __name__ == "__main__":
    geos = shapely.geos_version_string
    serve(
        Engine(
            "shapely_union",
            "shapely (GEOS of its wheel)",
            f"{shapely.__version__}, GEOS {geos}",
            f"GEOS {geos}",
            "BSD-3-Clause, GEOS LGPL-2.1",
            CONFIGURATIONS,
            takes=("simple evenodd", "simple nonzero"),
        )
    )
