"""Warnings that point to the user's own line."""

from __future__ import annotations

import sys
import warnings
from pathlib import Path

from plumbline.errors import LossWarning

_PACKAGE = str(Path(__file__).parent)


def warn_of_loss(message: str) -> None:
    """Warns at the line that called into the package."""
    level = 1
    frame = sys._getframe(1)
    while frame.f_back is not None and frame.f_code.co_filename.startswith(_PACKAGE):
        frame = frame.f_back
        level += 1
    warnings.warn(message, LossWarning, stacklevel=level + 1)
