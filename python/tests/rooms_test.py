"""The rooms of plans."""

from __future__ import annotations

import json
import pickle
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import geopandas
import numpy as np
import plumbline
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st


def outline(x: float, y: float, to_x: float, to_y: float) -> shapely.LineString:
    """A rectangle as lines: a drawing of polygons is one of areas, all of which are rooms."""
    return shapely.LineString(shapely.box(x, y, to_x, to_y).exterior.coords)


# Two rooms of 4 x 3 and 5 x 5 m that share a wall without width.
WITHOUT_WALLS = shapely.MultiLineString([outline(0, 0, 4, 3), outline(4, 0, 9, 5)])
# Outer walls of 3 dm, a wall of 2 dm between rooms of 4 x 3 and 5 x 3 m; in decimetres.
WITH_WALLS = [outline(0, 0, 98, 36), outline(3, 3, 43, 33), outline(45, 3, 95, 33)]


def text_in(words: str, x: float, y: float) -> str:
    """A text in SVG."""
    return f'<text x="{x}" y="{y}" font-size="1">{words}</text>'


def svg(tmp_path: Path, content: str) -> Path:
    file = tmp_path / "plan.svg"
    file.write_text(f'<svg xmlns="http://www.w3.org/2000/svg">{content}</svg>')
    return file


def test_rooms_with_a_common_wall_are_neighbours_by_its_length() -> None:
    found = plumbline.rooms(WITHOUT_WALLS, unit="m")
    assert [room.area for room in found] == [12, 25]
    assert [room.perimeter for room in found] == [14, 20]
    assert [(n.room, n.shared, n.across, n.door) for n in found[0].neighbours] == [
        (1, 3.0, 0.0, False)
    ]
    assert found[-1].width == pytest.approx(5, rel=0.02)
    assert found[0].gross_area == 12
    assert found.unit is not None and found.unit.name == "m"


def test_walls_are_no_rooms_and_rooms_face_each_other_across_them() -> None:
    found = plumbline.rooms(WITH_WALLS, unit="dm")
    assert [room.area for room in found] == [1200, 1500]
    assert found.narrow == 1
    assert found[0].neighbours[0].across == pytest.approx(30)
    assert found[0].neighbours[0].shared == 0
    every = plumbline.rooms(WITH_WALLS, min_area=0, min_width=0)
    assert len(every) == 3
    assert sum(room.area for room in every) == 98 * 36


def test_sizes_are_the_decimals_that_are_written_and_told() -> None:
    for size in (0.5, "1/2", Decimal("0.5"), Fraction(1, 2)):
        assert plumbline.rooms(WITHOUT_WALLS, min_width=size).min_width == Fraction(1, 2)
    assert plumbline.rooms(WITHOUT_WALLS, min_area=0.1).min_area == Fraction(1, 10)
    # By default half a metre, and half a square metre.
    found = plumbline.rooms(WITH_WALLS, unit="dm")
    assert found.min_width == 5
    assert found.min_area == 50


def test_a_room_is_left_out_where_it_is_small_or_narrow() -> None:
    assert [r.area for r in plumbline.rooms(WITHOUT_WALLS, min_area="12.1", unit="m")] == [25]
    found = plumbline.rooms(WITHOUT_WALLS, min_width=4, min_area=0)
    assert [room.area for room in found] == [25]
    assert (found.narrow, found.small) == (1, 0)


def test_texts_name_rooms_and_those_outside_are_listed(tmp_path: Path) -> None:
    plan = svg(
        tmp_path,
        '<rect width="50" height="40"/><rect x="20" y="20" width="4" height="2"/>'
        + text_in("0.07", 21, 21)
        + text_in("Street", 90, 90),
    )
    found = plumbline.rooms(plan, unit="dm")
    assert [room.name for room in found] == ["0.07"]
    assert [room.area for room in found] == [1992]
    assert [room.gross_area for room in found] == [2000]
    assert [label.text for label in found.outside] == ["Street"]


def test_the_flat_has_three_rooms_once_its_furniture_is_left_out(examples: Path) -> None:
    found = plumbline.rooms(examples / "flat.dxf", walls=["walls", "DOORS"])
    assert [room.name for room in found] == ["Kitchen", "Bedroom", "Living room"]
    assert all(room.layers == ["DOORS", "WALLS"] for room in found)
    # Each room has a door to both others; the rooms fill 10 x 8 m with a bay.
    beside = list(found.to_networkx().edges(data=True))
    assert len(beside) == 3
    assert all(data["door"] for _, _, data in beside)
    assert 80 < sum(room.area for room in found) < 82
    assert not any(
        neighbour.door
        for room in plumbline.rooms(examples / "flat.dxf", walls=["walls", "DOORS"], doors=())
        for neighbour in room.neighbours
    )


