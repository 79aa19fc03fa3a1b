"""Whether polygons are valid, feature by feature, and valid ones in their place."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from plumbline import _core
from plumbline._arguments import arrangement_of
from plumbline._numbers import Numbers
from plumbline.arrangement import Arrangement
from plumbline.errors import Error
from plumbline.lines import LinesLike
from plumbline.regions import Region, union, union_all

Method = Literal["linework", "structure", "nonzero"]


def _problems(
    polygons: Arrangement | LinesLike, numbers: Numbers | None
) -> list[list[_core.RingProblem] | None]:
    """Per item its problems; None for what is no polygon and no closed line."""
    of = arrangement_of(polygons, numbers=numbers)
    result: list[list[_core.RingProblem] | None] = [None] * of.lines.item_count
    for item, problems in _core.problems_of_polygons(of.lines._core, of._core):
        if item is not None:
            result[item] = [*(result[item] or []), *problems]
    return result


def is_valid(
    polygons: Arrangement | LinesLike, /, *, numbers: Numbers | None = None
) -> NDArray[np.bool_]:
    """Per feature whether its polygons are valid, and its closed lines simple: shapely.is_valid,
    exactly.

    Parameters
    ----------
    polygons : GeoDataFrame, geometries, or whatever `lines` takes with polygons
    numbers : {"doubles", "decimals"}, optional
        As in `lines`.

    Returns
    -------
    ndarray of bool
        False for what is no polygon and no closed line, or has no length.

    Raises
    ------
    Error
        As `arrange`.

    See Also
    --------
    plumbline.validity : all problems, with places

    Examples
    --------
    >>> import plumbline
    >>> plumbline.is_valid("POLYGON ((0 0, 3 1, 3 0, 0 2, 0 0))")
    array([False])
    """
    return np.array([p is not None and not p for p in _problems(polygons, numbers)], dtype=bool)


def is_valid_reason(
    polygons: Arrangement | LinesLike, /, *, numbers: Numbers | None = None
) -> list[str]:
    """Per feature why it is not valid: shapely.is_valid_reason, in exact places.

    Parameters
    ----------
    polygons, numbers
        As in `is_valid`.

    Returns
    -------
    list of str
        "Valid Geometry", or the first problem in the words of GEOS with its place in brackets,
        whose coordinates are exact: whole numbers or fractions. "No polygon" for what is none.

    Raises
    ------
    Error
        As `arrange`.

    Examples
    --------
    >>> import plumbline
    >>> plumbline.is_valid_reason("POLYGON ((0 0, 3 1, 3 0, 0 2, 0 0))")
    ['Self-intersection[2 2/3]']
    """

    def reason(problems: list[_core.RingProblem] | None) -> str:
        if problems is None:
            return "No polygon"
        if not problems:
            return "Valid Geometry"
        x, y = problems[0].where
        return f"{problems[0].jts_name}[{x} {y}]"

    return [reason(problems) for problems in _problems(polygons, numbers)]


def make_valid(
    polygons: Arrangement | LinesLike,
    /,
    *,
    method: Method = "linework",
    numbers: Numbers | None = None,
) -> list[Region]:
    """Per feature valid polygons in its place: shapely.make_valid of polygons, exactly.

    Parameters
    ----------
    polygons, numbers
        As in `is_valid`.
    method : {"linework", "structure", "nonzero"}
        What an invalid polygon covers: what lies within an odd number of rings; its parts, of each
        what its outer ring goes around without what its holes do; what its rings, as they run, go
        around more often one way than the other. By linework a side that is drawn twice bounds
        nothing; GEOS takes it as drawn once.

    Returns
    -------
    list of Region
        Rings keep their corners and get one where they cross. Of what has no area, or is no
        polygon, nothing is left.

    Raises
    ------
    Error
        For another method; as `arrange`.

    Examples
    --------
    >>> import plumbline
    >>> [bow] = plumbline.make_valid("POLYGON ((0 0, 3 1, 3 0, 0 2, 0 0))")
    >>> bow, bow.area
    (<Region: 2 polygons, area 2.5>, Fraction(5, 2))
    """
    if method not in ("linework", "structure", "nonzero"):
        raise Error(f"a method is linework, structure or nonzero: {method!r}")
    of = arrangement_of(polygons, numbers=numbers)
    found: dict[int, list[Region]] = {}
    for item, core in _core.made_valid(of.lines._core, of._core, method):
        if item is not None:
            found.setdefault(item, []).append(Region(core, of.lines))
    return [_as_one(found.get(i, [])) for i in range(of.lines.item_count)]


def _as_one(regions: list[Region]) -> Region:
    """An item's regions; nothing where there are none."""
    if len(regions) == 1:
        return regions[0]
    result = union_all([])
    for region in regions:
        result = union(result, region)
    return result
