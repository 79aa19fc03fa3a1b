"""Arrangements in other programs' words."""

from __future__ import annotations

import json
import xml.etree.ElementTree as xml
from pathlib import Path
from typing import Any

import geopandas
import networkx
import numpy as np
import plumbline
import pyarrow
import pytest
import shapely
from drawings import polylines

SQUARES = [shapely.box(0, 0, 4, 4), shapely.box(1, 1, 2, 2), shapely.LineString([(0, 0), (1, 1)])]
"""A square in a square, and a line from one to the other."""


@pytest.fixture(scope="module")
def building(examples: Path) -> plumbline.Arrangement:
    return plumbline.arrange(examples / "building.svg")


# Shapely.


@pytest.mark.parametrize("seed", range(40))
def test_polygons_are_those_that_shapely_finds(seed: int) -> None:
    lines = polylines(seed)
    ours = plumbline.arrange(lines).to_shapely()
    theirs = shapely.get_parts(shapely.polygonize([shapely.unary_union(lines)]))
    assert shapely.is_valid(ours).all()
    keys = [sorted(g.wkb for g in shapely.normalize(list(x))) for x in (ours, theirs)]
    assert keys[0] == keys[1]


def test_polygons_are_in_the_order_of_faces(building: plumbline.Arrangement) -> None:
    polygons = building.to_shapely()
    assert len(polygons) == len(building) == 302  # shapely.polygonize of unary_union, too
    assert shapely.is_valid(polygons).all()
    assert building.polygons.face.tolist() == list(range(1, 303))
    assert np.allclose(shapely.area(polygons), building.area[1:], rtol=1e-12)
    assert np.allclose(shapely.length(polygons), building.perimeter[1:], rtol=1e-12)
    assert shapely.is_ccw(shapely.get_exterior_ring(polygons)).all()
    assert not building.polygons.coords.flags.writeable


def test_holes_are_holes_and_what_ends_within_is_left_out() -> None:
    a = plumbline.arrange(SQUARES)
    assert [p.wkt for p in shapely.normalize(a.to_shapely())] == [
        "POLYGON ((0 0, 0 4, 4 4, 4 0, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))",
        "POLYGON ((1 1, 1 2, 2 2, 2 1, 1 1))",
    ]


# GeoPandas.


def test_a_geodataframe_goes_in_and_its_faces_come_out() -> None:
    frame = geopandas.GeoDataFrame(
        {"kind": ["a", "b", "c"]}, index=["x", "y", "z"], geometry=SQUARES, crs="EPSG:25832"
    )
    faces = plumbline.arrange(frame).to_geopandas()
    assert faces.crs == frame.crs
    assert faces.face.tolist() == [1, 2]
    assert faces.area.tolist() == [15.0, 1.0]
    assert faces["area"].tolist() == [15.0, 1.0]
    assert faces.perimeter.tolist() == [20.0, 4.0]
    assert faces.depth.tolist() == [1, 1] and faces.parent.tolist() == [0, 0]  # joined by the line
    assert faces.sources.tolist() == [[0, 1, 2], [1]]
    assert faces.source_index.tolist() == [["x", "y", "z"], ["y"]]
    assert list(plumbline.arrange(frame).to_geopandas(sources=False).columns) == [
        "face",
        "area",
        "perimeter",
        "depth",
        "parent",
        "geometry",
    ]


def test_areas_of_tables_are_the_exact_ones_rounded_once() -> None:
    third = plumbline.arrange([(0, 0, "1/3", 0), ("1/3", 0, 0, 1), (0, 1, 0, 0)])
    for a in (third, third.rounded(), third.rounded(1)):
        assert a.to_geopandas()["area"].tolist() == [1 / 6]
        assert a.to_arrow()["area"].to_pylist() == [1 / 6]


def test_faces_within_faces_know_it() -> None:
    faces = plumbline.arrange(SQUARES[:2]).to_geopandas()
    assert faces.depth.tolist() == [1, 2] and faces.parent.tolist() == [0, 1]


def test_edges_know_what_is_beside_them() -> None:
    edges = plumbline.arrange(SQUARES).edges_to_geopandas()
    within = edges[edges.left == edges.right]
    assert within.geometry.iloc[0].wkt == "LINESTRING (0 0, 1 1)"
    assert within.sources.tolist() == [[2]]
    assert np.allclose(edges["length"], edges.geometry.length)


def test_nothing_gives_empty_tables() -> None:
    a = plumbline.arrange([])
    assert len(a.to_geopandas()) == len(a.edges_to_geopandas()) == a.to_arrow().num_rows == 0
    assert len(a.to_networkx()) == 0 and len(a.to_networkx(dual=True)) == 1
    assert a.__geo_interface__["features"] == []


# Arrow.


