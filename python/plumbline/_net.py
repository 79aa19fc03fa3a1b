"""Line work noded, and its edges by what they are: what shapely's functions tell apart."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from plumbline import _core
from plumbline._geometries import as_geometries
from plumbline._numbers import Numbers
from plumbline._optional import needed
from plumbline._warnings import warn_of_loss
from plumbline.arrangement import arrange
from plumbline.errors import Error
from plumbline.exports import rows_of
from plumbline.lines import LinesLike
from plumbline.lists import Lists
from plumbline.sourced import Sourced


def _nothing(kind: str) -> Sourced:
    empty = np.zeros(1, dtype=np.uint32)
    return Sourced(np.empty(0, dtype=object), Lists(empty, empty[:0]), kind)


def _geometries(values: LinesLike) -> NDArray[np.object_] | None:
    """Values as an array of geometries; None where they are something else, as Lines are."""
    return None if hasattr(values, "_core") else as_geometries(values)


def curves_of(geometries: NDArray[np.object_]) -> tuple[NDArray[np.object_], NDArray[np.intp]]:
    """Their lines and rings, and the position of each one's geometry; of a single collection
    that of its part."""
    import shapely

    item = np.arange(len(geometries))
    if len(geometries) == 1 and shapely.get_type_id(geometries[0]) >= 4:
        geometries = shapely.get_parts(geometries)
        item = np.arange(len(geometries))
    while (shapely.get_type_id(geometries) >= 4).any():
        geometries, of = shapely.get_parts(geometries, return_index=True)
        item = item[of]
    is_polygon = shapely.get_type_id(geometries) == 3
    rings, of = shapely.get_rings(geometries[is_polygon], return_index=True)
    is_line = np.isin(shapely.get_type_id(geometries), (1, 2))
    curves = np.concatenate([geometries[is_line], rings])
    item = np.concatenate([item[is_line], item[is_polygon][of]])
    order = np.argsort(item, kind="stable")
    return curves[order], item[order]


def curves_that_are_not_finite(curves: NDArray[np.object_]) -> NDArray[np.bool_]:
    """Which have coordinates that are no finite numbers."""
    import shapely

    coords, curve = shapely.get_coordinates(curves, return_index=True)
    result = np.zeros(len(curves), dtype=bool)
    result[curve[~np.isfinite(coords).all(axis=1)]] = True
    return result


class _Net:
    """Line work, arranged and rounded, as lines between nodes: the halfedges of the rounded
    arrangement in the order and the directions of the input."""

    def __init__(self, values: LinesLike, numbers: Numbers | None) -> None:
        values = list(values) if hasattr(values, "__next__") else values
        geometries = _geometries(values)
        if geometries is None:
            self.arrangement = arrange(values, numbers=numbers)
            self._curve = np.arange(len(self.arrangement.lines))
            self._item: NDArray[np.intp] | None = None
        else:
            curves, self._item = curves_of(geometries)
            self.arrangement = arrange(curves, numbers=numbers)
            self._curve = self.arrangement.lines.item.astype(np.intp)
        self.rounded = self.arrangement.rounded()
        self._halfedges = self._in_order()
        self._find_lines()

    def _in_order(self) -> NDArray[np.intp]:
        """Halfedges, each edge once: along the first segment of each, segment by segment."""
        a, r = self.arrangement, self.rounded
        if not a.counts.edges:
            return np.empty(0, dtype=np.intp)
        owner = a.edge_segments.indices[a.edge_segments.indptr[:-1]]
        up = _core.ascending(a.lines._core)[owner] == 1
        edge = np.arange(a.counts.edges)
        order = np.lexsort((np.where(up, edge, -edge), owner))
        images = rows_of(r.edge_image, order)
        lengths = images.lengths
        against = np.repeat(~up[order], lengths)
        start = np.repeat(images.indptr[:-1].astype(np.intp), lengths)
        end = np.repeat(images.indptr[1:].astype(np.intp), lengths)
        position = np.arange(len(images.indices))
        halfedges = images.indices[np.where(against, start + end - 1 - position, position)]
        halfedges = halfedges.astype(np.intp) ^ against
        _, once = np.unique(halfedges >> 1, return_index=True)
        result: NDArray[np.intp] = halfedges[np.sort(once)]
        return result

    def _find_lines(self) -> None:
        """Cuts the sequence of halfedges where a line ends or something else meets it."""
        r, h = self.rounded, self._halfedges
        ends = r.edges.astype(np.intp)[h >> 1]
        against = (h & 1).astype(bool)
        self._from = np.where(against, ends[:, 1], ends[:, 0])
        self._to = np.where(against, ends[:, 0], ends[:, 1])
        degree = np.bincount(r.edges.reshape(-1), minlength=r.counts.vertices)
        alone = r.edge_segments.lengths[h >> 1] == 1
        segment = r.edge_segments.indices[r.edge_segments.indptr[:-1][h >> 1]].astype(np.intp)
        curve = self._curve[segment]
        step = np.diff(segment)
        goes_on = (
            (self._to[:-1] == self._from[1:])
            & (degree[self._to[:-1]] == 2)
            & (alone[:-1] & alone[1:])
            & (curve[:-1] == curve[1:])
            & ((step == 0) | (step == 1))
        )
        self._starts = np.flatnonzero(np.concatenate([[True], ~goes_on])[: len(h)])
        self.first = h[self._starts] >> 1  # the first edge of each line

    def lines(self, chosen: NDArray[np.intp], kind: str) -> Sourced:
        """Those lines as geometries."""
        if not len(chosen):
            return _nothing(kind)
        shapely = needed("shapely")
        bounds = np.append(self._starts, len(self._halfedges))
        counts = np.diff(bounds)[chosen]
        offsets = np.concatenate([[0], np.cumsum(counts + 1)])
        line = np.repeat(np.arange(len(chosen)), counts + 1)
        along = np.arange(offsets[-1]) - offsets[line]
        halfedge = bounds[:-1][chosen][line] + along
        vertex = np.where(along == 0, self._from[halfedge - (along > 0)], self._to[halfedge - 1])
        geometries = shapely.from_ragged_array(
            shapely.GeometryType.LINESTRING, self.rounded.vertices[vertex], (offsets,)
        )
        return Sourced(geometries, self._items(self.rounded.sources, self.first[chosen]), kind)

    def polygons(self) -> Sourced:
        """The bounded faces."""
        base, _ = self.arrangement._placed()
        polygons = self.arrangement.polygons
        sources = self._items(base.face_sources, polygons.face)
        return Sourced(polygons.to_shapely(), sources, "geometrycollections")

    def _items(self, curves: Lists, rows: NDArray[Any]) -> Lists:
        """Lists of curves as lists of items, each once. Items ascend as their curves do."""
        chosen = rows_of(curves, rows)
        if self._item is None or not len(chosen.indices):
            return chosen
        items = self._item[chosen.indices].astype(np.uint32)
        row = np.repeat(np.arange(len(chosen)), chosen.lengths)
        again = np.append(False, (items[1:] == items[:-1]) & (row[1:] == row[:-1]))
        counts = np.bincount(row[~again], minlength=len(chosen))
        indptr = np.concatenate([[0], np.cumsum(counts)]).astype(np.uint32)
        return Lists(indptr, items[~again])

    def antennas(self) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """Per edge of the rounded arrangement whether the same face is on both sides; whether it
        goes when what has a free end is taken away, again and again."""
        r = self.rounded
        antenna = np.zeros(r.counts.edges, dtype=bool)
        antenna[r.antennas] = True
        degree = np.bincount(r.edges.reshape(-1), minlength=r.counts.vertices)
        dangles = _free_ends(r.edges[r.antennas], degree)
        dangle = np.zeros(r.counts.edges, dtype=bool)
        dangle[r.antennas[dangles]] = True
        return antenna, dangle

    def refuse_meetings(self, item: NDArray[np.intp]) -> None:
        """Takes `item` for that of each curve. Raises Error where curves meet elsewhere than in
        their ends: then one is cut, or an edge is of several."""
        self._item = item
        curve = self._curve[self.rounded.edge_segments.indices[self._first_cover()]]
        cut = np.flatnonzero(np.bincount(curve) > 1)
        shared = self.arrangement.edge_segments
        several = shared.indices[shared.indptr[:-1][shared.lengths > 1]]
        for bad in [*cut, *self._curve[several]]:
            raise Error(
                f"geometry {item[bad]} meets others elsewhere than in its ends: leave out `noded`"
            )

    def _first_cover(self) -> NDArray[Any]:
        """Per line the position of the first segment that covers it."""
        starts: NDArray[Any] = self.rounded.edge_segments.indptr[:-1][self.first]
        return starts


def _free_ends(edges: NDArray[Any], degree: NDArray[np.intp]) -> list[int]:
    """Which of these edges go when those with an end of degree 1 are taken away, again and again.
    Of `degree` others have a part that stays."""
    edges_at: dict[int, set[int]] = {}
    pairs = edges.tolist()
    for e, (a, b) in enumerate(pairs):
        edges_at.setdefault(a, set()).add(e)
        edges_at.setdefault(b, set()).add(e)
    left = {v: int(degree[v]) for v in edges_at}
    free = [v for v in edges_at if left[v] == 1]
    gone = []
    while free:
        v = free.pop()
        if left[v] != 1:
            continue
        (e,) = edges_at[v]
        gone.append(e)
        for end in pairs[e]:
            edges_at[end].discard(e)
            left[end] -= 1
            if left[end] == 1:
                free.append(end)
    return sorted(gone)


def _of_noded(
    values: LinesLike, numbers: Numbers | None
) -> tuple[Sourced, Sourced, Sourced, Sourced]:
    """`polygonize_full` of lines that are joined at their ends alone."""
    geometries = _geometries(list(values) if hasattr(values, "__next__") else values)
    if geometries is None:
        raise Error(f"noded lines are geometries: {type(values).__name__}")
    import shapely

    curves, item = curves_of(geometries)
    wrong = curves_that_are_not_finite(curves)
    if wrong.any():
        count = "one line takes" if wrong.sum() == 1 else f"{wrong.sum()} lines take"
        first = item[np.flatnonzero(wrong)[0]]
        warn_of_loss(
            f"{count} no part; the first, of geometry {first}: coordinate is not a finite number"
        )
    there = ~wrong & (shapely.length(curves) > 0)
    curves, item = curves[there], item[there]
    ends = np.concatenate([shapely.get_point(curves, 0), shapely.get_point(curves, -1)])
    _, point = np.unique(shapely.get_coordinates(ends), axis=0, return_inverse=True)
    edges = point.reshape(2, -1).T
    degree = np.bincount(edges.reshape(-1))
    dangles = np.array(_free_ends(edges, degree), dtype=np.intp)
    kept = np.setdiff1d(np.arange(len(curves)), dangles)
    net = _Net(curves[kept], numbers)
    net.refuse_meetings(item[kept])
    antenna, _ = net.antennas()
    cut = np.flatnonzero(antenna[net.first])
    kind = "geometrycollections"
    each = np.arange(len(dangles) + 1, dtype=np.uint32)
    nowhere = Sourced(curves[dangles], Lists(each, item[dangles].astype(np.uint32)), kind)
    return net.polygons(), net.lines(cut, kind), nowhere, _nothing(kind)
