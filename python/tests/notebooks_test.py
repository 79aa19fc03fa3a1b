"""The notebooks of the pages run from top to bottom, as plain Python."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from conftest import ROOT

NOTEBOOKS = sorted((ROOT / "python" / "docs" / "notebooks").glob("*.md"))
CELL = re.compile(r"^```\{code-cell\} python\n(.*?)^```$", re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize("name", ["rooms", "lar", "polygonize", "engines"])
def test_the_first_cell_finds_the_repository_above_it(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = ROOT / "python" / "docs" / "notebooks"
    monkeypatch.delenv("PLUMBLINE_ROOT", raising=False)
    monkeypatch.chdir(folder)
    names: dict[str, object] = {}
    exec(CELL.findall((folder / f"{name}.md").read_text())[0], names)
    assert names["root"] == ROOT


@pytest.mark.parametrize(
    "notebook", [n for n in NOTEBOOKS if n.stem != "index"], ids=lambda n: n.stem
)
def test_every_cell_runs(notebook: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PLUMBLINE_ROOT", str(ROOT))
    cells = CELL.findall(notebook.read_text())
    assert len(cells) > 3
    names: dict[str, object] = {}
    for cell in cells:
        exec(compile(cell, str(notebook), "exec"), names)
