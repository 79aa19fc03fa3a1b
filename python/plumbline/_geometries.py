"""Segments of shapely's geometries, all at once."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from numpy import object_

_POLYGON, _PART, _HOLE, _LINE = 0, 1, 2, 3  # roles of rings


@dataclass(frozen=True)
class GeometrySegments:
    """Segments (n, 4) in the order of geometries, each with the position of its geometry."""

    coords: NDArray[np.float64]
    item: NDArray[np.uint32]
    rings: NDArray[np.uint32]  # rows of first segment, count, role
    points: NDArray[np.intp]  # geometries that are, or have, points, which are not drawn


def segments_of(geometries: NDArray[object_]) -> GeometrySegments:
    """The sides and lines of geometries. Empty ones, and None, have none."""
    import shapely

    parts, item = _parts(geometries)
    kinds = shapely.get_type_id(parts)
    is_line = (kinds == 1) | (kinds == 2)
    polygons = np.flatnonzero(kinds == 3)
    rings, of_polygon = shapely.get_rings(parts[polygons], return_index=True)
    curves = np.concatenate([parts[is_line], rings])
    curve_item = np.concatenate([item[is_line], item[polygons][of_polygon]])
    lines = int(is_line.sum())
    role = np.full(len(curves), _LINE, dtype=np.uint32)
    role[lines:] = _ring_roles(item[polygons], of_polygon)
    is_ring = np.ones(len(curves), dtype=bool)
    is_ring[:lines] = shapely.is_closed(curves[:lines])

    order = np.argsort(curve_item, kind="stable")
    curves, curve_item, role, is_ring = (
        values[order] for values in (curves, curve_item, role, is_ring)
    )
    coords, of_curve = shapely.get_coordinates(curves, return_index=True)
    joined = of_curve[1:] == of_curve[:-1]
    segments = np.hstack([coords[:-1], coords[1:]])[joined]
    curve = of_curve[:-1][joined]
    counts = np.bincount(curve, minlength=len(curves))
    first = np.concatenate([[0], np.cumsum(counts)[:-1]]) if len(counts) else counts
    return GeometrySegments(
        coords=np.ascontiguousarray(segments, dtype=np.float64),
        item=curve_item[curve].astype(np.uint32),
        rings=np.ascontiguousarray(
            np.column_stack([first, counts, role])[is_ring & (counts > 0)], dtype=np.uint32
        ),
        points=np.unique(item[kinds == 0]),
    )


def _parts(geometries: NDArray[object_]) -> tuple[NDArray[object_], NDArray[np.intp]]:
    """Points, lines and polygons of all collections, and of which geometry each is."""
    import shapely

    parts = geometries
    item = np.arange(len(geometries), dtype=np.intp)
    while (shapely.get_type_id(parts) >= 4).any():
        parts, of = shapely.get_parts(parts, return_index=True)
        item = item[of]
    there = ~shapely.is_missing(parts)
    return parts[there], item[there]


def _ring_roles(item: NDArray[np.intp], of_polygon: NDArray[np.intp]) -> NDArray[np.uint32]:
    """Of rings: the first of a polygon is its outer one, of an item's second polygon a part."""
    roles = np.full(len(of_polygon), _HOLE, dtype=np.uint32)
    outer = np.flatnonzero(np.diff(of_polygon, prepend=-1))
    polygon = of_polygon[outer]
    is_part = polygon > 0
    is_part[is_part] = item[polygon[is_part]] == item[polygon[is_part] - 1]
    roles[outer] = np.where(is_part, _PART, _POLYGON)
    return roles


def as_geometries(values: Any) -> NDArray[object_] | None:
    """Values as an array of shapely geometries; None where they are something else."""
    try:
        import shapely
    except ImportError:
        return None
    if isinstance(values, shapely.Geometry):
        return np.array([values], dtype=object)
    if hasattr(values, "geometry") and hasattr(values, "crs"):  # GeoDataFrame, GeoSeries
        return np.asarray(values.geometry.array, dtype=object)
    if hasattr(values, "dtype") and str(values.dtype) == "geometry":  # GeometryArray
        return np.asarray(values, dtype=object)
    if hasattr(values, "dtype") and values.dtype == object and hasattr(values, "to_numpy"):
        values = values.to_numpy()  # a Series
    if isinstance(values, (list, tuple)) or (
        isinstance(values, np.ndarray) and values.dtype == object and values.ndim == 1
    ):
        flat = np.empty(len(values), dtype=object)
        flat[:] = list(values)
        if (len(flat) or isinstance(values, np.ndarray)) and all(
            v is None or isinstance(v, shapely.Geometry) for v in flat
        ):
            return flat
    return None
