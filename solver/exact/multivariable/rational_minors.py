"""Minors of a transfer matrix in lowest terms, and the poles and zeros that they show.

Source: A. G. J. MacFarlane and N. Karcanias, Poles and zeros of linear multivariable systems, Int. J. Control 24
(1976): the pole polynomial is the least common denominator of all minors of all orders, the zero polynomial the
greatest common divisor of the numerators of the minors of normal rank, brought over the pole polynomial.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache, reduce
from itertools import combinations
from math import comb

import sympy as sp

from solver.exact.linear_algebra.fields import NotExact
from solver.exact.multivariable.rosenbrock import polynomial_determinant
from solver.exact.representation.polynomials import factored_form, factors_of, in_lowest_terms, least_common_multiple
from solver.exact.representation.transfer import TransferMatrix

MOST_MINORS = 300
"""A matrix with more minors than this is given up: nobody reads such a table."""

Place = tuple[tuple[int, ...], tuple[int, ...]]
"""Rows and columns, counted from 0."""


@dataclass(frozen=True)
class Minor:
    """The determinant of some rows and columns (counted from 0) of G: top/bottom in lowest terms, bottom monic."""

    rows: tuple[int, ...]
    columns: tuple[int, ...]
    top: sp.Poly
    bottom: sp.Poly
    factors: tuple[tuple[sp.Poly, int], ...]

    @property
    def order(self) -> int:
        """The number of rows."""
        return len(self.rows)

    @cached_property
    def value(self) -> sp.Expr:
        """The minor as an expression, its denominator a product of irreducible factors."""
        return in_lowest_terms(self.top, self.bottom, self.factors)


@dataclass(frozen=True)
class RationalMinors:
    """All minors of G (p×m), by order from 1 to min(p, m)."""

    G: TransferMatrix
    orders: tuple[tuple[Minor, ...], ...]

    @property
    def variable(self) -> sp.Symbol:
        """The symbol s (or z)."""
        return self.G.variable

    @cached_property
    def rank(self) -> int:
        """The normal rank of G: the largest order with a minor that is not zero."""
        return max((k for k, listed in enumerate(self.orders, 1) if any(not m.top.is_zero for m in listed)), default=0)

    @cached_property
    def pole_polynomial(self) -> sp.Poly:
        """The monic least common denominator of all minors."""
        bottoms = [minor.bottom for listed in self.orders for minor in listed if not minor.top.is_zero]
        one = sp.Poly([self.G.domain.one], self.variable, domain=self.G.domain)
        return least_common_multiple([one, *bottoms])

    @cached_property
    def largest(self) -> tuple[Minor, ...]:
        """The minors of normal rank that are not zero."""
        return tuple(minor for minor in self.orders[self.rank - 1] if not minor.top.is_zero) if self.rank else ()

    @cached_property
    def over_the_poles(self) -> tuple[sp.Poly, ...]:
        """Their numerators over the pole polynomial."""
        return tuple(minor.top * self.pole_polynomial.quo(minor.bottom) for minor in self.largest)

    @cached_property
    def zero_polynomial(self) -> sp.Poly:
        """The monic greatest common divisor of these numerators."""
        one = sp.Poly([self.G.domain.one], self.variable, domain=self.G.domain)
        return reduce(lambda p, q: p.gcd(q).monic(), self.over_the_poles).monic() if self.over_the_poles else one

    @cached_property
    def pole_powers(self) -> tuple[tuple[sp.Expr, int, Minor], ...]:
        """Each irreducible factor of the pole polynomial, its power, and the first minor that has that power."""
        listed = [minor for order in self.orders for minor in order]
        return tuple(
            (factored_form([(p, 1)]), m, next(minor for minor in listed if power_in(minor.bottom, p) == m))
            for p, m in factors_of(self.pole_polynomial)
        )


def power_in(q: sp.Poly, p: sp.Poly) -> int:
    """How often q has the factor p."""
    found = 0
    while q.degree() > 0 and q.rem(p).is_zero:
        q, found = q.quo(p), found + 1
    return found


@lru_cache(maxsize=32)
def rational_minors(G: TransferMatrix) -> RationalMinors:
    """All minors of G; raises NotExact where they are too many. Each order comes from the one before it."""
    p, m = G.shape
    if comb(p + m, m) - 1 > MOST_MINORS:
        raise NotExact("multivariable/too_many_minors", count=sp.Integer(comb(p + m, m) - 1))
    entries = [[in_lowest(t, b) for t, b in zip(*row, strict=True)] for row in zip(G.tops, G.bottoms, strict=True)]
    d = least_common_multiple(bottom for row in entries for _, bottom in row)
    factors = factors_of(d)
    over_d = [[top * d.quo(bottom) for top, bottom in row] for row in entries]
    one = sp.Poly([G.domain.one], G.variable, domain=G.domain)
    found: dict[Place, sp.Poly] = {((), ()): one}
    orders = []
    for k in range(1, min(p, m) + 1):
        found = {
            (rows, columns): _expanded(over_d, found, rows, columns)
            for rows in combinations(range(p), k)
            for columns in combinations(range(m), k)
        }
        powers = tuple((f, k * e) for f, e in factors)
        orders.append(tuple(_minor(place, top, d, powers) for place, top in found.items()))
    return RationalMinors(G, tuple(orders))


def _expanded(
    N: list[list[sp.Poly]], smaller: dict[Place, sp.Poly], rows: tuple[int, ...], columns: tuple[int, ...]
) -> sp.Poly:
    """The minor of N by its first row, from the minors of one row less."""
    first, *rest = rows
    total = N[first][columns[0]] * 0
    for i, j in enumerate(columns):
        if not N[first][j].is_zero:
            term = N[first][j] * smaller[tuple(rest), tuple(c for c in columns if c != j)]
            total = total - term if i % 2 else total + term
    return total


def _minor(place: Place, top: sp.Poly, d: sp.Poly, factors: tuple[tuple[sp.Poly, int], ...]) -> Minor:
    """The minor top/dᵏ without common factors; the factors of d, to the powers in dᵏ, are known."""
    one = sp.Poly([d.domain.one], d.gen, domain=d.domain)
    if top.is_zero:
        return Minor(*place, top, one, factors)
    bottom = one
    for p, highest in factors:
        left = highest
        while left and top.rem(p).is_zero:
            top, left = top.quo(p), left - 1
        bottom = bottom * p**left
    return Minor(*place, top, bottom, factors)


def in_lowest(top: sp.Poly, bottom: sp.Poly) -> tuple[sp.Poly, sp.Poly]:
    """The quotient in lowest terms, the denominator monic."""
    if top.is_zero:
        return top, sp.Poly([top.domain.one], top.gen, domain=top.domain)
    shared = top.gcd(bottom).monic()
    return top.quo(shared), bottom.quo(shared)


def rational_determinant(G: TransferMatrix) -> sp.Expr:
    """The determinant of a square G in lowest terms, by elimination without fractions."""
    entries = [[in_lowest(t, b) for t, b in zip(*row, strict=True)] for row in zip(G.tops, G.bottoms, strict=True)]
    d = least_common_multiple(bottom for row in entries for _, bottom in row)
    top = polynomial_determinant([[top * d.quo(bottom) for top, bottom in row] for row in entries])
    size = len(entries)
    whole = _minor((tuple(range(size)), tuple(range(size))), top, d, tuple((f, size * e) for f, e in factors_of(d)))
    return whole.value


def rational_zeros_of_entries(G: TransferMatrix) -> list[tuple[int, int, sp.Rational]]:
    """The rational zeros of the entries, each with its row and column (from 0); none where there are parameters."""
    found: list[tuple[int, int, sp.Rational]] = []
    if not G.domain.is_QQ:
        return found
    for i, row in enumerate(zip(G.tops, G.bottoms, strict=True)):
        for j, pair in enumerate(zip(*row, strict=True)):
            top, _ = in_lowest(*pair)
            if top.degree() > 0:
                linear = [p.rep.to_list() for p, _ in top.factor_list()[1] if p.degree() == 1]
                found += [(i, j, G.domain.to_sympy(-low / lead)) for lead, low in linear]
    return found
