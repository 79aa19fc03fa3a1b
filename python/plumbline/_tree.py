"""Hierarchies as text."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator

from plumbline import _core


def plural(n: int, noun: str) -> str:
    """ "1 model", "2 models"."""
    return f"{n} {noun}" if n == 1 else f"{n} {noun}s"


def title(core: _core.Structure) -> str:
    """What a tree begins with."""
    root = core.root
    files = ", ".join(os.path.basename(file) for file in core.files)
    name = (core.name(root) if root is not None else "") or files or "(no name)"
    return (
        f"{name}: {plural(len(core) - (root is not None), 'struct')}, "
        f"{plural(core.instance_count(), 'model')} when evaluated"
    )


def tree_rows(core: _core.Structure, root: int, depth: int | None) -> Iterator[str]:
    """Rows of a tree below its title, which stands for the root. Structs without a name that do
    nothing but place another one are passed over."""
    own = _own(core.contents(root))
    if own:
        yield f"  {own}"
    way = [_children(core, root)]
    while way:
        child, times = next(way[-1], (None, 0))
        if child is None:
            way.pop()
            continue
        words = [core.name(child) or "(no name)"]
        if core.category(child):
            words.append(f"({core.category(child)})")
        if times > 1:
            words.append(f"x {times}")
        own = _own(core.contents(child))
        yield "  " * len(way) + " ".join(words) + (f"  {own}" if own else "")
        if depth is None or len(way) < depth:
            way.append(_children(core, child))


def _children(core: _core.Structure, number: int) -> Iterator[tuple[int, int]]:
    """The Structs that a body refers to, in the order of first use, and how often."""
    counts: Counter[int] = Counter()
    for child, times in Counter(core.contents(number).structs).items():
        while (placed := _placed(core, child)) is not None:
            child, times = placed[0], times * placed[1]
        counts[child] += times
    return iter(counts.items())


def _placed(core: _core.Structure, number: int) -> tuple[int, int] | None:
    """Of a Struct without a name that does nothing but place another one this, and how often."""
    if core.name(number) or core.category(number):
        return None
    contents = core.contents(number)
    kinds = Counter(contents.structs)
    if contents.elements or contents.models or len(kinds) != 1:
        return None
    return next(iter(kinds.items()))


def _own(contents: _core.Contents) -> str:
    """What a body holds itself."""
    parts = []
    if contents.elements:
        segments = plural(contents.segments, "segment")
        parts.append(f"{plural(contents.elements, 'element')} of {segments}")
    if contents.models:
        parts.append(plural(contents.models, "model"))
    return ", ".join(parts)
