"""Which sign each amplifier carries, so that few others are needed to change signs.

An amplifier gives s X with s = ±1 and changes the sign of what it sums: for X' = Σ c Y (or X = Σ c Y) its inputs must
add up to -s Σ c Y. An input that is there with the other sign takes an inverter, which serves all who need it, or the
wrong ones of an amplifier go together through one summer before it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from itertools import combinations
from operator import or_

import sympy as sp

EXACT = 9
"""Up to so many amplifiers all choices of signs are tried; of more, those that single changes lead to."""
MOST_COLLECTED = 6


@dataclass(frozen=True)
class SignedRow:
    """One amplifier: its variable, the sign of the coefficient of each term that has a sign of its own.

    `collects` tells that the wrong terms may go through a summer without leaving the range.
    """

    variable: sp.Symbol
    terms: Mapping[sp.Expr, int]
    collects: bool


@dataclass(frozen=True)
class Signs:
    """The sign that each amplifier carries, the terms that get an inverter, the variables whose amplifier has a summer.

    `tried` is the number of choices that were compared, `exhaustive` whether these are all.
    """

    of: Mapping[sp.Expr, int]
    inverted: tuple[sp.Expr, ...]
    collected: tuple[sp.Symbol, ...]
    tried: int
    exhaustive: bool

    @property
    def added(self) -> int:
        """How many amplifiers only change signs."""
        return len(self.inverted) + len(self.collected)


class _Search:
    """Sets of signals are numbers, a bit for each: the amplifiers first, then the inputs."""

    def __init__(self, rows: Sequence[SignedRow]) -> None:
        self.rows = rows
        self.signals: list[sp.Expr] = [row.variable for row in rows]
        self.signals += [each for row in rows for each in row.terms if each not in self.signals]
        self.signals = list(dict.fromkeys(self.signals))
        bit = {signal: 1 << i for i, signal in enumerate(self.signals)}
        self.plus = [sum(bit[term] for term, sign in row.terms.items() if sign > 0) for row in rows]
        self.minus = [sum(bit[term] for term, sign in row.terms.items() if sign < 0) for row in rows]

    def wrong(self, negative: int) -> list[int]:
        """For each amplifier the signals that it needs with the other sign, where some amplifiers are negative."""
        return [
            (self.plus[i] & negative) | (self.minus[i] & ~negative)
            if negative >> i & 1
            else (self.plus[i] & ~negative) | (self.minus[i] & negative)
            for i in range(len(self.rows))
        ]

    def best(self, wrong: Sequence[int]) -> tuple[int, tuple[int, ...]]:
        """The signals to invert and the amplifiers with a summer before them, as few as can be."""
        able = [i for i, each in enumerate(wrong) if self.rows[i].collects and each.bit_count() > 1]
        found: tuple[int, tuple[int, ...]] | None = None
        for count in range(min(len(able), MOST_COLLECTED) + 1):
            for chosen in combinations(able, count):
                inverted = reduce(or_, (each for i, each in enumerate(wrong) if i not in chosen), 0)
                if found is None or inverted.bit_count() + count < found[0].bit_count() + len(found[1]):
                    found = inverted, chosen
        return found or (0, ())

    def key(self, negative: int) -> tuple[int, ...]:
        """What is least: amplifiers, then inverters within a chain of integrators, then negative variables."""
        wrong = self.wrong(negative)
        inverted, collected = self.best(wrong)
        chain = sum(bool(each) for each, row in zip(wrong, self.rows, strict=True) if len(row.terms) == 1)
        return inverted.bit_count() + len(collected), chain, negative & 1, negative.bit_count(), negative

    def candidates(self) -> Iterator[int]:
        """All choices, or those that single changes lead to from the usual beginnings."""
        n = len(self.rows)
        if n <= EXACT:
            yield from range(1 << n)
            return
        alternating = sum(1 << i for i in range(1, n, 2))
        for start in (alternating, 0):
            here = start
            while True:
                yield here
                after = min((here ^ 1 << i for i in range(n)), key=self.key)
                if self.key(after) >= self.key(here):
                    break
                here = after


def carried_signs(rows: Sequence[SignedRow]) -> Signs:
    """Return the signs with the fewest amplifiers beside those of the rows."""
    search = _Search(rows)
    tried = list(search.candidates())
    negative = min(tried, key=search.key)
    inverted, collected = search.best(search.wrong(negative))
    return Signs(
        {row.variable: -1 if negative >> i & 1 else 1 for i, row in enumerate(rows)},
        tuple(signal for i, signal in enumerate(search.signals) if inverted >> i & 1),
        tuple(rows[i].variable for i in collected),
        len(tried),
        len(rows) <= EXACT,
    )
