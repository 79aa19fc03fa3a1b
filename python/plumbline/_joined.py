"""Line work with its drift joined, as lines of its own."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

import numpy as np

from plumbline import _core
from plumbline.arrangement import Arrangement
from plumbline.errors import InternalError
from plumbline.lines import ExactPoint, Lines
from plumbline.lists import Lists
from plumbline.points import Points

_TEXT = -1  # instead of a count of digits: the number is a text


def joined_arrangement(of: Lines, joined: _core.Complex) -> Arrangement:
    """The arrangement `joined`, whose edges are covered by segments of `of` that were bent, as one
    of lines that are bent.

    Raises
    ------
    InternalError
        Where these lines have another arrangement.
    """
    lines = _bent(of, joined)
    core = _core.arrange(lines._core, False, 0, None)
    if core.signature() != joined.signature():
        raise InternalError("the drawing with its drift joined has another arrangement")
    return Arrangement(core, lines)


def _bent(of: Lines, joined: _core.Complex) -> Lines:
    """The segments as they are in `joined`: each that was bent as its edges, from end to end."""
    state: Any = of._core.__getstate__()
    files, sources, (mantissas, digits, texts), item, rounding, rest = state
    mantissas, digits = mantissas.reshape(-1, 4), digits.reshape(-1, 4)
    points = Points(joined)
    ends = joined.edges().tolist()
    rows: list[Any] = []
    counts = np.zeros(len(of), dtype=np.intp)
    texts = list(texts)
    for s, edges in enumerate(_edges_of_segments(joined, len(of))):
        pieces = _pieces(of.exact(s), [ends[e] for e in edges], points)
        if pieces is None:
            rows.append((mantissas[s], digits[s]))
            counts[s] = 1
            continue
        for a, b in pieces:
            numbers = [c for v in (a, b) for c in points[v]]
            rows.append((np.arange(4) + len(texts), np.full(4, _TEXT)))
            texts += [f"{c.numerator:x}/{c.denominator:x}" for c in numbers]
        counts[s] = len(pieces)
    starts = np.concatenate([[0], np.cumsum(counts)])
    rings = [(int(starts[f]), int(starts[f + n] - starts[f]), role) for f, n, role in rest[0]]
    numbers_state = (
        np.array([row for row, _ in rows], dtype=np.int64).reshape(-1),
        np.array([row for _, row in rows], dtype=np.int8).reshape(-1),
        texts,
    )
    core = _core.SegmentSet.__new__(_core.SegmentSet)
    if len(rounding):
        rounding = np.repeat(rounding, counts)
    core.__setstate__(
        (files, sources, numbers_state, np.repeat(item, counts), rounding, (rings, *rest[1:]))
    )
    return Lines(core, of.numbers)


def _edges_of_segments(joined: _core.Complex, count: int) -> list[list[int]]:
    starts, segments = joined.edge_sources()
    edge = np.repeat(np.arange(len(starts) - 1), Lists(starts, segments).lengths)
    result: list[list[int]] = [[] for _ in range(count)]
    for e, s in zip(edge.tolist(), segments.tolist()):
        result[s].append(e)
    return result


def _pieces(
    segment: tuple[ExactPoint, ExactPoint], edges: Sequence[Sequence[int]], points: Points
) -> list[tuple[int, int]] | None:
    """A segment's edges in its direction, as pairs of vertices; None where it was not bent."""
    (ax, ay), (bx, by) = segment
    if (ax, ay) == (bx, by):
        return None
    x, y = bx - ax, by - ay
    along: dict[int, Fraction] = {}
    is_straight = True
    for v in {v for edge in edges for v in edge}:
        px, py = points[v]
        along[v] = (px - ax) * x + (py - ay) * y
        is_straight = is_straight and (px - ax) * y == (py - ay) * x
    length = x * x + y * y
    reaches = along and min(along.values()) == 0 and max(along.values()) == length
    if is_straight and reaches:
        return None
    directed = [(a, b) if along[a] < along[b] else (b, a) for a, b in edges]
    return sorted(directed, key=lambda piece: along[piece[0]])
