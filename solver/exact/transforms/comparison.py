"""Coefficients over quadratics to higher powers, as they are found by hand: divided again and again, or compared."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from solver.exact.functions.covering import at_upper_roots, compared, put_together
from solver.exact.functions.fractions import Fraction, fractions_of
from solver.exact.functions.rational import RationalMatrix
from solver.exact.linear_algebra.affine import tidy


@dataclass(frozen=True)
class QuadraticDivision:
    """M = quotient · p + remainder."""

    dividend: sp.Expr
    quotient: sp.Expr
    remainder: sp.Expr


@dataclass(frozen=True)
class Divided:
    """What is left of F over pᵐ when the known fractions are taken away, M/pᵐ, and M divided by p again and again.

    The remainders are the numerators over pᵐ, pᵐ⁻¹, …, the last quotient that over p. `known` are the fractions
    taken away.
    """

    base: sp.Expr
    power: int
    known: tuple[sp.Expr, ...]
    left: sp.Expr
    divisions: tuple[QuadraticDivision, ...]


@dataclass(frozen=True)
class AllCompared:
    """Unknown numerators βᵢ s + γᵢ over quadratics, and an equation for each power of s that gives them.

    `terms` are the pairs (numerator with its letters, common denominator over its own); `known` what the other
    fractions give to the numerator N. `equations` have the power, the coefficient of N less what is known, and the
    other side in the letters.
    """

    numerator: sp.Expr
    known: sp.Expr
    terms: tuple[tuple[sp.Expr, sp.Expr], ...]
    equations: tuple[tuple[int, sp.Expr, sp.Expr], ...]
    letters: tuple[sp.Symbol, ...]
    values: tuple[sp.Expr, ...]


def _scalar(matrix: sp.ImmutableMatrix) -> sp.Expr:
    return matrix[0]


def is_found_otherwise(image: RationalMatrix, s: sp.Symbol) -> bool:
    """Whether covering, one comparison or the upper roots give all numerators of an image (1×1)."""
    quadratics = [each for each in fractions_of(image, s) if each.slope is not None]
    alone = len(fractions_of(image, s)) == 1
    return not quadratics or alone or compared(image, s) is not None or bool(at_upper_roots(image, s))


def divided_again(image: RationalMatrix, s: sp.Symbol) -> Divided | None:
    """The numerators over the powers of the one quadratic of an image (1×1) by division; None if there are more."""
    fractions = fractions_of(image, s)
    quadratics = [each for each in fractions if each.slope is not None]
    bases = {each.base for each in quadratics}
    if len(bases) != 1:
        return None
    (p,) = bases
    power = max(each.power for each in quadratics)
    by_power = {each.power: _scalar(each.numerator) for each in quadratics}
    digits = [by_power.get(j, sp.S.Zero) for j in range(power, 0, -1)]
    divisions, quotient = [], digits[-1]
    for digit in reversed(digits[:-1]):
        dividend = _in_powers(quotient * p + digit, s)
        divisions.append(QuadraticDivision(dividend, quotient, digit))
        quotient = dividend
    known = tuple(_scalar(each.numerator) / each.base**each.power for each in fractions if each.slope is None)
    return Divided(p, power, known, quotient, tuple(reversed(divisions)))


def compared_at_all(image: RationalMatrix, s: sp.Symbol) -> AllCompared:
    """The numerators over all quadratics of an image (1×1) from as many equations, one for each power of s."""
    whole, parts = put_together(image, s)
    unknown = [(below, each) for below, each in parts if each.slope is not None]
    letters, terms, values = _lettered(unknown, s)
    known = sp.Add(*(below * _scalar(each.numerator) for below, each in parts if each.slope is None))
    N = _scalar(whole)
    right = sp.Poly(sp.expand(sp.Add(*(above * below for above, below in terms))), s)
    left = sp.Poly(sp.expand(N - known), s)
    top = max(right.degree(), left.degree(), 0)
    equations = tuple(
        (k, tidy(left.coeff_monomial(s**k)), sp.collect(right.coeff_monomial(s**k), letters))
        for k in range(top, -1, -1)
        if right.coeff_monomial(s**k) != 0
    )
    return AllCompared(N, known, tuple(terms), equations, tuple(letters), tuple(values))


def _lettered(
    unknown: Sequence[tuple[sp.Expr, Fraction]], s: sp.Symbol
) -> tuple[list[sp.Symbol], list[tuple[sp.Expr, sp.Expr]], list[sp.Expr]]:
    """βᵢ, γᵢ for each quadratic fraction, its numerator in them, and their values."""
    letters: list[sp.Symbol] = []
    terms, values = [], []
    for i, (below, each) in enumerate(unknown, 1):
        beta, gamma = sp.symbols(f"beta_{i} gamma_{i}", real=True)
        letters += [beta, gamma]
        terms.append((beta * s + gamma, below))
        slope = each.slope if each.slope is not None else sp.zeros(1, 1)
        values += [slope[0], each.constant[0]]
    return letters, terms, values


def _in_powers(polynomial: sp.Expr, s: sp.Symbol) -> sp.Expr:
    return sp.Add(*(tidy(c) * s**i for (i,), c in sp.Poly(sp.expand(polynomial), s).terms()))
