"""Rounded coordinates that are proven."""

from __future__ import annotations

import pickle
from fractions import Fraction
from pathlib import Path

import numpy as np
import plumbline
import pytest
import shapely
from drawings import segments
from hypothesis import given, settings
from plumbline import _core

NEAR = [(0, 0, 10, 3), ("3.4", "1.01", "6.4", "1.91"), (0, 0, 0, 5), (0, 5, 10, 3)]
"""A loose piece beside the side of a triangle, nearer than whole numbers can tell."""


def test_doubles_are_kept() -> None:
    a = plumbline.arrange([(0, 0, 3, 1), (0, 1, 3, 0)])
    r = a.rounded()
    assert a.rounded() is r and r.rounded() is r and r.exact is a
    assert r.method == "nearest doubles" and r.has_same_incidences and r.valid_as_doubles
    assert r.changes.moved_vertices == []
    assert r.vertices.tolist() == a.vertices.tolist()


def test_what_a_vertex_moved_by_is_exact() -> None:
    a = plumbline.arrange([(0, 0, "1/3", 0)])
    changes = a.rounded(2).changes
    assert changes.moved_vertices[0].squared_distance == (Fraction(1, 3) - Fraction("0.33")) ** 2
    assert changes.largest_squared_movement() == Fraction(1, 90000)
    assert a.rounded(2).spacing == Fraction(1, 100)


def test_edges_are_bent_where_simple_rounding_would_carry_a_vertex_over_them() -> None:
    a = plumbline.arrange(NEAR)
    assert not _core.is_kept_by_simple_rounding(a._core, 0)
    r = plumbline.snap_round(a, decimals=0)
    assert r.method == "snap rounded" and not r.has_same_incidences
    assert [bend.edge for bend in r.changes.bent_edges] == [1]
    assert "1 edges bent" in repr(r.changes)
    assert r.edge_image.lengths.tolist() == [1, 3, 1, 1]
    assert plumbline.validate(r) == []
    assert r.to_geopandas().face.tolist() == [1]
    assert r.face_origin.tolist() == [0, 1]
    assert shapely.is_valid(r.to_shapely()).all()


@settings(deadline=None, max_examples=60)
@given(segments)
def test_any_drawing_is_valid_in_few_decimals(drawing: list[tuple[str, ...]]) -> None:
    a = plumbline.arrange(drawing)
    r = a.rounded(0)
    assert plumbline.validate(r) == []
    assert (r.vertices == np.round(r.vertices)).all()
    assert r.rounded(0) is r
    again = plumbline.arrange(r.vertices[r.edges].reshape(-1, 4)).rounded(0)
    assert again.counts.edges == r.counts.edges
    polygons = r.to_shapely()
    assert shapely.is_valid(polygons).all()
    assert shapely.area(polygons).sum() == shapely.unary_union(polygons).area


def test_decimals_too_fine_for_doubles_are_said_to_be() -> None:
    a = plumbline.arrange([(10**6, 0, "1000000.000000000000000001", 0)])
    assert not a.rounded(18).valid_as_doubles
    with pytest.raises(plumbline.Error, match="doubles are too coarse for these 18 decimals"):
        a.rounded(18).to_geojson()


@pytest.mark.parametrize("decimals", [-1, 19, 1.5, "2", True])
def test_decimals_out_of_range_are_refused(decimals: int) -> None:
    a = plumbline.arrange([(0, 0, 1, 1)])
    with pytest.raises(plumbline.Error, match=str(decimals)):
        a.rounded(decimals)


def test_pickling_keeps_what_was_asked_for() -> None:
    r = plumbline.arrange(NEAR).rounded(0)
    again = pickle.loads(pickle.dumps(r))
    assert again == r and again.decimals == 0 and again.exact == r.exact


def test_progress_is_told() -> None:
    parts: list[float] = []
    plumbline.snap_round(plumbline.arrange(NEAR), progress=parts.append)
    assert parts == sorted(parts)


def test_a_building_is_valid_in_doubles_and_in_three_decimals(examples: Path) -> None:
    a = plumbline.arrange(examples / "building.svg")
    assert a.rounded().counts == a.counts
    r = a.rounded(3)
    (split,) = r.changes.split_faces
    assert r.face_origin[split.into].tolist() == [split.face] * 2
    assert r.counts.faces == a.counts.faces - len(r.changes.vanished_faces) + 1 == 301
    polygons = r.to_shapely()
    assert shapely.is_valid(polygons).all()
    assert shapely.area(polygons).sum() == pytest.approx(a.area.sum(), rel=1e-6)
    assert plumbline.validate(r) == []
