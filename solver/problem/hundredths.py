"""Marks in hundredths that add up to a whole."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

HUNDRED = 100


def rounded(marks: Fraction) -> Fraction:
    """Return marks to the nearest hundredth, a half of one up."""
    return Fraction((marks * HUNDRED + Fraction(1, 2)) // 1, HUNDRED)


def told_in_hundredths(shares: Sequence[Fraction]) -> list[Fraction]:
    """Return shares in hundredths that add up to what they did, as they are where their sum is not in hundredths."""
    whole = sum(shares, Fraction(0))
    return dealt(whole, shares) if (whole * HUNDRED).denominator == 1 else list(shares)


def dealt(whole: Fraction, shares: Sequence[Fraction]) -> list[Fraction]:
    """Return shares in hundredths whose sum is the whole, by the largest remainders; of equal ones the first."""
    down = [share * HUNDRED // 1 for share in shares]
    left = int(whole * HUNDRED) - sum(down)
    by_loss = sorted(range(len(shares)), key=lambda i: (down[i] - shares[i] * HUNDRED, i))
    raised = set(by_loss[:left])
    return [Fraction(each + (i in raised), HUNDRED) for i, each in enumerate(down)]
