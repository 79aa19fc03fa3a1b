"""Faces that triangles make when they are joined across edges that nobody drew."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from study_adapter import Floats, Ints


class _Triangulation:
    """Triangles by their sides: side k of a triangle goes from its corner k to the next."""

    def __init__(self, triangles: Ints) -> None:
        self.corners = triangles.tolist()
        self.at = {
            (corners[k], corners[(k + 1) % 3]): (t, k)
            for t, corners in enumerate(self.corners)
            for k in range(3)
        }

    def across(self, t: int, k: int) -> tuple[int, int] | None:
        """The same side, as the triangle beyond has it; None at the border."""
        a, b = self.corners[t][k], self.corners[t][(k + 1) % 3]
        return self.at.get((b, a))


def faces_of_triangles(
    vertices: Floats, triangles: Ints, fixed: Sequence[Sequence[int]]
) -> list[list[list[int]]]:
    """Per bounded face its rings, the outer one first, found by walking from triangle to
    triangle: which faces there are does not depend on coordinates. Triangles that are joined with
    the outside of the triangulation are in no face."""
    net = _Triangulation(triangles)
    drawn = {(a, b) for a, b in fixed} | {(b, a) for a, b in fixed}
    face, outside = _joined(net, drawn)
    rings: dict[int, list[list[int]]] = {}
    done: set[tuple[int, int]] = set()
    for side, (t, _) in net.at.items():
        if side not in done and face[t] not in outside and _is_border(net, face, side):
            rings.setdefault(face[t], []).append(_walk(net, face, side, done))
    return [sorted(of, key=lambda ring: -_area(vertices, ring)) for of in rings.values()]


def _joined(net: _Triangulation, drawn: set[tuple[int, int]]) -> tuple[list[int], set[int]]:
    """For each triangle its face, and the faces that nothing separates from the outside."""
    face = [-1] * len(net.corners)
    outside: set[int] = set()
    for first in range(len(face)):
        if face[first] >= 0:
            continue
        face[first] = first
        todo = [first]
        while todo:
            t = todo.pop()
            for k in range(3):
                if (net.corners[t][k], net.corners[t][(k + 1) % 3]) in drawn:
                    continue
                beyond = net.across(t, k)
                if beyond is None:
                    outside.add(first)
                elif face[beyond[0]] < 0:
                    face[beyond[0]] = first
                    todo.append(beyond[0])
    return face, outside


def _is_border(net: _Triangulation, face: list[int], side: tuple[int, int]) -> bool:
    t, k = net.at[side]
    beyond = net.across(t, k)
    return beyond is None or face[beyond[0]] != face[t]


def _walk(
    net: _Triangulation, face: list[int], start: tuple[int, int], done: set[tuple[int, int]]
) -> list[int]:
    """The ring through a side, with the face on its left."""
    ring: list[int] = []
    side = start
    while side not in done:
        done.add(side)
        ring.append(side[0])
        t, k = net.at[side]
        k = (k + 1) % 3
        side = (net.corners[t][k], net.corners[t][(k + 1) % 3])
        while not _is_border(net, face, side):  # around the vertex, within the face
            beyond = net.across(t, k)
            assert beyond is not None
            t, k = beyond[0], (beyond[1] + 1) % 3
            side = (net.corners[t][k], net.corners[t][(k + 1) % 3])
    return ring


def _area(vertices: Floats, ring: list[int]) -> float:
    """Twice the signed area: an outer ring's is the only positive one."""
    p = vertices[ring] - vertices[ring[0]]
    q = np.roll(p, -1, axis=0)
    return float((p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]).sum())
