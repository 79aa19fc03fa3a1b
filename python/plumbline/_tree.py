"""Hierarchies as text."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from plumbline import _core


def plural(n: int, noun: str) -> str:
    """"1 model", "2 models"."""
    return f"{n} {noun}" if n == 1 else f"{n} {noun}s"


def title(core: _core.Structure) -> str:
    """What a tree begins with."""
    root = core.root
    name = (core.name(root) if root is not None else "") or ", ".join(core.files) or "(no name)"
    return (
        f"{name}: {plural(len(core) - (root is not None), 'struct')}, "
        f"{plural(core.instance_count(), 'model')} when evaluated"
    )


def tree_rows(core: _core.Structure, root: int, depth: int | None) -> Iterator[str]:
    """Rows of a tree below its title, which stands for the root."""
    own = _own(core.contents(root))
    if own:
        yield f"  {own}"
    way = [iter(Counter(core.contents(root).structs).items())]
    while way:
        child, times = next(way[-1], (None, 0))
        if child is None:
            way.pop()
            continue
        contents = core.contents(child)
        words = [core.name(child) or "(no name)"]
        if core.category(child):
            words.append(f"({core.category(child)})")
        if times > 1:
            words.append(f"x {times}")
        own = _own(contents)
        yield "  " * len(way) + " ".join(words) + (f"  {own}" if own else "")
        if depth is None or len(way) < depth:
            way.append(iter(Counter(contents.structs).items()))


def _own(contents: _core.Contents) -> str:
    """What a body holds itself."""
    parts = []
    if contents.elements:
        segments = plural(contents.segments, "segment")
        parts.append(f"{plural(contents.elements, 'element')} of {segments}")
    if contents.models:
        parts.append(plural(contents.models, "model"))
    return ", ".join(parts)
