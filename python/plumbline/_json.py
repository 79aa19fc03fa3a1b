"""JSON of objects, with errors of this package."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from typing import Any

from plumbline.errors import Error


def dumped(mapping: Mapping[str, Any], plain: Callable[[Any], Any] | None = None) -> str:
    """The text of an object; `plain` makes what the json module takes of other values."""
    try:
        return json.dumps(mapping, default=plain)
    except RecursionError:
        raise Error("a mapping that is nested too deep, or contains itself") from None
    except (TypeError, ValueError) as error:
        if isinstance(error, Error):
            raise
        raise Error(f"a mapping that is no JSON: {error}") from None


def loaded(text: str, what: str) -> Any:
    """What a text says."""
    try:
        return json.loads(text)
    except RecursionError:
        raise Error(f"{what} that is nested too deep") from None
    except ValueError as error:
        raise Error(f"{what} that is no JSON: {error}") from None
