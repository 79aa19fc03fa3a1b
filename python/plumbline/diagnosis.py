"""What is wrong with line work itself."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from plumbline import _core
from plumbline._arguments import arrangement_of, count, ensure_none, written_table
from plumbline._core import Defect, InvalidRing, Opening, ToleranceEffect
from plumbline._notebook import drawn
from plumbline._numbers import Number, Numbers
from plumbline._sizes import optional_size, size_text
from plumbline._tables import to_geodataframe
from plumbline.arrangement import Arrangement
from plumbline.errors import Error
from plumbline.lines import LinesLike

if TYPE_CHECKING:
    from geopandas import GeoDataFrame

__all__ = [
    "Defect",
    "Diagnosis",
    "InvalidRing",
    "Opening",
    "ToleranceEffect",
    "diagnose",
    "validity",
]


class Diagnosis:
    """Defects of line work in the words of CAD and GIS. Made by `plumbline.diagnose`.

    Attributes
    ----------
    arrangement : Arrangement
        That of the drawing, whose cells the defects name.
    """

    def __init__(self, core: _core.Diagnosis, arrangement: Arrangement) -> None:
        self._core = core
        self.arrangement = arrangement

    @property
    def within(self) -> Fraction:
        """The search distance: near is no further than this."""
        return self._core.within

    @property
    def defects(self) -> list[Defect]:
        """By kind: duplicates, overlaps, gaps, undershoots, overshoots, near-misses, dangles,
        bridges, slivers, short edges, nearly parallel edges, invalid rings; in each kind what
        matters most first."""
        return self._core.defects

    @property
    def counts(self) -> dict[str, int]:
        """How many there are of each kind that there is; `defects` lists at most `most_listed` of
        each."""
        return self._core.found

    @property
    def by_effect(self) -> list[Defect]:
        """The same as `defects`, those that matter most first: ends that leave a face open, the
        largest first; rings that are not valid; other ends that do not meet; what is near; what is
        drawn twice; what dangles."""
        defects = self.defects
        return [defects[i] for i in self._core.by_effect()]

    @property
    def openings(self) -> list[Opening]:
        """Ways through that are as wide as doors: no defects."""
        return self._core.openings

    @property
    def tolerances(self) -> list[ToleranceEffect]:
        """What tolerances would mend, ascending."""
        return self._core.tolerances

    @property
    def tips(self) -> int:
        """How many loose ends there are."""
        return self._core.tips

    @property
    def shared_sides(self) -> int:
        """Pairs of segments that are sides of two closed shapes next to each other: no defects."""
        return self._core.shared_sides

    @property
    def cut_short(self) -> int:
        """Vertices around which so much is near that the search was cut short: 0 unless the search
        distance is far too large for the drawing."""
        return self._core.cut_short

    def __len__(self) -> int:
        """How many defects there are, listed or not."""
        return sum(self.counts.values())

    def __bool__(self) -> bool:
        """Whether there are any."""
        return len(self) > 0

    def to_text(self, limit: int = 0) -> str:
        """For a terminal: counts, what matters most, openings, what tolerances would mend, and
        then `limit` of each kind."""
        return self._core.to_text(self.arrangement.lines._core, count(limit, "the limit"))

    def to_json(self) -> str:
        """All that are listed, as JSON."""
        return self._core.to_json(self.arrangement.lines._core)

    def to_svg(self) -> str:
        """A panel for each kind: the drawing with the defects marked by their numbers."""
        return self._core.to_svg(self.arrangement.lines._core, self.arrangement._core)

    def to_geopandas(self) -> GeoDataFrame:
        """Defects, and then openings, as points with the columns number, rank, kind, message, size,
        open_area, tolerance, exact_x, exact_y, sources. Needs GeoPandas."""
        of = self.arrangement.lines
        return to_geodataframe(self._core.table(of._core), of.crs)

    def _repr_svg_(self) -> str | None:
        return drawn(self.to_svg())

    def _written(self, format: str, **options: Any) -> str:
        """The content of a file: what `plumbline.write` asks for."""
        ensure_none(options)
        forms = {"json": self.to_json, "svg": self.to_svg}
        if format in forms:
            return forms[format]()
        table = self._core.table(self.arrangement.lines._core)
        return written_table(table, format, "a diagnosis")

    def __str__(self) -> str:
        return self.to_text()

    def __repr__(self) -> str:
        found = ", ".join(f"{n} {kind}" for kind, n in self.counts.items())
        return f"<Diagnosis: {found or 'no defects'}; {len(self.openings)} openings>"


def diagnose(
    lines: Arrangement | LinesLike,
    *,
    within: Number | None = None,
    doors: Sequence[Number] | None = None,
    most_listed: int = 1000,
    numbers: Numbers | None = None,
) -> Diagnosis:
    """What is wrong with line work: gaps, undershoots, duplicates, slivers, invalid rings ...

    Parameters
    ----------
    lines : Arrangement, or line work as `arrange` takes it
    within : number, optional
        The search distance. By default a thousandth of the drawing's longer side.
    doors : pair of numbers, optional
        How wide doors are. By default from a hundredth to a tenth of the drawing's longer side.
    most_listed : int
        At most so many of each kind are listed; all are counted.
    numbers : {"doubles", "decimals"}, optional
        As in `lines`.

    Returns
    -------
    Diagnosis
        With exact places; sizes both rounded and, squared, exact.

    Raises
    ------
    Error
        Where nothing is drawn; for a negative distance or widths out of order; as `arrange`.

    Notes
    -----
    O(n log n) for a search distance that is not larger than the drawing's features.

    Examples
    --------
    >>> import plumbline
    >>> lines = [(0, 0, 4, 0), (4, 0, 4, 3), (4, 3, 0, 3), (0, 3, 0, "0.002")]
    >>> d = plumbline.diagnose(lines)
    >>> d
    <Diagnosis: 1 gap; 0 openings>
    >>> d.defects[0].squared_size, d.defects[0].open_area
    (Fraction(1, 250000), 12.0)
    """
    arrangement = arrangement_of(lines, numbers=numbers)
    if not arrangement.counts.vertices:
        raise Error("there is nothing drawn that could be diagnosed")
    core = _core.diagnose(
        arrangement.lines._core,
        arrangement._core,
        optional_size("within", within),
        count(most_listed, "most_listed"),
        _door_widths(doors),
    )
    return Diagnosis(core, arrangement)


def _door_widths(doors: Sequence[Number] | None) -> tuple[str, str] | None:
    if doors is None:
        return None
    if isinstance(doors, str) or not hasattr(doors, "__len__") or len(doors) != 2:
        raise Error(f"doors are from one width to another: {doors!r}")
    least, most = (size_text("the width of a door", width) for width in doors)
    if Fraction(least) > Fraction(most):
        raise Error(f"doors are from the least width to the largest: {doors!r}")
    return least, most


def validity(
    lines: Arrangement | LinesLike, *, numbers: Numbers | None = None
) -> list[InvalidRing]:
    """Why polygons are not valid, and closed lines not simple (OGC Simple Features), exactly.

    Parameters
    ----------
    lines : Arrangement, or line work as `arrange` takes it
        Polygons of geometries, closed polylines of drawings. Open lines do not matter.
    numbers : {"doubles", "decimals"}, optional
        As in `lines`.

    Returns
    -------
    list of InvalidRing
        All problems, by polygon, then fault and place; none, just if all are valid. `jts_name` has
        the words of shapely's ``is_valid_reason``, which tells the first one, rounded.

    Raises
    ------
    Error
        Where there is no polygon and no closed line; as `arrange`.

    Examples
    --------
    >>> import plumbline
    >>> [problem] = plumbline.validity("POLYGON ((0 0, 3 1, 3 0, 0 2, 0 0))")
    >>> problem.jts_name, problem.where
    ('Self-intersection', (Fraction(2, 1), Fraction(2, 3)))
    """
    arrangement = arrangement_of(lines, numbers=numbers)
    of = arrangement.lines._core
    if not _core.ring_count(of):
        raise Error("there is no polygon and no closed line that could be valid")
    return _core.invalid_rings(of, arrangement._core)
