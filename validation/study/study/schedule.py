"""Which drawings a study has, in blocks: what one worker does before it takes the next."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from study import families
from study.families import Family, Unit
from study.ring_families import RingFamily, ring_families
from study.words import TRUTHS

_BLOCK = 25  # seeds that one worker takes at a time: some seconds of work
_LARGE = 2000  # segments, from which on a block has a seed alone


@dataclass(frozen=True)
class Amount:
    """How much of everything."""

    seeds: int
    """Of each family of the campaign, and of plans as drawn."""
    scaled_seeds: int
    """Of each family that is made in sizes and scales, for each of them."""
    sizes: tuple[int, ...]
    large: tuple[tuple[int, int], ...]
    """Sizes with numbers of seeds, at unit scale and over the doubles alone: for times."""
    orders: int
    """Permutations of each drawing that is drawn in several orders."""
    ordered_seeds: int
    ulp_side: int
    """Of the maps of neighbours of an end point."""
    swept_seeds: int
    """Of drawings that are given with tolerances of all sizes."""
    ratios: tuple[float, ...]
    """Of these tolerances to the least feature that was meant."""
    rings: tuple[tuple[int, int], ...]
    """Sizes of rings, with numbers of seeds for each family and scale."""
    first_seed: int = 0


_RATIOS = (0.0, *(float(f"1e{k}") for k in range(-12, 2)))

QUICK = Amount(1, 1, (12,), (), 4, 1, 7, 1, (1e-9, 1e-1, 10.0), ((10, 1),))
FULL = Amount(
    seeds=100,
    scaled_seeds=25,
    sizes=(12, 40),
    large=((200, 10), (1000, 3), (10_000, 1), (100_000, 1)),
    orders=20,
    ordered_seeds=10,
    ulp_side=32,
    swept_seeds=10,
    ratios=_RATIOS,
    rings=((10, 100), (100, 40), (1000, 3)),
)


def at_most(amount: Amount, seeds: int) -> Amount:
    """The same with so many seeds of everything, or fewer."""
    return replace(
        amount,
        seeds=min(seeds, amount.seeds),
        scaled_seeds=min(seeds, amount.scaled_seeds),
        ordered_seeds=min(seeds, amount.ordered_seeds),
        swept_seeds=min(seeds, amount.swept_seeds),
        rings=tuple((size, min(n, seeds)) for size, n in amount.rings),
    )


_ORDERED = ("T-junctions", "near-concurrent fans", "plan with doors, turned", "random")
_SWEPT = (
    *(("plans", f"plan{how}") for how in ("", ", turned", ", turned, 3 decimals")),
    ("plans", "plan with doors, turned"),
    ("junctions", "tees on a slant"),
    ("campaign", "T-junctions"),
    ("campaign", "T-junctions on slants"),
    ("campaign", "near-concurrent fans"),
    ("random", "random"),
)
_SWEPT_BLOCK = 2  # seeds, each with all tolerances


@dataclass(frozen=True)
class Block:
    """Units of one family, all with these truths."""

    family: Family
    units: tuple[Unit, ...]
    truths: tuple[str, ...] = TRUTHS
    ratios: tuple[float | None, ...] = (None,)
    """Of tolerances to the least feature that was meant; None: each engine's own tolerance."""


@dataclass(frozen=True)
class RingBlock:
    """Units of one family of rings."""

    family: RingFamily
    units: tuple[Unit, ...]


def ring_blocks(amount: Amount) -> Iterator[RingBlock]:
    """All blocks of engines of rings, in the same order every time."""
    for size, count in amount.rings:
        for family in ring_families():
            for scale in family.scales if size <= family.most else ():
                last = amount.first_seed + count
                for start in range(amount.first_seed, last, _BLOCK):
                    seeds = range(start, min(start + _BLOCK, last))
                    units = tuple(Unit(family.name, size, scale, s) for s in seeds)
                    yield RingBlock(family, units)


def blocks(amount: Amount, drawings: Path) -> Iterator[Block]:
    """All blocks of engines of line work, in the same order every time."""
    small = [*families.campaign_families(), *families.plan_families()]
    made = families.made_families(amount.sizes)
    for family in small:
        yield from _seeds(family, amount.seeds, amount.first_seed, family.scales[:1])
    for family in small:
        yield from _seeds(family, amount.scaled_seeds, amount.first_seed, family.scales[1:])
    for family in made:
        yield from _seeds(family, amount.scaled_seeds, amount.first_seed, family.scales)
    yield from sweeps(amount)
    for family in families.drawing_families(drawings):
        yield from _seeds(family, 1, amount.first_seed, family.scales)
    for family in (*small, *made):
        if family.name in _ORDERED:
            yield from _orders(family, amount)
    for size, seeds in amount.large:
        for family in families.made_families((size,)):
            if family.grows_well:
                yield from _seeds(family, seeds, amount.first_seed, ("unit",), ("doubles",))
    for family in families.ulp_maps():
        yield from _map(family, amount.ulp_side)


def sweeps(amount: Amount) -> Iterator[Block]:
    """Drawings of some families, each with tolerances from none to ten times its features."""
    all_families = [
        *families.plan_families(),
        *families.made_families(amount.sizes),
        *families.campaign_families(),
    ]
    for family in all_families:
        if (family.group, family.name) not in _SWEPT:
            continue
        one = replace(family, sizes=family.sizes[:1])
        of_seeds = _seeds(one, amount.swept_seeds, amount.first_seed, family.scales[:1])
        for block in of_seeds:
            for start in range(0, len(block.units), _SWEPT_BLOCK):
                units = block.units[start : start + _SWEPT_BLOCK]
                yield replace(block, units=units, ratios=amount.ratios)


def _seeds(
    family: Family,
    count: int,
    first: int,
    scales: tuple[str, ...],
    truths: tuple[str, ...] = TRUTHS,
) -> Iterator[Block]:
    if family.most_seeds is not None:
        count = min(count, family.most_seeds)
    for size in dict.fromkeys(family.sizes):
        block = 1 if size >= _LARGE else _BLOCK
        for scale in scales:
            for start in range(first, first + count, block):
                seeds = range(start, min(start + block, first + count))
                units = tuple(Unit(family.name, size, scale, s) for s in seeds)
                yield Block(family, units, truths)


def _orders(family: Family, amount: Amount) -> Iterator[Block]:
    """The same drawings in several orders; the first one as drawn, which is among the seeds."""
    scale, size = family.scales[0], family.sizes[0]
    count = amount.seeds if family.sizes == (0,) else amount.scaled_seeds
    seeds = range(amount.first_seed, amount.first_seed + min(amount.ordered_seeds, count))
    for seed in seeds:
        units = [Unit(family.name, size, scale, seed, k) for k in range(1, amount.orders)]
        yield Block(family, tuple(units), ("doubles",))


def _map(family: Family, side: int) -> Iterator[Block]:
    for row in range(side):
        cells = range(row * side, (row + 1) * side)
        yield Block(family, tuple(Unit(family.name, side, "unit", c) for c in cells), ("doubles",))
