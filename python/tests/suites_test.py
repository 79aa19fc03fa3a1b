"""validation/suites in short: files of our own in the formats of other libraries' suites."""

from __future__ import annotations

import importlib
import json
import sys
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT

FOLDER = ROOT / "validation" / "suites"
pytestmark = pytest.mark.skipif(not FOLDER.is_dir(), reason="there is no folder validation/suites")

JTS = """<run><case><a>POLYGON ((0 0, 3 0, 0 1, 0 0))</a><b>
  POLYGON ((0 0, 1 0, 0 3, 0 0))</b>
<test><op name="intersection" arg1="A" arg2="B">
  POLYGON ((0 0, 1 0, 0.75 0.75, 0 1, 0 0))</op></test>
<test><op name="union" arg1="A" arg2="B">POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))</op></test>
<test><op name="overlayAreaTest" arg1="A" arg2="B">true</op></test>
<test><op name="isValid" arg1="A">true</op></test>
<test><op name="relate" arg1="A" arg2="B">true</op></test></case>
<case><a>MULTIPOLYGON (((0 0, 7 1, 7 0, 0 2, 0 0), EMPTY))</a>
<test><op name="isValid" arg1="A">false</op></test>
<test><op name="unionArea" arg1="A">1</op></test></case></run>"""
CLIPPER = """CAPTION: 1.
CLIPTYPE: INTERSECTION
FILLRULE: NONZERO
SOL_AREA: 7500
SOL_COUNT: 1
SUBJECTS
0,0, 300,0, 0,100
CLIPS
0,0, 100,0, 0,300

CAPTION: 2.
CLIPTYPE: UNION
FILLRULE: EVENODD
SOL_AREA: 301
SOL_COUNT: 1
SUBJECTS
0,0 30,0 30,20 0,20
0,0 30,0 0,20
"""
SQUARE = [[0, 0], [4, 0], [4, 4], [0, 4]]
IOVERLAY = {
    "fillRule": 0,
    "subjPaths": [SQUARE],
    "clipPaths": [[[2, 2], [6, 2], [6, 6], [2, 6]]],
    "subject": [[[SQUARE]]],
    "clip": [[[SQUARE]], [[[[2, 2], [6, 2], [6, 6], [2, 6]]]]],
    "union": [[[[[0, 0], [4, 0], [4, 2], [6, 2], [6, 6], [2, 6], [2, 4], [0, 4]]]]],
    "intersect": [[[[[2, 2], [4, 2], [4, 4], [2, 4]]]]],
    "difference": [[[[[0, 0], [4, 0], [4, 2], [2, 2], [2, 4], [0, 4]]]]],
    "inverseDifference": [[[[[6, 6], [2, 6], [2, 4], [4, 4], [4, 2], [6, 2]]]]],
    "xor": [[]],
}


def feature(corners: list[list[float]], **properties: str) -> dict[str, Any]:
    geometry = {"type": "Polygon", "coordinates": [corners]}
    return {"type": "Feature", "properties": properties, "geometry": geometry}


MARTINEZ = {
    "type": "FeatureCollection",
    "features": [
        feature([[0, 0], [0.3, 0], [0, 0.1], [0, 0]]),
        feature([[0, 0], [0.1, 0], [0, 0.7], [0, 0]]),
        feature([[0, 0], [0.1, 0], [0.08, 0.07], [0, 0.1], [0, 0]], operation="intersection"),
    ],
}


def verdicts(tmp_path: Path, name: str, text: str) -> list[Any]:
    """What validation/suites says of the cases of a file."""
    (tmp_path / name).write_text(text)
    sys.path.insert(0, str(FOLDER))
    try:
        cases, judge = importlib.import_module("cases"), importlib.import_module("judge")
    finally:
        sys.path.remove(str(FOLDER))
    return [
        case if isinstance(case, str) else judge.judged(case) for case in cases.cases_of(tmp_path)
    ]


def test_jts(tmp_path: Path) -> None:
    found = verdicts(tmp_path, "a.xml", JTS)
    kinds = [verdict if isinstance(verdict, str) else verdict.kind for verdict in found]
    of_first = ["equal", "expectation wrong", *["laws"] * 4, "equal"]
    of_second = ["equal", "expectation wrong"]
    assert kinds == [*of_first, "a.xml 1: relate is not about areas", *of_second]
    assert all(verdict.by_slabs for verdict in found[:6])


def test_clipper(tmp_path: Path) -> None:
    assert [v.kind for v in verdicts(tmp_path, "a.txt", CLIPPER)] == ["equal", "rounded"]


def test_ioverlay(tmp_path: Path) -> None:
    found = verdicts(tmp_path, "a.json", json.dumps(IOVERLAY))
    kinds = [verdict.kind for verdict in found]
    assert kinds == ["equal"] * 3 + ["expectation wrong"] + ["equal"] * 3


def test_martinez(tmp_path: Path) -> None:
    [verdict] = verdicts(tmp_path, "a.geojson", json.dumps(MARTINEZ))
    assert verdict.kind == "rounded" and verdict.by_slabs
