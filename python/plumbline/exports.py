"""Arrangements as tables, graphs and texts of other packages."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from plumbline import _core
from plumbline._optional import needed
from plumbline.errors import Error
from plumbline.lists import Lists

if TYPE_CHECKING:
    import geopandas
    import networkx
    import pyarrow

    from plumbline.arrangement import Arrangement

CELLS = ("faces", "edges", "vertices")


def lists_of_ints(lists: Lists) -> NDArray[np.object_]:
    """Lists as an array of lists of ints, for a column."""
    flat, bounds = lists.indices.tolist(), lists.indptr.tolist()
    column = np.empty(len(lists), dtype=object)
    for i in range(len(lists)):
        column[i] = flat[bounds[i] : bounds[i + 1]]
    return column


def rows_of(lists: Lists, rows: NDArray[Any]) -> Lists:
    """Those lists, in this order."""
    lengths = lists.lengths[rows]
    indptr = np.concatenate([[0], np.cumsum(lengths)])
    shift = np.repeat(lists.indptr[rows].astype(np.intp) - indptr[:-1], lengths)
    return Lists(indptr.astype(np.uint32), lists.indices[np.arange(indptr[-1]) + shift])


def _labelled(sources: NDArray[np.object_], labels: Any) -> NDArray[np.object_]:
    known = list(labels)
    column = np.empty(len(sources), dtype=object)
    for i, items in enumerate(sources):
        column[i] = [known[k] for k in items]
    return column


def _with_sources(
    columns: dict[str, Any], sources: Lists, labels: Any | None, wanted: bool
) -> None:
    if not wanted:
        return
    columns["sources"] = lists_of_ints(sources)
    if labels is not None:
        columns["source_index"] = _labelled(columns["sources"], labels)


def _table(columns: dict[str, Any], geometry: Any, crs: str) -> geopandas.GeoDataFrame:
    frames = needed("geopandas")
    return frames.GeoDataFrame(columns, geometry=geometry, crs=crs or None)


def faces_table(a: Arrangement, sources: bool) -> geopandas.GeoDataFrame:
    """`Arrangement.to_geopandas`."""
    needed("geopandas")
    base, _ = a._placed()
    polygons = a.polygons
    face = polygons.face
    columns: dict[str, Any] = {
        "face": face.astype(np.int64),
        "area": base._exact_area()[face],
        "perimeter": base.perimeter[face],
        "depth": base.depth[face].astype(np.int64),
        "parent": base.parent[face].astype(np.int64),
    }
    _with_sources(columns, rows_of(base.face_sources, face), a.labels, sources)
    return _table(columns, polygons.to_shapely(), a.lines.crs)


def edge_geometries(a: Arrangement) -> NDArray[np.object_]:
    """The edges as LineStrings."""
    shapely = needed("shapely")
    base, coords = a._placed()
    geometries: NDArray[np.object_] = shapely.linestrings(coords[base.edges])
    return geometries


def edge_lengths(base: Arrangement, coords: NDArray[np.float64]) -> NDArray[np.float64]:
    """Lengths of edges, rounded."""
    ends = coords[base.edges]
    lengths: NDArray[np.float64] = np.hypot(
        ends[:, 1, 0] - ends[:, 0, 0], ends[:, 1, 1] - ends[:, 0, 1]
    )
    return lengths


def edges_table(a: Arrangement, sources: bool) -> geopandas.GeoDataFrame:
    """`Arrangement.edges_to_geopandas`."""
    needed("geopandas")
    base, coords = a._placed()
    columns: dict[str, Any] = {
        "edge": np.arange(base.counts.edges),
        "tail": base.edges[:, 0].astype(np.int64),
        "head": base.edges[:, 1].astype(np.int64),
        "left": base.halfedge_face[0::2].astype(np.int64),
        "right": base.halfedge_face[1::2].astype(np.int64),
        "length": edge_lengths(base, coords),
    }
    _with_sources(columns, base.sources, a.labels, sources)
    return _table(columns, edge_geometries(a), a.lines.crs)


def vertices_table(a: Arrangement) -> geopandas.GeoDataFrame:
    """The vertices, with their degrees."""
    shapely = needed("shapely")
    base, coords = a._placed()
    degree = np.bincount(base.edges.reshape(-1), minlength=len(coords))
    columns = {"vertex": np.arange(len(coords)), "degree": degree}
    return _table(columns, shapely.points(coords), a.lines.crs)


def graph(a: Arrangement, exact: bool) -> networkx.Graph[int]:
    """`Arrangement.to_networkx`."""
    result: networkx.Graph[int] = needed("networkx").Graph()
    base, coords = a._placed()
    for v, pos in enumerate(coords.tolist()):
        result.add_node(v, pos=tuple(pos))
    if exact:
        for v, point in enumerate(base.points):
            result.nodes[v]["point"] = point
    lengths = edge_lengths(base, coords).tolist()
    sources = lists_of_ints(base.sources)
    result.add_edges_from(
        (tail, head, {"edge": e, "length": lengths[e], "sources": sources[e]})
        for e, (tail, head) in enumerate(base.edges.tolist())
    )
    return result


def dual_graph(a: Arrangement, exact: bool) -> networkx.Graph[int]:
    """The same of faces."""
    result: networkx.Graph[int] = needed("networkx").Graph()
    base, _ = a._placed()
    areas = base.areas if exact else base._exact_area().tolist()
    for f, (area, depth) in enumerate(zip(areas, base.depth.tolist())):
        result.add_node(f, area=area, depth=depth)
    indptr, faces, lengths = _core.neighbours(base._core)
    here = np.repeat(np.arange(len(indptr) - 1), Lists(indptr, faces).lengths)
    once = here < faces
    result.add_weighted_edges_from(
        zip(here[once].tolist(), faces[once].tolist(), lengths[once].tolist()), weight="length"
    )
    return result


def _crs_metadata(crs: str) -> bytes:
    """The metadata of GeoArrow: PROJJSON where pyproj is there, else the name."""
    if not crs:
        return b"{}"
    try:
        known = needed("pyproj").CRS.from_user_input(crs)
    except (ImportError, ValueError):
        return json.dumps({"crs": crs}).encode()
    return json.dumps({"crs": known.to_json_dict(), "crs_type": "projjson"}).encode()


def arrow_table(a: Arrangement, sources: bool) -> pyarrow.Table:
    """`Arrangement.to_arrow`."""
    pa = needed("pyarrow")
    base, _ = a._placed()
    polygons = a.polygons
    face = polygons.face
    arrays: dict[str, Any] = {
        "face": pa.array(face),
        "area": pa.array(base._exact_area()[face]),
        "perimeter": pa.array(base.perimeter[face]),
        "depth": pa.array(base.depth[face]),
        "parent": pa.array(base.parent[face]),
    }

    def listed(offsets: NDArray[Any], values: Any) -> Any:
        if len(values) > np.iinfo(np.int32).max:
            raise Error(f"Arrow's lists hold less than 2^31 values: {len(values)}")
        return pa.ListArray.from_arrays(pa.array(offsets.astype(np.int32)), values)

    if sources:
        rows = rows_of(base.face_sources, face)
        arrays["sources"] = listed(rows.indptr, pa.array(rows.indices))
    points = pa.FixedSizeListArray.from_arrays(pa.array(polygons.coords.reshape(-1)), 2)
    rings = listed(polygons.ring_offsets, points)
    arrays["geometry"] = listed(polygons.polygon_offsets, rings)
    metadata = {
        b"ARROW:extension:name": b"geoarrow.polygon",
        b"ARROW:extension:metadata": _crs_metadata(a.lines.crs),
    }
    fields = [
        pa.field(name, array.type, metadata=metadata if name == "geometry" else None)
        for name, array in arrays.items()
    ]
    return pa.Table.from_arrays(list(arrays.values()), schema=pa.schema(fields))


def chosen_cells(cells: str | Sequence[str] | None, default: str) -> list[str]:
    """Names of cells, held against those that there are."""
    names = [default] if cells is None else [cells] if isinstance(cells, str) else list(cells)
    for name in names:
        if name not in CELLS:
            raise Error(f"cells are {', '.join(CELLS)}: {name!r}")
    if not names:
        raise Error("no cells are asked for")
    return names


def features_text(
    a: Arrangement, format: str, cells: str | Sequence[str] | None, decimals: int | None
) -> str:
    """Cells as a text: GeoJSON, TopoJSON, DXF, WKT, CSV or WKB."""
    rounded = a._in_doubles(decimals)
    exact, input = rounded.exact._core, a.lines._core
    layers = []
    for name in chosen_cells(cells, "edges" if format == "dxf" else "faces"):
        if name == "faces":
            layers.append(_core.face_layer(exact, input, rounded._rounding))
        elif name == "edges":
            layers.append(_core.edge_layer(input, rounded._rounding))
        else:
            layers.append(_core.vertex_layer(rounded._rounding))
    return _core.features_text(format, layers, input, rounded.note)


def json_text(a: Arrangement, compact: bool, decimals: int | None) -> str:
    """`Arrangement.to_json`."""
    from plumbline.rounding import RoundedArrangement

    if decimals is None and not isinstance(a, RoundedArrangement):
        return _core.complex_json(a._core, a.lines._core, compact)
    if compact:
        raise Error("what is compact holds exact numbers: it is not rounded")
    r = a.rounded(decimals)
    return _core.rounded_json(r.exact._core, a.lines._core, r.decimals, r._rounding)
