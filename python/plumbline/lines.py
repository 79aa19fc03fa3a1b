"""Line work: exact segments, each with the item that it came from."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from plumbline import _core
from plumbline._cached import cached
from plumbline._numbers import Numbers
from plumbline._warnings import warn_of_loss

if TYPE_CHECKING:
    pass

ExactPoint = tuple[Fraction, Fraction]
LinesLike = Any
"""What `lines` takes: see there."""


class Lines:
    """Exact segments, each with the item of the input that it came from.

    Made by `plumbline.lines` and `plumbline.read`. Immutable.

    See Also
    --------
    plumbline.lines, plumbline.read
    """

    def __init__(self, core: _core.SegmentSet, numbers: Numbers) -> None:
        self._core = core
        self._numbers: Numbers = numbers

    @property
    def numbers(self) -> Numbers:
        """Whether floats of the input stand for the numbers that they are ("doubles") or for the
        decimals that they print as."""
        return self._numbers

    def __len__(self) -> int:
        return len(self._core)

    def __iter__(self) -> Iterator[tuple[ExactPoint, ExactPoint]]:
        for i in range(len(self)):
            yield self.exact(i)

    def exact(self, i: int) -> tuple[ExactPoint, ExactPoint]:
        """The ends of segment `i` as Fractions."""
        ax, ay, bx, by = self._core.segment(range(len(self))[i])
        return (ax, ay), (bx, by)

    @cached
    def coords(self) -> NDArray[np.float64]:
        """Segments as rows ax, ay, bx, by, correctly rounded to nearest doubles. (n, 4),
        read-only."""
        return self._core.coords()

    @cached
    def item(self) -> NDArray[np.uint32]:
        """Per segment the position of its item: row of the array, geometry of the series, element
        of the drawing. (n,), read-only."""
        return self._core.item()

    @property
    def item_count(self) -> int:
        """How many items the input has; some may have no segment."""
        return self._core.source_count()

    def source(self, i: int) -> _core.Source:
        """Of item `i` the place in its file, layer, id."""
        return self._core.source(range(self.item_count)[i])

    def source_text(self, i: int) -> str:
        """The same as a text: "plan.dxf:312 LINE 2F (A-WALL)"."""
        return self._core.source_text(range(self.item_count)[i])

    @property
    def rejected(self) -> list[_core.Rejected]:
        """Items that take no part, and why."""
        return self._core.rejected

    @property
    def remarks(self) -> list[_core.Remark]:
        """What is to be said of items that were drawn."""
        return self._core.remarks

    @property
    def ledger(self) -> list[_core.Replacement]:
        """What was replaced on the way to exact numbers: curves by chords, angles by rational
        rotations. Empty where every number is exactly what the input says."""
        return self._core.ledger

    @property
    def labels(self) -> list[_core.Label]:
        """Texts of the drawing."""
        return self._core.labels

    @property
    def layers(self) -> list[_core.Layer]:
        """Layers that the drawing declares."""
        return self._core.layers

    @property
    def files(self) -> list[str]:
        """Names of the files; of an array its title."""
        return self._core.files

    @property
    def crs(self) -> str:
        """Name of the reference system, or ""."""
        return self._core.crs

    @property
    def unit(self) -> _core.LengthUnit | None:
        """The unit of length, where the input says it."""
        return self._core.unit

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """The box of what is not stray: xmin, ymin, xmax, ymax."""
        return self._core.extent()

    def on_layers(self, *patterns: str) -> Lines:
        """Those segments alone that lie on layers of these names; ``*`` and ``?`` stand for any
        characters, in any case.

        Raises
        ------
        Error
            For a pattern that no layer has.
        """
        return Lines(self._core.on_layers(list(patterns)), self.numbers)

    def to_shapely(self) -> NDArray[np.object_]:
        """Each segment as a LineString of nearest doubles."""
        import shapely

        return np.asarray(shapely.linestrings(self.coords.reshape(-1, 2, 2)), dtype=object)

    @property
    def __geo_interface__(self) -> dict[str, Any]:
        return {"type": "MultiLineString", "coordinates": self.coords.reshape(-1, 2, 2).tolist()}

    def _repr_svg_(self) -> str:
        from plumbline._pictures import lines_picture

        return lines_picture(self)

    def __getstate__(self) -> tuple[_core.SegmentSet, Numbers]:
        return self._core, self._numbers

    def __setstate__(self, state: tuple[_core.SegmentSet, Numbers]) -> None:
        self._core, self._numbers = state

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {len(self)} segments of {self.item_count} items, " + (
            f"floats as {self.numbers}>"
        )


def _warn_of_losses(result: Lines) -> None:
    lost = [item for item in result.rejected if not item.harmless]
    if not lost:
        return
    place = result._core.place_text(lost[0].source)
    count = "one item takes" if len(lost) == 1 else f"{len(lost)} items take"
    warn_of_loss(f"{count} no part, see `rejected`; the first: {place}: {lost[0].reason}")
