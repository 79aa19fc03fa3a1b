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

import json
import math
import os
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plumbline import _core
from plumbline._numbers import Number, Numbers, exact_text
from plumbline._whole import count, threads_of, whole
from plumbline.arrangement import arrange as exact_arrangement
from plumbline.drawing import read
from plumbline.errors import Error, FileError
from plumbline.line_inputs import lines
from plumbline.lines import Lines, LinesLike
from plumbline.lists import Lists
from plumbline.maps import Map, r, s, t
from plumbline.models import CellsLike, LarModel, ModelLike, as_model, starts_and_indices
from plumbline.structure import Struct, StructLike, Structure, as_structure, box

if TYPE_CHECKING:
    import scipy.sparse

__all__ = [
    "Map",
    "Result",
    "Struct",
    "arrange",
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

Variant = Literal["exact", "repaired", "published"]
FloatVariant = Literal["repaired", "published"]
Radius = Union[Number, Literal["larlib", "plasm", "drawing"], None]
"""A number in drawing units; "larlib", 0.001 of the drawing's longer side; "plasm", 1e-8, as
Plasm.jl and LinearAlgebraicRepresentation.jl have it; None or "drawing", the variant's default:
published 0.001, repaired 0.001 of the longer side, but at most a quarter of the shortest
segment."""

Floats = NDArray[np.float64]
Pairs = NDArray[np.uint32]

_PUBLISHED_RADIUS = 0.001
_DECIMALS = 4


@dataclass(frozen=True)
class Result:
    """What a float pipeline of LAR makes of lines.

    Attributes
    ----------
    V : ndarray (n, 2)
        Vertices.
    EV : ndarray (m, 2)
        Edges as pairs of vertices.
    FV : Lists
        Per bounded face its vertices as its boundary is walked. Repaired: counter-clockwise, then
        its holes, clockwise; edges that end within it left out. Published: clockwise, no holes.
    FE : Lists
        Per bounded face its edges, ascending; repaired: those that end within it, too.
    variant : str
        "repaired" or "published".
    radius : float
        Of merging, in drawing units.
    complete : bool
        Repaired: whether rounds of cutting and merging settled. Published: whether the walk of
        faces came to its end; where not, faces are missing.
    trace : dict or None
        With ``trace=True`` the output of every stage: see `stages`.
    """

    V: Floats
    EV: Pairs
    FV: Lists
    FE: Lists
    variant: FloatVariant
    radius: float
    complete: bool
    trace: dict[str, Any] | None = field(default=None, repr=False)

    def __repr__(self) -> str:
        return (
            f"<lar.Result: {self.variant}, {len(self.V)} vertices, {len(self.EV)} edges, "
            f"{len(self.FV)} faces, radius {self.radius:g}"
            + ("" if self.complete else ", incomplete")
            + ">"
        )


def arrange(
    lines_like: LinesLike,
    variant: FloatVariant = "repaired",
    *,
    radius: Radius = None,
    decimals: int = _DECIMALS,
    unit_square: bool = False,
    trace: bool = False,
    numbers: Numbers | None = None,
    threads: int | None = None,
) -> Result:
    """The float pipeline of LAR on lines, as ``plumbline lar`` runs it.

    Parameters
    ----------
    lines_like, numbers
        As `plumbline.lines` takes them. Segments without length take no part.
    variant : {"repaired", "published"}
        `plumbline.arrange` is the exact one.
    radius : number, "larlib", "plasm" or "drawing", optional
        Vertices no further apart are merged, transitively. By default published 0.001, repaired
        0.001 of the longer side, but no more than a quarter of the shortest segment.
    decimals : int
        Published: of coordinates and parameters, 0 to 12.
    unit_square : bool
        Whether the drawing is mapped to the unit square first, y upwards, as published for SVG.
    trace : bool
        Whether the output of every stage is in the result.
    threads : int, optional
        As in `plumbline.arrange`.

    Returns
    -------
    Result

    Raises
    ------
    Error
        Where the published pipeline has no faces: it failed, or returned None, as where no edges
        form a cycle. The message tells; `stages` shows how far it came.

    Notes
    -----
    Source: Paoluzzi, "Accelerated intersection of geometric objects", November 2015. Results are
    rounded, and no better than the variant: `plumbline.check` holds them against the exact answer.

    Examples
    --------
    >>> import plumbline.lar
    >>> room = [(0, 0, 7, 0), (7, 0, 7, 11), (7, 11, 0, 11), (0, 11, 0, 0), (0, 1, 7, 1)]
    >>> plumbline.lar.arrange(room)
    <lar.Result: repaired, 6 vertices, 7 edges, 2 faces, radius 0.011>
    >>> plumbline.lar.arrange(room, "published")
    <lar.Result: published, 5 vertices, 5 edges, 1 faces, radius 0.001>
    """
    of = lines(lines_like, numbers=numbers)
    if variant == "repaired":
        run = _run_repaired(of, radius, decimals, unit_square, threads)
        V, EV, FV, FE = run.arrays()
        told = json.loads(run.to_json()) if trace else None
        faces = Lists(*FV)
        return Result(V, EV, faces, Lists(*FE), variant, run.radius, run.settled, told)
    if variant == "published":
        chosen = _published_radius(of, radius, unit_square)
        published = _run_published(of, chosen, decimals, unit_square, threads)
        V, EV, FV = published.lar_from_lines()
        told = json.loads(published.to_json()) if trace else None
        faces = Lists(*FV)
        edges = _edges_of_walks(faces, EV)
        return Result(V, EV, faces, edges, variant, chosen, not published.aborted, told)
    raise Error(f'variants are "repaired" and "published": {variant!r}')


def stages(
    lines_like: LinesLike,
    variant: FloatVariant = "repaired",
    *,
    radius: Radius = None,
    decimals: int = _DECIMALS,
    unit_square: bool = False,
    numbers: Numbers | None = None,
    threads: int | None = None,
) -> dict[str, Any]:
    """The output of every stage of a float pipeline of LAR, also where it fails on the way.

    Returns
    -------
    dict
        As ``plumbline lar --trace`` writes it and docs/json.md describes it: `outputs` by the names
        of LAR's module inters (boxes, buckets, params, raw, prune, lar, components, ...), and of
        the published variant `errors`, what the original raised in which stage.

    Examples
    --------
    >>> import plumbline.lar
    >>> cross = plumbline.lar.stages([(0, 0, 1, 1), (0, 1, 1, 0)], "published")
    >>> cross["outputs"]["intersectionPoints"], cross["outputs"]["larFromLines"]
    ([[0.5, 0.5]], None)
    """
    of = lines(lines_like, numbers=numbers)
    if variant == "repaired":
        text = _run_repaired(of, radius, decimals, unit_square, threads).to_json()
    elif variant == "published":
        chosen = _published_radius(of, radius, unit_square)
        text = _run_published(of, chosen, decimals, unit_square, threads).to_json()
    else:
        raise Error(f'variants are "repaired" and "published": {variant!r}')
    result: dict[str, Any] = json.loads(text)
    return result


def svg2lines(
    filename: str | os.PathLike[str],
    variant: Literal["exact", "published"] = "exact",
    *,
    rect2lines: bool = True,
) -> Lines:
    """The lines of an SVG file on the unit square: the longer side of the drawing becomes 1, its
    left edge 0, its top 1; y upwards.

    Parameters
    ----------
    filename : path
    variant : {"exact", "published"}
        Exact: all that `plumbline.read` reads, mapped exactly. Published: `line` and `rect`
        elements that stand on a text line of their own, with their attributes in one order;
        integers are divided as integers; four decimals.
    rect2lines : bool
        Published: whether rectangles are their sides, or one diagonal.

    Raises
    ------
    Error
        As `plumbline.read`; published: what the original raises.

    Notes
    -----
    Source: svg2lines of inters (2015), section 4.
    """
    if variant == "exact":
        if not rect2lines:
            raise Error("rectangles as diagonals are the published variant's: rect2lines=False")
        drawing = read(filename)
        return Lines(_core.lar_unit_square(drawing._core), drawing.numbers)
    if variant != "published":
        raise Error(f'variants are "exact" and "published": {variant!r}')
    try:
        with open(filename, encoding="utf-8") as file:
            svg = file.read()
    except OSError as error:
        raise FileError(f"{os.fspath(filename)}: {error.strerror}") from error
    return lines(_core.inters_svg_lines(svg, rect2lines), numbers="doubles")


def lines2lar(
    lines_like: LinesLike,
    variant: Variant = "exact",
    *,
    radius: Radius = None,
    decimals: int = _DECIMALS,
    numbers: Numbers | None = None,
) -> tuple[Floats, Pairs]:
    """The lines cut where they meet, as a 1-complex (V, EV).

    Parameters
    ----------
    lines_like, radius, decimals, numbers
        As in `arrange`; of the exact variant neither radius nor decimals.
    variant : {"exact", "repaired", "published"}

    Returns
    -------
    V, EV : ndarray (n, 2) of float64, (m, 2) of uint32
        Exact: vertices by (x, y), correctly rounded, edges by (tail, head). Published: in the
        original's order; lines that overlap are not cut, and vertices within 0.001 are one.

    Notes
    -----
    Source: lines2lar of inters (2015), section 2.3.

    Examples
    --------
    >>> import plumbline.lar
    >>> V, EV = plumbline.lar.lines2lar([(0, 0, 2, 0), (1, 0, 3, 0)])
    >>> EV.tolist()
    [[0, 1], [1, 2], [2, 3]]
    >>> V, EV = plumbline.lar.lines2lar([(0, 0, 2, 0), (1, 0, 3, 0)], "published")
    >>> len(EV)
    2
    """
    of = lines(lines_like, numbers=numbers)
    if variant == "exact":
        _ensure_exact(radius, decimals)
        a = exact_arrangement(of)
        return a.V, a.EV
    if variant == "repaired":
        V, EV, _, _ = _run_repaired(of, radius, decimals, False, None).arrays()
        return V, EV
    if variant == "published":
        run = _run_published(of, _published_radius(of, radius, False), decimals, False, None)
        V, EV, _ = run.lar()
        if not len(EV):
            raise Error(f"the published pipeline has no edges: {run.failure}")
        return V, EV
    raise Error(f'variants are "exact", "repaired" and "published": {variant!r}')


def larFromLines(
    lines_like: LinesLike,
    variant: Variant = "exact",
    *,
    radius: Radius = None,
    decimals: int = _DECIMALS,
    numbers: Numbers | None = None,
) -> tuple[Floats, Lists, Pairs]:
    """The 2-complex (V, FV, EV) that lines cut the plane into.

    Parameters
    ----------
    lines_like, radius, decimals, numbers
        As in `arrange`; of the exact variant neither radius nor decimals.
    variant : {"exact", "repaired", "published"}

    Returns
    -------
    V : ndarray (n, 2) of float64
    FV : Lists
        Per bounded face its vertices as its boundary is walked: see `Result`. Empty where there is
        no bounded face.
    EV : ndarray (m, 2) of uint32
        Exact and repaired: with dangling edges and bridges, which are in no FV.

    Raises
    ------
    Error
        Published: where the original fails, or returns None, as where no edges form a cycle.

    Notes
    -----
    Source: larFromLines of inters (2015), section 2.8, which keeps the biconnected component with
    the most edges alone, drops dangling edges, and knows no holes.

    Examples
    --------
    >>> import plumbline.lar
    >>> V, FV, EV = plumbline.lar.larFromLines([(0, 0, 2, 0), (2, 0, 0, 2), (0, 2, 0, 0)])
    >>> FV.tolist()
    [[1, 0, 2]]
    """
    if variant == "repaired" or variant == "published":
        result = arrange(lines_like, variant, radius=radius, decimals=decimals, numbers=numbers)
        return result.V, result.FV, result.EV
    if variant != "exact":
        raise Error(f'variants are "exact", "repaired" and "published": {variant!r}')
    _ensure_exact(radius, decimals)
    a = exact_arrangement(lines_like, numbers=numbers)
    return a.V, a.FV, a.EV


def larSimplify(
    model: ModelLike, radius: Number = _PUBLISHED_RADIUS, variant: FloatVariant = "repaired"
) -> tuple[Any, ...]:
    """A model of the plane with vertices no further apart than the radius merged, transitively,
    into their centroids.

    Parameters
    ----------
    model : (V, EV) or (V, FV, EV)
        Coordinates as nearest doubles.
    radius : number
    variant : {"repaired", "published"}
        Repaired: cells that collapse, repeated cells and unused vertices are dropped; vertices and
        edges ascending. Published: cells in the original's order; vertices stay, used or not, and
        of (V, FV, EV) edges that became a point, too.

    Returns
    -------
    V, EV or V, FV, EV

    Notes
    -----
    Source: larSimplify of inters (2015), section 2.9. Faces thinner than the radius may overlap
    then.
    """
    if variant not in ("repaired", "published"):
        raise Error(f'variants are "repaired" and "published": {variant!r}')
    of = as_model(model)
    if of.dimension != 2 or len(of) not in (2, 3):
        raise Error(f"a model of the plane, (V, EV) or (V, FV, EV), is needed: {of!r}")
    if (of.cells[-1].lengths != 2).any():
        raise Error("edges are pairs of vertices")
    pairs = np.ascontiguousarray(of.cells[-1].indices.reshape(-1, 2))
    faces = starts_and_indices(of.cells[0] if len(of) == 3 else [])
    V, EV, FV = _core.lar_simplify(of.V, pairs, faces, _double(radius), variant == "published")
    return (V, EV) if len(of) == 2 else (V, Lists(*FV), EV)


# Structures.


def evalStruct(struct: StructLike) -> list[LarModel]:
    """All models of a Struct under the maps above them, in traversal order, exactly.

    Notes
    -----
    Source: evalStruct of larstruct (2015), section 4. There the dimension is that of the first
    item; here items of different dimensions are refused.

    Examples
    --------
    >>> from plumbline.lar import Struct, evalStruct, t
    >>> edge = ([(0, 0), (1, 0)], [[0, 1]])
    >>> [model.points for model in evalStruct(Struct([t(0, 1), edge]))]
    [[(Fraction(0, 1), Fraction(1, 1)), (Fraction(1, 1), Fraction(1, 1))]]
    """
    return as_structure(struct).models()


def struct2lar(
    struct: StructLike,
    variant: Literal["exact", "published"] = "exact",
    *,
    decimals: int | None = None,
    merge_cells: bool | None = None,
) -> LarModel:
    """A Struct as one model: ``V, CV = struct2lar(struct)``, or V, FV, EV.

    Parameters
    ----------
    struct : Struct, Structure or model
    variant : {"exact", "published"}
        What the next two are by default: no rounding, repeated cells kept; or 4 decimals, and cells
        of the same vertices once, as since November 2015.
    decimals : int, optional
        Vertices that are equal after rounding to so many are one, and are rounded.
    merge_cells : bool, optional
        Whether cells of the same vertices are kept once.

    Returns
    -------
    LarModel
        Vertices in the order of first use, cells in traversal order (published: by hash).

    Notes
    -----
    Source: struct2lar of larstruct (2015), section 3.1. There the last model decides whether there
    are edges; here no array is lost.
    """
    if variant not in ("exact", "published"):
        raise Error(f'variants are "exact" and "published": {variant!r}')
    published = variant == "published"
    return as_structure(struct).to_lar(
        decimals=_DECIMALS if published and decimals is None else decimals,
        merge_cells=published if merge_cells is None else merge_cells,
    )


def larApply(affineMatrix: Map | ArrayLike) -> Callable[[ModelLike], LarModel]:
    """A function that applies a map, or a matrix in homogeneous coordinates, to a model, exactly.

    Notes
    -----
    Source: larApply of larstruct (2015), section 1.2.

    Examples
    --------
    >>> from plumbline.lar import larApply, s
    >>> larApply(s(2, 3))(([(1, 1)], [[0]])).V.tolist()
    [[2.0, 3.0]]
    """
    map = affineMatrix if isinstance(affineMatrix, Map) else Map(affineMatrix)
    return lambda model: as_model(model).mapped(map)


def larEmbed(k: int) -> Callable[[ModelLike], LarModel]:
    """A function that gives a model k more coordinates, all 0; for k < 0 -k fewer.

    Notes
    -----
    Source: larEmbed of larstruct (2015), section 3.2, which for k < 0 keeps the first -k
    coordinates.

    Examples
    --------
    >>> from plumbline.lar import larCuboids, larEmbed
    >>> larEmbed(-1)(larCuboids([1, 1, 1])).dimension
    2
    """
    return lambda model: as_model(model).embed(k)


def embedStruct(k: int) -> Callable[[StructLike], Structure]:
    """A function that gives a Struct k more dimensions, its maps too; for k < 0 -k fewer.

    Notes
    -----
    Source: embedStruct of larstruct (2015), section 4, which leaves maps as they are.
    """
    return lambda struct: as_structure(struct).embed(k)


def checkStruct(lst: Sequence[Any]) -> int:
    """The common dimension of the items of a body; 0 where it has neither models nor maps.

    Raises
    ------
    Error
        Where two are different. The original looks at the first item alone.

    Notes
    -----
    Source: checkStruct of larstruct (2015), section 4.
    """
    return Struct(lst).dimension


# Boundaries.


def larBoundary(cells: CellsLike, facets: CellsLike) -> scipy.sparse.csc_array:
    """The boundary operator mod 2 of cells given by their vertices, facets x cells.

    A facet bounds a cell where all its vertices are the cell's: right where cells are convex. Of
    an arrangement `d2`, `FE` and `planar_arrangement` are right always.

    Notes
    -----
    Source: larBoundary of larlib's module boundary.

    Examples
    --------
    >>> from plumbline.lar import larBoundary
    >>> larBoundary([[0, 1, 2]], [[0, 1], [1, 2], [0, 2], [2, 3]]).toarray().T.tolist()
    [[1, 1, 1, 0]]
    """
    return _incidences(cells, facets).boundary_operator()


def boundaryCells(cells: CellsLike, facets: CellsLike) -> list[int]:
    """The facets that an odd number of cells hold, as `larBoundary` has it: the boundary of all.
    Source: boundaryCells of larlib's module boundary."""
    found: list[int] = _incidences(cells, facets).boundary_cells().tolist()
    return found


def coboundary_0(EV: CellsLike) -> scipy.sparse.csr_array:
    """The coboundary operator from vertices to edges, E x V: -1 at an edge's first vertex, +1 at
    its second one. Source: coboundary_0 of LinearAlgebraicRepresentation.jl."""
    from scipy.sparse import csr_array

    starts, indices = starts_and_indices(EV)
    if (np.diff(starts) != 2).any():
        raise Error("edges are pairs of vertices")
    signs = np.tile(np.array([-1, 1], dtype=np.int8), len(starts) - 1)
    columns = int(indices.max()) + 1 if len(indices) else 0
    return csr_array((signs, indices, starts), shape=(len(starts) - 1, columns))


def coboundary_1(FV: CellsLike, EV: CellsLike) -> scipy.sparse.csr_array:
    """The coboundary operator from edges to faces, F x E, unsigned: the transpose of `larBoundary`,
    with its rule. Source: u_coboundary_1 of LinearAlgebraicRepresentation.jl; signed, and right for
    faces of any shape, is copFE of `planar_arrangement`."""
    return larBoundary(FV, EV).transpose().tocsr()


def planar_arrangement(
    lines_like: LinesLike, *, numbers: Numbers | None = None
) -> tuple[Floats, scipy.sparse.csr_array, scipy.sparse.csr_array]:
    """The exact arrangement as LinearAlgebraicRepresentation.jl has it: V and the signed coboundary
    operators.

    Returns
    -------
    V : ndarray (n, 2)
        A point a row; `to_julia` has a point a column.
    copEV : csr_array, E x V
        -1 at an edge's tail, +1 at its head.
    copFE : csr_array, F x E
        Bounded faces, counter-clockwise: +1 where the edge runs along. ``copFE @ copEV`` is 0. An
        edge with the face on both sides has no entry.

    Notes
    -----
    There dangling edges and bridges are dropped, and vertices within 1e-8 are one; here nothing is.
    """
    a = exact_arrangement(lines_like, numbers=numbers)
    return a.V, a.d1.T.tocsr(), a.d2[:, 1:].T.tocsr()


def larCuboids(shape: Sequence[int], full: bool = False) -> LarModel:
    """The grid of unit cubes [0, shape[0]] x [0, shape[1]] x ..., of any dimension.

    Parameters
    ----------
    shape : sequence of int
        How many cubes in each direction.
    full : bool
        Whether its cells of all lower dimensions are there, too: in the plane (V, FV, EV, VV).
        larlib lists these the other way round, single vertices first.

    Returns
    -------
    LarModel
        Vertices are the integer points, the last coordinate fastest.

    Notes
    -----
    Source: larCuboids of larcc's module largrid.

    Examples
    --------
    >>> import plumbline.lar
    >>> plumbline.lar.larCuboids([2, 1])
    <LarModel: 6 vertices in 2 dimensions, cells: 2>
    >>> plumbline.lar.larCuboids([1, 1, 1], full=True)
    <LarModel: 8 vertices in 3 dimensions, cells: 1, 6, 12, 8>
    """
    sizes = [int(n) for n in shape]
    if any(n < 0 or n >= 2**32 for n in sizes):
        raise Error(f"extents of a grid are 0 to 2^32 - 1: {list(shape)!r}")
    return LarModel._of(_core.cuboids(sizes, full))


# Lines at random, and Julia's conventions.


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


def to_julia(model: ModelLike) -> tuple[Any, ...]:
    """A model as LinearAlgebraicRepresentation.jl has it: V with a point a column, (d, n), and
    cells as lists of vertices counted from 1.

    Examples
    --------
    >>> from plumbline.lar import to_julia
    >>> V, EV = to_julia(([(0, 0), (1, 0), (1, 1)], [[0, 1], [1, 2]]))
    >>> V.shape, EV
    ((2, 3), [[1, 2], [2, 3]])
    """
    V, *cells = as_model(model)
    return (V.T, *([[v + 1 for v in cell] for cell in array.tolist()] for array in cells))


def from_julia(
    V: ArrayLike, *cells: Sequence[Sequence[int]], numbers: Numbers = "decimals"
) -> LarModel:
    """The model of what LinearAlgebraicRepresentation.jl has: points as columns, vertices counted
    from 1.

    Examples
    --------
    >>> from plumbline.lar import from_julia
    >>> from_julia([[0, 1, 1], [0, 0, 1]], [[1, 2], [2, 3]]).cells[0].tolist()
    [[0, 1], [1, 2]]
    """
    points = list(zip(*np.asarray(V, dtype=object).tolist(), strict=True))
    from_0 = [[[int(v) - 1 for v in cell] for cell in array] for array in cells]
    return LarModel(points, *from_0, numbers=numbers)


# What these have in common.


def _run_repaired(
    of: Lines, radius: Radius, decimals: int, unit_square: bool, threads: int | None
) -> _core.LarResult:
    if whole(decimals, "decimals") != _DECIMALS:
        raise Error(f"decimals are the published variant's; this one has doubles: {decimals}")
    core = _core.lar_unit_square(of._core) if unit_square else of._core
    return _core.lar_arrange(core, _radius(core, radius), threads_of(threads))


def _run_published(
    of: Lines, radius: float, decimals: int, unit_square: bool, threads: int | None
) -> _core.IntersTrace:
    return _core.inters_run(
        of._core, whole(decimals, "decimals"), radius, unit_square, threads_of(threads)
    )


def _published_radius(of: Lines, radius: Radius, unit_square: bool) -> float:
    core = _core.lar_unit_square(of._core) if unit_square else of._core
    chosen = _radius(core, radius)
    return _PUBLISHED_RADIUS if chosen is None else chosen


def _radius(core: _core.SegmentSet, radius: Radius) -> float | None:
    if radius is None or radius == "drawing":
        return None
    if radius in ("larlib", "plasm"):
        return _core.lar_preset_radius(str(radius), core)
    return _double(radius)


def _double(value: Number) -> float:
    """The nearest double of a number."""
    try:
        nearest = _core.nearest_double(exact_text(value))
    except ValueError as error:
        raise Error(str(error)) from None
    if not math.isfinite(nearest):
        raise Error(f"a number that doubles can hold is needed: {value!r:.60}")
    return nearest


def _ensure_exact(radius: Radius, decimals: int) -> None:
    if radius is not None or decimals != _DECIMALS:
        raise Error(
            "the exact variant has neither radius nor decimals: "
            + (f"decimals={decimals}" if radius is None else f"radius={radius!r}")
        )


def _incidences(cells: CellsLike, facets: CellsLike) -> LarModel:
    """A model of these cells whose vertices have no places of their own."""
    arrays = [starts_and_indices(cells), starts_and_indices(facets)]
    count = max((int(indices.max()) + 1 for _, indices in arrays if len(indices)), default=0)
    return LarModel(np.zeros((count, 1)), *(Lists(*array) for array in arrays))


def _edges_of_walks(faces: Lists, edges: Pairs) -> Lists:
    """Per face the edges between successive vertices, ascending."""
    number = {(min(pair), max(pair)): e for e, pair in enumerate(edges.tolist())}
    rows = []
    for walk in faces.tolist():
        pairs = zip(walk, walk[1:] + walk[:1], strict=True)
        sides = {number.get((min(pair), max(pair))) for pair in pairs}
        rows.append(sorted(side for side in sides if side is not None))
    return Lists(*starts_and_indices(rows))
