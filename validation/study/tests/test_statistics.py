"""Known values."""

from __future__ import annotations

import math

import pytest
from study.statistics import Share, holm, mcnemar


@pytest.mark.parametrize(
    ("k", "n", "low", "high"),
    [
        # Newcombe, "Two-sided confidence intervals for the single proportion" (1998), table I.
        (81, 263, 0.2553, 0.3662),
        (15, 148, 0.0624, 0.1605),
        (0, 20, 0.0, 0.1611),
        (1, 29, 0.0061, 0.1718),
    ],
)
def test_intervals_are_those_of_wilson(k: int, n: int, low: float, high: float) -> None:
    assert Share(k, n).interval == pytest.approx((low, high), abs=5e-5)


def test_shares_are_told_in_words() -> None:
    assert str(Share(0, 1000)) == "<3/1000"
    assert str(Share(81, 263)) == "30.8 % (25.5-36.6)"
    assert str(Share(0, 0)) == "-" and math.isnan(Share(0, 0).value)


def test_mcnemar_is_the_sign_test_of_pairs_that_differ() -> None:
    assert mcnemar(0, 0) == 1
    assert mcnemar(5, 0) == 2 / 2**5
    assert mcnemar(1, 8) == pytest.approx(2 * (1 + 9) / 2**9)
    assert mcnemar(4, 4) == 1


def test_holm_adjusts_by_rank_and_keeps_the_order() -> None:
    assert holm([0.01, 0.04, 0.03, 0.005]) == pytest.approx([0.03, 0.06, 0.06, 0.02])
    assert holm([0.6, 0.9]) == [1.0, 1.0]
    assert holm([]) == []
