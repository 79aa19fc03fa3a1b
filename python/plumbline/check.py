"""Results held against the exact arrangement of their drawing."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NoReturn, Protocol

import numpy as np
from numpy.typing import NDArray

from plumbline import _core
from plumbline._arguments import (
    arrangement_of,
    ensure_none,
    threads_of,
    written_table,
)
from plumbline._cached import cached
from plumbline._core import Answer, Cause, ChangedFaces, Finding, FindingGroup, RightRadii
from plumbline._crs import ensure_same_crs
from plumbline._notebook import framed
from plumbline._numbers import Number, Numbers
from plumbline._progress import Progress, told
from plumbline._results import ResultLike, answer_of_result
from plumbline._sizes import nearest_size
from plumbline._tables import to_geodataframe
from plumbline._warnings import warn_of_loss
from plumbline._whole import optional_count
from plumbline.arrangement import Arrangement
from plumbline.drawing import Drawing
from plumbline.errors import Error
from plumbline.ladder import Ladder
from plumbline.lines import Lines, LinesLike

if TYPE_CHECKING:
    from geopandas import GeoDataFrame

__all__ = [
    "Answer",
    "Cause",
    "ChangedFaces",
    "Check",
    "Engine",
    "Finding",
    "FindingGroup",
    "RightRadii",
    "check",
]


class Engine(Protocol):
    """Whatever arranges line work: a function of segments, rows ax, ay, bx, by, as an array (n, 4)
    of float64 that is its own. It returns a result in any of the forms that `check` takes: polygons
    of shapely, (V, EV), (V, EV, FV), segments, the path of a file ..."""

    def __call__(self, segments: NDArray[np.float64], /) -> ResultLike: ...


class Check:
    """A result held against the exact arrangement of its drawing: whether it is right, and if not
    what is wrong where, and why. Made by `plumbline.check` and `plumbline.cross_check`.

    True in a condition if the result is right and nothing of the drawing, or of the result, was
    left out as unreadable.

    Attributes
    ----------
    exact : Arrangement
        The exact arrangement of the drawing.
    """

    def __init__(self, core: _core.Check, exact: Arrangement) -> None:
        self._core = core
        self.exact = exact

    @property
    def agree(self) -> bool:
        """Whether the result is a valid complex whose cells match the exact ones one to one."""
        return self._core.agree()

    def __bool__(self) -> bool:
        return self.agree and self._core.lost() == 0

    @cached
    def findings(self) -> list[Finding]:
        """What is wrong. Numbered from 1 by their positions."""
        return self._core.comparison.findings

    @cached
    def causes(self) -> list[Cause]:
        """Why, one for each finding."""
        return self._core.causes

    @cached
    def groups(self) -> list[FindingGroup]:
        """Findings that are one event in one place; what changes most comes first."""
        return self._core.groups

    @property
    def own_findings(self) -> int:
        """How many findings are the drawing's own: its digits leave them open."""
        return self._core.own_findings()

    @cached
    def conversion_findings(self) -> list[Finding]:
        """What rounding the drawing to doubles alone changes, whatever the result: how `doubles`
        differs from `exact`."""
        return self._core.conversion.findings

    @cached
    def conversion_causes(self) -> list[Cause]:
        """Of those: whether reading the numbers makes them ("parse"), or applying maps
        ("transform")."""
        return self._core.conversion_causes

    @cached
    def doubles(self) -> Arrangement:
        """The exact arrangement of the drawing's numbers, each rounded to the nearest double, with
        lines of its own. Arranged when asked for."""
        of = Lines(_core.in_doubles(self.exact.lines._core), "doubles")
        return Arrangement(_core.arrange(of._core, False, 0, None), of)

    @property
    def answer(self) -> Answer:
        """The result as it was compared, with the engine, its parameters and its radius."""
        return self._core.answer

    @property
    def tolerance(self) -> float:
        """Within which vertices matched."""
        return self._core.comparison.tolerance

    @property
    def compared(self) -> str:
        """Which cells were compared: "all"; "graph", of a result without faces; "faces", of one
        that has polygons alone; "some faces"."""
        return self._core.comparison.compared

    @property
    def exact_counts(self) -> _core.Counts:
        """Numbers of cells of the exact arrangement."""
        return self._core.comparison.exact_counts

    @property
    def answer_counts(self) -> _core.Counts:
        """Numbers of cells of the result."""
        return self._core.comparison.answer_counts

    @property
    def matched(self) -> tuple[int, int, int]:
        """How many vertices, edges and faces match one to one."""
        c = self._core.comparison
        return c.matched_vertices, c.matched_edges, c.matched_faces

    @property
    def largest_displacement(self) -> float:
        """Of a vertex that matches."""
        return self._core.comparison.largest_displacement

    @property
    def right_radii(self) -> RightRadii | None:
        """With which radii the engine is right; None where that was not looked for."""
        return self._core.right_radii

    @cached
    def ladder(self) -> Ladder:
        """At which radii the drawing falls together."""
        core = self._core.ladder or _core.tolerance_ladder(self._core.exact_complex, 1000, None)
        return Ladder(core, self.exact, self.right_radii)

    def to_text(self, listed: int | None = None) -> str:
        """For a terminal: the verdict, counts side by side, where findings come from, groups.

        Parameters
        ----------
        listed : int, optional
            So many groups, with their findings. By default as many groups as fit on a screen.
        """
        return self._core.to_text(optional_count(listed, "listed"))

    def to_json(self) -> str:
        """All findings, as JSON: what ``plumbline check --output`` writes."""
        return self._core.to_json()

    def to_svg(self) -> str:
        """A picture: the exact arrangement and the result beside it, with the groups marked."""
        return self._core.to_svg()

    def to_html(self) -> str:
        """A page to look at all of it in a browser, with the ladder. Loads nothing else."""
        return self._core.to_html()

    def to_geopandas(self) -> GeoDataFrame:
        """Findings as points with the columns number, group, kind, disagreement, invariant, stage,
        rule, message, advice, distance, exact_x, exact_y, sources; a finding about the result as a
        whole has no point. Needs GeoPandas."""
        return to_geodataframe(self._core.table(), self.exact.lines.crs)

    def __str__(self) -> str:
        return self.to_text()

    def __repr__(self) -> str:
        verdict = self.to_text(0).partition("\n")[0]
        n = self.exact_counts
        return (
            f"<Check of {self.answer.title}: {verdict}; "
            f"exact {n.vertices} vertices, {n.edges} edges, {n.faces - 1} bounded faces>"
        )

    def _repr_html_(self) -> str | None:
        return framed(self.to_html(), 640)

    def _written(self, format: str, **options: Any) -> str:
        """The content of a file: what `plumbline.write` asks for."""
        ensure_none(options)
        forms = {"json": self.to_json, "svg": self.to_svg, "html": self.to_html}
        if format in forms:
            return forms[format]()
        return written_table(self._core.table(), format, "a check")

    def __reduce__(self) -> NoReturn:
        raise TypeError(
            "a Check cannot be pickled: it holds the run of its engine; keep to_json(), or the "
            "drawing and the result, and check again"
        )


