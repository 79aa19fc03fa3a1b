"""Line work of whatever holds it."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from decimal import Decimal
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from plumbline import _core
from plumbline._geometries import as_geometries, segments_of
from plumbline._json import dumped
from plumbline._numbers import Numbers, ensure_unmasked, exact_text, in_doubles
from plumbline.errors import Error, FileError

if TYPE_CHECKING:
    from collections.abc import Mapping
from plumbline.lines import Lines, LinesLike, _warn_of_losses


def lines(
    values: LinesLike,
    *,
    numbers: Numbers | None = None,
    points: Iterable[Sequence[Any]] | None = None,
    ids: Sequence[Any] | None = None,
    layers: Sequence[str] | None = None,
) -> Lines:
    """Line work of whatever holds it, exactly.

    Parameters
    ----------
    values : array, sequence, geometry, path or text
        - an array (n, 4) or (n, 2, 2) of floats or integers;
        - a sequence of segments ``(ax, ay, bx, by)`` or ``((ax, ay), (bx, by))`` of int, float,
          str ("1/3", "0.1"), Decimal or Fraction;
        - a shapely geometry, a sequence of them, a GeoSeries or GeoDataFrame (its index gives the
          ids, its column ``layer`` the layers, if there is one);
        - what has ``__geo_interface__``, and sequences of that;
        - the path of a drawing, as `read` takes it; well-known text, GeoJSON; bytes of WKB;
        - `Lines`, which are returned as they are; a `Region`, whose exact sides they are.
    numbers : {"doubles", "decimals"}, optional
        What a float stands for: the number that it is (0.1 is
        3602879701896397/36028797018963968), or the decimal that it prints as (0.1 is 1/10). By
        default doubles for arrays, geometries and floats, decimals for files and texts, where it
        is what is written.
    points : sequence of pairs, optional
        Isolated points.
    ids : sequence, optional
        Names of the items, for messages: of arrays, sequences and geometries; what is read has its
        own.
    layers : sequence of str, optional
        Layers of the items, of the same.

    Returns
    -------
    Lines
        Polygons give their sides; points of geometries are not drawn, and listed in `rejected`.

    Warns
    -----
    LossWarning
        Where something that looks like lines takes no part: coordinates that are not finite, or
        beyond 8.7e99; elements that a reader does not understand.

    Raises
    ------
    Error
        For what is none of these, an array of another shape, masked values, `ids` and `layers` of
        what is read, and as `read`.

    Examples
    --------
    >>> import plumbline
    >>> plumbline.lines([(0, 0, "1/3", 1)]).exact(0)
    ((Fraction(0, 1), Fraction(0, 1)), (Fraction(1, 3), Fraction(1, 1)))
    >>> plumbline.lines("LINESTRING (0 0, 1 0, 1 1)")
    <Lines: 2 segments of 1 items, floats as decimals>
    """
    values = getattr(values, "_as_lines", values)
    if isinstance(values, Lines):
        if numbers not in (None, values.numbers) or any(
            extra is not None for extra in (points, ids, layers)
        ):
            raise Error("these are lines already: make them with these options instead")
        return values
    if numbers not in (None, "doubles", "decimals"):
        raise Error(f'numbers are "doubles" or "decimals": {numbers!r}')
    if hasattr(values, "__next__"):
        values = list(values)
    try:
        ensure_unmasked(values)
    except ValueError as error:
        raise Error(str(error)) from None
    result = _lines_of(values, numbers, _texts(ids, "ids"), _texts(layers, "layers"))
    if points is not None:
        texts = [c for pair in point_texts(points, result.numbers) for c in pair]
        result._core.add_points(texts, "points")
    _warn_of_losses(result)
    return result


def point_texts(points: Any, numbers: Numbers) -> list[tuple[str, str]]:
    """Points as exact texts; a pair of numbers is one point.

    Raises
    ------
    Error
        For what is no sequence of points with finite coordinates.
    """
    try:
        rows = [points] if isinstance(points, str) else list(points)
        if len(rows) == 2 and all(isinstance(c, str) or not hasattr(c, "__iter__") for c in rows):
            rows = [rows]
        pairs = [_pair(row) for row in rows]
        texts = [(exact_text(x, numbers), exact_text(y, numbers)) for x, y in pairs]
        for pair in texts:
            for text in pair:
                _core.nearest_double(text)  # refuses what is no number
        return texts
    except (TypeError, ValueError) as error:
        if isinstance(error, Error):
            raise
        raise Error(f"points are pairs of finite numbers: {points!r:.60}: {error}") from None


def _lines_of(
    values: LinesLike, numbers: Numbers | None, ids: list[str], layers: list[str]
) -> Lines:
    whole = _of_whole(values, numbers)
    if whole is not None:
        for name, texts in (("ids", ids), ("layers", layers)):
            if texts:
                raise Error(f"{name} are of arrays, sequences and geometries; this has its own")
        return whole
    if isinstance(values, np.ndarray) and values.dtype != object:
        return _of_array(values, numbers, ids, layers)
    geometries = as_geometries(values)
    if geometries is not None:
        return _of_geometries(geometries, values, numbers, ids, layers)
    if is_of_mappings(values):
        return _of_mappings(values, numbers, ids, layers)
    if hasattr(values, "__array__") and not isinstance(values, (list, tuple)):
        array = np.asarray(values)
        if array.dtype != object:
            return _of_array(array, numbers, ids, layers)
        values = array.tolist()
    return _of_sequence(values, numbers, ids, layers)


def _of_whole(values: LinesLike, numbers: Numbers | None) -> Lines | None:
    """The lines of what names its items itself: a file, a text, a mapping, WKB."""
    if isinstance(values, (bytes, bytearray, memoryview)):
        options = _core.ReadOptions()
        return _evaluated(_core.read_wkb(bytes(values), "<wkb>", options), numbers)
    if isinstance(values, os.PathLike):
        from plumbline.drawing import read

        return read(values, numbers=numbers or "decimals")
    if isinstance(values, str):
        return _of_text(values, numbers)
    if isinstance(values, dict) and "type" in values:
        return _of_mapping(values, numbers)
    if as_geometries(values) is None and hasattr(values, "__geo_interface__"):
        return _of_mapping(values.__geo_interface__, numbers)
    return None


def is_of_mappings(values: Any) -> bool:
    """Whether these are several objects with `__geo_interface__`, or mappings as that has them."""
    if not isinstance(values, (list, tuple)) or not values:
        return False
    return all(
        hasattr(v, "__geo_interface__") or (isinstance(v, dict) and "type" in v) for v in values
    )


def feature_of(value: Any) -> dict[str, Any]:
    """An object with `__geo_interface__`, or a mapping as that has it, as a feature."""
    mapping = dict(getattr(value, "__geo_interface__", value))
    if mapping.get("type") == "Feature":
        return mapping
    if mapping.get("type") == "FeatureCollection":
        geometries = [feature.get("geometry") for feature in mapping.get("features", [])]
        parts = [geometry for geometry in geometries if geometry is not None]
        mapping = {"type": "GeometryCollection", "geometries": parts}
    return {"type": "Feature", "properties": {}, "geometry": mapping}


def _of_mappings(
    values: Sequence[Any], numbers: Numbers | None, ids: list[str], layers: list[str]
) -> Lines:
    features = [feature_of(value) for value in values]
    _ensure_as_many(len(features), ids, layers)
    for feature, name in zip(features, ids):
        feature["id"] = name
    for feature, layer in zip(features, layers):
        feature["properties"] = {**(feature.get("properties") or {}), "layer": layer}
    return _of_mapping({"type": "FeatureCollection", "features": features}, numbers)


def _ensure_as_many(count: int, ids: list[str], layers: list[str]) -> None:
    for name, texts in (("ids", ids), ("layers", layers)):
        if texts and len(texts) != count:
            raise Error(f"there are {count} items and {len(texts)} {name}")


def _evaluated(structure: _core.Structure, numbers: Numbers | None) -> Lines:
    return Lines(structure.evaluate(numbers == "doubles"), numbers or "decimals")


WKT = ("POINT", "LINESTRING", "LINEARRING", "POLYGON", "MULTI", "GEOMETRYC", "SRID=")
"""How well-known text begins."""


def is_wkt(text: str) -> bool:
    """Whether a text looks like well-known text."""
    start = text.lstrip()[:40].upper()
    return start.startswith(WKT) and ("(" in text or "EMPTY" in text.upper())


def ensure_utf8(text: str) -> str:
    """A text; an Error for one that cannot be written in UTF-8."""
    try:
        text.encode()
    except UnicodeEncodeError:
        raise Error(f"a text that is no Unicode: {text!a:.60}") from None
    return text


def _of_text(text: str, numbers: Numbers | None) -> Lines:
    from plumbline.drawing import read

    if os.path.exists(text):
        return read(text, numbers=numbers or "decimals")
    options = _core.ReadOptions()
    if text.lstrip()[:1] == "{":
        structure = _core.read_text("geojson", ensure_utf8(text).encode(), "<geojson>", options)
        return _evaluated(structure, numbers)
    if is_wkt(text):
        return _evaluated(
            _core.read_text("wkt", ensure_utf8(text).encode(), "<wkt>", options), numbers
        )
    raise FileError(
        f"there is no such file, and this is no WKT and no GeoJSON: {text!r:.60}",
        text=text[:60],
    )


def _of_mapping(mapping: Mapping[str, Any], numbers: Numbers | None) -> Lines:
    text = dumped(mapping, lambda array: np.asarray(array).tolist())
    structure = _core.read_text("geojson", text.encode(), "<geometry>", _core.ReadOptions())
    return _evaluated(structure, numbers or "doubles")


def are_beyond_doubles(array: NDArray[Any]) -> bool:
    """Whether an array has integers that no double need be."""
    if array.dtype.kind not in "iu" or not array.size:
        return False
    return int(array.max()) > 2**53 or int(array.min()) < -(2**53)


def _of_array(
    array: NDArray[Any], numbers: Numbers | None, ids: list[str], layers: list[str]
) -> Lines:
    if array.ndim == 3 and array.shape[1:] == (2, 2):
        array = array.reshape(-1, 4)
    if array.size == 0 and array.ndim != 2:
        array = array.reshape(0, 4)
    if array.ndim != 2 or array.shape[1] != 4:
        raise Error(f"an array (n, 4) or (n, 2, 2) is needed: {array.shape}")
    if array.dtype.kind not in "iuf":
        raise Error(f"an array of numbers is needed: {array.dtype}")
    if are_beyond_doubles(array):
        return _of_sequence(array.tolist(), numbers, ids, layers)
    try:
        coords = in_doubles(array, numbers)
    except ValueError as error:
        raise Error(str(error)) from None
    items = _core.Items("<array>", "row", None, len(coords), ids, layers, None)
    return _of_doubles(coords, items, numbers, len(coords), ids, layers)


def _of_doubles(
    coords: NDArray[np.float64],
    items: _core.Items,
    numbers: Numbers | None,
    count: int,
    ids: list[str],
    layers: list[str],
) -> Lines:
    _ensure_as_many(count, ids, layers)
    core = _core.SegmentSet.of_doubles(coords, items, numbers == "decimals")
    return Lines(core, numbers or "doubles")


def _of_geometries(
    geometries: NDArray[np.object_],
    values: Any,
    numbers: Numbers | None,
    ids: list[str],
    layers: list[str],
) -> Lines:
    if not ids and hasattr(values, "index") and not isinstance(values, (list, tuple)):
        ids = _texts(values.index, "ids")
    if not layers and "layer" in getattr(values, "columns", ()):
        column = values["layer"]
        layers = _texts(column.astype(object).where(column.notna(), ""), "layers")
    parts = segments_of(geometries)
    items = _core.Items(
        "<geometries>", "geometry", parts.item, len(geometries), ids, layers, parts.rings
    )
    result = _of_doubles(parts.coords, items, numbers, len(geometries), ids, layers)
    for i in parts.points.tolist():
        result._core.reject(i, "points are not drawn", True)
    crs = getattr(values, "crs", None)
    result._core.set_frame("" if crs is None else crs.to_string(), True)
    return result


def _of_sequence(values: Any, numbers: Numbers | None, ids: list[str], layers: list[str]) -> Lines:
    try:
        rows = [_four(row) for row in values]
    except TypeError:
        raise Error(
            "lines are an array (n, 4), a sequence of segments, geometries, a path or a text: "
            f"{type(values).__name__}"
        ) from None
    if rows and all(isinstance(c, float) for row in rows for c in row):
        return _of_array(np.array(rows, dtype=np.float64), numbers, ids, layers)
    _ensure_as_many(len(rows), ids, layers)
    chosen: Numbers = numbers or "doubles"
    wrong = [i for i, row in enumerate(rows) if any(_is_infinite(c) for c in row)]
    item = np.delete(np.arange(len(rows), dtype=np.uint32), wrong)
    try:
        texts = [exact_text(c, chosen) for i in item.tolist() for c in rows[i]]
    except ValueError as error:
        raise Error(str(error)) from None
    items = _core.Items("<sequence>", "row", item, len(rows), ids, layers, None)
    core = _core.SegmentSet.of_texts(texts, items)
    for i in wrong:
        core.reject(i, "coordinate is not a finite number", False)
    return Lines(core, chosen)


def _is_infinite(value: Any) -> bool:
    """Whether it is a number that is not finite."""
    if isinstance(value, Decimal):
        return not value.is_finite()
    return isinstance(value, (float, np.floating)) and not np.isfinite(value)


def _four(segment: Any) -> list[Any]:
    row = list(segment)
    if len(row) == 2:
        return [*_pair(row[0]), *_pair(row[1])]
    if len(row) != 4:
        raise Error(f"a segment is (ax, ay, bx, by) or ((ax, ay), (bx, by)): {row!r:.60}")
    return row


def _pair(point: Any) -> tuple[Any, Any]:
    if isinstance(point, str) or not hasattr(point, "__iter__"):
        raise Error(f"a point is (x, y): {point!r:.60}")
    coordinates = tuple(point)
    if len(coordinates) != 2:
        raise Error(f"a point is (x, y): {coordinates!r:.60}")
    return coordinates[0], coordinates[1]


def _texts(values: Iterable[Any] | None, what: str) -> list[str]:
    if values is None:
        return []
    if isinstance(values, (str, bytes)) or not hasattr(values, "__iter__"):
        raise Error(f"{what} are a sequence, one for each item: {values!r:.60}")
    return [ensure_utf8(str(value)) for value in values]
