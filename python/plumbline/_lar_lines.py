"""LAR's pipelines on lines, exact, repaired and as published: part of `plumbline.lar`."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from plumbline import _core
from plumbline._numbers import Number, Numbers
from plumbline.arrangement import arrange as exact_arrangement
from plumbline.drawing import read
from plumbline.errors import Error, FileError
from plumbline.line_inputs import lines
from plumbline.lines import Lines, LinesLike
from plumbline.lists import Lists
from plumbline.models import ModelLike, as_model, starts_and_indices

if TYPE_CHECKING:
    pass
from plumbline._lar_runs import (
    _DECIMALS,
    _PUBLISHED_RADIUS,
    Floats,
    FloatVariant,
    Pairs,
    Radius,
    Variant,
    _double,
    _ensure_exact,
    _published_radius,
    _run_published,
    _run_repaired,
)


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


def _edges_of_walks(faces: Lists, edges: Pairs) -> Lists:
    """Per face the edges between successive vertices, ascending."""
    number = {(min(pair), max(pair)): e for e, pair in enumerate(edges.tolist())}
    rows = []
    for walk in faces.tolist():
        pairs = zip(walk, walk[1:] + walk[:1], strict=True)
        sides = {number.get((min(pair), max(pair))) for pair in pairs}
        rows.append(sorted(side for side in sides if side is not None))
    return Lists(*starts_and_indices(rows))