def check(
    result: ResultLike | Engine,
    drawing: Arrangement | LinesLike,
    *,
    tolerance: Number | None = None,
    some_faces: bool = False,
    numbers: Numbers | None = None,
    threads: int | None = None,
    progress: Progress = None,
) -> Check:
    """Any result, held against the exact arrangement of its drawing.

    Parameters
    ----------
    result : path, geometries, cells, segments, Arrangement or Engine
        - the path of a result file: LAR as JSON, GeoJSON, well-known text, WKB, CSV, what
          ``plumbline arrange`` writes; the text of GeoJSON, of a LAR model or of WKT;
        - a GeoDataFrame, a GeoSeries, shapely geometries: polygons are faces, lines edges between
          successive points;
        - a tuple ``(V, EV)`` or ``(V, EV, FV)`` of points, pairs of vertices and lists of vertices
          (None for an EV that is not there): each in the order of its face, or any where EV says
          how they are joined; ends of edges within a face left out, as in `Arrangement.FV`; a dict
          of these names, with `polygons` (per face its rings) or `index_base` if needed. Indices
          count from 0, or from 1 where that alone fits;
        - segments (n, 4): edges alone;
        - an `Arrangement`;
        - an `Engine`: a function, which is run on the drawing's segments.
    drawing : Arrangement, or line work as `lines` takes it
        What was to be arranged.
    tolerance : number, optional
        Vertices match within this distance, compared exactly. By default 1e-9 of the drawing's
        longer side, but at least 2^-46 of its largest coordinate.
    some_faces : bool
        Whether the result has some of the faces only: each must be one of the drawing's, and
        nothing else is compared.
    numbers : {"doubles", "decimals"}, optional
        What floats of the drawing stand for, as in `lines`.
    threads : int, optional
        At most so many; by default, and for 0, as many as there are cores. Does not change the
        result.
    progress : bool or function, optional
        A bar, or a function that is told which part of the advice is given, from 0 to 1. Ctrl-C
        ends the arrangement of the drawing and the advice, with or without `progress`.

    Returns
    -------
    Check
        Coordinates of results count as the doubles that they are; a result that is wrong in
        whatever way is a finding and no error. Of polygons alone all is compared that polygons can
        have: no dangling edges.

    Warns
    -----
    LossWarning
        Where something of the drawing, or of the result, could not be read.

    Raises
    ------
    Error
        Where nothing is drawn, so that there is nothing to agree about; where both have reference
        systems, and different ones; for what is no result,
        indices out of range, coordinates that are not finite; from what an engine raised.

    Notes
    -----
    The cost of `arrange` twice and of a comparison.

    Examples
    --------
    >>> import plumbline
    >>> drawing = [(0, 0, 2, 2), (0, 2, 2, 0), (0, 0, 0, 2)]
    >>> V, EV = [(0, 0), (0, 2), (1, 1), (2, 2), (2, 0)], [(0, 1), (0, 2), (1, 2), (2, 3), (2, 4)]
    >>> plumbline.check((V, EV), drawing).agree
    True
    >>> wrong = plumbline.check((V, EV[:-1]), drawing)
    >>> [(f.kind, f.disagreement) for f in wrong.findings]
    [('edge', 'missing')]

    A function is an engine:

    >>> def nothing_to_do(segments):
    ...     return segments
    >>> bool(plumbline.check(nothing_to_do, drawing))
    False
    """
    within, count = _tolerance(tolerance), threads_of(threads)
    ensure_same_crs(result, drawing)
    exact = _drawn(arrangement_of(drawing, numbers=numbers, threads=threads))
    ensure_same_crs(result, exact)
    if callable(result) and not isinstance(result, Arrangement):
        answer = _answer_of_function(result, exact.lines)
    else:
        answer = answer_of_result(result)
    _warn_of_losses(answer)
    if some_faces:
        _core.choose_some_faces(answer)
    with told(progress, "checking") as callback:
        core = _core.check(
            exact.lines._core,
            exact._core,
            answer,
            _structure(exact.lines),
            False,
            within,
            False,
            False,
            count,
            callback,
        )
    return Check(core, exact)


