"""Line work: exact segments, each with the item that it came from."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from plumbline import _core
from plumbline._cached import cached
from plumbline._geometries import as_geometries, segments_of
from plumbline._numbers import Numbers, exact_text
from plumbline._warnings import warn_of_loss
from plumbline.errors import Error

if TYPE_CHECKING:
    from collections.abc import Mapping

ExactPoint = tuple[Fraction, Fraction]
LinesLike = Any
"""What `lines` takes: see there."""


class Lines:
    """Exact segments, each with the item of the input that it came from.

    Made by `plumbline.lines` and `plumbline.read`. Immutable.

    See Also
    --------
    plumbline.lines, plumbline.read
    """

    def __init__(self, core: _core.SegmentSet, numbers: Numbers) -> None:
        self._core = core
        self._numbers: Numbers = numbers

    @property
    def numbers(self) -> Numbers:
        """Whether floats of the input stand for the numbers that they are ("doubles") or for the
        decimals that they print as."""
        return self._numbers

    def __len__(self) -> int:
        return len(self._core)

    def __iter__(self) -> Iterator[tuple[ExactPoint, ExactPoint]]:
        for i in range(len(self)):
            yield self.exact(i)

    def exact(self, i: int) -> tuple[ExactPoint, ExactPoint]:
        """The ends of segment `i` as Fractions."""
        ax, ay, bx, by = self._core.segment(range(len(self))[i])
        return (ax, ay), (bx, by)

    @cached
    def coords(self) -> NDArray[np.float64]:
        """Segments as rows ax, ay, bx, by, correctly rounded to nearest doubles. (n, 4),
        read-only."""
        return self._core.coords()

    @cached
    def item(self) -> NDArray[np.uint32]:
        """Per segment the position of its item: row of the array, geometry of the series, element
        of the drawing. (n,), read-only."""
        return self._core.item()

    @property
    def item_count(self) -> int:
        """How many items the input has; some may have no segment."""
        return self._core.source_count()

    def source(self, i: int) -> _core.Source:
        """Of item `i` the place in its file, layer, id."""
        return self._core.source(range(self.item_count)[i])

    def source_text(self, i: int) -> str:
        """The same as a text: "plan.dxf:312 LINE 2F (A-WALL)"."""
        return self._core.source_text(range(self.item_count)[i])

    @property
    def rejected(self) -> list[_core.Rejected]:
        """Items that take no part, and why."""
        return self._core.rejected

    @property
    def remarks(self) -> list[_core.Remark]:
        """What is to be said of items that were drawn."""
        return self._core.remarks

    @property
    def ledger(self) -> list[_core.Replacement]:
        """What was replaced on the way to exact numbers: curves by chords, angles by rational
        rotations. Empty where every number is exactly what the input says."""
        return self._core.ledger

    @property
    def labels(self) -> list[_core.Label]:
        """Texts of the drawing."""
        return self._core.labels

    @property
    def layers(self) -> list[_core.Layer]:
        """Layers that the drawing declares."""
        return self._core.layers

    @property
    def files(self) -> list[str]:
        """Names of the files; of an array its title."""
        return self._core.files

    @property
    def crs(self) -> str:
        """Name of the reference system, or ""."""
        return self._core.crs

    @property
    def unit(self) -> _core.LengthUnit | None:
        """The unit of length, where the input says it."""
        return self._core.unit

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """The box of what is not stray: xmin, ymin, xmax, ymax."""
        return self._core.extent()

    def on_layers(self, *patterns: str) -> Lines:
        """Those segments alone that lie on layers of these names; ``*`` and ``?`` stand for any
        characters, in any case.

        Raises
        ------
        Error
            For a pattern that no layer has.
        """
        return Lines(self._core.on_layers(list(patterns)), self.numbers)

    def to_shapely(self) -> NDArray[np.object_]:
        """Each segment as a LineString of nearest doubles."""
        import shapely

        return np.asarray(shapely.linestrings(self.coords.reshape(-1, 2, 2)), dtype=object)

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        return {"type": "MultiLineString", "coordinates": self.coords.reshape(-1, 2, 2).tolist()}

    def _repr_svg_(self) -> str:
        from plumbline._pictures import lines_picture

        return lines_picture(self)

    def __getstate__(self) -> tuple[_core.SegmentSet, Numbers]:
        return self._core, self._numbers

    def __setstate__(self, state: tuple[_core.SegmentSet, Numbers]) -> None:
        self._core, self._numbers = state

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {len(self)} segments of {self.item_count} items, " + (
            f"floats as {self.numbers}>"
        )


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
        - what has ``__geo_interface__``;
        - the path of a drawing, as `read` takes it; well-known text, GeoJSON; bytes of WKB;
        - `Lines`, which are returned as they are.
    numbers : {"doubles", "decimals"}, optional
        What a float stands for: the number that it is (0.1 is
        3602879701896397/36028797018963968), or the decimal that it prints as (0.1 is 1/10). By
        default doubles for arrays, geometries and floats, decimals for files and texts, where it
        is what is written.
    points : sequence of pairs, optional
        Isolated points.
    ids : sequence, optional
        Names of the items, for messages.
    layers : sequence of str, optional
        Layers of the items.

    Returns
    -------
    Lines
        Polygons give their sides; points of geometries are not drawn, and listed in `rejected`.

    Warns
    -----
    LossWarning
        Where something that looks like lines takes no part: coordinates that are not finite,
        elements that a reader does not understand.

    Raises
    ------
    Error
        For what is none of these, an array of another shape, and as `read`.

    Examples
    --------
    >>> import plumbline
    >>> plumbline.lines([(0, 0, "1/3", 1)]).exact(0)
    ((Fraction(0, 1), Fraction(0, 1)), (Fraction(1, 3), Fraction(1, 1)))
    >>> plumbline.lines("LINESTRING (0 0, 1 0, 1 1)")
    <Lines: 2 segments of 1 items, floats as decimals>
    """
    if isinstance(values, Lines):
        if numbers not in (None, values.numbers) or any(
            extra is not None for extra in (points, ids, layers)
        ):
            raise Error("these are lines already: make them with these options instead")
        return values
    if numbers not in (None, "doubles", "decimals"):
        raise Error(f'numbers are "doubles" or "decimals": {numbers!r}')
    result = _lines_of(values, numbers, _texts(ids), _texts(layers))
    if points is not None:
        texts = [exact_text(c, result.numbers) for point in points for c in _pair(point)]
        result._core.add_points(texts, "points")
    _warn_of_losses(result)
    return result


