"""For which parameters a transfer matrix has other poles, other zeros or another rank than in general."""

from __future__ import annotations

from collections.abc import Iterator
from functools import reduce
from itertools import combinations
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.fields import vanishing_factors
from solver.exact.multivariable.rational_minors import RationalMinors, power_in, rational_minors
from solver.exact.representation.polynomials import factors_of
from solver.exact.representation.transfer import transfer_matrix_of_fractions

PRIMES = [sp.Rational(p, q) for p, q in ((17, 5), (29, 7), (13, 11), (31, 9), (23, 13), (41, 17), (37, 19), (43, 23))]
"""Values for the parameters that a condition leaves free."""


def parameter_exceptions(minors: RationalMinors) -> tuple[sp.Eq, ...]:
    """Where parameters change the poles, the zeros or the rank: they meet, vanish or go to infinity.

    A condition is left out where at one of its points the degrees and the rank are those of the general case.
    """
    if not minors.G.domain.is_FractionField or not minors.rank:
        return ()
    values = [*_meetings(minors), *_lost_poles(minors), *_lost_zeros(minors)]
    found = dict.fromkeys(factor for value in values for factor in vanishing_factors(sp.S.Zero + value))
    return tuple(sp.Eq(factor, 0) for factor in found if not _is_the_same(minors, factor))


def _is_the_same(minors: RationalMinors, factor: sp.Expr) -> bool:
    """Whether nothing changes at a point where the factor is zero: then nothing changes at almost all such points."""
    G, x = minors.G, minors.variable
    symbols = sorted(
        set().union(*(p.as_expr().free_symbols for row in (*G.tops, *G.bottoms) for p in row)) - {x}, key=str
    )
    for a in sorted(factor.free_symbols, key=str):
        if sp.degree(factor, a) != 1:
            continue
        others: dict[Any, Any] = {
            b: PRIMES[i % len(PRIMES)] + i // len(PRIMES) for i, b in enumerate(symbols) if b != a
        }
        slope, constant = sp.Poly(factor, a).all_coeffs()
        slope, constant = slope.xreplace(others), constant.xreplace(others)
        if slope == 0 or not (slope.is_Rational and constant.is_Rational):
            continue
        there = _at(minors, {**others, a: -constant / slope})
        return there is not None and _degrees(there) == _degrees(minors)
    return False


def _at(minors: RationalMinors, values: dict[Any, Any]) -> RationalMinors | None:
    """The minors with these values of the parameters; None where G has no value there."""
    G, x = minors.G, minors.variable
    tops, bottoms = ([[p.as_expr().xreplace(values) for p in row] for row in rows] for rows in (G.tops, G.bottoms))
    if any(entry.has(sp.nan, sp.zoo, sp.oo) for row in (*tops, *bottoms) for entry in row):
        return None
    return rational_minors(transfer_matrix_of_fractions(tops, bottoms, x))


def _degrees(minors: RationalMinors) -> tuple[int, int, int]:
    return minors.rank, minors.pole_polynomial.degree(), minors.zero_polynomial.degree()


def _meetings(minors: RationalMinors) -> Iterator[sp.Expr]:
    """Resultants of the irreducible factors of both polynomials."""
    factors = [*factors_of(minors.pole_polynomial), *factors_of(minors.zero_polynomial)]
    listed = dict.fromkeys(p.as_expr() for p, _ in factors)
    yield from (sp.resultant(p, q, minors.variable) for p, q in combinations(listed, 2))


def _lost_poles(minors: RationalMinors) -> Iterator[sp.Expr]:
    """For each pole what must vanish so that every minor with its highest power has a lower one."""
    listed = [minor for order in minors.orders for minor in order if not minor.top.is_zero]
    for p, m in factors_of(minors.pole_polynomial):
        carrying = [minor.top for minor in listed if power_in(minor.bottom, p) == m]
        yield _common([sp.resultant(top.as_expr(), p.as_expr(), minors.variable) for top in carrying])


def _lost_zeros(minors: RationalMinors) -> Iterator[sp.Expr]:
    """The leading coefficients, which vanish where zeros go to infinity; what must vanish so that others appear."""
    rest = [top.quo(minors.zero_polynomial).as_expr() for top in minors.over_the_poles]
    yield _common([top.as_poly(minors.variable).LC() for top in (each.as_expr() for each in minors.over_the_poles)])
    if len(rest) > 1:
        yield _common([sp.resultant(p, q, minors.variable) for p, q in combinations(rest, 2)])


def _common(values: list[sp.Expr]) -> sp.Expr:
    """The greatest common divisor of the numerators."""
    return reduce(sp.gcd, [sp.numer(sp.together(value)) for value in values])
