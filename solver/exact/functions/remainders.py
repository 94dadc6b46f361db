"""Rational functions of a matrix modulo its characteristic polynomial, which need no eigenvalue."""

from __future__ import annotations

from dataclasses import dataclass
from math import comb
from typing import Any

import sympy as sp

from solver.exact.functions.scalar_functions import ScalarFunction
from solver.exact.linear_algebra.faddeev import faddeev_leverrier
from solver.exact.linear_algebra.fields import NotExact, domain_matrix, expression, matrix_of

LOW = 12
"""Powers up to this one are written with what is divided out; the values of higher ones at the eigenvalues are long."""

MOST_DIGITS = 4000
MOST_TERMS = 5000


@dataclass(frozen=True)
class Remainder:
    """The polynomials of p = q g + h χ in one symbol."""

    numerator: sp.Expr
    denominator: sp.Expr
    chi: sp.Expr
    remainder: sp.Expr
    quotient: sp.Expr | None


def reduced(A: sp.ImmutableMatrix, f: ScalarFunction) -> tuple[sp.ImmutableMatrix, tuple[sp.Expr, ...]]:
    """A rational function modulo χ: its value f(A) by Horner's rule, and α₀ … αₙ₋₁."""
    fl = faddeev_leverrier(A)
    numerator, denominator = f.rational or (sp.Integer(0), sp.Integer(1))
    x = f.variable
    own = sp.Poly(numerator, x), sp.Poly(denominator, x)
    _check_size(A, max(each.degree() for each in own))
    entries = sp.ImmutableMatrix([[*A.flat(), *dict.fromkeys(c for p in own for c in p.all_coeffs())]])
    over = domain_matrix(entries, real=False)
    K, element = over.domain, dict(zip(entries.flat(), over.to_list_flat(), strict=True))
    chi = sp.Poly([K.convert(c, fl.domain) for c in fl.chi], x, domain=K)
    p, q = (sp.Poly([element[c] for c in each.all_coeffs()], x, domain=K) for each in own)
    common = q.gcd(chi)
    if common.degree() > 0:
        raise NotExact("functions/division_by_zero", factor=common.as_expr().subs(x, sp.Symbol("lamda")))
    p, q = _modulo(p, chi), _modulo(q, chi) if q.degree() > 0 else q
    alpha = (p * q.invert(chi)).rem(chi) if q.degree() > 0 else p.quo_ground(q.LC())
    low = alpha.rep.to_list()[::-1]
    low += [K.zero] * (A.rows - len(low))
    M = domain_matrix(A, real=False).convert_to(K)
    identity = M.eye(A.rows, K).to_dense()
    total = identity * low[-1]
    for c in reversed(low[:-1]):
        total = total * M + identity * c
    if K.is_QQ and max(max(map(abs, _parts_of(c))) for c in [*total.to_list_flat(), *low]) >= 10**MOST_DIGITS:
        raise NotExact("functions/long_numbers", most=MOST_DIGITS)
    return matrix_of(total), tuple(expression(K, c) for c in low)


def _modulo(p: sp.Poly, chi: sp.Poly) -> sp.Poly:
    """The remainder; of high powers by squaring, since division takes a time that is quadratic in the degree."""
    if p.degree() <= 2 * LOW:
        return p.rem(chi)
    total = p.zero
    for (exponent,), c in p.terms():
        power_of_x, square, left = p.one, sp.Poly(p.gen, p.gen, domain=p.domain), exponent
        while left:
            power_of_x = (power_of_x * square).rem(chi) if left % 2 else power_of_x
            square, left = (square * square).rem(chi), left // 2
        total += power_of_x.mul_ground(c)
    return total


def _parts_of(c: Any) -> tuple[int, int]:
    return int(c.numerator), int(c.denominator)


def _check_size(A: sp.ImmutableMatrix, degree: int) -> None:
    """Refuse powers with more terms in parameters than anyone reads."""
    symbols = len(A.free_symbols)
    if symbols and comb(degree + symbols, symbols) > MOST_TERMS:
        raise NotExact("functions/many_terms", degree=degree)


def remainder_identity(A: sp.ImmutableMatrix, f: ScalarFunction, x: sp.Symbol) -> Remainder:
    """What f = p/q is modulo χ: p = q g + h χ, where h is left out of high powers."""
    numerator, denominator = f.rational or (sp.Integer(0), sp.Integer(1))
    _, alpha = reduced(A, f)
    g = sp.Add(*(c * x**i for i, c in enumerate(alpha)))
    chi = faddeev_leverrier(A).characteristic_polynomial(x)
    p, q = (part.xreplace({f.variable: x}) for part in (numerator, denominator))
    quotient_of = None
    if max(sp.degree(p, x), sp.degree(q, x)) <= LOW:
        quotient_of = sp.factor_terms(sp.collect(sp.quo(sp.expand(p - q * g), chi, x), x, sp.factor))
    return Remainder(p, q, chi, g, quotient_of)
