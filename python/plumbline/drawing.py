"""Drawings: line work from files, with its hierarchy."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

from plumbline import _core
from plumbline._numbers import Number, Numbers, exact_text
from plumbline._reading import Reading
from plumbline.errors import Error
from plumbline.lines import Lines, _warn_of_losses
from plumbline.structure import Struct, Structure


class Drawing(Lines):
    """Line work of a file: `Lines`, with the hierarchy that the file has.

    Attributes
    ----------
    structure : Structure
        The hierarchy: layers, blocks, groups. Printed it is a tree.
    """

    _read_from: tuple[str, _core.ReadOptions] | None = None
    """The file and how it was read: to write it with changes."""

    def __init__(self, core: _core.SegmentSet, numbers: Numbers, structure: Structure) -> None:
        super().__init__(core, numbers)
        self.structure = structure

    @property
    def structs(self) -> list[Struct]:
        """The Structs of the hierarchy, each once: layers, blocks, groups, the whole."""
        return self.structure.structs

    def of_category(self, category: str) -> Drawing:
        """The lines within Structs of this category ("layer", "block", ...) alone.

        Raises
        ------
        Error
            Where there is none; it names those that there are.
        """
        part = self.structure.of_category(category)
        return Drawing(part._core.evaluate(self.numbers == "doubles"), self.numbers, part)

    def __getstate__(self) -> tuple[Any, ...]:
        return (*super().__getstate__(), self.structure, self._read_from is not None)

    def __setstate__(self, state: tuple[Any, ...]) -> None:
        *lines, self.structure, is_of_file = state
        super().__setstate__((lines[0], lines[1]))
        reading = self.structure._made_by
        if is_of_file and isinstance(reading, Reading):
            self._read_from = reading.path, reading.options


def read(
    path: str | os.PathLike[str],
    *,
    numbers: Numbers = "decimals",
    format: str = "",
    flatten: Number | None = None,
    hidden: bool = False,
    layers: Sequence[str] = (),
    without_layers: Sequence[str] = (),
    hatches: bool = False,
    layer_property: str = "layer",
    join_curves: bool = True,
    shortest_decimals: bool = False,
) -> Drawing:
    """The drawing in a file, every number as it is written.

    Parameters
    ----------
    path : path
        A ``.svg``, ``.svgz``, ``.dxf``, ``.geojson``, ``.json``, ``.wkt``, ``.wkb``, ``.csv`` or
        ``.lines`` file.
    numbers : {"decimals", "doubles"}
        Exactly what is written, or as programs have it that read doubles.
    format : str
        One of these endings, where the file has another one.
    flatten : number, optional
        Largest distance of a curve from the chords that replace it. By default a thousandth of
        the curve's size or, where that is more, a 5000th of the drawing's.
    hidden : bool
        Whether what the drawing hides is read, too.
    layers, without_layers : sequence of str
        Patterns of the layers that are read, all where there are none, and of those that are not.
    hatches : bool
        Whether boundaries of hatches of a DXF are read.
    layer_property : str
        The property of GeoJSON features that names their layer.
    join_curves : bool
        Whether curves are joined to what they meet within the rounding of the file's numbers.
    shortest_decimals : bool
        Whether 420.34000000000003 is read as 420.34, as programs print doubles.

    Returns
    -------
    Drawing

    Warns
    -----
    LossWarning
        Where something that looks like lines was not understood.

    Raises
    ------
    Error
        For what is no such file, with line, column and text; FileError where it cannot be read.
    """
    options = _core.ReadOptions()
    if not isinstance(format, str):
        raise Error(f"a format is one of the endings: {format!r}")
    options.format = format
    if flatten is not None:
        options.chord_tolerance = exact_text(flatten)
    options.hidden = hidden
    options.layers = [layers] if isinstance(layers, str) else list(layers)
    options.without_layers = (
        [without_layers] if isinstance(without_layers, str) else list(without_layers)
    )
    options.hatches = hatches
    options.layer_property = layer_property
    options.join_curves = join_curves
    options.shortest_decimals = shortest_decimals
    if numbers not in ("decimals", "doubles"):
        raise Error(f'numbers are "doubles" or "decimals": {numbers!r}')
    structure = _core.read(os.fspath(path), options)
    made_by = Reading.of_file(path, options)
    core = structure.evaluate(numbers == "doubles")
    result = Drawing(core, numbers, Structure(structure, made_by))
    result._read_from = os.fspath(path), options
    _warn_of_losses(result)
    return result