def _tolerance(value: Number | None) -> float | None:
    return None if value is None else nearest_size("the tolerance", value)


def _drawn(exact: Arrangement) -> Arrangement:
    if not exact.counts.vertices:
        raise Error("nothing is drawn, so there is nothing to agree about")
    return exact


def _structure(of: Lines) -> _core.Structure | None:
    """The hierarchy of a drawing, which tells parsing from transforming."""
    return of.structure._core if isinstance(of, Drawing) else None


def _answer_of_function(engine: Engine, of: Lines) -> Answer:
    name = getattr(engine, "__name__", None) or type(engine).__name__
    try:
        result = engine(np.array(of.coords))
    except Exception as error:
        raise Error(f"the engine {name} failed: {type(error).__name__}: {error}") from error
    if callable(result) and not isinstance(result, Arrangement):
        raise Error(f"the engine {name} returned a function")
    try:
        answer = answer_of_result(result)
    except Error as error:
        raise Error(f"the engine {name} returned no result: {error}") from error
    answer.rename(name)
    return answer


def _warn_of_losses(answer: Answer) -> None:
    lost = [item for item in answer.rejected if not item.harmless]
    if lost:
        count = "one item" if len(lost) == 1 else f"{len(lost)} items"
        warn_of_loss(
            f"{count} of the result cannot be read; the first, {lost[0].source.element} in line "
            f"{lost[0].source.line}: {lost[0].reason}"
        )
