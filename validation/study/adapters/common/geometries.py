"""Models of what shapely holds: lines that an engine noded, polygons that it made of them."""

from __future__ import annotations

from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray
from study_adapter import Floats, Ints, Model, distinct, edges_once

Geometries = NDArray[np.object_]


def as_lines(segments: Floats) -> Geometries:
    """Segments as an array of LineStrings."""
    return np.asarray(shapely.linestrings(segments.reshape(-1, 2, 2)), dtype=object)


def model_of(noded: Any, polygons: Any) -> Model:
    """A model of lines and polygons. Of lines every piece between two points is an edge."""
    parts = shapely.get_parts(np.atleast_1d(np.asarray(noded, dtype=object)))
    line_points, line = shapely.get_coordinates(parts, return_index=True)
    rings, polygon = shapely.get_rings(polygons, return_index=True)
    ring_points, ring = shapely.get_coordinates(rings, return_index=True)
    vertices, index = distinct(np.concatenate([line_points, ring_points]))
    along, around = index[: len(line_points)], index[len(line_points) :]
    successive = np.flatnonzero(line[:-1] == line[1:])
    pairs = np.stack([along[successive], along[successive + 1]], axis=1)
    return {
        "V": vertices.tolist(),
        "EV": edges_once(pairs),
        "polygons": _rings(around, ring, polygon, len(polygons)),
    }


def _rings(around: Ints, ring: Ints, polygon: Ints, count: int) -> list[list[list[int]]]:
    """Per polygon its rings, the outer one first, which is how shapely has them."""
    result: list[list[list[int]]] = [[] for _ in range(count)]
    starts = np.searchsorted(ring, np.arange(len(polygon) + 1))
    for i, of in enumerate(polygon):
        result[of].append(around[starts[i] : starts[i + 1] - 1].tolist())  # the last is the first
    return result
