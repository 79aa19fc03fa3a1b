"""Paths of data that tests read."""

import os
from pathlib import Path

import pytest

ROOT = Path(os.environ.get("PLUMBLINE_ROOT", Path(__file__).resolve().parents[2]))


@pytest.fixture(scope="session")
def examples() -> Path:
    """The drawings of examples/data."""
    return ROOT / "examples" / "data"


@pytest.fixture(scope="session")
def test_data() -> Path:
    """The data of the C++ tests."""
    return ROOT / "tests" / "data"
