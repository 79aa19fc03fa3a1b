"""Files of results, written whole or not at all."""

from __future__ import annotations

import os
import tempfile
import warnings
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, Union

from plumbline import _core
from plumbline._optional import needed
from plumbline.arrangement import Arrangement
from plumbline.errors import Error
from plumbline.exports import CELLS, chosen_cells, features_text, json_text
from plumbline.lines import Lines

PathLike = Union[str, "os.PathLike[str]"]
Cells = Union[str, Sequence[str], None]

_FEATURES = ("geojson", "topojson", "dxf", "wkt", "csv", "wkb")
_TABLES = {"gpkg": "GPKG", "fgb": "FlatGeobuf", "parquet": ""}  # and GDAL's names of them
_ENDINGS = {
    "json": (".json",),
    "svg": (".svg",),
    "geojson": (".geojson",),
    "topojson": (".topojson",),
    "dxf": (".dxf",),
    "wkt": (".wkt",),
    "csv": (".csv",),
    "wkb": (".wkb",),
    "obj": (".obj",),
    "lar": (".lar.json",),
    "lines": (".lines",),
    "html": (".html", ".htm"),
    "md": (".md",),
    "certificate": (".certificate",),
    "gpkg": (".gpkg",),
    "fgb": (".fgb",),
    "parquet": (".parquet", ".geoparquet"),
}


def write(
    x: Any,
    path: PathLike,
    *,
    format: str | None = None,
    decimals: int | None = None,
    cells: Cells = None,
) -> None:
    """Writes a result to a file, whole or not at all.

    Parameters
    ----------
    x : Arrangement, Lines, GeoDataFrame, or another result of this package
    path : path
        Its ending says the format:

        ============== ======================================================================
        ending         what an arrangement becomes
        ============== ======================================================================
        .json          everything, exactly
        .lar.json      V, EV, FV, exactly
        .lines         edges, exactly where all are decimals, else in doubles
        .certificate   what `plumbline-verify` checks
        .svg           a picture
        .geojson       faces in doubles that are proven to be a valid partition, and all below
        .topojson      faces that share arcs
        .dxf           edges, for CAD programs
        .wkt, .wkb     geometries, one a line; WKB in hexadecimal digits
        .csv           a table with a column ``wkt``
        .obj           vertices, edges and triangles
        .gpkg, .fgb    GeoPackage, FlatGeobuf: need geopandas
        .parquet       GeoParquet: needs geopandas and pyarrow
        ============== ======================================================================

        Lines are written as .lines, exactly; .svg; the formats from .geojson to .csv, and
        tables, in nearest doubles. GeoDataFrames are written as tables and .geojson.
    format : str, optional
        One of these endings without its dot ("lar" for .lar.json), where the file has another.
    decimals : int, optional
        Of an arrangement: coordinates are rounded to so many decimals and proven, as
        `snap_round` does.
    cells : {"faces", "edges", "vertices"} or a sequence of these, optional
        Of an arrangement in formats of features and tables. A .gpkg has a layer for each.

    Raises
    ------
    Error
        For an ending that is not known, a format that `x` is not written in, options that do
        not apply to it, decimals that are too fine for a file of doubles.
    FileError
        Where the file cannot be written; what was there before is then still there.
    ImportError
        Where a table is asked for and geopandas is not there.

    Examples
    --------
    >>> import plumbline, tempfile, pathlib
    >>> a = plumbline.arrange([(0, 0, 2, 2), (0, 2, 2, 0), (0, 0, 0, 2)])
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = pathlib.Path(folder) / "faces.wkt"
    ...     plumbline.write(a, path)
    ...     print(path.read_text().strip())
    POLYGON ((0 0, 1 1, 0 2, 0 0))
    """
    name = os.fspath(path)
    chosen = _format(name, format)
    refuse_to_overwrite(x, name)
    options: dict[str, Any] = {}
    if decimals is not None:
        options["decimals"] = decimals
    if cells is not None:
        options["cells"] = cells
    if chosen in _TABLES:
        content: str | bytes = _table_bytes(x, chosen, options)
    elif hasattr(x, "_written"):
        content = x._written(chosen, **options)
    elif isinstance(x, Lines):
        content = _lines_text(x, chosen, **options)
    elif _is_frame(x):
        content = _frame_text(x, chosen, options)
    else:
        raise Error(f"results of this package, and GeoDataFrames, are written: {type(x).__name__}")
    _core.write_file(name, content.encode() if isinstance(content, str) else content)


def _format(path: str, format: str | None) -> str:
    if format is not None:
        if not isinstance(format, str) or format.lower() not in _ENDINGS:
            raise Error(f"formats are {', '.join(_ENDINGS)}: {format!r}")
        return format.lower()
    lower = path.lower()
    known = [
        (len(ending), name)
        for name, endings in _ENDINGS.items()
        for ending in endings
        if lower.endswith(ending)
    ]
    if not known:
        endings = ", ".join(ending for endings in _ENDINGS.values() for ending in endings)
        raise Error(f"the file's ending is none of {endings}, and no format is given: {path!r}")
    return max(known)[1]


