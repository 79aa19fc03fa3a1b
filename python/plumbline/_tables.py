"""Layers of features as geopandas takes them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from plumbline import _core

if TYPE_CHECKING:
    from geopandas import GeoDataFrame


def to_geodataframe(table: _core.Table, crs: str) -> GeoDataFrame:
    """A row for each feature, in order; numbers, texts or None in the columns."""
    try:
        import geopandas
    except ImportError as error:
        raise ImportError('this needs geopandas: pip install "plumbline-geometry[geo]"') from error
    columns = {name: table.values(i) for i, name in enumerate(table.columns)}
    return geopandas.GeoDataFrame(columns, geometry=_geometries(table), crs=crs or None)


def _geometries(table: _core.Table) -> Any:
    import shapely

    coords, parts, features = table.geometries()
    if table.geometry == "polygon":
        return shapely.from_ragged_array(shapely.GeometryType.POLYGON, coords, (parts, features))
    if table.geometry == "line":
        return shapely.from_ragged_array(shapely.GeometryType.LINESTRING, coords, (parts,))
    there = ~np.isnan(coords[:, 0])
    points = np.full(len(coords), None, dtype=object)
    points[there] = shapely.points(coords[there])
    return points
