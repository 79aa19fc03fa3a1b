"""shapely's functions on line work, with the GEOS of its wheel; faces by polygonize."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import shapely
from geometries import Geometries, as_lines, model_of
from study_adapter import Clock, Configuration, Engine, Floats, Model, serve

GRID = 1e-9
_MANUAL = "shapely manual"


def noded_by(
    node: Callable[[Geometries, float | None], Any],
) -> Callable[[Floats, Clock, float | None], Model]:
    """The way to run it: noded, then polygonized."""

    def run(segments: Floats, clock: Clock, tolerance: float | None) -> Model:
        lines = as_lines(segments)
        with clock:
            noded = node(lines, tolerance)
            polygons = shapely.get_parts(shapely.polygonize([noded]))
        return model_of(noded, polygons)

    return run


def node(lines: Geometries, _: float | None) -> Any:
    return shapely.node(shapely.multilinestrings(lines))


def unary_union(lines: Geometries, _: float | None) -> Any:
    return shapely.unary_union(shapely.multilinestrings(lines))


def union_on_grid(lines: Geometries, grid: float | None) -> Any:
    return shapely.union_all(lines, grid_size=grid)


def set_precision_then_node(lines: Geometries, grid: float | None) -> Any:
    assert grid is not None
    on_grid = shapely.set_precision(shapely.multilinestrings(lines), grid, mode="valid_output")
    return shapely.node(on_grid)


def noded_within_rounding(lines: Geometries) -> Any:
    """What is to be repaired is more than that doubles do not lie on slanted lines."""
    return union_on_grid(lines, GRID)


def snapped(lines: Geometries, distance: float | None) -> Any:
    assert distance is not None
    noded = noded_within_rounding(lines)
    return noded_within_rounding(np.asarray(shapely.snap(noded, noded, distance)))


def clean_coverage(segments: Floats, clock: Clock, distance: float | None) -> Model:
    """Of the faces that polygonize finds in the lines as they are."""
    lines = as_lines(segments)
    with clock:
        faces = shapely.get_parts(shapely.polygonize([noded_within_rounding(lines)]))
        if len(faces):
            faces = shapely.coverage_clean(faces, snapping_distance=distance, gap_width=distance)
    parts = shapely.get_parts(faces)
    parts = parts[~shapely.is_empty(parts)]
    return model_of(shapely.boundary(parts), parts)


CONFIGURATIONS = [
    Configuration(
        "node",
        "node",
        ("none", 0),
        f"{_MANUAL}, node: 'to create a fully-noded linework' for polygonize",
        noded_by(node),
    ),
    Configuration(
        "unary-union",
        "unary_union",
        ("none", 0),
        f"{_MANUAL}, unary_union, an alias of union_all: unions of lines are noded",
        noded_by(unary_union),
    ),
    Configuration(
        "union-grid-1e-9",
        "union_all, grid 1e-9",
        ("grid", GRID),
        f"{_MANUAL}, union_all: with grid_size all coordinates are snapped to that grid",
        noded_by(union_on_grid),
        way="union_all on a grid",
    ),
    Configuration(
        "set-precision-1e-9-node",
        "set_precision 1e-9, node",
        ("grid", GRID),
        f"{_MANUAL}, set_precision: 'subsequent operations will always be performed in' it",
        noded_by(set_precision_then_node),
        promise="some",  # coordinates on the grid, no snap rounding
        way="set_precision, node",
    ),
]
REPAIRS = [
    Configuration(
        "snap",
        "union_all, snap to itself",
        ("snap", GRID),
        f"{_MANUAL}, snap: 'snaps an input geometry to reference geometry's vertices'",
        noded_by(snapped),
        way="union_all, snap to itself",
    ),
    Configuration(
        "coverage-clean",
        "union_all, polygonize, coverage_clean",
        ("snap", GRID),
        f"{_MANUAL}, coverage_clean: 'small gaps are removed, and all shared edges are exactly "
        "identical'",
        clean_coverage,
        way="union_all, polygonize, coverage_clean",
    ),
]

if __name__ == "__main__":
    geos = shapely.geos_version_string
    serve(
        Engine(
            "shapely",
            "shapely (GEOS of its wheel)",
            f"{shapely.__version__}, GEOS {geos}",
            f"GEOS {geos}",
            "BSD-3-Clause, GEOS LGPL-2.1",
            CONFIGURATIONS,
            REPAIRS,
        )
    )