def refuse_to_overwrite(x: Any, path: str) -> None:
    """An Error where this is the file of the drawing that `x` was made of."""
    source = getattr(x, "_patched", None)
    read_from: Any = getattr(source, "_read_from", None)
    are_there = read_from and os.path.exists(path) and os.path.exists(read_from[0])
    if are_there and os.path.samefile(path, read_from[0]):
        raise Error(f"this would overwrite the drawing that was read: {path!r}")


def _refusal(what: str, format: str, known: Sequence[str]) -> Error:
    """The error of a format that something is not written in."""
    return Error(f"{what} are not written as {format}; as {', '.join(known)} they are")


def arrangement_text(
    a: Arrangement, format: str, decimals: int | None = None, cells: Cells = None
) -> str:
    """An arrangement in one of the formats that are texts."""
    if format in _FEATURES:
        return features_text(a, format, cells, decimals)
    writers = {
        "json": lambda: json_text(a, False, decimals),
        "svg": lambda: _core.complex_svg(_source(a, decimals)._core, a.lines._core.y_up),
        "obj": lambda: _core.rounded_obj(a._in_doubles(decimals)._rounding),
        "lar": lambda: _core.lar_json(_source(a, decimals)._core),
        "lines": lambda: _edges_text(a, decimals),
        "certificate": lambda: _certificate(a, decimals),
    }
    if format not in writers:
        raise _refusal("arrangements", format, [*writers, *_FEATURES, *_TABLES])
    if cells is not None:
        raise Error(f"a .{format} file has all cells: {cells!r}")
    return writers[format]()


def _source(a: Arrangement, decimals: int | None) -> Arrangement:
    return a if decimals is None else a.rounded(decimals)


def _edges_text(a: Arrangement, decimals: int | None) -> str:
    source = _source(a, decimals)
    if not _core.are_decimals(source._core):
        source = source.rounded()
    return _core.complex_lines(source._core)


def _certificate(a: Arrangement, decimals: int | None) -> str:
    if a is not a.exact or decimals is not None:
        raise Error("a certificate is of an exact arrangement: it is not rounded")
    return _core.certificate_text(a._core, a.lines._core)


def _lines_text(lines: Lines, format: str, decimals: int | None = None, cells: Cells = None) -> str:
    if decimals is not None or cells is not None:
        raise Error("lines have no cells, and are not rounded: arrange them")
    if format == "lines":
        return _core.lines_text(lines._core)
    if format == "svg":
        return _core.lines_svg(lines._core)
    if format in _FEATURES:
        layer = _core.line_layer(lines._core)
        return _core.features_text(format, [layer], lines._core, "nearest doubles")
    raise _refusal("lines", format, ["lines", "svg", *_FEATURES, *_TABLES])


def _is_frame(x: Any) -> bool:
    return hasattr(x, "geometry") and hasattr(x, "columns") and hasattr(x, "to_file")


def _frame_text(frame: Any, format: str, options: dict[str, Any]) -> bytes:
    if options:
        raise Error(f"tables have none of these options: {', '.join(options)}")
    if format != "geojson":
        raise _refusal("tables", format, ["geojson", *_TABLES])
    return _bytes_of(lambda path: _flat(frame).to_file(path, driver="GeoJSON"), ".geojson")


def _table_bytes(x: Any, format: str, options: dict[str, Any]) -> bytes:
    needed("geopandas")
    frames = _frames(x, **options)
    if len(frames) > 1 and format != "gpkg":
        raise Error(f"a .{format} file holds one kind of cells: {', '.join(frames)}")

    def fill(path: Path) -> None:
        for name, frame in frames.items():
            if format == "parquet":
                needed("pyarrow")
                frame.to_parquet(path, index=False)
            else:
                _flat(frame).to_file(path, driver=_TABLES[format], layer=name, engine="pyogrio")

    return _bytes_of(fill, f".{format}")


def _frames(x: Any, decimals: int | None = None, cells: Cells = None) -> dict[str, Any]:
    if isinstance(x, Arrangement):
        source = x if decimals is None else x._in_doubles(decimals)
        makers = dict(
            zip(CELLS, (source.to_geopandas, source.edges_to_geopandas, source._vertices_frame))
        )
        return {name: makers[name]() for name in chosen_cells(cells, "faces")}
    if decimals is not None or cells is not None:
        raise Error("decimals and cells are of arrangements")
    if _is_frame(x):
        return {"features": x}
    if isinstance(x, Lines):
        frames = needed("geopandas")
        columns = {"item": x.item.astype("int64")}
        return {"lines": frames.GeoDataFrame(columns, geometry=x.to_shapely(), crs=x.crs or None)}
    if hasattr(x, "to_geopandas"):
        return {type(x).__name__.lower(): x.to_geopandas()}
    raise Error(f"this is no table: {type(x).__name__}")


def _flat(frame: Any) -> Any:
    """A table without lists: "2 5 7", as GIS programs can't hold them."""
    flat = frame.copy()
    for name in flat.columns:
        column = flat[name]
        if column.dtype == object and column.map(lambda v: isinstance(v, (list, tuple))).any():
            flat[name] = column.map(
                lambda v: " ".join(map(str, v)) if isinstance(v, (list, tuple)) else v
            )
    return flat


def _bytes_of(fill: Callable[[Path], object], ending: str) -> bytes:
    """What a function writes to a file of this ending."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"file{ending}"
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", message="'crs' was not provided")
            fill(path)
        return path.read_bytes()
