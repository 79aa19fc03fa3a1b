"""Attributes of layers' features, for what is made of several of them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from plumbline._optional import needed


def labels_of(layer: Any) -> list[Any] | None:
    index = getattr(layer, "index", None)
    return None if index is None or callable(index) else list(index)


def named(labels: list[Any] | None, items: Sequence[int]) -> list[Any]:
    return list(items) if labels is None else [labels[i] for i in items]


def attributes_of(layer: Any) -> dict[str, Any]:
    """The columns of a GeoDataFrame but for its geometries."""
    if not hasattr(layer, "columns") or not hasattr(layer, "geometry"):
        return {}
    return {name: layer[name] for name in layer.columns if name != layer.geometry.name}


def joined_values(values: Any, of_rows: Sequence[Sequence[int]]) -> Any:
    """A column of values of the one item of each row, of all where there are several; missing
    where there is none."""
    if all(len(items) <= 1 for items in of_rows):
        place = np.array([items[0] if items else -1 for items in of_rows], dtype=np.intp)
        if (place < 0).any():
            return needed("pandas").api.extensions.take(values.array, place, allow_fill=True)
        return values.array.take(place)
    known = values.tolist()
    return [
        None if not items else known[items[0]] if len(items) == 1 else [known[i] for i in items]
        for items in of_rows
    ]
