"""Quotients of polynomials in one variable: their cost, estimated before they are multiplied out, and cancelling."""

from __future__ import annotations

from dataclasses import dataclass
from math import comb, lcm, prod

import sympy as sp


@dataclass(frozen=True)
class Rational:
    """A quotient of polynomials in one variable, as given and cancelled; `text` is how it was given.

    `delay` is the T of a factor e^{−T s} beside it. `written` is numerator and denominator with the factors in which
    they were given, None where they are what is multiplied out.
    """

    numerator: sp.Poly
    denominator: sp.Poly
    text: str
    delay: sp.Expr = sp.S.Zero
    written: tuple[sp.Expr, sp.Expr] | None = None

    def cancelled(self) -> sp.Expr:
        """Return the quotient without common factors."""
        p, q = self.numerator, self.denominator
        if not _coprime_at_a_point(p, q):
            p, q = p.cancel(q, include=True)
        quotient: sp.Expr = p.as_expr() / q.as_expr()
        return quotient


def _coprime_at_a_point(p: sp.Poly, q: sp.Poly) -> bool:
    """Whether p and q have no common factor when primes are put in place of their symbols.

    Then they have none at all: a common factor would stay one, for the leading coefficients do not vanish there. This
    spares a greatest common divisor in many variables. False if there are no symbols, or other things than symbols.
    """
    symbols = sorted((p.free_symbols | q.free_symbols) - set(p.gens), key=str)
    point = {symbol: sp.prime(100 + 7 * i) for i, symbol in enumerate(symbols)}
    if not symbols:
        return False
    at = [[coefficient.subs(point) for coefficient in each.all_coeffs()] for each in (p, q)]
    if not all(value.is_Rational for values in at for value in values) or not (at[0][0] and at[1][0]):
        return False
    (P, Q) = (sp.Poly(values, *p.gens, domain=sp.QQ) for values in at)
    return bool(P.gcd(Q).degree() == 0)


def field_degree(p: sp.Expr, q: sp.Expr) -> int:
    """Return a bound of the degree over the rationals of the field that holds the roots of numbers in p and q."""
    degree = 2 if p.has(sp.I) or q.has(sp.I) else 1
    of_prime: dict[int, int] = {}
    for root in p.atoms(sp.Pow) | q.atoms(sp.Pow):
        if not (root.exp.is_Rational and root.exp.q > 1 and root.base.is_number):
            continue
        if not root.base.is_Rational:
            degree *= root.exp.q
            continue
        for prime in sp.factorrat(root.base):
            of_prime[prime] = lcm(of_prime.get(prime, 1), int(root.exp.q))
    return degree * prod(of_prime.values())


@dataclass(frozen=True)
class Bound:
    """Upper bounds of a polynomial multiplied out: its number of terms, and its degree in all symbols together."""

    terms: int
    degree: int

    def plus(self, other: Bound) -> Bound:
        """The bound of a sum."""
        return Bound(self.terms + other.terms, max(self.degree, other.degree))

    def times(self, other: Bound, symbols: int) -> Bound:
        """The bound of a product; a polynomial of degree d in v symbols has at most C(d+v, v) terms."""
        degree = self.degree + other.degree
        return Bound(min(self.terms * other.terms, comb(degree + symbols, symbols)), degree)


def expanded_size(expression: sp.Expr, x: sp.Symbol) -> tuple[Bound, Bound]:
    """Return bounds of numerator and denominator of an expression, brought to one fraction, in x and the atoms."""
    symbols = len(expression.free_symbols | expression.atoms(sp.Function) | {x})
    one = Bound(1, 0)

    def bounds(e: sp.Expr) -> tuple[Bound, Bound]:
        if isinstance(e, sp.Pow) and e.exp.is_Integer:
            top, bottom = bounds(e.base)
            top, bottom = _power(top, abs(int(e.exp)), symbols), _power(bottom, abs(int(e.exp)), symbols)
            return (top, bottom) if e.exp > 0 else (bottom, top)
        if not isinstance(e, (sp.Add, sp.Mul)):
            return (Bound(1, 0 if e.is_number else 1), one)
        top, bottom = (Bound(0, 0), one) if isinstance(e, sp.Add) else (one, one)
        for argument in e.args:
            p, q = bounds(argument)
            if isinstance(e, sp.Add):
                top = top.times(q, symbols).plus(p.times(bottom, symbols))
            else:
                top = top.times(p, symbols)
            bottom = bottom.times(q, symbols)
        return top, bottom

    return bounds(expression)


def _power(bound: Bound, exponent: int, symbols: int) -> Bound:
    degree = bound.degree * exponent
    terms = 1 if bound.terms == 1 else min(bound.terms**exponent, comb(degree + symbols, symbols))
    return Bound(terms, degree)
