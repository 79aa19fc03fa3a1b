"""Which drawings a study has, in blocks: what one worker does before it takes the next."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from study import families
from study.families import Family, Unit
from study.words import TRUTHS

_BLOCK = 25  # seeds that one worker takes at a time: some seconds of work
_LARGE = 2000  # segments, from which on a block has a seed alone


@dataclass(frozen=True)
class Amount:
    """How much of everything."""

    seeds: int
    """Of each family, size and scale."""
    sizes: tuple[int, ...]
    large_sizes: tuple[int, ...]
    """Some seeds of each of these, for times."""
    large_seeds: int
    first_seed: int
    orders: int
    """Permutations of each drawing that is drawn in several orders."""
    ordered_seeds: int
    ulp_side: int
    """Of the maps of neighbours of an end point."""


QUICK = Amount(1, (12,), (), 0, 0, 4, 1, 9)
FULL = Amount(1000, (12, 40, 200), (1000, 10_000, 100_000), 3, 0, 20, 50, 256)

_ORDERED = ("T-junctions", "near-concurrent fans", "plan with doors, turned", "random")


@dataclass(frozen=True)
class Block:
    """Units of one family, all with these truths."""

    family: Family
    units: tuple[Unit, ...]
    truths: tuple[str, ...] = TRUTHS


def blocks(amount: Amount, drawings: Path) -> Iterator[Block]:
    """All blocks of a study, in the same order every time."""
    small = [
        *families.campaign_families(),
        *families.plan_families(),
        *families.made_families(amount.sizes),
    ]
    for family in small:
        yield from _seeds(family, amount.seeds, amount.first_seed)
    for family in families.drawing_families(drawings):
        yield from _seeds(family, 1, amount.first_seed)
    for family in small:
        if family.name in _ORDERED:
            yield from _orders(family, amount)
    if amount.large_sizes:
        for family in families.made_families(amount.large_sizes):
            yield from _seeds(family, amount.large_seeds, amount.first_seed, ("unit",))
    for family in families.ulp_maps():
        yield from _map(family, amount.ulp_side)


def _seeds(
    family: Family, count: int, first: int, scales: tuple[str, ...] | None = None
) -> Iterator[Block]:
    for size in dict.fromkeys(family.sizes):
        block = 1 if size >= _LARGE else _BLOCK
        for scale in scales or family.scales:
            for start in range(first, first + count, block):
                seeds = range(start, min(start + block, first + count))
                yield Block(family, tuple(Unit(family.name, size, scale, s) for s in seeds))


def _orders(family: Family, amount: Amount) -> Iterator[Block]:
    """The same drawings in several orders; the first one as drawn, which is among the seeds."""
    scale, size = family.scales[0], family.sizes[0]
    seeds = range(amount.first_seed, amount.first_seed + min(amount.ordered_seeds, amount.seeds))
    for seed in seeds:
        units = [Unit(family.name, size, scale, seed, k) for k in range(1, amount.orders)]
        yield Block(family, tuple(units), ("doubles",))


def _map(family: Family, side: int) -> Iterator[Block]:
    for row in range(side):
        cells = range(row * side, (row + 1) * side)
        yield Block(family, tuple(Unit(family.name, side, "unit", c) for c in cells), ("doubles",))
