"""Wrong answers brought down to a few segments."""

from __future__ import annotations

import pathlib
import pickle
from typing import Any

import numpy as np
import plumbline
import pytest
from numpy.typing import NDArray

GAP = [(0, 0, 1, 0), (1, 1e-12, 1, 1), (1, 1, 0, 0), (3, 30, 4, 40), (3, 40, 4, 30)]
"""A triangle with a gap that a radius of 1e-9 closes, and a cross."""


def squares(count: int) -> list[tuple[float, float, float, float]]:
    """Beside each other, with gaps."""
    rows: list[tuple[float, float, float, float]] = []
    for x in range(0, 3 * count, 3):
        rows += [(x, 0, x + 2, 0), (x + 2, 0, x + 2, 2), (x + 2, 2, x, 2), (x, 2, x, 0)]
    return rows


def exactly(segments: NDArray[np.float64]) -> Any:
    """The right answer."""
    return plumbline.arrange(segments, numbers="doubles")


def test_an_engine_of_the_library_by_name() -> None:
    m = plumbline.minimise(GAP, "lar", radius=1e-9)
    assert not m
    assert (m.outcome, m.kind) == ("topology", "face invented")
    assert (len(m.lines), m.segments_before) == (3, 5)
    assert m.is_one_minimal and m.has_simple_numbers and m.is_representable
    assert m.engine == "lar" and m.radius_before is None and m.runs > 1
    assert [f.kind for f in m.check.findings] and not m.check.agree
    assert any(cause.rule == "merged-within-radius" for cause in m.check.causes)
    again = plumbline.cross_check(m.lines, "lar", radius=1e-9)
    assert [f.kind for f in again.findings] == [f.kind for f in m.check.findings]


def test_one_that_is_right_has_nothing_to_show() -> None:
    m = plumbline.minimise(GAP, exactly)
    assert m and m.agree and m.outcome == "right" and m.kind == ""
    assert len(m.lines) == 5 and m.runs == 1
    assert str(m).startswith("agree: exactly is right")


def test_a_function_that_loses_long_lines_needs_three_for_a_lost_face() -> None:
    def forgetful(segments: NDArray[np.float64]) -> Any:
        length = np.hypot(segments[:, 2] - segments[:, 0], segments[:, 3] - segments[:, 1])
        return exactly(segments[length < 9])

    rows = [*squares(5), (0, 5, 9.75, 5.25), (9.75, 5.25, 4.5, 8), (4.5, 8, 0, 5)]
    m = plumbline.minimise(rows, forgetful)
    assert m.kind == "face lost" and len(m.lines) == 3 and m.engine == "forgetful"
    for i in range(3):
        rest = np.delete(m.lines.coords, i, axis=0)
        assert "missing" not in {
            f.disagreement
            for f in plumbline.check(forgetful, plumbline.lines(rest)).findings
            if f.kind == "face"
        }


def test_what_a_function_raises_is_an_outcome() -> None:
    def few(segments: NDArray[np.float64]) -> Any:
        if len(segments) > 6:
            raise ValueError(f"too many: {len(segments)}")
        return exactly(segments)

    m = plumbline.minimise(squares(5), few)
    assert (m.outcome, m.kind) == ("loud", "exception: ValueError")
    assert len(m.lines) == 7
    assert "ValueError: too many: 7" in m.to_issue()


def test_what_is_no_result_is_one_too() -> None:
    m = plumbline.minimise(squares(2), lambda segments: 7)
    assert m.outcome == "loud" and m.kind == "exception: no result" and len(m.lines) == 1


def test_ctrl_c_within_a_function_or_its_progress_ends_it() -> None:
    def interrupted(segments: NDArray[np.float64]) -> Any:
        raise KeyboardInterrupt

    def told(part: float) -> None:
        raise LookupError(part)

    with pytest.raises(KeyboardInterrupt):
        plumbline.minimise(GAP, interrupted)
    with pytest.raises(LookupError):
        plumbline.minimise(GAP, "lar", radius=1e-9, progress=told)


def test_it_is_written_and_shown(tmp_path: pathlib.Path) -> None:
    m = plumbline.minimise(GAP, "lar", radius=1e-9)
    plumbline.write(m, tmp_path / "case.lines")
    plumbline.write(m, tmp_path / "case.svg")
    plumbline.write(m, tmp_path / "issue.md")
    assert (tmp_path / "case.lines").read_text() == m.to_lines()
    assert "magnified" in (tmp_path / "case.svg").read_text()
    assert (tmp_path / "issue.md").read_text().startswith("# float LAR: face invented")
    assert "(case.svg)" in m.to_issue(picture_file="case.svg")
    assert repr(m).startswith("<Minimised: disagree: face invented, in 3 of 5")
    assert "iframe" in (m._repr_html_() or "")
    with pytest.raises(TypeError, match="pickled"):
        pickle.dumps(m)
    with pytest.raises(plumbline.Error, match="lines, svg or md"):
        plumbline.write(m, tmp_path / "case.dxf")


def test_runs_may_end_before_it_is_least() -> None:
    m = plumbline.minimise(GAP, "lar", radius=1e-9, max_runs=1)
    assert not m.is_one_minimal and not m.has_simple_numbers and m.kind == "face invented"


def test_what_is_refused() -> None:
    for engine, parameters in (
        ("fast", {}),
        ("files", {}),
        ("lar", {"speed": 1}),
        (exactly, {"a": 1}),
    ):
        with pytest.raises(plumbline.Error):
            plumbline.minimise(GAP, engine, **parameters)  # type: ignore[arg-type]
    with pytest.raises(plumbline.Error, match="nothing is drawn"):
        plumbline.minimise([], "lar")
