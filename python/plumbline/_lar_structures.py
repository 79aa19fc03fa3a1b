"""LAR's structures under its own names: part of `plumbline.lar`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Literal

from numpy.typing import ArrayLike

from plumbline import _core
from plumbline.errors import Error
from plumbline.maps import Map
from plumbline.models import LarModel, ModelLike, as_model
from plumbline.structure import Struct, StructLike, Structure, as_structure

if TYPE_CHECKING:
    pass
from plumbline._lar_runs import _DECIMALS


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
