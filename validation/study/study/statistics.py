"""Statistics of shares: intervals, and tests of paired differences."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from scipy.stats import binomtest

CONFIDENCE = 0.95


@dataclass(frozen=True)
class Share:
    """k of n, with its Wilson interval."""

    k: int
    n: int

    @property
    def value(self) -> float:
        """Not a number where there are none."""
        return self.k / self.n if self.n else float("nan")

    @property
    def interval(self) -> tuple[float, float]:
        """Wilson's, "Probable inference, the law of succession, and statistical inference" (1927);
        all there is where there are none."""
        if not self.n:
            return 0.0, 1.0
        found = binomtest(self.k, self.n).proportion_ci(CONFIDENCE, method="wilson")
        return float(found.low), float(found.high)

    def __str__(self) -> str:
        """In per cent, with the interval; of none among n the bound 3/n that holds with the same
        confidence (Hanley and Lippman-Hand 1983)."""
        if not self.n:
            return "-"
        if self.k == 0:
            return f"<3/{self.n}"
        low, high = self.interval
        return f"{100 * self.value:.1f} % ({100 * low:.1f}-{100 * high:.1f})"


def mcnemar(only_first: int, only_second: int) -> float:
    """The exact probability, both sides, of so uneven a split among pairs that differ, if neither
    of two configurations were worse (McNemar 1947). 1 where no pair differs."""
    n = only_first + only_second
    return float(binomtest(only_first, n, 0.5).pvalue) if n else 1.0


def holm(p_values: Sequence[float]) -> list[float]:
    """The same probabilities, adjusted for their number (Holm 1979), in their order."""
    m = len(p_values)
    adjusted = [0.0] * m
    largest = 0.0
    for rank, i in enumerate(sorted(range(m), key=lambda i: p_values[i])):
        largest = max(largest, min(1.0, (m - rank) * p_values[i]))
        adjusted[i] = largest
    return adjusted
