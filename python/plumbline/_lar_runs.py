"""Runs of LAR's float pipelines, and what may be chosen of them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Literal, Union

import numpy as np
from numpy.typing import NDArray

from plumbline import _core
from plumbline._numbers import Number, exact_text
from plumbline._whole import threads_of, whole
from plumbline.errors import Error
from plumbline.lines import Lines

if TYPE_CHECKING:
    pass


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