@pytest.mark.parametrize(
    ("name", "rooms", "narrow", "small", "first_area"),
    [
        ("flat.dxf", 4, 9, 0, "6903042893574635279/287300000000000000"),
        ("office-plan.svg", 107, 0, 0, "12029587273137/9201200000"),
        ("hospital-ward.svg", 42, 184, 0, "5242209/200000"),
        ("building.svg", 119, 179, 4, "3394502654043/1047200000"),
        ("dwelling.svg", 7, 0, 0, "2399656903/250000"),
    ],
)
def test_rooms_are_those_that_the_tool_finds(
    examples: Path, name: str, rooms: int, narrow: int, small: int, first_area: str
) -> None:
    """Recorded from `plumbline rooms FILE --json`."""
    found = plumbline.rooms(examples / name)
    assert (len(found), found.narrow, found.small) == (rooms, narrow, small)
    assert found[0].area == Fraction(first_area)
    assert len(json.loads(found.to_json())["rooms"]) == rooms


def test_places_that_printed_doubles_leave_apart_are_joined() -> None:
    # The lower wall ends 4e-16 short of the right one, in numbers of 17 digits.
    plan = (
        "MULTILINESTRING ((0 0, 0.29999999999999966 0), (0.30000000000000004 0, "
        "0.30000000000000004 0.7), (0.30000000000000004 0.7, 0 0.7), (0 0.7, 0 0))"
    )
    assert plumbline.arrange(plan).counts.faces == 1
    found = plumbline.rooms(plan, min_area=0, min_width=0)
    assert (len(found), found.joined) == (1, 1)
    assert len(pickle.loads(pickle.dumps(found))) == 1


JOINED = [
    "POLYGON ((0 0, 0.29999999999999966 0, 0.30000000000000004 0.7, 0 0.7, 0 0))",
    "LINESTRING (0.30000000000000004 0.00000000000000001, 1 0, 1 0.7, 0.29999999999999999 0.7)",
    "LINESTRING (0 0.2, 1 0.2)",
    "POINT (7 7)",
]


@pytest.mark.filterwarnings("ignore::plumbline.LossWarning")
def test_the_arrangement_of_joined_places_is_that_of_its_lines() -> None:
    drawing = plumbline.lines("GEOMETRYCOLLECTION (" + ", ".join(JOINED) + ")")
    found = plumbline.rooms(drawing, min_area=0, min_width=0)
    assert found.joined
    joined = found.arrangement
    assert plumbline.validate(joined) == []
    assert plumbline.same(joined.lines, joined)
    assert not plumbline.same(joined, drawing)
    again = pickle.loads(pickle.dumps(joined))
    assert again == joined
    assert again.sources == joined.sources
    assert plumbline.verify(joined.lines, plumbline.certificate(joined))
    assert joined.lines.item_count == drawing.item_count
    assert {drawing.source_text(i) for i in set(joined.sources.indices)} == {
        drawing.source_text(i) for i in set(drawing.item)
    }
    assert plumbline.validity(joined) == []
    assert [room.area for room in found] == [joined.areas[room.face] for room in found]
    assert found.to_svg().startswith("<svg")
    assert len(found.to_geopandas()) == len(found)
    assert plumbline.signature(found.lines) == plumbline.signature(drawing)


def test_rooms_of_a_rounded_arrangement_are_those_of_the_exact_one() -> None:
    rounded = plumbline.arrange(WITH_WALLS).rounded(0)
    assert [room.area for room in plumbline.rooms(rounded)] == [
        room.area for room in plumbline.rooms(WITH_WALLS)
    ]


def test_polygons_are_valid_and_their_areas_those_of_the_rooms(examples: Path) -> None:
    found = plumbline.rooms(examples / "hospital-ward.svg")
    frame = found.to_geopandas()
    assert frame.geometry.is_valid.all()
    assert frame["room"].tolist() == list(range(1, len(found) + 1))
    areas = [float(room.area) for room in found]
    assert frame["area"].tolist() == areas
    assert np.allclose(frame.geometry.area, areas, rtol=1e-12)
    # A partition: none overlaps another one.
    assert shapely.union_all(frame.geometry.array).area == pytest.approx(sum(areas), rel=1e-9)


def test_areas_that_are_drawn_as_polygons_are_all_rooms() -> None:
    walls_too = plumbline.rooms([shapely.box(0, 0, 98, 36), shapely.box(3, 3, 43, 33)], unit="dm")
    assert [room.area for room in walls_too] == [98 * 36 - 1200, 1200]
    assert walls_too[1].parent == 0


def test_a_reference_system_is_kept() -> None:
    frame = geopandas.GeoDataFrame({"layer": ["walls"]}, geometry=[WITHOUT_WALLS], crs=25832)
    rooms = plumbline.rooms(frame).to_geopandas()
    assert rooms.crs == frame.crs
    assert rooms["layers"].tolist() == ["walls", "walls"]


