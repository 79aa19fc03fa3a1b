"""Engines of the library, held against the exact arrangement. Counts and texts are what
`plumbline check FILE [--engine inters]`, version 0.1.0, says of the examples.
"""

from __future__ import annotations

import json
from pathlib import Path

import plumbline
import pytest
from check_test import EV, ROOMS, V


def test_float_lar_is_as_the_tool_says(examples: Path) -> None:
    check = plumbline.cross_check(examples / "flat.dxf")
    assert check.agree
    assert (check.exact_counts.vertices, check.exact_counts.edges) == (228, 230)
    assert check.answer.radius_from == "segment"
    assert check.right_radii
    assert check.right_radii.advised == 3e-08
    assert check.to_text().splitlines()[1] == (
        "float LAR is right with --radius 3e-08, and with all tried from 1.52743e-13 to 0.00585309 "
        "(6)."
    )
    said = json.loads(check.to_json())
    assert said["verdict"] == "agree"


def test_lar_as_published_is_as_the_tool_says(examples: Path) -> None:
    drawing = plumbline.read(examples / "building.svg")
    check = plumbline.cross_check(drawing, variant="published", unit_square=True)
    assert check.to_text(0).splitlines()[0] == "disagree: 658 findings in 32 groups"
    check = plumbline.cross_check(drawing, "inters", decimals=4, radius=0.001)
    assert check.to_text(0).splitlines()[0] == "disagree: 2411 findings in 35 groups"
    assert check.answer.parameters["result"] == "larFromLines"
    said = json.loads(check.to_json())
    assert len(said["findings"]) == 2411
    assert [f["message"] for f in said["findings"]] == [f.message for f in check.findings]


def test_parameters_that_an_engine_has_not_are_refused_with_those_that_it_has() -> None:
    with pytest.raises(plumbline.Error, match=r"no such parameter; it has radius.*decimals"):
        plumbline.cross_check(ROOMS, decimals=3)
    with pytest.raises(plumbline.Error, match="there are lar, inters, plasm, files"):
        plumbline.cross_check(ROOMS, "cgal")
    with pytest.raises(plumbline.Error, match="the parameter decimals is an integer"):
        plumbline.cross_check(ROOMS, "inters", decimals=2.5)
    with pytest.raises(plumbline.Error, match="the parameter result is larFromLines or"):
        plumbline.cross_check(ROOMS, "inters", result="everything")
    with pytest.raises(plumbline.Error, match="radius"):
        plumbline.cross_check(ROOMS, radius=float("nan"))
    with pytest.raises(plumbline.Error, match="variants"):
        plumbline.cross_check(ROOMS, variant="new")  # type: ignore[arg-type]
    with pytest.raises(plumbline.Error, match="read from an SVG"):
        plumbline.cross_check(ROOMS, "inters", svg2lines=True)


def test_presets_of_the_radius_are_known() -> None:
    assert plumbline.cross_check(ROOMS, radius="larlib").answer.radius == 0.004
    assert plumbline.cross_check(ROOMS, radius="plasm").answer.radius == 1e-8
    assert plumbline.cross_check(ROOMS, radius="1/8").answer.radius == 0.125


def test_svg2lines_is_told_of_the_file(tmp_path: Path) -> None:
    svg = tmp_path / "lines.svg"
    triangle = (
        '<line x1="0" y1="0" x2="8" y2="0"/><line x1="8" y1="0" x2="4" y2="8"/>'
        '<line x1="4" y1="8" x2="0" y2="0"/>'
    )
    head = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10">'
    svg.write_text(f"{head}{triangle}</svg>")
    assert plumbline.cross_check(svg, "inters").agree
    told = plumbline.cross_check(svg, "inters", svg2lines=True)
    assert "one-element-per-line" in {cause.rule for cause in told.causes}


def test_without_advice_no_radius_is_tried() -> None:
    assert plumbline.cross_check(ROOMS, advice=False).right_radii is None
    assert plumbline.cross_check(ROOMS, advice=True).right_radii


def test_parsing_and_transforming_are_told_apart(tmp_path: Path) -> None:
    svg = tmp_path / "tee.svg"
    line = '<line x1="0" y1="0" x2="0.9" y2="0.3"/><line x1="0.3" y1="0.2" x2="0.3" y2="0.1"/>'
    head = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1">'
    svg.write_text(f"{head}{line}</svg>")
    parsed = plumbline.cross_check(svg)
    svg.write_text(f'{head}<g transform="scale(0.1)">{line.replace("0.", "")}</g></svg>')
    transformed = plumbline.cross_check(svg)
    assert {c.stage for c in parsed.conversion_causes} == {"parse"}
    assert {c.stage for c in transformed.conversion_causes} == {"transform"}


def test_ctrl_c_and_errors_of_a_callback_end_the_work() -> None:
    def stop(part: float) -> None:
        raise KeyboardInterrupt

    exact = plumbline.arrange(ROOMS)
    with pytest.raises(KeyboardInterrupt):
        plumbline.cross_check(exact, progress=stop)
    with pytest.raises(KeyboardInterrupt):
        plumbline.check((V, EV), exact, progress=stop)


def test_threads_do_not_change_the_result(examples: Path) -> None:
    drawing = plumbline.read(examples / "building.svg")
    one, many = (plumbline.cross_check(drawing, threads=n, advice=False) for n in (1, 2))
    assert one.to_json() == many.to_json()
    with pytest.raises(plumbline.Error, match="threads"):
        plumbline.cross_check(drawing, threads=-1)
