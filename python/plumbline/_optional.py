"""Packages that only some functions need."""

from __future__ import annotations

from importlib import import_module
from typing import Any

_EXTRAS = {"networkx": "graph"}


def needed(module: str) -> Any:
    """The module.

    Raises
    ------
    ImportError
        Where it is not installed, with what installs it.
    """
    try:
        return import_module(module)
    except ImportError as error:
        extra = _EXTRAS.get(module, "geo")
        raise ImportError(
            f'this needs {module}: pip install "plumbline-geometry[{extra}]"', name=module
        ) from error
