"""Random numbers that are the same on every machine and in every version of Python."""

from __future__ import annotations

import hashlib
from collections.abc import MutableSequence
from fractions import Fraction
from typing import TypeVar

T = TypeVar("T")
_MASK = 2**64 - 1
_UNIT = 2**53


class Dice:
    """A stream that is determined by a text: splitmix64 (Steele, Lea, Flood, "Fast splittable
    pseudorandom number generators", 2014), which the campaign uses, too."""

    def __init__(self, seed: str) -> None:
        digest = hashlib.sha256(seed.encode()).digest()
        self._state = int.from_bytes(digest[:8], "little")

    def roll(self) -> int:
        """From 0 to 2^64 - 1."""
        self._state = (self._state + 0x9E3779B97F4A7C15) & _MASK
        z = self._state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & _MASK
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & _MASK
        return z ^ (z >> 31)

    def between(self, low: int, high: int) -> int:
        """Both included."""
        return low + self.roll() % (high - low + 1)

    def unit(self) -> Fraction:
        """From 0 to 1, a multiple of 2^-53, exactly."""
        return Fraction(self.roll() % _UNIT, _UNIT)

    def shuffle(self, values: MutableSequence[T]) -> None:
        for i in range(len(values) - 1, 0, -1):
            j = self.between(0, i)
            values[i], values[j] = values[j], values[i]
