"""The project's own float engines, held against the exact arrangement."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Literal, Union

from plumbline import _core
from plumbline._arguments import (
    arrangement_of,
    threads_of,
)
from plumbline._numbers import Number, Numbers, exact_text
from plumbline._programs import folders, name_of
from plumbline._progress import Progress, told
from plumbline.arrangement import Arrangement
from plumbline.drawing import Drawing
from plumbline.errors import Error
from plumbline.lines import Lines, LinesLike

if TYPE_CHECKING:
    pass
from plumbline.check import Check, _drawn, _structure, _tolerance, _warn_of_losses


def cross_check(
    drawing: Arrangement | LinesLike,
    engine: str | os.PathLike[str] = "lar",
    *,
    variant: Literal["published", "repaired"] | None = None,
    advice: bool | None = None,
    tolerance: Number | None = None,
    unit_square: bool = False,
    svg2lines: bool = False,
    numbers: Numbers | None = None,
    threads: int | None = None,
    progress: Progress = None,
    **parameters: Union[Number, None],
) -> Check:
    """The answer of a float engine, held against the exact arrangement: of one of this library, or
    of a program.

    Parameters
    ----------
    drawing : Arrangement, or line work as `lines` takes it
    engine : str or path
        "lar": the best float version of LAR's algorithm; "inters": LAR's module as published in
        2015; "plasm": Plasm.jl's `ARRANGE2D`; "files": a result that is there, with the parameter
        `file`. Or a program that speaks the protocol of the study's adapters: its name, as
        `engines` lists it, or its path, which as a text has a slash.
    variant : {"published", "repaired"}, optional
        Other names of "inters" and "lar".
    advice : bool, optional
        Whether to look for the radii with which the engine is right, by a dozen runs. By default
        for up to 50,000 edges.
    tolerance : number, optional
        Vertices match within this distance. By default the radius of the engine.
    unit_square : bool
        Whether the drawing is mapped to the unit square first, as published for SVG.
    svg2lines : bool
        Of inters: whether to find what the published reader of SVG would misread, too. Needs a
        drawing that was read from an SVG file.
    numbers, threads, progress
        As in `check`.
    **parameters
        Of the engine, as `engine_parameters` lists them. `radius` may be "larlib" (0.001 of the
        drawing's longer side), "plasm" (1e-8) or "drawing" (the engine's own), too. Of programs
        `configuration`, one of those that they list; `radius`, the tolerance of those that have
        one; the limits `seconds`, by default 60, and `memory` in gigabytes, by default 4.

    Returns
    -------
    Check
        With causes: the stage of the engine to blame for each finding, proved by continuing
        its outputs exactly where it says `confirmed`. A program that failed, crashed or was
        ended, with its limits, has no result; the one finding says so.

    Raises
    ------
    Error
        Where nothing is drawn; for engines and parameters that there are not, and values that they
        do not take; for programs that do not keep to the protocol, or whose engine is not here; as
        `arrange`.

    Examples
    --------
    >>> import plumbline
    >>> thin = "MULTILINESTRING ((0 0, 8 0, 8 8, 0 8, 0 0), (0 0.005, 8 0.005))"
    >>> c = plumbline.cross_check(thin)
    >>> c.agree, c.answer.radius
    (False, 0.008)
    >>> sorted({cause.rule for cause in c.causes})
    ['merged-within-radius']
    >>> bool(plumbline.cross_check(thin, radius=c.right_radii.advised))
    True
    """
    engine = _engine_of_variant(name_of(engine), variant)
    settings = [(name, _setting(name, value)) for name, value in parameters.items()]
    places = folders()
    _core.engine_parameters(engine, places)  # refused at once where there is no such engine
    within, count = _tolerance(tolerance), threads_of(threads)
    of = _drawn(arrangement_of(drawing, numbers=numbers, threads=threads))
    answer = _core.engine_answer(
        engine,
        of.lines._core,
        unit_square,
        settings,
        _svg_file(of.lines, engine) if svg2lines else "",
        places,
        count,
    )
    _warn_of_losses(answer)
    exact = _mapped(of, count) if unit_square else of
    with told(progress, "checking") as callback:
        core = _core.check(
            exact.lines._core,
            exact._core,
            answer,
            _structure(of.lines),
            unit_square,
            within,
            advice,
            False,
            count,
            callback,
        )
    return Check(core, exact)


def engine_names() -> list[str]:
    """The engines of the library; `engines` lists programs, too."""
    return _core.engine_names()


def engine_parameters(engine: str | os.PathLike[str]) -> list[_core.Parameter]:
    """What may be chosen of an engine.

    Examples
    --------
    >>> import plumbline
    >>> [p.name for p in plumbline.engine_parameters("inters")]
    ['radius', 'decimals', 'result']
    """
    return _core.engine_parameters(name_of(engine), folders())


def _engine_of_variant(engine: str, variant: str | None) -> str:
    if variant is None:
        return engine
    by_name = {"published": "inters", "repaired": "lar"}
    if variant not in by_name:
        raise Error(f'variants are "published" and "repaired": {variant!r}')
    if engine not in ("lar", by_name[variant]):
        raise Error(f"a variant is not of the engine {engine}: {variant!r}")
    return by_name[variant]


def _setting(name: str, value: Number | None) -> str:
    if isinstance(value, str):
        return value
    if value is None or isinstance(value, bool):
        raise Error(f"the parameter {name} has a number or a text: {value!r}")
    try:
        return exact_text(value)
    except ValueError as error:
        raise Error(f"the parameter {name}: {error}") from None


def _svg_file(of: Lines, engine: str) -> str:
    if engine != "inters":
        raise Error(f"svg2lines belongs to the engine inters: {engine!r}")
    if not isinstance(of, Drawing) or len(of.files) != 1:
        raise Error("svg2lines needs a drawing that was read from an SVG file")
    return of.files[0]


def _mapped(of: Arrangement, threads: int) -> Arrangement:
    """The drawing mapped to the unit square, arranged."""
    lines = Lines(_core.on_unit_square(of.lines._core), of.lines.numbers)
    return Arrangement(_core.arrange(lines._core, False, threads, None), lines)
