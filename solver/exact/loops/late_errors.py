"""What remains of an error where the loop has a dead time: the limit of s E(s), with e^{−Ts} a letter beside s.

E is a quotient of polynomials in s and q = e^{−Ts}. At the origin q is a power series; where the closed loop is stable
no factor of the denominator with q vanishes there, nor in the right half plane, so the poles besides those are the
roots of factors in s alone.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from solver.exact.linear_algebra.affine import tidy
from solver.exact.loops.errors import LongRun, besides, error_transform
from solver.exact.stability.inequalities import sign_of
from solver.exact.stability.location import is_stable_polynomial

TERMS = 12
"""So many terms of the series of e^{−Ts} are tried: more than there are integrators."""


def late_transform(transfer: sp.Expr, image: sp.Expr, s: sp.Symbol, delay: sp.Expr) -> sp.Expr:
    """The product in lowest terms, a quotient of sums in s and e^{−Ts}."""
    q = sp.Dummy("q")
    found: sp.Expr = error_transform(_lettered(transfer, s, delay, q), image)
    return found.xreplace({q: sp.exp(-delay * s)})


def late_quotient(F: sp.Expr, s: sp.Symbol, delay: sp.Expr) -> sp.Expr:
    """A quotient of quotients as one of sums in s and e^{−Ts}, in lowest terms."""
    q = sp.Dummy("q")
    found: sp.Expr = sp.cancel(sp.together(_lettered(F, s, delay, q)))
    return found.xreplace({q: sp.exp(-delay * s)})


def late_long_run(E: sp.Expr, s: sp.Symbol, delay: sp.Expr, inside: sp.Expr = sp.S.One) -> LongRun:
    """What remains of e; the roots of `inside` and of each factor with e^{−Ts} are known to be on the left."""
    q = sp.Dummy("q")
    above, below = sp.fraction(sp.cancel(sp.together(_lettered(E, s, delay, q))))
    (top, zeros), (bottom, poles) = (_first_term(p, s, q, delay) for p in (above, below))
    order, lead = max(poles - zeros, 0), tidy(top / bottom)
    others = besides(_without_letter(below, s, q), sp.Poly(s * inside, s))
    settles = is_stable_polynomial(others.all_coeffs(), discrete=False) if others.degree() > 0 else True
    value = None
    if settles:
        sign = sign_of(lead) if order > 1 else None
        value = sp.S.Zero if order < 1 else lead if order == 1 else None if sign is None else sign * sp.oo
    if not order:
        return LongRun(0, sp.S.Zero, others.as_expr(), settles, value, (sp.S.Zero, sp.S.One))
    return LongRun(order, lead, others.as_expr(), settles, value, (top, bottom))


def _lettered(F: sp.Expr, s: sp.Symbol, delay: sp.Expr, q: sp.Symbol) -> sp.Expr:
    """F with powers of the letter q for those of e^{−Ts}."""

    def written(exponent: sp.Expr) -> sp.Expr:
        n = sp.cancel(-exponent / (delay * s))
        return q**n if n.is_Integer else sp.exp(exponent)

    found: Any = F.replace(sp.exp, written)
    lettered: sp.Expr = found
    return lettered


def _first_term(p: sp.Expr, s: sp.Symbol, q: sp.Symbol, delay: sp.Expr) -> tuple[sp.Expr, int]:
    """The first term c sⁿ of the power series about s = 0: c and n; (0, 0) of zero."""
    if p == 0:
        return sp.S.Zero, 0
    series = sum(((-delay * s) ** k / sp.factorial(k) for k in range(TERMS)), sp.S.Zero)
    coefficients = sp.Poly(sp.Poly(p, s, q).as_expr().subs(q, series), s).all_coeffs()[::-1]
    n = next(i for i, c in enumerate(coefficients) if sp.expand(c) != 0)
    return sp.expand(coefficients[n]), n


def _without_letter(p: sp.Expr, s: sp.Symbol, q: sp.Symbol) -> sp.Poly:
    """The factors of a polynomial in which the letter is not."""
    found = [factor**n for factor, n in sp.factor_list(p, s, q)[1] if not factor.has(q)]
    return sp.Poly(sp.Mul(*found), s)


__all__ = ["late_long_run", "late_quotient", "late_transform"]
