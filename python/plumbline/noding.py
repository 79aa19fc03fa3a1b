"""Shapely's functions on line work, exactly: node, polygonize, polygonize_full."""

from __future__ import annotations

import numpy as np

from plumbline._net import (
    _Net,
    _nothing,
    _of_noded,
)
from plumbline._numbers import Numbers
from plumbline.lines import LinesLike
from plumbline.sourced import Sourced


def node(geometry: LinesLike, *, numbers: Numbers | None = None) -> Sourced:
    """The lines cut where they meet, each piece once: shapely.node, exactly, with sources.

    Where shapely computes crossings in doubles, one by one, these are exact until the end; then
    all are rounded at once to doubles that are proven to be noded, so that nothing needs to be
    noded again, and no two pieces cross.

    Parameters
    ----------
    geometry : geometry, or whatever `lines` takes
        Polygons give their rings; points, and z, are left out. All that it holds is noded
        together, an array of geometries, too: for shapely's ``node(array)``, which does one by
        one, it is ``[plumbline.node(g) for g in array]``.
    numbers : {"doubles", "decimals"}, optional
        What floats stand for, as in `lines`.

    Returns
    -------
    Sourced
        A MultiLineString with `sources`: per line all items that it is a part of. As with
        shapely, lines go on through their vertices where nothing else meets them; unlike it,
        no line is of length 0 where a point is repeated. In the order of the input and in its
        directions; of a shared piece the first item's.

    Raises
    ------
    Error
        As `arrange`.

    Notes
    -----
    As `arrange` and `snap_round`.

    Examples
    --------
    >>> import plumbline
    >>> from shapely import LineString, MultiLineString, Point
    >>> line = LineString([(0, 0), (1, 1), (0, 1), (1, 0)])
    >>> plumbline.node(line)
    <MULTILINESTRING ((0 0, 0.5 0.5), (0.5 0.5, 1 1, 0 1, 0.5 0.5), (0.5 0.5, 1 0))>
    >>> plumbline.node(Point(1, 1))
    <MULTILINESTRING EMPTY>
    >>> plumbline.node(MultiLineString([[(0, 0), (2, 0)], [(1, 0), (3, 0)]])).sources.tolist()
    [[0], [0, 1], [1]]
    """
    net = _Net(geometry, numbers)
    return net.lines(np.arange(len(net.first)), "multilinestrings")


def polygonize(geometries: LinesLike, *, numbers: Numbers | None = None) -> Sourced:
    """The polygons that line work encloses: shapely.polygonize, exactly, with sources.

    Unlike shapely's, the lines need not be noded: whatever crosses, overlaps or ends within
    another line bounds polygons as it is drawn.

    Parameters
    ----------
    geometries : array_like of geometries, or whatever `lines` takes
        Polygons give their rings; points, and z, are left out.
    numbers : {"doubles", "decimals"}, optional
        What floats stand for, as in `lines`.

    Returns
    -------
    Sourced
        A GeometryCollection of valid polygons that do not overlap, in the order of
        `Arrangement`'s faces, with `sources`: per polygon the items that bound it. Outer rings
        run counter-clockwise, where shapely's run clockwise.

    Raises
    ------
    Error
        As `arrange`.

    Examples
    --------
    >>> import plumbline
    >>> from shapely import LineString
    >>> lines = [
    ...     LineString([(0, 0), (1, 1)]),
    ...     LineString([(0, 0), (0, 1)]),
    ...     LineString([(0, 1), (1, 1)])
    ... ]
    >>> plumbline.polygonize(lines)
    <GEOMETRYCOLLECTION (POLYGON ((0 0, 1 1, 0 1, 0 0)))>
    """
    return _Net(geometries, numbers).polygons()


def polygonize_full(
    geometries: LinesLike, *, noded: bool = False, numbers: Numbers | None = None
) -> tuple[Sourced, Sourced, Sourced, Sourced]:
    """Polygons, and what of the line work bounds none: shapely.polygonize_full, exactly.

    Parameters
    ----------
    geometries, numbers
        As in `polygonize`.
    noded : bool
        Whether lines are joined at their ends alone, as shapely has it. Then a line whose end is
        at no other line's end is a dangle, although it may touch one. What is left must meet in
        ends alone: unlike shapely, no polygon is made of what crosses.

    Returns
    -------
    polygons, cuts, dangles, invalid : Sourced
        In shapely's order: the polygons; lines between two pieces that have the same face on both
        sides; lines that lead nowhere; rings that are no polygons, of which there are none here.

    Raises
    ------
    Error
        As `arrange`; with `noded` where lines meet elsewhere than in their ends.

    Examples
    --------
    >>> import plumbline
    >>> from shapely import LineString
    >>> lines = [
    ...     LineString([(0, 0), (1, 1)]),
    ...     LineString([(0, 0), (0, 1), (1, 1)]),
    ...     LineString([(0, 1), (1, 1), (2, 1)])
    ... ]
    >>> polygons, cuts, dangles, invalid = plumbline.polygonize_full(lines)
    >>> polygons, dangles  # doctest: +NORMALIZE_WHITESPACE
    (<GEOMETRYCOLLECTION (POLYGON ((0 0, 1 1, 0 1, 0 0)))>,
     <GEOMETRYCOLLECTION (LINESTRING (1 1, 2 1))>)
    >>> polygons.sources.tolist(), dangles.sources.tolist()
    ([[0, 1, 2]], [[2]])
    """
    if noded:
        return _of_noded(geometries, numbers)
    net = _Net(geometries, numbers)
    antenna, dangle = net.antennas()
    here = net.first
    dangles = np.flatnonzero(dangle[here])
    cuts = np.flatnonzero(antenna[here] & ~dangle[here])
    kind = "geometrycollections"
    none = _nothing(kind)
    return net.polygons(), net.lines(cuts, kind), net.lines(dangles, kind), none
