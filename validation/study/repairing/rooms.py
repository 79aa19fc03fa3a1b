"""Which rooms of a plan a drawing has, told by points inside them and by areas: by the rule of
validation/repair, and by Shapely, which has no part in any repair but its own."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
import shapely
from numpy.typing import NDArray

from repairing.plans import Room, Rows

GRID = 1e-8
"""On which lines are noded: doubles of turned plans do not lie on their lines."""
_RELATIVE = 1e-9  # of areas and distances: what doubles lose

OUTCOMES = ("failed", "rooms lost", "rooms merged", "faces invented", "rooms reshaped", "right")
"""Exclusive, the first that holds: the tool says that it failed; a room is open to the outside; two
rooms are one; there is a face without a room; a room is there, but larger or smaller than its
border moved by the tolerance; none of these."""


@dataclass(frozen=True)
class Found:
    """The rooms of a plan as a drawing has them, by their numbers."""

    there: frozenset[int] = field(default_factory=frozenset)
    lost: int = 0
    merged: int = 0
    reshaped: int = 0
    invented: int = 0
    """Faces without a room."""

    @property
    def outcome(self) -> str:
        counts = (self.lost, self.merged, self.invented, self.reshaped)
        return next((name for name, n in zip(OUTCOMES[1:], counts) if n), OUTCOMES[-1])


def lines_of(rows: Rows) -> NDArray[np.object_]:
    ends = np.array(rows, dtype=np.float64).reshape(-1, 2, 2)
    return np.asarray(shapely.linestrings(ends[(ends[:, 0] != ends[:, 1]).any(axis=1)]))


def found(rows: Rows, rooms: Sequence[Room], size: float) -> Found:
    """A room is there where it is alone in a face, with its area, but for a border that moved by
    the size."""
    noded = shapely.union_all(lines_of(rows), grid_size=GRID)
    faces = shapely.get_parts(shapely.polygonize([noded]))
    points = shapely.points([(room.x, room.y) for room in rooms])
    room_of, face_of = shapely.STRtree(faces).query(points, predicate="within")
    within = dict(zip(room_of.tolist(), face_of.tolist()))
    count = Counter(within.values())
    alone = [r for r, face in within.items() if count[face] == 1]
    there = {
        r
        for r in alone
        if abs(shapely.area(faces[within[r]]) - rooms[r].area)
        <= size * rooms[r].perimeter + _RELATIVE * rooms[r].area
    }
    return Found(
        frozenset(there),
        lost=len(rooms) - len(within),
        merged=len(within) - len(alone),
        reshaped=len(alone) - len(there),
        invented=len(faces) - len(count),
    )


def moved_far(rows: Rows, given: Rows, size: float) -> int:
    """How many vertices of a result are further than the size from all that was drawn."""
    points = np.unique(np.array(rows, dtype=np.float64).reshape(-1, 2), axis=0)
    drawn = shapely.multilinestrings(lines_of(given))
    distances = shapely.distance(shapely.points(points), drawn)
    most = size + _RELATIVE * max(1.0, float(np.abs(points).max(initial=0.0)))
    return int(np.count_nonzero(distances > most))
