"""Wrong answers of engines, brought down to the fewest segments that show them."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any, NoReturn, Union

from numpy.typing import NDArray

from plumbline import _core
from plumbline._arguments import arrangement_of, ensure_none, threads_of
from plumbline._cached import cached
from plumbline._notebook import framed
from plumbline._numbers import Number, Numbers
from plumbline._programs import folders, name_of
from plumbline._progress import Progress, told
from plumbline._results import answer_of_result
from plumbline._whole import count
from plumbline.arrangement import Arrangement
from plumbline.check import Check, Engine, _drawn, _tolerance
from plumbline.cross_check import _setting
from plumbline.errors import Error
from plumbline.lines import Lines, LinesLike

__all__ = ["Minimised", "minimise"]


class Minimised:
    """A drawing of a few segments with which an engine is wrong as it is with the whole one. Made
    by `plumbline.minimise`.

    True in a condition if the engine is right: then there is nothing to show, and `lines` is the
    whole drawing, in doubles.
    """

    def __init__(self, core: _core.Minimised) -> None:
        self._core = core

    @property
    def agree(self) -> bool:
        """Whether the engine is right about the whole drawing, but for what is its own drift."""
        return self.outcome == "right"

    def __bool__(self) -> bool:
        return self.agree

    @property
    def outcome(self) -> str:
        """ "loud" (the engine says that it failed), "invalid" (the answer alone is no complex),
        "topology" (it is another one), "moved", or "right"."""
        return self._core.outcome.outcome_class

    @property
    def kind(self) -> str:
        """What is wrong, by the gravest difference: "face lost", "edge extra", the broken
        invariant, the class of an error. It is that of the whole drawing."""
        return self._core.outcome.kind

    @cached
    def lines(self) -> Lines:
        """The segments that are left, their doubles taken as exact. Items are those of the whole
        drawing."""
        return Lines(self._core.drawing, "doubles")

    @cached
    def check(self) -> Check:
        """The engine's answer to them, held against the exact arrangement, with causes."""
        core = self._core.check
        return Check(core, Arrangement(core.exact_complex, self.lines))

    @property
    def engine(self) -> str:
        """The engine's name."""
        return self._core.engine

    @property
    def segments_before(self) -> int:
        """Of the whole drawing."""
        return self._core.segments_before

    @property
    def runs(self) -> int:
        """How often the engine was run."""
        return self._core.runs

    @property
    def is_one_minimal(self) -> bool:
        """Whether no single segment can be left out; else the runs were not enough."""
        return self._core.is_one_minimal

    @property
    def has_simple_numbers(self) -> bool:
        """Whether none of the simpler numbers that are tried can take the place of one."""
        return self._core.has_simple_numbers

    @property
    def is_representable(self) -> bool:
        """Whether doubles can hold a right answer: the exact one keeps its incidences when every
        vertex is rounded."""
        return self._core.is_representable

    @property
    def radius_before(self) -> float | None:
        """The radius that the engine chose for the whole drawing, where it chose another one for
        the small one."""
        return self._core.radius_before

    def to_text(self) -> str:
        """For a terminal: what is wrong, the segments, counts side by side, versions."""
        return self._core.to_text()

    def to_lines(self) -> str:
        """Rows x1,y1,x2,y2, as a .lines file has them."""
        return self._core.to_lines()

    def to_issue(self, lines_file: str = "", picture_file: str = "") -> str:
        """An issue for the engine's maintainers, as Markdown: versions, the input as WKT and as
        rows, what is expected and why, what comes out, how to reproduce it.

        Parameters
        ----------
        lines_file, picture_file : str
            Names of files beside it, which it speaks of: the rows, and the picture of `to_svg`.
        """
        return self._core.to_issue(lines_file, picture_file)

    def to_svg(self) -> str:
        """A picture: the exact arrangement and the answer, and what is too close to be seen
        magnified."""
        return self._core.to_svg()

    def __str__(self) -> str:
        return self.to_text()

    def __repr__(self) -> str:
        return f"<Minimised: {self.to_text().partition(chr(10))[0]}>"

    def _repr_html_(self) -> str | None:
        return framed(self.to_svg(), 640)

    def _written(self, format: str, **options: Any) -> str:
        """The content of a file: what `plumbline.write` asks for."""
        ensure_none(options)
        forms = {"svg": self.to_svg, "lines": self.to_lines, "md": self.to_issue}
        if format in forms:
            return forms[format]()
        raise Error(f"a minimised drawing is written as lines, svg or md: {format!r}")

    def __reduce__(self) -> NoReturn:
        raise TypeError("a Minimised cannot be pickled: keep to_lines(), and check these again")


