"""Limits of quotients of exponential sums in the long run, by the terms that grow fastest."""

from __future__ import annotations

from typing import NamedTuple

import sympy as sp

from solver.exact.linear_algebra.affine import tidy
from solver.exact.linear_algebra.radicals import over_rational
from solver.exact.linear_algebra.signs import possible_signs
from solver.exact.variations.exponential_sums import ExponentialSum, Mode


class Leading(NamedTuple):
    """The coefficient of the term that grows fastest, τᵏ e^{aτ}: `rate` is a, `power` k."""

    rate: sp.Expr
    power: int
    coefficient: sp.Expr


def long_run(numerator: ExponentialSum, denominator: ExponentialSum, tau: sp.Symbol) -> sp.Expr | None:
    """Return the limit of N/D for τ → ∞; None where there is none, or where it depends on signs that are open."""
    if not numerator:
        return sp.S.Zero
    above, below = _leading(numerator, tau), _leading(denominator, tau)
    if below is None:
        return None
    if above is None:
        return sp.S.Zero if _is_outgrown(numerator, below, tau) else None
    order = _compared(above.rate, below.rate)
    if order is None:
        return None
    return _ratio(above, below, order or above.power - below.power)


def _ratio(above: Leading, below: Leading, order: int) -> sp.Expr | None:
    """The limit where the numerator grows as fast (`order` 0), more slowly (negative), or faster: there is none."""
    if order > 0:
        return None
    if order < 0:
        return sp.S.Zero
    ratio = above.coefficient / below.coefficient
    return _turned(tidy(ratio)) if ratio.free_symbols else tidy(over_rational(ratio))


def _turned(value: sp.Expr) -> sp.Expr:
    """A fraction with a minus before it without that, where it goes into a sum below."""
    above, below = sp.fraction(value)
    if above.could_extract_minus_sign() and below.is_Add:
        return sp.Mul(-above, sp.Pow(sp.expand(-below), -1))
    return value


def _leading(part: ExponentialSum, tau: sp.Symbol) -> Leading | None:
    """The term that grows fastest; None where several do, which oscillate, or where it is not seen which one does."""
    best: list[tuple[sp.Expr, int, Mode, sp.Expr]] = []
    for mode, c in part.terms:
        rate, power = mode.exponent.coeff(tau), int(sp.degree(mode.monomial, tau)) if mode.monomial.has(tau) else 0
        if best:
            order = _compared(rate, best[0][0])
            if order is None:
                return None
            order = order or power - best[0][1]
            if order < 0:
                continue
            if order > 0:
                best = []
        best.append((rate, power, mode, c))
    if len(best) != 1 or best[0][2].angle != 0:
        return None
    rate, power, _, c = best[0]
    return Leading(rate, power, c)


def _is_outgrown(part: ExponentialSum, below: Leading, tau: sp.Symbol) -> bool:
    """Whether every term grows more slowly than the leading one below."""
    for mode, _ in part.terms:
        power = int(sp.degree(mode.monomial, tau)) if mode.monomial.has(tau) else 0
        order = _compared(mode.exponent.coeff(tau), below.rate)
        if order is None or (order or power - below.power) >= 0:
            return False
    return True


def _compared(a: sp.Expr, b: sp.Expr) -> int | None:
    """The sign of a − b: 1, 0 or −1, for parameters the generic one; None where it is open."""
    gap = sp.expand(a - b)
    if gap == 0:
        return 0
    signs = possible_signs(gap) - {0}
    return next(iter(signs)) if len(signs) == 1 else None
