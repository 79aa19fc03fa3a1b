"""Damaged plans with known rooms, as `plumbline_rooms_again` prints them with what this project
makes of each."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

Rows = list[list[float]]

DAMAGES = (
    "ends short",
    "ends long",
    "ends short or long",
    "pieces missing",
    "walls doubled",
    "ends moved",
    "all but doors",
)
"""All that have a size; doors have none, and tools but ours know nothing of doors."""
RATIOS = ("0.0625", "0.25", "0.5", "1")
"""Of the size of a damage to the plan's least detail."""

NOTHING = "nothing"
OURS = "plumbline repair"
LAR = "float LAR, which prunes"
"""What there is for each plan without a program of another."""


@dataclass(frozen=True)
class Room:
    x: float
    y: float
    """A point inside."""
    area: float
    perimeter: float


@dataclass(frozen=True)
class Plan:
    damage: str
    ratio: str
    seed: int
    size: float
    """Damages are smaller than this, the tolerance that tools are given."""
    rooms: list[Room]
    lines: Rows
    """Damaged."""
    repaired: Rows
    """By `plumbline repair`, from the exact numbers."""
    by_lar: Rows
    """By float LAR, with the size as radius."""
    is_harm_unsaid: bool
    """Of ours: a room that was there is gone, or a face is new, and the repair does not say so."""


def plans(count: int, first_seed: int) -> Iterator[Plan]:
    """So many of each damage and size."""
    program = os.environ.get("PLUMBLINE_ROOMS_AGAIN")
    if not program:
        raise SystemExit("PLUMBLINE_ROOMS_AGAIN names the program plumbline_rooms_again")
    command = [program, str(count), str(first_seed)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as run:
        assert run.stdout
        for line in run.stdout:
            said = json.loads(line)
            ratio = str(float(Fraction(said["ratio"]))).removesuffix(".0")
            if said["damage"] in DAMAGES and ratio in RATIOS:
                yield _plan(said, ratio)
    if run.returncode:
        raise SystemExit(f"{program}: exit code {run.returncode}")


def _plan(said: dict[str, Any], ratio: str) -> Plan:
    return Plan(
        said["damage"],
        ratio,
        said["seed"],
        said["size"],
        [Room(*room) for room in said["rooms"]],
        said["damaged"],
        said["repaired"],
        said["lar"],
        said["one"][0] == "harm",
    )
