"""Line work that meets: what to edit, the proof, and the way back."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Literal, Union

from plumbline import _core
from plumbline._cached import cached
from plumbline._notebook import drawn, framed
from plumbline._numbers import Number, Numbers
from plumbline._sizes import names, size_text
from plumbline._tables import to_geodataframe
from plumbline._whole import optional_count
from plumbline.arrangement import Arrangement, arrange
from plumbline.errors import Error
from plumbline.line_inputs import lines
from plumbline.lines import Lines, LinesLike
from plumbline.lists import Lists

if TYPE_CHECKING:
    from geopandas import GeoDataFrame
from plumbline._drawing_files import (
    _FEATURE_FORMATS,
    _drawing_text,
    _ensure_none,
    _is_decimal,
    _write,
)

Tolerance = Union[Number, Literal["auto", "off"], bool]
"""A size in drawing units; "auto": chosen from the drawing; 0, False or "off": none."""


class Repair:
    """A repaired drawing, and every edit that made it.

    Made by `plumbline.repair`. Exact; `verify` has proven it before it was returned.

    Attributes
    ----------
    input : Lines
        The drawing.

    See Also
    --------
    plumbline.repair, plumbline.undo
    """

    def __init__(self, core: _core.Repair, of: Lines, options: Mapping[str, Any] | None = None):
        self._core = core
        self._options = dict(options or {})
        self.input = of

    @cached
    def output(self) -> Lines:
        """The repaired drawing: `plumbline.arrange` takes it, and all that takes lines."""
        return Lines(self._core.output, self.input.numbers)

    @cached
    def origins(self) -> Lists:
        """Per segment of `output` those of `input` that it stands for, ascending."""
        return Lists(*self._core.origins())

    @cached
    def edits(self) -> list[_core.Edit]:
        """In the order in which they were made: ``kind``, ``where``, ``size`` (rounded),
        ``squared_size`` (exact), lines ``before`` and ``after``."""
        return self._core.edits

    @cached
    def refused(self) -> list[_core.Refusal]:
        """What would have been an edit, and the ``reason`` why it is none."""
        return self._core.refused

    @cached
    def faces(self) -> list[_core.FaceOutcome]:
        """Faces that are not there as they were: ``fate`` ("closed", "split", "joined", "opened",
        "changed"), exact areas, the ``edits`` that did it."""
        return self._core.faces

    @property
    def tolerances(self) -> _core.Tolerances:
        """Up to which size each operation repaired, exactly; 0: it did not."""
        return self._core.tolerances

    @property
    def reasons(self) -> list[str]:
        """Why tolerances that were chosen automatically are what they are, a sentence each."""
        return self._core.reasons

    @property
    def anchored(self) -> list[int]:
        """Segments of `input` that no edit could touch."""
        return self._core.anchored

    @cached
    def changes(self) -> list[_core.NetChange]:
        """What changed on the whole: segments ``before``, with their sources, and ``after``."""
        return _core.net_changes(self.input._core, self._core)

    @cached
    def rounded_lines(self) -> int:
        """How many lines of `changes` end at fractions that no decimal is: all formats but .lines
        round them to doubles, beside what they meet."""
        return sum(
            any(not _is_decimal(c) for point in ends for c in point)
            for change in self.changes
            for ends in change.after
        )

    @cached
    def before(self) -> Arrangement:
        """The arrangement of `input`."""
        return arrange(self.input)

    @cached
    def after(self) -> Arrangement:
        """The arrangement of `output`."""
        return arrange(self.output)

    def verify(self) -> list[_core.Breach]:
        """What is not true of the repair, by code that shares nothing with what made it: nothing.

        The edits make the output of the input; each does what its kind says, within the
        tolerances; what became of faces is as it says.
        """
        return _core.verify_repair(
            self.input._core, self.before._core, self._core, self.after._core
        )

    def compare_rules(self, tolerance: Number | None = None) -> list[_core.RuleOutcome]:
        """The drawing as it is, its repair, and what rules in use make of it at one tolerance, by
        default the largest that was used: LAR's pruning, gaps closed at the mean of their ends, all
        segments extended.

        Raises
        ------
        Error
            For a tolerance of 0, at which nothing moves.
        """
        if tolerance is None:
            used = self.tolerances
            size = max(used.weld, used.grow, used.trim, used.snap)
        else:
            size = Fraction(size_text("tolerance", tolerance))
        if size == 0:
            raise Error("nothing moves, grows or goes at a tolerance of 0: give one")
        return _core.compare_rules(self.input._core, self._core, float(size))

    # Forms.

    def to_text(self, listed: int | None = None) -> str:
        """Tolerances and why, then the edits that do most to faces, `listed` of them or as many as
        fit on a screen; what was refused."""
        return self._core.to_text(self.input._core, optional_count(listed, "listed"))

    def to_json(self) -> str:
        """The log, which `undo` takes: tolerances, edits, faces, what was refused."""
        return self._core.to_json(self.input._core)

    def to_svg(self) -> str:
        """A picture: what was added, removed and moved, and the faces that changed."""
        return self._core.to_svg(self.input._core, self.before._core, self.after._core)

    def to_html(self) -> str:
        """A page: the drawing before, after or both, with lists to click through."""
        return self._core.to_html(self.input._core, self.before._core, self.after._core)

    def to_geopandas(self, what: Literal["edits", "lines"] = "edits") -> GeoDataFrame:
        """A GeoDataFrame. Needs geopandas.

        Parameters
        ----------
        what : {"edits", "lines"}
            The edits and then what was refused, as points; or the repaired drawing, with columns
            ``line``, ``layer``, ``source``, ``id`` and ``virtual``, rounded to nearest doubles.
        """
        if what == "edits":
            table = self._core.table(self.input._core)
        elif what == "lines":
            table = _core.line_table(self._core.output)
        else:
            raise Error(f'there are "edits" and "lines": {what!r}')
        return to_geodataframe(table, self.input.crs)

    def write(
        self, path: str | os.PathLike[str], *, format: str | None = None, edits: bool = False
    ) -> None:
        """Writes the repaired drawing: whole, or not at all.

        A DXF or SVG that was read from a file of that format stays that file, byte by byte, but
        for the elements that were edited; a .lines file is exact; others have nearest doubles. A
        new SVG has y negated where the drawing's runs upwards, as that of an array does. A .json
        file is the log, a .html file the page.

        Parameters
        ----------
        path : path
            Its ending says the format.
        format : str, optional
            "lines", "geojson", "topojson", "dxf", "wkt", "csv", "wkb", "svg", "json" or "html".
        edits : bool
            Whether the edits are written instead, as points.

        Warns
        -----
        LossWarning
            Where a DXF or SVG file cannot be kept, so that lines alone are written.

        Raises
        ------
        Error
            For a format that is not known, and the file that was read; FileError where the file
            cannot be written.
        """
        _write(self, path, format, edits=edits)

    @property
    def _patched(self) -> Lines:
        """The drawing whose file is written with changes."""
        return self.input

    def _written(self, format: str, *, edits: bool = False, **options: Any) -> str | bytes:
        """The content of a file: what `plumbline.write` asks for."""
        _ensure_none(options)
        if edits and format in _FEATURE_FORMATS:
            return self._core.table(self.input._core).written(format)
        if edits:
            raise Error(f"edits are written as {', '.join(_FEATURE_FORMATS)}: {format!r}")
        if format == "json":
            return self.to_json()
        if format == "html":
            return self.to_html()
        return _drawing_text(format, self.input, self.output)

    def _repr_svg_(self) -> str | None:
        return drawn(self.to_svg())

    def _repr_html_(self) -> str | None:
        return framed(self.to_html(), 560)

    def __reduce__(self) -> tuple[Any, ...]:
        return _made, (self.input, self._options)

    def __str__(self) -> str:
        return self.to_text()

    def __repr__(self) -> str:
        return f"<Repair: {self._core.line()}>"


def repair(
    drawing: LinesLike,
    /,
    *,
    tolerance: Tolerance = "auto",
    weld: Tolerance | None = None,
    grow: Tolerance | None = None,
    trim: Tolerance | None = None,
    sliver: Tolerance | None = None,
    snap: Tolerance | None = None,
    simplify: Tolerance | None = None,
    doors: tuple[Number, Number] | None = None,
    walls: str | Sequence[str] = (),
    anchors: str | Sequence[str] = (),
    except_: str | Sequence[str] = (),
    keeps_common_sides: bool = True,
    keeps_layers: bool = True,
    numbers: Numbers | None = None,
) -> Repair:
    """Repairs line work: the least that makes it meet, and nothing that is not listed.

    Lines that overlap become one, doubled ones are welded, loose ends run straight on to what they
    meet first, dangles are trimmed, slivers given to a neighbour, doors closed by virtual lines.

    Parameters
    ----------
    drawing : Arrangement, or whatever `lines` takes
        The drawing.
    tolerance : number, "auto" or False
        One for `weld`, `grow`, `trim` and `sliver`, as far as they are not given. Sizes are in
        drawing units; a float is the decimal that it prints as. "auto": each is chosen from the
        drawing, and `Repair.reasons` says why, or is off where the drawing does not tell. 0,
        False or "off": off.
    weld : number, "auto" or False, optional
        Lines that lie beside another one within this become one with it.
    grow : number, "auto" or False, optional
        Loose ends run straight on, at most so far.
    trim : number, "auto" or False, optional
        Loose ends that reach no further than this beyond a junction go.
    sliver : number, "auto" or False, optional
        Faces no wider than this go to their neighbours; nothing moves.
    snap, simplify : number, optional
        Ends this near to a vertex go there; vertices this near to the line between their
        neighbours go. Off unless given.
    doors : (number, number), optional
        Openings as wide as that, from the least to the largest width, are closed by virtual lines
        on the layer "plumbline-virtual". Off unless given.
    walls : sequence of str
        Layers whose lines have doors and block them; all by default. ``*`` and ``?`` stand for any
        characters, in any case, here and below.
    anchors : sequence of str
        Layers that no edit touches, and to which others go.
    except_ : sequence of str
        Ids of elements that no edit touches.
    keeps_common_sides : bool
        Whether a side that two closed shapes have in common stays drawn by both; else it becomes
        one line, as everything that is drawn twice.
    keeps_layers : bool
        Whether what two layers draw stays drawn by both.
    numbers : {"doubles", "decimals"}, optional
        What floats of the drawing stand for, as in `lines`.

    Returns
    -------
    Repair
        Which `Repair.verify` has proven. Edits depend on the geometry alone, not on order,
        direction or repetition of the lines. What cannot be done without breaking a promise is in
        `Repair.refused`.

    Raises
    ------
    Error
        For a negative size, an empty range of doors, a layer or an id that the drawing does not
        have; as `lines`.

    Notes
    -----
    Some times the cost of `arrange`. Ctrl-C ends it between two steps. What each operation does,
    what is promised and how tolerances are chosen is in docs/repair.md.

    Examples
    --------
    >>> import plumbline
    >>> sloppy = [(0, 0, "10.03", 0), (10, "0.02", 10, 8), (10, 8, 0, 8), (0, 8, 0, 0)]
    >>> fixed = plumbline.repair(sloppy, tolerance=0.05)
    >>> fixed
    <Repair: 2 edits: 1 end grown by 0.02, 1 dangle of 0.03 trimmed; 1 room closed>
    >>> plumbline.arrange(fixed.output).areas[1]
    Fraction(80, 1)
    >>> fixed.verify()
    []
    >>> plumbline.same(plumbline.undo(fixed.output, fixed), sloppy)
    True
    """
    for_all = _tolerance("tolerance", tolerance)
    options = {
        name: for_all if value is None else _tolerance(name, value)
        for name, value in (("weld", weld), ("grow", grow), ("trim", trim), ("sliver", sliver))
    }
    for name, value in (("snap", snap), ("simplify", simplify)):
        text = "0" if value is None else _tolerance(name, value)
        if text is None:
            raise Error(f"{name} has no automatic size: {value!r}")
        options[name] = text
    others = {
        "doors": None if doors is None else _widths(doors),
        "walls": names(walls),
        "anchors": names(anchors),
        "excepted": names(except_),
        "keeps_common_sides": keeps_common_sides,
        "keeps_layers": keeps_layers,
    }
    of = drawing.lines if isinstance(drawing, Arrangement) else drawing
    return _made(lines(of, numbers=numbers), {**options, **others})


def _tolerance(what: str, value: Tolerance) -> str | None:
    """As the library takes it: None is automatic."""
    if isinstance(value, str) and value == "auto":
        return None
    if value is False or (isinstance(value, str) and value == "off"):
        return "0"
    return size_text(what, value)


def _widths(doors: tuple[Number, Number]) -> tuple[str, str]:
    try:
        least, most = doors
    except (TypeError, ValueError):
        raise Error(f"doors are a least and a largest width: {doors!r}") from None
    return size_text("the least width of doors", least), size_text("the largest", most)


def _made(of: Lines, options: Mapping[str, Any]) -> Repair:
    core_options = _core.RepairOptions()
    for name, value in options.items():
        setattr(core_options, name, value)
    return Repair(_core.repair(of._core, core_options), of, options)
