"""LAR's functions under the names that its users know, exact or as published.

Names, arguments and results are those of larlib (lar-cc, November 2015) and, where it says so, of
LinearAlgebraicRepresentation.jl. Variants:

``"exact"``
    The arrangement of this library: nothing is moved, merged or lost.
``"repaired"``
    The published float algorithm with its errors mended: vertices within a radius are merged.
``"published"``
    The original's answers, in the original's order (Python 2.7's), with its four decimals, its
    omissions and its failures: to reproduce results, and to see what became of them.
    docs/divergences.md lists how it differs.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from plumbline import _core
from plumbline._lar_chains import (
    bool2d,
    boundaryCells,
    coboundary_0,
    coboundary_1,
    from_julia,
    larBoundary,
    planar_arrangement,
    to_julia,
)
from plumbline._lar_lines import (
    Result,
    arrange,
    larFromLines,
    larSimplify,
    lines2lar,
    stages,
    svg2lines,
)
from plumbline._lar_runs import Floats, _double
from plumbline._lar_structures import (
    checkStruct,
    embedStruct,
    evalStruct,
    larApply,
    larCuboids,
    larEmbed,
    struct2lar,
)
from plumbline._numbers import Number
from plumbline._whole import count, whole
from plumbline.errors import Error
from plumbline.evaluation import box
from plumbline.maps import Map, r, s, t
from plumbline.structure import Struct

if TYPE_CHECKING:
    pass

__all__ = [
    "Map",
    "Result",
    "Struct",
    "arrange",
    "bool2d",
    "boundaryCells",
    "box",
    "checkStruct",
    "coboundary_0",
    "coboundary_1",
    "embedStruct",
    "evalStruct",
    "from_julia",
    "larApply",
    "larBoundary",
    "larCuboids",
    "larEmbed",
    "larFromLines",
    "larSimplify",
    "lines2lar",
    "planar_arrangement",
    "r",
    "randomLines",
    "random_lines",
    "s",
    "stages",
    "struct2lar",
    "svg2lines",
    "t",
    "to_julia",
]


def random_lines(n: int, scaling: Number = 0.1, seed: int = 1) -> Floats:
    """n random segments, (n, 4): differences of random points of the unit square, scaled, about
    random points, moved to where the least coordinates are 0.

    Parameters
    ----------
    n : int
    scaling : number
        Of the lengths.
    seed : int
        Determines them, on every machine; 0 to 2^64 - 1. All three as ``plumbline random`` has
        them.

    Notes
    -----
    Source: randomLines of inters (2015), appendix. The generator is another one than Python's.

    Examples
    --------
    >>> import plumbline
    >>> plumbline.random_lines(100, seed=7).shape
    (100, 4)
    """
    n, seed = count(n, "n"), whole(seed, "the seed")
    if not 0 <= seed < 2**64:
        raise Error(f"a seed of 0 to 2^64 - 1 is needed: {seed}")
    return _core.random_lines(n, _double(scaling), seed)


def randomLines(numberOfLines: int = 200, scaling: Number = 0.3, seed: int = 1) -> Floats:
    """LAR's name for `random_lines`, with LAR's number and scaling."""
    return random_lines(numberOfLines, scaling, seed)
