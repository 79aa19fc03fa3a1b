"""Drawings for tests, at random."""

from __future__ import annotations

from typing import Any

import numpy as np
import shapely
from hypothesis import strategies as st

_DIRECTIONS = np.array([(1, 0), (0, 1), (1, 1), (1, -1)])

tenths = st.integers(0, 60).map(lambda n: f"{n // 10}.{n % 10}")
segments = st.lists(st.tuples(tenths, tenths, tenths, tenths), min_size=1, max_size=9)
"""Few segments between tenths: they cross in fractions, overlap and touch."""


def polylines(seed: int) -> list[shapely.LineString]:
    """Some lines along axes and diagonals whose crossings are doubles: shapely has them right."""
    rng = np.random.default_rng(seed)
    result = []
    for _ in range(rng.integers(1, 7)):
        points = [2 * rng.integers(0, 6, 2)]
        for _ in range(rng.integers(1, 6)):
            step = 2 * (rng.integers(-3, 4) or 1)
            points.append(points[-1] + step * _DIRECTIONS[rng.integers(4)])
        result.append(shapely.LineString(points))
    return result


def undirected(geometries: Any) -> list[list[list[float]]]:
    """Lines in an order and directions of their own."""
    texts = [shapely.get_coordinates(line).tolist() for line in geometries]
    return sorted(min(text, text[::-1]) for text in texts)
