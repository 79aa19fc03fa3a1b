"""Pictures for notebooks."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from plumbline import _core

if TYPE_CHECKING:
    from plumbline.arrangement import Arrangement
    from plumbline.lines import Lines

LARGEST = 20_000
"""So many lines a notebook draws without delay, in some 500 kB."""

_WIDTH, _HEIGHT = 720.0, 360.0  # at most, in CSS pixels


def sized(svg: str, note: str = "") -> str:
    """A picture as large as fits a notebook, with a note below it."""
    found = re.match(r'<svg ([^>]*?)viewBox="([^"]*)"', svg)
    if not found:
        return svg
    x, y, width, height = (float(number) for number in found[2].split())
    text = ""
    if note:
        size = width / 40
        text = (
            f'<text x="{x + size / 2:g}" y="{y + height + size:g}" font-size="{size:g}" '
            f'font-family="sans-serif">{note}</text>\n'
        )
        height += 1.5 * size
    scale = min(_WIDTH / width, _HEIGHT / height) if width > 0 and height > 0 else 1.0
    start = (
        f'<svg {found[1]}width="{width * scale:.4g}" height="{height * scale:.4g}" '
        f'viewBox="{x:.17g} {y:.17g} {width:.17g} {height:.17g}"'
    )
    end = svg.rindex("</svg>")
    return start + svg[found.end() : end] + text + svg[end:]


def arrangement_picture(a: Arrangement) -> str:
    """Faces by depth and edges; of many edges a sample."""
    edges = a.edges
    if len(edges) <= LARGEST:
        return sized(_core.complex_svg(a._core, a.lines._core.y_up))
    chosen = _sample(len(edges))
    coords = a.vertices[edges[chosen]].reshape(-1, 4)
    return _sampled(coords, len(edges), "edges", a.lines._core.y_up)


def lines_picture(lines: Lines) -> str:
    """All segments; of many a sample."""
    if len(lines) <= LARGEST:
        return sized(_core.lines_svg(lines._core))
    coords = lines.coords[_sample(len(lines))]
    return _sampled(coords, len(lines), "segments", lines._core.y_up)


def _sample(count: int) -> NDArray[np.intp]:
    return np.linspace(0, count - 1, LARGEST).astype(np.intp)


def _sampled(coords: NDArray[np.float64], count: int, what: str, y_up: bool) -> str:
    items = _core.Items("<sample>", "row", None, len(coords), [], [], None)
    sample = _core.SegmentSet.of_doubles(np.ascontiguousarray(coords), items, False)
    sample.set_frame("", y_up)
    return sized(_core.lines_svg(sample), f"{LARGEST:,} of {count:,} {what}")
