"""Structs as the library has them, and as they are pickled: without recursion, each once."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from plumbline import _core
from plumbline._numbers import Numbers
from plumbline._reading import structure_read
from plumbline.errors import Error
from plumbline.lines import Lines
from plumbline.maps import Map
from plumbline.models import LarModel, as_model

if TYPE_CHECKING:
    from plumbline.structure import BodyItem, Struct, Structure


def _compiled(root: Struct) -> _core.Structure:
    """The Structs that Python made, each once, and the structures that others are part of."""
    from plumbline.structure import Struct

    core = _core.Structure("<struct>")
    numbers: dict[int, int] = {}
    starts: dict[int, int] = {}  # of structures that were appended

    def number_of(struct: Struct) -> int:
        if struct._owner is None:
            return numbers[id(struct)]
        owner = struct._owner
        if id(owner) not in starts:
            starts[id(owner)] = core.append(owner._core)
        return starts[id(owner)] + struct._number

    for struct in _children_first(root):
        parts = [number_of(item) for item in struct.body if isinstance(item, Struct)]
        number = core.add_struct(struct.name, struct.category)
        numbers[id(struct)] = number
        part = iter(parts)
        for item in struct.body:
            if isinstance(item, Struct):
                core.add_reference(number, next(part))
            else:
                _add(core, number, item)
    core.set_root(numbers[id(root)])
    return core


def _children_first(root: Struct) -> Iterator[Struct]:
    """The Structs that Python made, without recursion, each once."""
    from plumbline.structure import Struct

    seen = {id(root)}
    way = [(root, iter(root.body))]
    while way:
        struct, rest = way[-1]
        for item in rest:
            if isinstance(item, Struct) and item._owner is None and id(item) not in seen:
                seen.add(id(item))
                way.append((item, iter(item.body)))
                break
        else:
            way.pop()
            yield struct


def _add(core: _core.Structure, number: int, item: BodyItem) -> None:
    if isinstance(item, Map):
        if item.degrees is not None:
            core.add_turn(number, str(item.degrees))
        else:
            core.add_map(number, item._core, repr(item), str(item.bound))
    elif isinstance(item, LarModel):
        core.add_model(number, item._core)
    elif isinstance(item, Lines):
        core.add_lines(number, item._core)
    elif isinstance(item, _core.Element):
        core.add_element(number, item)


def _structure_of(struct: Struct) -> Structure:
    return struct.structure


def _structure_read(*state: Any) -> Structure:
    from plumbline.structure import Structure

    return Structure(*structure_read(*state))


def _struct_of(owner: Structure, number: int) -> Struct:
    return owner._struct(number)


Row = tuple[str, str, list[Any]]
"""A Struct: name, category, items, those that Python made as `_Reference`."""


@dataclass(frozen=True)
class _Reference:
    row: int


def _rows(root: Struct) -> list[Row]:
    """The Structs that Python made below one, and itself last: pickled without recursion."""
    from plumbline.structure import Struct

    number: dict[int, int] = {}
    rows: list[Row] = []
    for struct in _children_first(root):
        items: list[Any] = []
        for item in struct.body:
            if isinstance(item, _core.Element):
                raise TypeError(
                    "a Struct with elements of a drawing cannot be pickled: put the drawing's "
                    "Struct, or its lines, into it"
                )
            is_row = isinstance(item, Struct) and item._owner is None
            items.append(_Reference(number[id(item)]) if is_row else item)
        number[id(struct)] = len(rows)
        rows.append((struct.name, struct.category, items))
    return rows


def _struct_of_rows(rows: list[Row]) -> Struct:
    from plumbline.structure import Struct

    made: list[Struct] = []
    for name, category, items in rows:
        body = [made[item.row] if isinstance(item, _Reference) else item for item in items]
        made.append(Struct(body, name, category))
    return made[-1]


def _item(item: Any, numbers: Numbers) -> BodyItem:
    """An item of a body as what it stands for."""
    from plumbline.structure import Struct, Structure

    if isinstance(item, (Struct, LarModel, Map, _core.Element)):
        return item
    if isinstance(item, Structure):
        return item.root
    if isinstance(item, Lines):
        structure = getattr(item, "structure", None)
        return structure.root if isinstance(structure, Structure) else item
    if isinstance(item, np.ndarray) and item.ndim == 2 and item.shape[0] == item.shape[1]:
        return Map(item, numbers=numbers)
    if isinstance(item, (tuple, list)):
        return as_model(item, numbers)
    raise Error(
        f"a body holds models (V, CV), maps, Structs and Lines: {type(item).__name__} {item!r:.60}"
    )
