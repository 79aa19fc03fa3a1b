"""Files: written, and read again."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import geopandas
import numpy as np
import plumbline
import pytest
import shapely

FEATURES = ["geojson", "dxf", "wkt", "csv", "wkb"]
TABLES = ["gpkg", "fgb", "parquet"]


@pytest.fixture(scope="module")
def thirds() -> plumbline.Arrangement:
    """A turned square and two lines that cut it in places that are no decimals."""
    return plumbline.arrange(
        [(0, 0, 3, 1), (3, 1, 2, 4), (2, 4, -1, 3), (-1, 3, 0, 0), (-2, 1, 4, 2), (0, -1, 2, 5)]
    )


@pytest.fixture(scope="module")
def decimals() -> plumbline.Arrangement:
    return plumbline.arrange([(0, 0, "0.1", 0), ("0.1", 0, 0, "0.1"), (0, "0.1", 0, 0)])


@pytest.mark.parametrize("ending", ["lines", "lar.json", "geojson", "dxf", "wkt", "csv"])
def test_what_is_written_is_read_again(
    ending: str, decimals: plumbline.Arrangement, tmp_path: Path
) -> None:
    path = tmp_path / f"x.{ending}"
    plumbline.write(decimals, path)
    assert plumbline.signature(plumbline.read(path)) == decimals.signature


@pytest.mark.parametrize("ending", FEATURES)
def test_doubles_are_read_as_the_proven_ones(
    ending: str, thirds: plumbline.Arrangement, tmp_path: Path
) -> None:
    path = tmp_path / f"x.{ending}"
    plumbline.write(thirds, path, cells="edges")
    again = plumbline.read(path, numbers="doubles")
    assert plumbline.signature(again) == thirds.rounded().signature


def test_json_and_certificates_have_the_signature(
    thirds: plumbline.Arrangement, tmp_path: Path
) -> None:
    plumbline.write(thirds, tmp_path / "x.json")
    assert json.loads((tmp_path / "x.json").read_text())["signature"] == thirds.signature
    plumbline.write(thirds, tmp_path / "x.json", decimals=1)
    rounding = json.loads((tmp_path / "x.json").read_text())["rounding"]
    assert (rounding["grid"], rounding["verified"]) == ("1 decimal", True)
    plumbline.write(thirds, tmp_path / "x.certificate")
    assert thirds.signature in (tmp_path / "x.certificate").read_text()


def test_lar_json_is_exact(thirds: plumbline.Arrangement, tmp_path: Path) -> None:
    plumbline.write(thirds, tmp_path / "x.lar.json")
    faces = plumbline.read(tmp_path / "x.lar.json")
    assert plumbline.signature(faces) == thirds.signature


def test_decimals_are_those_that_are_asked_for(
    thirds: plumbline.Arrangement, tmp_path: Path
) -> None:
    plumbline.write(thirds, tmp_path / "x.lines", decimals=2)
    again = plumbline.arrange(tmp_path / "x.lines")
    assert again == thirds.rounded(2)


@pytest.mark.parametrize("ending", TABLES)
def test_tables_are_read_by_geopandas(
    ending: str, thirds: plumbline.Arrangement, tmp_path: Path
) -> None:
    path = tmp_path / f"x.{ending}"
    plumbline.write(thirds, path)
    read: Any = geopandas.read_parquet if ending == "parquet" else geopandas.read_file
    frame = read(path)
    assert sorted(frame["area"]) == sorted(thirds.area[1:])
    ours = shapely.normalize(thirds.to_shapely())
    assert {g.wkb for g in shapely.normalize(frame.geometry)} == {g.wkb for g in ours}
    first = thirds.to_geopandas().set_index("face").sources
    sources = frame.set_index("face").sources
    expected = list(first[1]) if ending == "parquet" else " ".join(map(str, first[1]))
    assert (list(sources[1]) if ending == "parquet" else sources[1]) == expected


def test_a_geopackage_has_a_layer_for_each_kind(
    thirds: plumbline.Arrangement, tmp_path: Path
) -> None:
    path = tmp_path / "x.gpkg"
    plumbline.write(thirds, path, cells=["faces", "edges", "vertices"])
    n = thirds.counts
    for layer, count in (("faces", n.faces - 1), ("edges", n.edges), ("vertices", n.vertices)):
        assert len(geopandas.read_file(path, layer=layer)) == count
    with pytest.raises(plumbline.Error, match="one kind of cells: faces, edges"):
        plumbline.write(thirds, tmp_path / "x.fgb", cells=["faces", "edges"])


@pytest.mark.parametrize("ending", ["lines", "geojson", "dxf", "wkt", "csv", "wkb"])
def test_lines_are_written_too(ending: str, tmp_path: Path) -> None:
    lines = plumbline.lines([(0, 0, 0.5, 0.25), (1, 2, 3, 4)])
    plumbline.write(lines, tmp_path / f"x.{ending}")
    again = plumbline.read(tmp_path / f"x.{ending}")
    assert sorted(map(sorted, again)) == sorted(map(sorted, lines))


def test_lines_are_exact_in_lines_files(tmp_path: Path) -> None:
    lines = plumbline.lines([("1/3", 0, 1, "2/7")])
    plumbline.write(lines, tmp_path / "x.lines")
    assert list(plumbline.read(tmp_path / "x.lines")) == list(lines)


def test_results_of_others_write_themselves(tmp_path: Path) -> None:
    class Result:
        def _written(self, format: str, **options: Any) -> str:
            return f"{format} {options}"

    plumbline.write(Result(), tmp_path / "x.HTM")
    assert (tmp_path / "x.HTM").read_text() == "html {}"


def test_frames_of_ours_are_written(thirds: plumbline.Arrangement, tmp_path: Path) -> None:
    frame = thirds.to_geopandas()
    for ending in ("geojson", *TABLES):
        plumbline.write(frame, tmp_path / f"x.{ending}")
    again = geopandas.read_file(tmp_path / "x.geojson")
    assert np.array_equal(again["area"], frame["area"])


def test_a_file_that_cannot_be_written_leaves_what_was_there(
    decimals: plumbline.Arrangement, tmp_path: Path
) -> None:
    path = tmp_path / "x.obj"
    path.write_text("before")
    finer = plumbline.arrange([(10**6, 0, "1000000.000000000000000001", 0)])
    with pytest.raises(plumbline.Error, match="too coarse"):
        plumbline.write(finer, path, decimals=18)
    with pytest.raises(plumbline.FileError):
        plumbline.write(decimals, tmp_path / "no" / "x.obj")
    assert path.read_text() == "before"
    assert [p.name for p in tmp_path.iterdir()] == ["x.obj"]


@pytest.mark.parametrize(
    ("path", "options", "message"),
    [
        ("x.docx", {}, "ending is none of .json"),
        ("x", {}, "no format is given: 'x'"),
        ("x.json", {"format": "pdf"}, "'pdf'"),
        ("x.html", {}, "arrangements are not written as html"),
        ("x.json", {"cells": "faces"}, "has all cells: 'faces'"),
        ("x.wkt", {"cells": "rooms"}, "'rooms'"),
        ("x.csv", {"cells": ["faces", "edges"]}, "one kind of cells"),
        ("x.certificate", {"decimals": 3}, "exact arrangement"),
        ("x.wkt", {"decimals": 19}, "19"),
    ],
)
def test_what_cannot_be_meant_is_refused(
    path: str,
    options: dict[str, Any],
    message: str,
    decimals: plumbline.Arrangement,
    tmp_path: Path,
) -> None:
    with pytest.raises(plumbline.Error, match=message):
        plumbline.write(decimals, path if path == "x" else tmp_path / path, **options)
    assert list(tmp_path.iterdir()) == []


def test_what_is_no_result_is_refused(tmp_path: Path) -> None:
    with pytest.raises(plumbline.Error, match="int"):
        plumbline.write(5, tmp_path / "x.json")
    with pytest.raises(plumbline.Error, match="lines are not written as obj"):
        plumbline.write(plumbline.lines([(0, 0, 1, 1)]), tmp_path / "x.obj")
    with pytest.raises(plumbline.Error, match="arrange them"):
        plumbline.write(plumbline.lines([(0, 0, 1, 1)]), tmp_path / "x.dxf", decimals=2)
