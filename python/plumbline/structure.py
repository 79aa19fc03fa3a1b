"""Hierarchies: LAR's Struct, and those of drawings."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from fractions import Fraction
from typing import Any, Union

from plumbline import _core
from plumbline._cached import cached
from plumbline._numbers import Numbers
from plumbline._reading import Reading
from plumbline._struct_making import (
    _compiled,
    _item,
    _rows,
    _struct_of,
    _struct_of_rows,
    _structure_of,
    _structure_read,
)
from plumbline._tree import plural, title, tree_rows
from plumbline.errors import Error
from plumbline.lines import Lines, _warn_of_losses
from plumbline.maps import Map
from plumbline.models import LarModel, ModelLike

BodyItem = Union["Struct", LarModel, Map, Lines, _core.Element]
ExactBox = tuple[tuple[Fraction, ...], tuple[Fraction, ...]]
StructLike = Union["Struct", "Structure", ModelLike]
"""A `Struct`, a `Structure`, or a model as LAR has them."""

_SHOWN = 40  # lines of a tree that is printed


class Struct:
    """LAR's Struct: an ordered body of models, maps, Structs and lines. A map applies to all that
    follows it in the same body, and to nothing else.

    Immutable. A Struct that is used several times is stored once, however often and deep.

    Parameters
    ----------
    body : iterable
        `LarModel` or LAR's tuples (V, CV), (V, FV, EV); maps (`t`, `s`, `r`, `Map`, or a square
        array in homogeneous coordinates); `Struct`; `Lines` and `Drawing`, with their hierarchy;
        elements of a drawing's Structs, which then have no place in its file any more.
    name : str
        It stands in the paths of what comes from it.
    category : str
        Its kind, for `of_category`: "layer", "block", "chair", ...
    numbers : {"decimals", "doubles"}
        Whether floats of tuples and arrays in the body stand for the decimals that they print as,
        0.1 for 1/10, or for what they are.

    Raises
    ------
    Error
        For an item that is none of these.

    Notes
    -----
    Source: Struct of larstruct (2015), section 2.3. There the dimension is that of the first item;
    here items of different dimensions are refused on evaluation.

    Examples
    --------
    >>> from plumbline import Struct, box, evaluate, r, t
    >>> square = ([(0, 0), (0, 1), (1, 0), (1, 1)], [[0, 1, 3, 2]])
    >>> pair = Struct([square, t(2, 0), square], name="pair")
    >>> scene = Struct([pair, r(degrees=45), Struct([r(degrees=45), pair])], name="scene")
    >>> evaluate(scene)
    <Lines: 16 segments of 4 items, floats as decimals>
    >>> [[str(x) for x in corner] for corner in box(scene)]
    [['-1', '0'], ['3', '3']]
    >>> print(scene)
    scene: 2 structs, 4 models when evaluated
      pair x 2  2 models
    """

    def __init__(
        self,
        body: Iterable[Any] = (),
        name: str = "",
        category: str = "",
        *,
        numbers: Numbers = "decimals",
    ) -> None:
        self.name = str(name)
        self.category = str(category)
        self._items: tuple[BodyItem, ...] | None = tuple(_item(item, numbers) for item in body)
        self._owner: Structure | None = None
        self._number = 0

    @classmethod
    def _of(cls, owner: Structure, number: int) -> Struct:
        """A Struct of a structure, whose items are made when they are asked for."""
        result = object.__new__(cls)
        result.name = owner._core.name(number)
        result.category = owner._core.category(number)
        result._items = None
        result._owner = owner
        result._number = number
        return result

    @property
    def body(self) -> tuple[BodyItem, ...]:
        """Its items. Of a drawing, elements: segments with their source."""
        if self._items is None:
            assert self._owner is not None
            self._items = tuple(self._owner._items(self._number))
        return self._items

    def __len__(self) -> int:
        return len(self.body)

    def __iter__(self) -> Iterator[BodyItem]:
        return iter(self.body)

    def __getitem__(self, i: int) -> BodyItem:
        return self.body[i]

    @cached
    def structure(self) -> Structure:
        """It and all that it refers to, with what can be asked of that."""
        if self._owner is not None:
            core = self._owner._core
            if core.root == self._number:
                return self._owner
            made_by = _structure_of, (self,)
            return Structure(core.with_root(self._number), made_by)
        return Structure(_compiled(self), (_structure_of, (self,)))

    @property
    def dimension(self) -> int:
        """Of all its models and maps; 0 where there are none."""
        return self.structure.dimension

    @property
    def box(self) -> ExactBox | None:
        """The least box, (low, high), as `plumbline.box` has it."""
        return self.structure.box

    def __reduce__(self) -> tuple[Any, ...]:
        if self._owner is not None:
            return _struct_of, (self._owner, self._number)
        return _struct_of_rows, (_rows(self),)

    def __str__(self) -> str:
        return str(self.structure)

    def __repr__(self) -> str:
        category = f" ({self.category})" if self.category else ""
        return f"<Struct: {self.name or 'no name'}{category}, {plural(len(self), 'item')}>"


class Structure:
    """A hierarchy of Structs, each stored once: that of a drawing, or of a `Struct`.

    Printed it is a tree: names, categories in parentheses, how often a Struct is used there, and
    what it holds itself.

    See Also
    --------
    plumbline.read, plumbline.Struct
    """

    def __init__(
        self,
        core: _core.Structure,
        made_by: tuple[Callable[..., Structure], tuple[Any, ...]] | Reading | None = None,
    ) -> None:
        self._core = core
        self._made_by = made_by
        self._made: dict[int, Struct] = {}

    @classmethod
    def from_json(cls, text: str, name: str = "<json>") -> Structure:
        """Of the text that `to_json` writes, or of LAR's hierarchies in that form."""
        return cls(_core.Structure.of_json(text, name), (cls.from_json, (text, name)))

    @classmethod
    def read(cls, path: str | os.PathLike[str]) -> Structure:
        """The hierarchy of a file, of any dimension, without its lines. `plumbline.read` has both,
        and says how files are read."""
        options = _core.ReadOptions()
        return cls(_core.read(os.fspath(path), options), Reading.of_file(path, options))

    @property
    def root(self) -> Struct:
        """The Struct that is the whole."""
        number = self._core.root
        if number is None:
            raise Error("there is no Struct")
        return self._struct(number)

    @property
    def structs(self) -> list[Struct]:
        """All Structs, each once."""
        return [self._struct(number) for number in range(len(self))]

    def __len__(self) -> int:
        return len(self._core)

    def _struct(self, number: int) -> Struct:
        if number not in self._made:
            self._made[number] = Struct._of(self, number)
        return self._made[number]

    def _items(self, number: int) -> Iterator[BodyItem]:
        for k in range(self._core.body_size(number)):
            item = self._core.item(number, k)
            if isinstance(item, int):
                yield self._struct(item)
            elif isinstance(item, _core.Affine):
                yield Map._of(item)
            elif isinstance(item, _core.Turn):
                yield Map._of(None, f"r(degrees={item.degrees})", degrees=item.degrees)
            elif isinstance(item, _core.LarModel):
                yield LarModel._of(item)
            else:
                yield item

    @property
    def files(self) -> list[str]:
        """Names of the files."""
        return self._core.files

    @property
    def rejected(self) -> list[_core.Rejected]:
        """Items of the file that were not read, and why."""
        return self._core.rejected

    @property
    def remarks(self) -> list[_core.Remark]:
        """What is to be said of items that were read."""
        return self._core.remarks

    @property
    def ledger(self) -> list[_core.Replacement]:
        """What was replaced on the way to exact numbers, rotations on evaluation included."""
        return self._core.ledger + self._core.replaced()

    @property
    def layers(self) -> list[_core.Layer]:
        """Layers that the file declares."""
        return self._core.layers

    @property
    def dimension(self) -> int:
        """Of all models and maps; 0 where there are none.

        Raises
        ------
        Error
            Where two are different.
        """
        return self._core.dimension()

    @property
    def instances(self) -> int:
        """How many models and elements there are when each counts as often as it is used."""
        return self._core.instance_count()

    @property
    def box(self) -> ExactBox | None:
        """The least box, (low, high), as `plumbline.box` has it."""
        corners = self._core.box()
        return None if corners is None else (tuple(corners[0]), tuple(corners[1]))

    def evaluate(self, *, numbers: Numbers = "decimals") -> Lines:
        """Its lines, as `plumbline.evaluate` has them."""
        from plumbline.evaluation import evaluate

        return evaluate(self, numbers=numbers)

    def view(self) -> Lines:
        """Lines to look at: as `evaluate`, and of space in an oblique view, (x + y/2, z + y/4),
        exactly.

        Raises
        ------
        Error
            For another dimension than 2 or 3.
        """
        result = Lines(self._core.drawn(), "decimals")
        _warn_of_losses(result)
        return result

    def models(self) -> list[LarModel]:
        """All models under the maps above them, in traversal order: larlib's evalStruct. Elements
        of a drawing are models (V, EV)."""
        return [LarModel._of(core) for core in self._core.models()]

    def to_lar(self, *, decimals: int | None = None, merge_cells: bool = False) -> LarModel:
        """All of it as one model: larlib's struct2lar.

        Parameters
        ----------
        decimals : int, optional
            Vertices are the same when they are equal after rounding to so many, half away from
            zero, and are rounded; by default when they are equal.
        merge_cells : bool
            Whether cells of the same vertices are kept once.
        """
        return LarModel._of(self._core.to_lar(decimals, merge_cells))

    def of_category(self, category: str) -> Structure:
        """What stands within Structs of this category.

        Raises
        ------
        Error
            Where there is none; it names those that there are.
        """
        made_by = Structure.of_category, (self, category)
        return Structure(self._core.of_category(category), made_by)

    def embed(self, k: int) -> Structure:
        """With k more dimensions, for k < 0 with -k fewer."""
        return Structure(self._core.embedded(k), (Structure.embed, (self, k)))

    def to_json(self) -> str:
        """As text that `from_json` and `plumbline.read` take; docs/json.md describes it."""
        return self._core.to_json()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes that text to a .json file."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.to_json())

    def tree(self, *, depth: int | None = None, lines: int | None = None) -> str:
        """The tree as text, no deeper than `depth`, and of at most so many lines."""
        text = [title(self._core)]
        if self._core.root is not None:
            rows = tree_rows(self._core, self._core.root, depth)
            for row in rows:
                if lines is not None and len(text) == lines:
                    text.append(f"  ... {1 + sum(1 for _ in rows)} more lines")
                    break
                text.append(row)
        return "\n".join(text)

    def __eq__(self, other: object) -> bool:
        """Whether all Structs, and what is said of them, are the same."""
        if not isinstance(other, Structure):
            return NotImplemented
        return self._core == other._core

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        """What it was made of: the file's bytes, or Structs."""
        if isinstance(self._made_by, tuple):
            return self._made_by
        state = None if self._made_by is None else self._made_by.state(self._core)
        if state is None:
            raise TypeError(
                "this Structure cannot be pickled so that it stays the same, as that of a file "
                "that has changed, or of a pipe: pickle the Lines that evaluate() gives"
            )
        return _structure_read, state

    def __str__(self) -> str:
        return self.tree(lines=_SHOWN)

    def __repr__(self) -> str:
        n = len(self)
        return f"<Structure: {plural(n, 'struct')}, {plural(self.instances, 'model')} evaluated>"


def as_structure(struct: StructLike | Lines) -> Structure:
    """A structure of whatever stands for one.

    Raises
    ------
    Error
        For what does not.
    """
    if isinstance(struct, Structure):
        return struct
    if isinstance(struct, Struct):
        return struct.structure
    structure = getattr(struct, "structure", None)
    if isinstance(structure, Structure):  # of a Drawing
        return structure
    return Struct([struct]).structure