def test_features_are_those_of_the_frame() -> None:
    found = plumbline.rooms(WITH_WALLS, unit="dm")
    features = found.__geo_interface__["features"]
    assert [shapely.geometry.shape(f["geometry"]).area for f in features] == [1200, 1500]
    assert [f["properties"]["area_m2"] for f in features] == [12, 15]
    assert found.to_geopandas()["area_m2"].tolist() == [12, 15]


@pytest.mark.parametrize(
    ("format", "says"),
    [
        ("json", '"plumbline rooms 1"'),
        ("svg", "<svg"),
        ("html", "<!DOCTYPE html>"),
        ("geojson", "FeatureCollection"),
        ("topojson", "Topology"),
        ("dxf", "AC1015"),
        ("wkt", "POLYGON"),
        ("csv", "area_exact"),
        ("wkb", "0103"),
    ],
)
def test_rooms_are_written_in_the_formats_of_the_tool(format: str, says: str) -> None:
    content = plumbline.rooms(WITH_WALLS)._written(format)
    assert isinstance(content, str)
    assert says in content


def test_other_formats_and_options_are_refused() -> None:
    found = plumbline.rooms(WITH_WALLS)
    with pytest.raises(plumbline.Error, match="'obj'"):
        found._written("obj")
    with pytest.raises(plumbline.Error, match="decimals"):
        found._written("json", decimals=3)


def test_a_notebook_gets_the_page_in_a_frame_that_is_shut_off_and_the_plan() -> None:
    found = plumbline.rooms(WITH_WALLS)
    page = found._repr_html_()
    assert page is not None and page.startswith("<iframe srcdoc=")
    assert 'sandbox="allow-scripts"' in page
    assert "<script" not in page  # nothing of the page is the notebook's
    picture = found._repr_svg_()
    assert picture is not None and picture.startswith("<svg")


def test_an_arrangement_that_is_there_is_taken_as_it_is() -> None:
    arrangement = plumbline.arrange(WITH_WALLS)
    found = plumbline.rooms(arrangement)
    assert found.arrangement._core is arrangement._core
    assert [room.area for room in found] == [room.area for room in plumbline.rooms(WITH_WALLS)]
    assert arrangement.areas[found[1].face] == found[1].area


def test_pickling_keeps_rooms_and_what_was_chosen() -> None:
    found = plumbline.rooms(WITH_WALLS, unit="dm", min_area=1300)
    again = pickle.loads(pickle.dumps(found))
    assert str(again) == str(found)
    assert again.min_area == 1300


def test_no_lines_have_no_rooms() -> None:
    found = plumbline.rooms(np.zeros((0, 4)))
    assert len(found) == 0
    assert found.outside == []
    assert len(found.to_geopandas()) == 0
    assert "<svg" in found.to_svg()


def test_a_slice_of_rooms_is_a_list() -> None:
    found = plumbline.rooms(WITHOUT_WALLS)
    assert [room.area for room in found[::-1]] == [25, 12]
    with pytest.raises(IndexError):
        found[2]


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"min_area": -1}, "min_area.*-1"),
        ({"min_width": "wide"}, "min_width.*'wide'"),
        ({"min_width": float("nan")}, "min_width.*nan"),
        ({"min_width": True}, "min_width.*True"),
        ({"unit": "furlong"}, "unit.*'furlong'"),
        ({"unit": 0}, "unit.*0"),
        ({"walls": "no such layer"}, "no such layer"),
    ],
)
def test_what_makes_no_sense_is_refused(arguments: dict[str, Any], says: str) -> None:
    with pytest.raises(plumbline.Error, match=says):
        plumbline.rooms(WITH_WALLS, **arguments)


@pytest.mark.parametrize(
    ("unit", "metres"),
    [("mm", "1/1000"), ("Inches", "254/10000"), ("ft", "0.3048"), (0.5, "1/2"), ("2", "2")],
)
def test_units_are_names_or_numbers_of_metres(unit: str | float, metres: str) -> None:
    found = plumbline.rooms(WITH_WALLS, unit=unit)
    assert found.unit is not None
    assert found.unit.metres == Fraction(metres)


numbers = st.integers(-50, 50)


@settings(max_examples=40, deadline=None)
@given(
    st.lists(st.tuples(numbers, numbers, numbers, numbers), min_size=3, max_size=8),
    st.randoms(use_true_random=False),
)
def test_rooms_do_not_depend_on_order_direction_or_repetition(
    segments: list[tuple[int, int, int, int]], random: Any
) -> None:
    def facts(lines: list[tuple[int, int, int, int]]) -> list[Any]:
        found = plumbline.rooms(lines, min_area=0, min_width=0)
        return [
            (room.area, room.gross_area, room.parent, [n.room for n in room.neighbours])
            for room in found
        ]

    lines = [s for s in segments if s[:2] != s[2:]]
    others = [(c, d, a, b) for a, b, c, d in lines] + lines[:2]
    random.shuffle(others)
    assert facts(others) == facts(lines)
