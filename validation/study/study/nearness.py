"""How near things are to each other in an arrangement, in doubles: cheap estimates that tell
whether an exact answer is worth its cost."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from plumbline import Arrangement

Floats = NDArray[np.float64]

_MOST = 4_000_000  # pairs of a vertex and an edge, or of vertices, that are looked at


class Nearness:
    """Distances between vertices, and between vertices and edges that they do not bound."""

    def __init__(self, of: Arrangement) -> None:
        self._distances: Floats | None = None
        vertices, edges = of.vertices, of.edges
        if len(vertices) * max(len(edges), len(vertices)) <= _MOST:
            self._distances = np.concatenate(
                [_between_vertices(vertices), _from_edges(vertices, edges)]
            )
        self.rounding = float(np.abs(vertices).max(initial=0.0)) * 2.0**-52

    @property
    def is_known(self) -> bool:
        """Whether the arrangement is small enough."""
        return self._distances is not None

    @property
    def least(self) -> float:
        """Within some `rounding`. Requires: is_known."""
        assert self._distances is not None
        return float(self._distances.min(initial=np.inf))

    def count_within(self, distance: float) -> int:
        """Requires: is_known."""
        assert self._distances is not None
        return int(np.count_nonzero(self._distances <= distance + 4 * self.rounding))


def _between_vertices(vertices: Floats) -> Floats:
    i, j = np.triu_indices(len(vertices), 1)
    result: Floats = np.hypot(*(vertices[i] - vertices[j]).T)
    return result


def _from_edges(vertices: Floats, edges: NDArray[np.uint32]) -> Floats:
    result = []
    for tail, head in edges:
        a, d = vertices[tail], vertices[head] - vertices[tail]
        squared = float(d @ d)
        off = vertices - a
        along = np.clip(off @ d / squared, 0, 1) if squared > 0 else np.zeros(len(off))
        distance = np.hypot(*(off - along[:, None] * d).T)
        distance[[tail, head]] = np.inf
        result.append(distance)
    return np.concatenate(result) if result else np.empty(0)
