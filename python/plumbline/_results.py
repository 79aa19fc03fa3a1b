"""Results of other programs, as files or in memory, as answers that can be checked.

What is in memory is given to the readers of result files, as the text that such a file has, so
that both mean the same.
"""

from __future__ import annotations

import json
import math
import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from plumbline import _core
from plumbline._geometries import as_geometries
from plumbline._json import dumped, loaded
from plumbline._numbers import exact_text
from plumbline.arrangement import Arrangement
from plumbline.errors import Error, FileError
from plumbline.line_inputs import ensure_utf8, feature_of, is_of_mappings, is_wkt

ResultLike = Any
"""What `check` takes as a result: see there."""


def answer_of_result(result: Any) -> _core.Answer:
    """What `check` takes as a result, but for engines."""
    if isinstance(result, Arrangement):
        return _core.result_of(result._core, "<arrangement>")
    if isinstance(result, os.PathLike):
        return _core.read_result(os.fspath(result))
    if isinstance(result, str):
        return _of_text(result)
    if hasattr(result, "__next__"):
        result = list(result)
    geometries = as_geometries(result)
    if geometries is not None:
        return _of_geometries(geometries, getattr(result, "index", None))
    if hasattr(result, "__geo_interface__"):
        return _of_mapping(result.__geo_interface__)
    if isinstance(result, Mapping):
        return _of_mapping(result)
    if is_of_mappings(result):
        features = [feature_of(value) for value in result]
        return _of_mapping({"type": "FeatureCollection", "features": features})
    if isinstance(result, tuple) and len(result) in (2, 3):
        return _of_cells(*result)
    if isinstance(result, (list, np.ndarray)):
        return _of_segments(result)
    raise Error(
        "a result is a path, geometries, (V, EV), (V, EV, FV), segments, an Arrangement or an "
        f"engine: {type(result).__name__}"
    )


def _of_text(text: str) -> _core.Answer:
    if os.path.exists(text):
        return _core.read_result(text)
    if text.lstrip()[:1] == "{":
        mapping = loaded(text, "a result")
        return _of_mapping(mapping, ensure_utf8(text))
    if is_wkt(text):
        return _core.read_result_text("wkt", ensure_utf8(text), "<wkt>")
    raise FileError(
        f"there is no such file, and this is no WKT, GeoJSON or LAR model: {text!r:.60}",
        text=text[:60],
    )


def _of_mapping(mapping: Mapping[str, Any], text: str | None = None) -> _core.Answer:
    if text is None:
        text = dumped(mapping, _plain)
    if "V" in mapping:
        return _core.read_result_text("lar", text, "<LAR model>")
    if "type" not in mapping:
        raise Error(f"a result is GeoJSON or a LAR model with V: {sorted(mapping)!r:.60}")
    return _core.read_result_text("geojson", text, "<geojson>")


def _plain(value: Any) -> Any:
    if hasattr(value, "tolist"):
        return value.tolist()
    raise Error(f"results have numbers, texts and lists: {type(value).__name__}")


def _of_geometries(geometries: NDArray[np.object_], index: Any) -> _core.Answer:
    """As a FeatureCollection with a geometry a line, whose decimals are the shortest ones that
    read back as the same doubles."""
    import shapely

    coords, item = shapely.get_coordinates(geometries, return_index=True)
    wrong = np.flatnonzero(~np.isfinite(coords).all(axis=1))
    if len(wrong):
        raise Error(f"geometry {item[wrong[0]]} of the result has coordinates that are not finite")
    ids = list(range(len(geometries))) if index is None or callable(index) else list(index)
    features = [
        f'{{"type":"Feature","id":{json.dumps(str(name))},"properties":null,"geometry":{text}}}'
        for name, text in zip(ids, shapely.to_geojson(geometries), strict=True)
        if text is not None
    ]
    text = '{"type":"FeatureCollection","features":[' + ",\n".join(features) + "]}"
    return _core.read_result_text("geojson", text, "<geometries>")


def _of_cells(vertices: Any, edges: Any, faces: Any = None) -> _core.Answer:
    """Of (V, EV) and (V, EV, FV), as the LAR model of these names."""
    model: dict[str, Any] = {"V": _points(vertices)}
    if edges is not None:
        model["EV"] = _indices(edges, "EV")
    if faces is not None:
        model["FV"] = _indices(faces, "FV")
    return _core.read_result_text("lar", json.dumps(model), "<LAR model>")


def _points(vertices: Any) -> list[list[float]]:
    try:
        rows = vertices.tolist() if isinstance(vertices, np.ndarray) else vertices
        points = [[_double(c) for c in row] for row in rows]
    except TypeError:
        raise Error(f"V is a sequence of points (x, y): {vertices!r:.60}") from None
    for i, point in enumerate(points):
        if len(point) not in (2, 3):
            raise Error(f"a point of V is (x, y): {point!r:.60}")
        if not all(math.isfinite(c) for c in point):
            raise Error(f"vertex {i} of the result is not finite: {point!r}")
    return points


def _double(value: Any) -> float:
    """Rounded to the nearest double, as results are read."""
    if isinstance(value, float):
        return value
    try:
        return _core.nearest_double(exact_text(value))
    except ValueError as error:
        raise Error(f"coordinates of V are numbers: {error}") from None


def _indices(cells: Any, name: str) -> list[list[int]]:
    try:
        return [[i.__index__() for i in cell] for cell in cells]
    except (TypeError, AttributeError):
        raise Error(f"{name} is a list of lists of indices of vertices: {cells!r:.60}") from None


def _of_segments(rows: Sequence[Any] | NDArray[Any]) -> _core.Answer:
    """Edges by their coordinates, (n, 4) or (n, 2, 2)."""
    try:
        array = np.asarray(rows, dtype=np.float64)
    except (TypeError, ValueError):
        raise Error(f"segments of a result are an array (n, 4): {rows!r:.60}") from None
    if array.size and array.shape[1:] not in ((4,), (2, 2)):
        raise Error(f"segments of a result are an array (n, 4) or (n, 2, 2): {array.shape}")
    if not np.isfinite(array).all():
        raise Error("segments of the result have coordinates that are not finite")
    text = json.dumps({"type": "MultiLineString", "coordinates": array.reshape(-1, 2, 2).tolist()})
    return _core.read_result_text("geojson", text, "<segments>")
