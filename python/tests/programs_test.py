"""Programs as engines. The one of these tests cuts nothing, and fails in whatever way is asked."""

from __future__ import annotations

import os
from pathlib import Path

import plumbline
import pytest
from plumbline import _programs

FAKE = Path(__file__).resolve().parents[2] / "tests" / "support" / "fake_engine"
UNCROSSED = [(0, 0, 4, 0), (4, 0, 4, 3)]
CROSSED = [(0, 0, 4, 4), (0, 4, 4, 0)]


@pytest.fixture
def found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder of PATH with the engine `found`, and with one that is not here."""
    (tmp_path / "plumbline-engine-found").symlink_to(FAKE)
    absent = tmp_path / "plumbline-engine-absent"
    absent.write_text("#!/bin/sh\necho no library >&2\nexit 3\n")
    absent.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}{os.pathsep}{os.environ['PATH']}")
    return tmp_path


def test_a_program_at_a_path_is_an_engine() -> None:
    check = plumbline.cross_check(UNCROSSED, FAKE)
    assert check.agree
    assert (check.answer.engine, check.answer.version) == ("fake", "1.5")
    crossed = plumbline.cross_check(CROSSED, str(FAKE))
    assert not crossed.agree
    assert {cause.stage for cause in crossed.causes} == {"fake"}


def test_a_program_in_path_is_found_by_its_name(found: Path) -> None:
    check = plumbline.cross_check(UNCROSSED, "found", configuration="snapped", radius=0.5)
    assert check.agree and check.tolerance == check.answer.radius == 0.5
    assert plumbline.cross_check(UNCROSSED, "found", configuration="snapped").answer.radius == 0.25
    listed = {e.name: e for e in plumbline.engines()}
    assert [c.name for c in listed["found"].configurations[:2]] == ["uncut", "snapped"]
    assert listed["found"].configurations[1].tolerance_kind == "snap"
    assert listed["found"].program == str(found / "plumbline-engine-found")
    assert listed["lar"].title == "float LAR" and listed["lar"].program is None
    assert "no library" in (listed["absent"].not_here or "")
    with pytest.raises(plumbline.Error, match=r"programs found are .*found"):
        plumbline.cross_check(UNCROSSED, "luck")
    with pytest.raises(plumbline.Error, match="not here: no library"):
        plumbline.cross_check(UNCROSSED, "absent")


def test_a_failure_is_a_finding() -> None:
    failed = plumbline.cross_check(UNCROSSED, FAKE, configuration="throws")
    [finding], [cause] = failed.findings, failed.causes
    assert not failed and failed.compared == "nothing"
    assert finding.message == "fake says Sorry: no"
    assert cause.rule == "engine-error"
    late = plumbline.cross_check(UNCROSSED, FAKE, configuration="hangs", seconds=0.3)
    assert late.findings[0].message == "fake gave no answer within 0.3 s"


def test_what_is_not_of_the_protocol_is_an_error() -> None:
    with pytest.raises(plumbline.Error, match="does not keep to the protocol"):
        plumbline.cross_check(UNCROSSED, FAKE, configuration="garbage")
    with pytest.raises(plumbline.Error, match="the parameter configuration is uncut or"):
        plumbline.cross_check(UNCROSSED, FAKE, configuration="magic")


def test_parameters_of_programs_are_listed() -> None:
    names = [p.name for p in plumbline.engine_parameters(FAKE)]
    assert names == ["configuration", "radius", "seconds", "memory"]


def test_programs_beside_the_tool_come_first(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    tool = tmp_path / "bin" / "plumbline"
    tool.parent.mkdir()
    tool.write_text("#!/bin/sh\n")
    tool.chmod(0o755)
    monkeypatch.setenv("PATH", str(tool.parent))
    assert _programs.folders() == [
        str(tmp_path / "libexec" / "plumbline"),
        str(tmp_path / "bin" / "libexec" / "plumbline"),
        str(tool.parent),
    ]


def test_a_program_is_minimised_by_its_path_and_by_its_name(found: Path) -> None:
    rows = [*CROSSED, *((x, 9, x + 1, 9) for x in range(0, 12, 2))]
    for engine in (FAKE, "found"):
        m = plumbline.minimise(rows, engine)
        assert (m.outcome, len(m.lines), m.segments_before) == ("invalid", 2, 8)
    failed = plumbline.minimise(rows, FAKE, configuration="throws")
    assert (failed.outcome, len(failed.lines)) == ("loud", 2)
