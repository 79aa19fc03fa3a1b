"""Layers of points as GeoDataFrames."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import geopandas


def point_frame(
    columns: list[tuple[str, list[Any]]], coords: NDArray[np.float64], crs: str
) -> geopandas.GeoDataFrame:
    """A row for each point; None where one has no place. Counts stay integers where some are not
    known."""
    import geopandas
    import pandas
    import shapely

    data = {name: _column(pandas, values) for name, values in columns}
    geometry = np.full(len(coords), None, dtype=object)
    there = ~np.isnan(coords).any(axis=1)
    geometry[there] = shapely.points(coords[there])
    return geopandas.GeoDataFrame(data, geometry=geometry, crs=crs or None)


def _column(pandas: Any, values: list[Any]) -> Any:
    kinds = {type(value) for value in values} - {type(None)}
    if kinds == {int} and None in values:
        return pandas.array(values, dtype="Int64")
    is_float = kinds <= {float} and len(values) > 0
    return pandas.Series(values, dtype="float64" if is_float else object if str in kinds else None)
