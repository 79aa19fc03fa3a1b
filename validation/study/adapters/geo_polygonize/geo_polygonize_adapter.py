"""geo-polygonize: a port of JTS's polygonizer to Rust with a noder of its own.

It says its faces, and what of the lines bounds none as lines apart; edges are the sides of all.
"""

from __future__ import annotations

from collections.abc import Callable
from importlib.metadata import version
from typing import Any

import geo_polygonize
import numpy as np
from study_adapter import Clock, Configuration, Engine, Floats, Model, distinct, edges_once, serve

GRID = 1e-9
NODED: dict[str, Any] = {"node_input": True}


def certified(grid: float | None) -> dict[str, Any]:
    return {
        "node_input": True,
        "precision_model": {"type": "fixed_grid", "grid_size": grid},
        "noding": {"backend": "Snap", "guarantee": "CertifiedFixedPrecision"},
    }


def with_options(
    options: Callable[[float | None], dict[str, Any]],
) -> Callable[[Floats, Clock, float | None], Model]:
    def run(segments: Floats, clock: Clock, grid: float | None) -> Model:
        starts = np.arange(0, 2 * len(segments), 2, dtype=np.uint32)
        points = np.ascontiguousarray(segments.reshape(-1, 2))
        with clock:
            result = geo_polygonize.polygonize_with_options(
                coords=points, offsets=starts, options=options(grid), output="lean_report"
            )
        return _model(result)

    return run


def _model(result: dict[str, Any]) -> Model:
    rings = [(p.shell, *p.holes) for p in result["polygons"]]
    others = [line for kind in ("dangles", "cut_edges") for line in result[kind]]
    chains = [_points(ring) for polygon in rings for ring in polygon]
    chains += [_points(line) for line in others]
    vertices, index = distinct(np.concatenate(chains) if chains else np.empty((0, 2)))
    cut = np.split(index, np.cumsum([len(chain) for chain in chains])[:-1]) if chains else []
    pairs = [np.stack([c[:-1], c[1:]], axis=1) for c in cut]
    numbered = iter(cut)
    return {
        "V": vertices.tolist(),
        "EV": edges_once(np.concatenate(pairs) if pairs else np.empty((0, 2), dtype=np.int64)),
        "polygons": [[next(numbered)[:-1].tolist() for _ in polygon] for polygon in rings],
    }


def _points(chain: Any) -> Floats:
    return np.asarray(chain, dtype=np.float64).reshape(len(chain), -1)[:, :2]


CONFIGURATIONS = [
    Configuration(
        "noded",
        "node_input, floating",
        ("none", 0),
        "README: where intersections are unresolved, enable node_input; floating by default",
        with_options(lambda _: NODED),
    ),
    Configuration(
        "certified-1e-9",
        "certified fixed precision, grid 1e-9",
        ("grid", GRID),
        "README: CertifiedFixedPrecision, hot-pixel snap rounding plus validation",
        with_options(certified),
        way="certified fixed precision",
    ),
]

if __name__ == "__main__":
    serve(
        Engine(
            "geo_polygonize",
            "geo-polygonize",
            version("geo-polygonize-py"),
            "geo-polygonize",
            "MIT or Apache-2.0",
            CONFIGURATIONS,
        )
    )
