"""Arrangements with rounded coordinates, proven to be valid."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
from numpy.typing import NDArray

from plumbline import _core
from plumbline._arguments import arrangement_of
from plumbline._cached import cached
from plumbline._progress import Progress, told
from plumbline._whole import decimals_of
from plumbline.arrangement import Arrangement
from plumbline.lines import LinesLike
from plumbline.lists import Lists


class RoundedArrangement(Arrangement):
    """An arrangement whose coordinates are doubles, or decimals, proven to be a valid one.

    Made by `Arrangement.rounded` and `plumbline.snap_round`. All that an `Arrangement` has, it
    has of the rounded cells; `exact` is the arrangement that it was made of, and the images lead
    from its cells to these. What covers its edges are the segments that covered the exact ones.

    Attributes
    ----------
    decimals : int or None
        The decimals that were asked for; None: doubles.

    See Also
    --------
    plumbline.snap_round
    """

    def __init__(self, rounding: _core.Rounding, exact: Arrangement, decimals: int | None) -> None:
        super().__init__(rounding.complex, exact.lines, exact.labels)
        self._rounding = rounding
        self._exact = exact
        self.decimals = decimals

    @property
    def exact(self) -> Arrangement:
        """The arrangement that was rounded."""
        return self._exact

    @property
    def method(self) -> str:
        """How: "nearest doubles", "nearest points" of a grid, or "snap rounded", where the
        nearest ones are no valid arrangement."""
        return self._rounding.method

    @property
    def spacing(self) -> Fraction:
        """That of the grid; of nearest doubles the largest between two of them. In x and in y,
        no vertex moved by more than half of it."""
        return self._rounding.spacing

    @property
    def note(self) -> str:
        """What is to be known of the numbers, in words; files have it, too."""
        return self._rounding.note()

    @property
    def has_same_incidences(self) -> bool:
        """Whether vertices, edges and faces correspond one to one to those of `exact`, with all
        their incidences: always but for "snap rounded"."""
        return self._rounding.has_same_incidences()

    @property
    def valid_as_doubles(self) -> bool:
        """Whether `vertices`, the decimals as nearest doubles, are valid, too."""
        return self._rounding.valid_as_doubles

    @cached
    def vertex_image(self) -> NDArray[np.uint32]:
        """Per exact vertex the vertex that it went to."""
        return self._rounding.vertex_image()

    @cached
    def edge_image(self) -> Lists:
        """Per exact edge the halfedges that it became, from tail to head; none: it vanished."""
        return Lists(*self._rounding.edge_image())

    @cached
    def face_origin(self) -> NDArray[np.uint32]:
        """Per face the exact face that it is, or is a part of."""
        return self._rounding.face_origin()

    @cached
    def changes(self) -> _core.RoundingChanges:
        """What moved, merged, bent, vanished and fell into parts, cell by cell."""
        return _core.rounding_changes(self.exact._core, self._rounding)

    def rounded(
        self, decimals: int | None = None, *, progress: Progress = None
    ) -> RoundedArrangement:
        """Itself, or the exact arrangement with other decimals."""
        if decimals in (None, self.decimals):
            return self
        return self.exact.rounded(decimals, progress=progress)

    def _exact_area(self) -> NDArray[np.float64]:
        return self.exact.area[self.face_origin] if self.has_same_incidences else self.area

    def _violations(self) -> list[_core.Violation]:
        return self._core.validate()

    def __reduce__(self) -> tuple[Any, ...]:
        return _rounded, (self.exact, self.decimals)

    def __repr__(self) -> str:
        n = self.counts
        numbers = "doubles" if self.decimals is None else f"{self.decimals} decimals"
        return (
            f"<RoundedArrangement: {n.vertices} vertices, {n.edges} edges, "
            f"{n.faces - 1} bounded faces; {numbers}, {self.method}>"
        )


def _rounded(exact: Arrangement, decimals: int | None) -> RoundedArrangement:
    return exact.rounded(decimals)


def snap_round(
    arrangement: Arrangement | LinesLike,
    *,
    decimals: int | None = None,
    progress: Progress = None,
) -> RoundedArrangement:
    """The arrangement with rounded coordinates that are proven to be a valid one.

    Every vertex goes to the nearest double, or decimal. Only where that is no valid arrangement
    with the same incidences, edges are led through the vertices that they come near (snap
    rounding); then cells may merge, and nothing gets into another face.

    Parameters
    ----------
    arrangement : Arrangement, or line work as `arrange` takes it
        Of a rounded one, what it was made of is rounded.
    decimals : int, optional
        0 to 18; by default doubles.
    progress : bool or function, optional
        As in `arrange`; told of snap rounding alone, of the arrangement in it, during which Ctrl-C
        ends the work.

    Returns
    -------
    RoundedArrangement
        In x and in y, no vertex moves by more than half the `spacing`; none goes past an edge.
        The same whatever the order of the input.

    Raises
    ------
    Error
        For decimals out of range; LimitError for grids too fine for the coordinates.

    Notes
    -----
    O(n log n) where simple rounding will do.

    Examples
    --------
    >>> import plumbline
    >>> a = plumbline.arrange([(0, 0, 3, 1), (0, 1, 3, 0)])
    >>> r = plumbline.snap_round(a, decimals=1)
    >>> r
    <RoundedArrangement: 5 vertices, 4 edges, 0 bounded faces; 1 decimals, nearest points>
    >>> near = plumbline.arrange([(0, 0, 10, 3), ("3.4", "1.01", "6.4", "1.91")])
    >>> coarse = plumbline.snap_round(near, decimals=0)
    >>> coarse.method, len(coarse.changes.bent_edges)
    ('snap rounded', 1)
    """
    decimals = decimals_of(decimals)
    exact = arrangement_of(arrangement).exact
    with told(progress, "rounding") as callback:
        rounding = _core.safely_rounded(exact._core, decimals, 0, callback)
    return RoundedArrangement(rounding, exact, decimals)
