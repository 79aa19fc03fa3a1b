"""What structures come to: lines, and boxes."""

from __future__ import annotations

from plumbline._numbers import Numbers
from plumbline.errors import Error
from plumbline.lines import Lines, _warn_of_losses
from plumbline.structure import ExactBox, StructLike, as_structure


def evaluate(
    struct: StructLike | Lines, *, numbers: Numbers = "decimals", category: str | None = None
) -> Lines:
    """The lines of a hierarchy of the plane: every model under the maps above it, exactly.

    Parameters
    ----------
    struct : Struct, Structure, Drawing or model
        Of a model its last array of cells with more than one vertex is drawn: edges, or cells as
        the polygons of their vertices in order, else as their convex hulls.
    numbers : {"decimals", "doubles"}
        "doubles": what those get who read the numbers of the structure as doubles, and then
        compute exactly.
    category : str, optional
        Only what stands within Structs of this category.

    Returns
    -------
    Lines
        In traversal order, each model an item whose path names the Structs above it. `ledger` has
        the rotations that are not exactly those asked for.

    Raises
    ------
    Error
        For items of different dimensions, of others than 2; LimitError for results of more than
        2 GB.

    Examples
    --------
    >>> import plumbline
    >>> edge = ([(0, 0), (1, 0)], [[0, 1]])
    >>> plumbline.evaluate(plumbline.Struct([plumbline.t("1/3", 0), edge])).exact(0)
    ((Fraction(1, 3), Fraction(0, 1)), (Fraction(4, 3), Fraction(0, 1)))
    """
    if numbers not in ("decimals", "doubles"):
        raise Error(f'numbers are "doubles" or "decimals": {numbers!r}')
    structure = as_structure(struct)
    if category is not None:
        structure = structure.of_category(category)
    result = Lines(structure._core.evaluate(numbers == "doubles"), numbers)
    _warn_of_losses(result)
    return result


def box(struct: StructLike | Lines) -> ExactBox | None:
    """The least axis-parallel box of all vertices, after all maps: (low, high), exactly; None where
    there are no vertices.

    Notes
    -----
    Exact under rotations, too, where larstruct's box of a nested Struct maps two corners.

    Examples
    --------
    >>> import plumbline
    >>> diagonal = plumbline.Struct([plumbline.r(degrees=45), ([(0, 0), (1, 1)], [[0, 1]])])
    >>> low, high = plumbline.box(diagonal)
    >>> abs(float(high[1]) - 2**0.5) < 1e-15
    True
    """
    return as_structure(struct).box
