"""Words that results are told in."""

from __future__ import annotations

LOUD = ("error", "crash", "timeout", "memory")
SILENT = ("invalid", "topology")
RIGHT = ("moved", "identical")
OUTCOMES = (*LOUD, *SILENT, *RIGHT)
"""Exclusive, in the order in which they are decided: see `study.outcomes`."""

TRUTHS = ("authored", "doubles", "intended", "contract")
"""See `study.truths`."""

RINGS = "rings"
"""The group of families of rings: see `study.ring_families`."""