def minimise(
    drawing: Arrangement | LinesLike,
    engine: Union[str, os.PathLike[str], Engine] = "lar",
    *,
    tolerance: Number | None = None,
    max_runs: int = 20_000,
    numbers: Numbers | None = None,
    threads: int | None = None,
    progress: Progress = None,
    **parameters: Union[Number, None],
) -> Minimised:
    """The fewest segments, with the simplest numbers, with which an engine is wrong as it is with
    the drawing.

    Every number is replaced by its nearest double first, and these are taken as exact: an engine
    is not blamed for reading. What stays is the kind of the gravest difference. Where doubles can
    hold a right answer to the drawing, they can hold one to what comes out.

    Parameters
    ----------
    drawing : Arrangement, or line work as `lines` takes it
    engine : str, path or Engine
        The name of an engine, or a program, as in `cross_check`, or a function, as in `check`.
        What a function raises is an outcome like another.
    tolerance : number, optional
        Vertices match within this distance. By default as in `check`, for each smaller drawing.
    max_runs : int
        Of the engine; then it ends with what there is.
    numbers, threads
        As in `check`.
    progress : bool or function, optional
        A bar, or a function that is told which part of `max_runs` is done, from 0 to 1.
    **parameters
        Of the engine, as in `cross_check`. They stay as they are.

    Returns
    -------
    Minimised

    Raises
    ------
    Error
        Where nothing is drawn; for engines and parameters that there are not; as `arrange`.

    Notes
    -----
    Delta debugging (Zeller and Hildebrandt 2002), which begins near one difference, and then fewer
    digits, number by number, until nothing changes. Some hundred to some thousand runs.

    Examples
    --------
    >>> import plumbline
    >>> def forgetful(segments):
    ...     return segments[abs(segments[:, 2] - segments[:, 0]) < 8]
    >>> rows = [(i, 0.5, i + 0.5, 0.5) for i in range(20)] + [(3.25, 7.125, 14.5, 9.75)]
    >>> m = plumbline.minimise(rows, forgetful)
    >>> m.kind, len(m.lines), m.segments_before
    ('edge missing', 1, 21)
    >>> print(m.to_lines(), end="")
    0,0,10,0
    """
    within, threads_wanted = _tolerance(tolerance), threads_of(threads)
    most = count(max_runs, "max_runs")
    of = _drawn(arrangement_of(drawing, numbers=numbers, threads=threads)).lines
    with told(progress, "minimising") as callback:
        if not isinstance(engine, (str, os.PathLike)):
            if parameters:
                raise Error(f"a function has no parameters here: {', '.join(parameters)}")
            name = getattr(engine, "__name__", None) or type(engine).__name__
            core = _core.minimised_by_function(
                of._core, name, _answering(engine, name), within, most, threads_wanted, callback
            )
        else:
            if engine == "files":
                raise Error("a result in a file cannot be made again of fewer segments")
            settings = [(name, _setting(name, value)) for name, value in parameters.items()]
            core = _core.minimised(
                of._core,
                name_of(engine),
                settings,
                folders(),
                within,
                most,
                threads_wanted,
                callback,
            )
    return Minimised(core)


def _answering(engine: Engine, name: str) -> Callable[[NDArray[Any]], _core.Answer | str]:
    """The engine as the library calls it: an Answer, or how it failed."""

    def answer(segments: NDArray[Any]) -> _core.Answer | str:
        try:
            result = engine(segments)
        except Exception as error:
            return f"{type(error).__name__}: {error}"
        try:
            of = answer_of_result(result)
        except Error as error:
            return f"no result: {error}"
        of.rename(name)
        return of

    return answer