def _lines_of(
    values: LinesLike, numbers: Numbers | None, ids: list[str], layers: list[str]
) -> Lines:
    if isinstance(values, (bytes, bytearray)):
        options = _core.ReadOptions()
        return _evaluated(_core.read_wkb(bytes(values), "<wkb>", options), numbers)
    if isinstance(values, os.PathLike):
        from plumbline.drawing import read

        return read(values, numbers=numbers or "decimals")
    if isinstance(values, str):
        return _of_text(values, numbers)
    if isinstance(values, np.ndarray) and values.dtype != object:
        return _of_array(values, numbers, ids, layers)
    geometries = as_geometries(values)
    if geometries is not None:
        return _of_geometries(geometries, values, numbers, ids, layers)
    if hasattr(values, "__geo_interface__"):
        return _of_mapping(values.__geo_interface__, numbers)
    if isinstance(values, dict) and "type" in values:
        return _of_mapping(values, numbers)
    if hasattr(values, "__array__") and not isinstance(values, (list, tuple)):
        return _of_array(np.asarray(values), numbers, ids, layers)
    return _of_sequence(values, numbers, ids, layers)


def _evaluated(structure: _core.Structure, numbers: Numbers | None) -> Lines:
    return Lines(structure.evaluate(numbers == "doubles"), numbers or "decimals")


def _of_text(text: str, numbers: Numbers | None) -> Lines:
    start = text.lstrip()[:40].upper()
    options = _core.ReadOptions()
    if start.startswith("{"):
        return _evaluated(_core.read_text("geojson", text, "<geojson>", options), numbers)
    is_wkt = any(
        start.startswith(word)
        for word in ("POINT", "LINESTRING", "LINEARRING", "POLYGON", "MULTI", "GEOMETRYC", "SRID=")
    )
    if is_wkt and ("(" in text or "EMPTY" in text.upper()):
        return _evaluated(_core.read_text("wkt", text, "<wkt>", options), numbers)
    from plumbline.drawing import read

    return read(text, numbers=numbers or "decimals")


def _of_mapping(mapping: Mapping[str, Any], numbers: Numbers | None) -> Lines:
    text = json.dumps(mapping, default=lambda array: np.asarray(array).tolist())
    structure = _core.read_text("geojson", text, "<geometry>", _core.ReadOptions())
    return _evaluated(structure, numbers or "doubles")


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
    if array.dtype.kind in "iu" and array.size and np.abs(array).max() > 2**53:
        return _of_sequence(array.tolist(), numbers, ids, layers)
    if array.dtype.kind == "f" and array.dtype.itemsize > 8:
        raise Error(f"doubles are needed, which {array.dtype} is more than")
    coords = np.ascontiguousarray(array, dtype=np.float64)
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
    for name, texts in (("ids", ids), ("layers", layers)):
        if texts and len(texts) != count:
            raise Error(f"there are {count} items and {len(texts)} {name}")
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
        ids = [str(i) for i in values.index]
    if not layers and "layer" in getattr(values, "columns", ()):
        layers = ["" if layer is None else str(layer) for layer in values["layer"]]
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
    for name, texts in (("ids", ids), ("layers", layers)):
        if texts and len(texts) != len(rows):
            raise Error(f"there are {len(rows)} items and {len(texts)} {name}")
    chosen: Numbers = numbers or "doubles"
    try:
        texts = [exact_text(c, chosen) for row in rows for c in row]
    except ValueError as error:
        raise Error(str(error)) from None
    items = _core.Items("<sequence>", "row", None, len(rows), ids, layers, None)
    return Lines(_core.SegmentSet.of_texts(texts, items), chosen)


def _four(segment: Any) -> list[Any]:
    row = list(segment)
    if len(row) == 2:
        return [*_pair(row[0]), *_pair(row[1])]
    if len(row) != 4:
        raise Error(f"a segment is (ax, ay, bx, by) or ((ax, ay), (bx, by)): {row!r:.60}")
    return row


def _pair(point: Any) -> tuple[Any, Any]:
    coordinates = tuple(point)
    if len(coordinates) != 2:
        raise Error(f"a point is (x, y): {coordinates!r:.60}")
    return coordinates[0], coordinates[1]


def _texts(values: Sequence[Any] | None) -> list[str]:
    return [] if values is None else [str(value) for value in values]


def _warn_of_losses(result: Lines) -> None:
    lost = [item for item in result.rejected if not item.harmless]
    if not lost:
        return
    place = result._core.place_text(lost[0].source)
    count = "one item takes" if len(lost) == 1 else f"{len(lost)} items take"
    warn_of_loss(f"{count} no part, see `rejected`; the first: {place}: {lost[0].reason}")
