"""Jury's table of a polynomial in z: rows, conditions, and how many roots lie inside the unit circle.

From a row r₀, …, rₘ the next is the 2×2 determinants r₀ rₖ − rₘ r₍ₘ₋ₖ₎, k = 0, …, m − 1. From the third such row on
they have a factor in common, the first entry two rows above, by which they are divided.
Sources: E. I. Jury, Theory and Application of the z-Transform Method, §3; M. Marden, Geometry of Polynomials, §42.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.fields import domain_matrix, expression
from solver.exact.stability.inequalities import sign_of
from solver.exact.stability.root_counts import RootCounts, root_counts
from solver.exact.stability.routh import bilinear

SHORTEST = 3
"""Rows that decide about stability have so many entries at least."""
UNDIVIDED = 3
"""So many rows, the coefficients among them, have no factor to be divided by."""


@dataclass(frozen=True)
class JuryRow:
    """A row and what its determinants were divided by; `divisor` is 1 where they were not."""

    entries: tuple[sp.Expr, ...]
    divisor: sp.Expr


@dataclass(frozen=True)
class JuryTable:
    """The rows without those in reverse order; the first is a₀, …, aₙ."""

    rows: tuple[JuryRow, ...]

    @property
    def matrix(self) -> sp.ImmutableMatrix:
        """The table, each row but the last followed by its reverse, filled up with zeros to n + 1 columns."""
        width = len(self.rows[0].entries)
        listed = [each for row in self.rows for each in (row.entries, row.entries[::-1])][:-1]
        return sp.ImmutableMatrix([[*row, *[0] * (width - len(row))] for row in listed])


def jury_table(coefficients: Sequence[sp.Expr], *, whole: bool = False) -> JuryTable:
    """Return the table of a polynomial (highest power first) down to a row of three entries; `whole`: to one of one.

    What rows are divided by is positive: of a number its absolute value; of a parameter's expression what is positive
    where all roots are inside. Raises NotExact for coefficients without exact arithmetic.
    """
    matrix = domain_matrix(sp.Matrix([list(coefficients)[::-1]]))
    K, (first,) = matrix.domain, matrix.to_list()
    rows, divisors = [first], [K.one]
    least = 1 if whole else SHORTEST
    while len(rows[-1]) > max(least, 1):
        row, m = rows[-1], len(rows[-1]) - 1
        found = [row[0] * row[k] - row[m] * row[m - k] for k in range(m)]
        divisor = _divisor(K, rows)
        rows.append([K.exquo(each, divisor) for each in found])
        divisors.append(divisor)
    shown = [tuple(expression(K, each) for each in row) for row in rows]
    return JuryTable(tuple(JuryRow(row, expression(K, d)) for row, d in zip(shown, divisors, strict=True)))


def _divisor(K: Any, rows: Sequence[Sequence[Any]]) -> Any:
    """The first entry two rows above the next row, made positive; 1 where there is none, or it is zero."""
    if len(rows) < UNDIVIDED or not rows[-2][0]:
        return K.one
    pivot = rows[-2][0]
    sign = sign_of(expression(K, pivot))
    negative = sign == -1 or (sign is None and len(rows) == UNDIVIDED)
    return -pivot if negative else pivot


@dataclass(frozen=True)
class JuryConditions:
    """What must be positive: p(1), (−1)ⁿ p(−1), aₙ ∓ a₀, and of each further row what compares its ends.

    `at_one` and `at_minus_one` are the first two; `ends` are the pairs of the others, row by row. Of the last row one
    is enough: the other follows from the first two.
    """

    at_one: sp.Expr
    at_minus_one: sp.Expr
    ends: tuple[tuple[sp.Expr, ...], ...]

    @property
    def positive(self) -> tuple[sp.Expr, ...]:
        """All of them, in their order."""
        return (self.at_one, self.at_minus_one, *(each for pair in self.ends for each in pair))


def jury_conditions(coefficients: Sequence[sp.Expr]) -> JuryConditions:
    """Return what must be positive for all roots of a polynomial with aₙ > 0 to lie inside the unit circle."""
    n, rows = len(coefficients) - 1, jury_table(coefficients).rows
    at_one = sp.expand(sp.Add(*coefficients))
    at_minus_one = sp.expand(sp.Add(*((-1) ** i * c for i, c in enumerate(coefficients))))
    ends = []
    for i, row in enumerate(rows if n > 1 else ()):
        first, last = row.entries[0], row.entries[-1]
        large, small = (last, first) if i == 0 else (-first, last) if i == 1 else (first, last)
        one = sp.expand(large - small) if i != 1 else sp.expand(large + small)
        other = sp.expand(large + small) if i != 1 else sp.expand(large - small)
        ends.append((one,) if len(row.entries) == SHORTEST else (one, other))
    return JuryConditions(at_one, at_minus_one, tuple(ends))


def inside_by_jury(table: JuryTable) -> int | None:
    """Return the number of roots inside: of negative products of the first entries below the coefficients.

    The table must be whole. None where a first entry is zero, or has no known sign.
    """
    signs = [sign_of(row.entries[0]) for row in table.rows[1:]]
    products = list(_products(signs))
    return None if None in products or 0 in products else sum(1 for each in products if each == -1)


def _products(signs: Sequence[int | None]) -> Iterator[int | None]:
    total: int | None = 1
    for each in signs:
        total = None if total is None or each is None else total * each
        yield total


@dataclass(frozen=True)
class DiscCounts:
    """Where the roots of p(z) lie; `counts` are those of its image in w, of which roots at z = −1 were divided out."""

    image: tuple[sp.Expr, ...]
    minus_ones: int
    rest: tuple[sp.Expr, ...]
    counts: RootCounts | None

    @property
    def outside(self) -> int | None:
        """Roots with |z| > 1; None where a sign is not known."""
        return None if self.counts is None else self.counts.outside

    @property
    def on(self) -> int | None:
        """Roots with |z| = 1."""
        return None if self.counts is None else self.counts.on + self.minus_ones


def bilinear_image(coefficients: Sequence[sp.Expr]) -> tuple[sp.Expr, ...]:
    """Return the coefficients of (1 − w)ⁿ p((1 + w)/(1 − w)), highest power first; the first is (−1)ⁿ p(−1)."""
    return bilinear(coefficients)[::-1]


def disc_counts(coefficients: Sequence[sp.Expr]) -> DiscCounts:
    """Return how many roots lie outside the unit circle and on it, by Routh arrays of the image in w."""
    left, ones = off_the_point_minus_one(coefficients)
    if len(left) == 1:
        return DiscCounts(left, ones, left, RootCounts((sp.Integer(1),), left, 0, 0, 0))
    image = bilinear_image(left)
    return DiscCounts(image, ones, left, root_counts(image))


def off_the_point_minus_one(listed: Sequence[sp.Expr]) -> tuple[tuple[sp.Expr, ...], int]:
    """Divide a polynomial in z by (z + 1) as often as that goes; return the quotient's coefficients and how often."""
    c, count = list(listed), 0
    while len(c) > 1 and sp.expand(sum((-1) ** i * each for i, each in enumerate(c))) == 0:
        for i in range(1, len(c)):
            c[i] = sp.expand(c[i] - c[i - 1])
        c.pop()
        count += 1
    return tuple(c), count
