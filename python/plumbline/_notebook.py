"""Pages in notebooks."""

from __future__ import annotations

import html

MOST_BYTES = 8_000_000
"""What is larger is not put into a notebook."""


def framed(page: str, height: int = 480) -> str | None:
    """A page in a frame of its own, which keeps its scripts and styles away from the notebook's.

    The page is in the attribute ``srcdoc``, so that nothing is loaded: that works in Jupyter, on
    nbviewer and in VS Code. None for a very large one.
    """
    if len(page) > MOST_BYTES:
        return None
    return (
        f'<iframe srcdoc="{html.escape(page)}" sandbox="allow-scripts" width="100%" '
        f'height="{height}" style="border: 1px solid #ccc; background: #fff"></iframe>'
    )


def drawn(svg: str) -> str | None:
    """A picture; None for a very large one."""
    return svg if len(svg) <= MOST_BYTES else None
