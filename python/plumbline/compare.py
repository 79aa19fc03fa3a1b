"""Two arrangements held against each other."""

from __future__ import annotations

from plumbline import _core
from plumbline._arguments import arrangement_of
from plumbline._core import Comparison, Finding
from plumbline._crs import ensure_same_crs
from plumbline._numbers import Number
from plumbline._results import ResultLike, answer_of_result
from plumbline._sizes import nearest_size
from plumbline.arrangement import Arrangement
from plumbline.lines import LinesLike

__all__ = ["Comparison", "Finding", "compare", "compare_result"]


def compare(
    a: Arrangement | LinesLike, b: Arrangement | LinesLike, tolerance: Number = 0
) -> Comparison:
    """What is different in the second of two arrangements: cell by cell, as findings.

    Parameters
    ----------
    a, b : Arrangement, or line work as `arrange` takes it
        `a` counts as the right one: what `b` lacks is missing, what it has on top is extra.
    tolerance : number
        Vertices match within this distance, compared exactly. Rounded to a double.

    Returns
    -------
    Comparison
        True in a condition where the two agree. Cells are told by their indices in the two.

    Raises
    ------
    Error
        For a negative tolerance; where both have reference systems, and different ones; as
        `arrange`.

    See Also
    --------
    plumbline.same : whether two arrangements are the same, to the last digit.

    Notes
    -----
    O(n log n) where the two agree; an overlay of the faces that differ where they do not.

    Examples
    --------
    >>> import plumbline
    >>> a = plumbline.arrange("POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))")
    >>> b = plumbline.arrange("POLYGON ((0 0, 2 0, 2 2.001, 0 2, 0 0))")
    >>> bool(plumbline.compare(a, b, tolerance=0.01))
    True
    >>> finding = plumbline.compare(a, b, tolerance=0.0001).findings[0]
    >>> finding.kind, finding.disagreement, finding.distance
    ('vertex', 'moved', 0.001)
    """
    within = nearest_size("the tolerance", tolerance)
    ensure_same_crs(a, b)
    one, other = arrangement_of(a), arrangement_of(b)
    ensure_same_crs(one, other)
    return _core.compare(one._core, other._core, within)


def compare_result(
    result: ResultLike, drawing: Arrangement | LinesLike, tolerance: Number = 0
) -> Comparison:
    """What is different in a result, as `check` finds it, without causes: for many results, a
    fraction of the time.

    Parameters
    ----------
    result
        As in `check`, no function.
    drawing : Arrangement, or line work as `arrange` takes it
    tolerance : number
        Vertices match within this distance, compared exactly. Rounded to a double.

    Returns
    -------
    Comparison
        True in a condition where the two agree. What the drawing's own digits leave open counts.

    Raises
    ------
    Error
        For a negative tolerance, and for what is no result; where both have reference systems,
        and different ones; as `arrange`.

    Examples
    --------
    >>> import plumbline
    >>> drawing = [(0, 0, 2, 2), (0, 2, 2, 0)]
    >>> V, EV = [(0, 0), (0, 2), (1, 1), (2, 2), (2, 0)], [(0, 2), (1, 2), (2, 3), (2, 4)]
    >>> bool(plumbline.compare_result((V, EV), drawing))
    True
    >>> [f.disagreement for f in plumbline.compare_result((V, EV[1:]), drawing).findings]
    ['missing']
    """
    within = nearest_size("the tolerance", tolerance)
    ensure_same_crs(result, drawing)
    exact = arrangement_of(drawing)
    ensure_same_crs(result, exact)
    return _core.compare_answer(exact._core, answer_of_result(result), within)