def test_arrow_has_the_same_table(building: plumbline.Arrangement) -> None:
    table = building.to_arrow()
    assert table.field("geometry").metadata[b"ARROW:extension:name"] == b"geoarrow.polygon"
    frame = geopandas.GeoDataFrame.from_arrow(building)
    assert shapely.equals_identical(np.asarray(frame.geometry), building.to_shapely()).all()
    assert frame.sources.map(list).tolist() == building.to_geopandas().sources.tolist()
    assert pyarrow.table(building).num_rows == len(building)


def test_arrow_keeps_the_reference_system() -> None:
    frame = geopandas.GeoDataFrame(geometry=SQUARES, crs="EPSG:25832")
    again = geopandas.GeoDataFrame.from_arrow(plumbline.arrange(frame))
    assert again.crs == "EPSG:25832"


# NetworkX.


def test_the_graph_has_the_cycles_that_euler_counts(building: plumbline.Arrangement) -> None:
    graph = building.to_networkx()
    n = building.counts
    assert networkx.number_connected_components(graph) == n.components
    assert len(networkx.cycle_basis(graph)) == n.faces - 1


def test_edges_of_the_graph_have_sources_and_lengths() -> None:
    graph = plumbline.arrange([(0, 0, 3, 4), ("1/3", "4/9", 3, 4)]).to_networkx(exact=True)
    assert [data["sources"] for *_, data in graph.edges(data=True)] == [[0, 1], [0]][::-1]
    assert sum(data["length"] for *_, data in graph.edges(data=True)) == pytest.approx(5)
    assert str(graph.nodes[1]["point"][0]) == "1/3"


def test_the_dual_graph_has_shared_lengths() -> None:
    dual = plumbline.arrange(SQUARES).to_networkx(dual=True)
    assert dict(dual.nodes[1]) == {"area": 15.0, "depth": 1}
    assert [(a, b, d["length"]) for a, b, d in dual.edges(data=True)] == [(0, 1, 16.0), (1, 2, 4.0)]


# Texts and pictures.


def test_texts_are_features_with_properties(building: plumbline.Arrangement) -> None:
    collection = building.__geo_interface__
    assert len(collection["features"]) == len(building)
    frame = geopandas.GeoDataFrame.from_features(building)
    assert frame["area"].tolist() == building.area[1:].tolist()
    assert json.loads(building.to_topojson())["type"] == "Topology"
    assert len(shapely.from_wkt(building.to_wkt("edges").splitlines())) == building.counts.edges
    with pytest.raises(plumbline.Error, match="'rooms'"):
        building.to_geojson("rooms")


def test_json_is_exact_and_has_the_signature(building: plumbline.Arrangement) -> None:
    whole = json.loads(building.to_json())
    assert whole["signature"] == building.signature
    assert len(building.to_json(compact=True)) < len(building.to_json()) / 2


def test_notebooks_get_pictures_that_fit(building: plumbline.Arrangement) -> None:
    for picture in (building._repr_svg_(), building.lines._repr_svg_()):
        root = xml.fromstring(picture)
        assert float(root.attrib["height"]) <= 360 and float(root.attrib["width"]) <= 720


def test_pictures_of_many_lines_are_samples_that_say_so() -> None:
    rows = np.arange(21_000.0)
    lines = plumbline.lines(np.column_stack([0 * rows, rows, 0 * rows + 1, rows]))
    for x in (lines, plumbline.arrange(lines)):
        picture = x._repr_svg_()
        assert "20,000 of 21,000" in picture
        assert len(picture) < 2_000_000
        xml.fromstring(picture)


def test_triangles_fill_faces(building: plumbline.Arrangement) -> None:
    triangles = plumbline.triangulate(building)
    corners = building.vertices[triangles.vertices]
    areas = shapely.area(shapely.polygons(corners))
    sums = np.bincount(triangles.face, weights=areas, minlength=building.counts.faces)
    assert np.allclose(sums, building.area, rtol=1e-9)
    only = plumbline.triangulate(building, 3)
    assert only.vertices.tolist() == triangles.vertices[triangles.face == 3].tolist()
    with pytest.raises(plumbline.Error, match="303"):
        plumbline.triangulate(building, 303)


@pytest.mark.parametrize("module", ["shapely", "geopandas", "networkx", "pyarrow"])
def test_packages_that_are_not_there_are_named(
    module: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    a = plumbline.arrange([(0, 0, 1, 0), (1, 0, 0, 1), (0, 1, 0, 0)])
    monkeypatch.setitem(__import__("sys").modules, module, None)
    calls: dict[str, Any] = {
        "shapely": a.to_shapely,
        "geopandas": a.to_geopandas,
        "networkx": a.to_networkx,
        "pyarrow": a.to_arrow,
    }
    with pytest.raises(ImportError, match=rf"{module}: pip install \"plumbline-geometry\["):
        calls[module]()
