"""Faces as polygons, and as triangles."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plumbline import _core
from plumbline._arguments import arrangement_of
from plumbline._optional import needed
from plumbline.arrangement import Arrangement
from plumbline.lines import LinesLike


@dataclass(frozen=True)
class FacePolygons:
    """Bounded faces as valid polygons, flat, as Arrow and `shapely.from_ragged_array` have them.

    The outer ring of a polygon runs counter-clockwise, holes clockwise; each ring begins at its
    least vertex. Edges that end within a face are left out. All arrays are read-only.
    """

    vertices: NDArray[np.uint32]
    """Rings of vertices, the first of each repeated at its end."""
    coords: NDArray[np.float64]
    """The same as coordinates, (N, 2): doubles that are proven to be valid."""
    ring_offsets: NDArray[np.int64]
    """Where each ring starts in these, and where the last one ends."""
    polygon_offsets: NDArray[np.int64]
    """Where each polygon starts in rings, and where the last one ends; its outer ring is first."""
    face: NDArray[np.uint32]
    """The face of each polygon, ascending."""

    def __len__(self) -> int:
        return len(self.face)

    def __repr__(self) -> str:
        return f"<FacePolygons: {len(self)} polygons, {len(self.ring_offsets) - 1} rings>"

    def to_shapely(self) -> NDArray[np.object_]:
        """An array of shapely's polygons."""
        shapely = needed("shapely")
        if not len(self):
            return np.empty(0, dtype=object)
        geometries: NDArray[np.object_] = shapely.from_ragged_array(
            shapely.GeometryType.POLYGON, self.coords, (self.ring_offsets, self.polygon_offsets)
        )
        return geometries


def polygons_of(core: _core.Complex, coords: NDArray[np.float64]) -> FacePolygons:
    """The polygons of a complex whose vertices have these coordinates."""
    vertices, ring_offsets, polygon_offsets, face = _core.polygon_rings(core)
    placed = coords[vertices]
    placed.flags.writeable = False
    return FacePolygons(vertices, placed, ring_offsets, polygon_offsets, face)


class Triangles(NamedTuple):
    """Triangles of faces."""

    vertices: NDArray[np.uint32]
    """Rows of three vertices, counter-clockwise, the least one first, (T, 3)."""
    face: NDArray[np.uint32]
    """The face of each, (T,)."""


def triangulate(arrangement: Arrangement | LinesLike, face: int | None = None) -> Triangles:
    """Triangles that fill bounded faces: constrained Delaunay triangulations, exactly.

    Parameters
    ----------
    arrangement : Arrangement, or line work as `arrange` takes it
    face : int, optional
        Of this bounded face alone; by default of all.

    Returns
    -------
    Triangles
        By face, then ascending. Holes are left out; edges that end within a face take no part.

    Raises
    ------
    Error
        For a face that is not there, or the unbounded one.

    Examples
    --------
    >>> import plumbline
    >>> square = plumbline.arrange([(0, 0, 1, 0), (1, 0, 1, 2), (1, 2, 0, 1), (0, 1, 0, 0)])
    >>> plumbline.triangulate(square).vertices.tolist()
    [[0, 2, 1], [1, 2, 3]]
    """
    of = arrangement_of(arrangement)
    chosen = None if face is None else of._bounded(face)
    return Triangles(*_core.triangulate(of._core, chosen))
