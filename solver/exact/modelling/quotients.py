"""Nonlinear functions in a normal form: quotients of polynomials in symbols, sines, cosines and other functions.

Every function of another argument is a variable of its own; sin² + cos² = 1 is used where it leaves fewer terms. So two
functions that are equal may still look different (sin(a + b) beside sin a); none that differ look equal.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import sympy as sp
from sympy.polys.rings import ring

Polynomial = Any
"""An element of a sympy ring QQ[variables]."""


@dataclass(frozen=True)
class Quotients:
    """The field of quotients in some variables, each at its place; `pairs`: of the sine and cosine of an angle."""

    variables: tuple[sp.Expr, ...]
    places: dict[sp.Expr, int]
    R: Any
    pairs: tuple[tuple[int, int], ...]

    def of(self, expression: sp.Expr) -> tuple[Polynomial, Polynomial]:
        """Numerator and denominator, without common factors."""
        return self.reduced(*self._walk(expression))

    def is_zero(self, expression: sp.Expr) -> bool:
        """Whether an expression is zero: nothing need be cancelled for that."""
        return self.vanishes(self._walk(expression)[0])

    def _walk(self, e: Any) -> tuple[Polynomial, Polynomial]:
        one = self.R.one
        if e.is_Rational:
            return self.R(e.p), self.R(e.q)
        if (place := self.places.get(e)) is not None:
            return self.R.gens[place], one
        if e.is_Add:
            above, below = self.R.zero, one
            for term in e.args:
                n, d = self._walk(term)
                above, below = (above + n, below) if d == below else (above * d + n * below, below * d)
            return above, below
        if e.is_Mul:
            above, below = one, one
            for factor in e.args:
                n, d = self._walk(factor)
                above, below = above * n, below * d
            return above, below
        n, d = self._walk(e.base)  # a power with a whole exponent: anything else is a variable
        return (n**e.exp.p, d**e.exp.p) if e.exp.p > 0 else (d**-e.exp.p, n**-e.exp.p)

    def reduced(self, above: Polynomial, below: Polynomial) -> tuple[Polynomial, Polynomial]:
        """The quotient with as few terms as sin² + cos² = 1 makes them, cancelled; the sign is in the numerator."""
        if self.vanishes(above):
            return self.R.zero, self.R.one
        above, below = self.shortest(above), self.shortest(below)
        if below.is_ground:
            above, below = _over_a_number(above, below)
        elif _share_a_monomial(above, below):
            above, below = _over_a_monomial(above, below)
        else:
            above, below = above.cancel(below)
        if below.LC < 0:
            above, below = -above, -below
        return above, below

    def vanishes(self, p: Polynomial) -> bool:
        """Whether a polynomial is zero because of sin² + cos² = 1 or without it."""
        for sine, cosine in self.pairs if p else ():
            p = self._replaced(p, sine, cosine)
        return not p

    def shortest(self, p: Polynomial) -> Polynomial:
        """The polynomial with sin² or cos² replaced, angle by angle, where that leaves fewer terms."""
        for sine, cosine in self.pairs:
            ways = (self._replaced(p, sine, cosine), self._replaced(p, cosine, sine), p)
            p = min(ways, key=len)
        return p

    def _replaced(self, p: Polynomial, first: int, second: int) -> Polynomial:
        """Put 1 − b² for a², where a and b are the variables at two positions."""
        if all(monomial[first] < 2 for monomial in p):
            return p
        rest, found = 1 - self.R.gens[second] ** 2, self.R.zero
        for monomial, c in p.terms():
            pairs, left = divmod(monomial[first], 2)
            kept = self.R({(*monomial[:first], left, *monomial[first + 1 :]): c})
            found += kept * rest**pairs if pairs else kept
        return found

    def expression(self, above: Polynomial, below: Polynomial) -> sp.Expr:
        """The quotient as an expression: of both parts what all terms have in common, times the rest multiplied out."""
        content, n = self._common(above)
        found: sp.Expr
        if below == self.R.one:
            found = content * n
            return found
        divisor, d = self._common(below)
        found = content / divisor * n / d
        return found

    def _common(self, p: Polynomial) -> tuple[sp.Expr, sp.Expr]:
        """The product that all terms have in common, if there are several, and the rest."""
        if len(p) < 2:
            return sp.S.One, p.as_expr(*self.variables)
        number, primitive = p.primitive()
        if all(c < 0 for c in primitive.coeffs()):
            number, primitive = -number, -primitive
        lowest, rest = _over_the_lowest(primitive)
        monomial = self.R({lowest: self.R.domain.one})
        return sp.Rational(number) * monomial.as_expr(*self.variables), rest.as_expr(*self.variables)


def _over_a_number(above: Polynomial, below: Polynomial) -> tuple[Polynomial, Polynomial]:
    """The quotient of a polynomial and a number, with whole coefficients and no common factor, as `cancel` has it."""
    number, whole = above.mul_ground(1 / below.LC).clear_denoms()
    return whole, above.ring(number)


def _share_a_monomial(p: Polynomial, q: Polynomial) -> bool:
    """Whether it is seen that p and q have no common factor but a monomial.

    Such a factor holds no variable that only one of them holds, so it divides the coefficients that this one has as a
    polynomial in these variables: where one of the coefficients is a single term, the factor is one too.
    """
    inside = [[any(powers) for powers in zip(*each, strict=True)] for each in (p, q)]
    for each, mine, others in ((p, *inside), (q, *reversed(inside))):
        alone = [i for i, (a, b) in enumerate(zip(mine, others, strict=True)) if a and not b]
        terms = Counter(tuple(monomial[i] for i in alone) for monomial in each)
        if 1 in terms.values():
            return True
    return False


def _over_a_monomial(p: Polynomial, q: Polynomial) -> tuple[Polynomial, Polynomial]:
    """The quotient of polynomials that share a monomial only, with whole coefficients, as `cancel` has it."""
    (number, p), (divisor, q) = p.primitive(), q.primitive()
    (above, p), (below, q) = _over_the_lowest(p), _over_the_lowest(q)
    R, number = p.ring, number / divisor
    for_p = tuple(max(a - b, 0) for a, b in zip(above, below, strict=True))
    for_q = tuple(max(b - a, 0) for a, b in zip(above, below, strict=True))
    return p * R({for_p: R.domain.numer(number)}), q * R({for_q: R.domain.denom(number)})


def _over_the_lowest(p: Polynomial) -> tuple[tuple[int, ...], Polynomial]:
    """The monomial that all terms have in common, by its powers, and the polynomial over it."""
    lowest = tuple(min(powers) for powers in zip(*p, strict=True))
    if not any(lowest):
        return lowest, p
    return lowest, p.new({tuple(a - b for a, b in zip(powers, lowest, strict=True)): c for powers, c in p.items()})


def quotients_in(expressions: Iterable[sp.Expr]) -> Quotients:
    """Return the field that some expressions lie in."""
    found: set[Any] = set()
    for each in expressions:
        _collect(each, found)
    for angle in {f.args[0] for f in found if isinstance(f, sp.sin | sp.cos)}:
        found |= {sp.sin(angle), sp.cos(angle)}
    variables = tuple(sorted(found, key=sp.default_sort_key))
    places = {variable: i for i, variable in enumerate(variables)}
    pairs = [(places[f], places[sp.cos(f.args[0])]) for f in variables if isinstance(f, sp.sin)]
    return Quotients(variables, places, _ring_in(len(variables) or 1), tuple(pairs))


@cache
def _ring_in(n: int) -> Any:
    """The ring QQ[n variables], whatever these are called: making one takes longer than most of what is done in it."""
    return ring([sp.Dummy() for _ in range(n)], sp.QQ)[0]


def _collect(e: Any, found: set[Any]) -> None:
    if e.is_Rational:
        return
    if e.is_Add or e.is_Mul:
        for each in e.args:
            _collect(each, found)
    elif e.is_Pow and e.exp.is_Integer:
        _collect(e.base, found)
    else:
        found.add(e)


def normal(expression: sp.Expr) -> sp.Expr:
    """Return the expression as one quotient in normal form."""
    if expression.is_Atom:
        return expression
    field = quotients_in([expression])
    return field.expression(*field.of(expression))


def is_zero(expression: sp.Expr) -> bool:
    """Whether an expression is zero, sums of angles multiplied out."""
    if expression.is_Rational or expression.is_Symbol:
        return bool(expression == 0)
    angles: set[Any] = {f.args[0] for f in expression.atoms(sp.sin, sp.cos)}
    whole = expression if all(angle.is_Symbol for angle in angles) else sp.expand_trig(expression)
    return quotients_in([whole]).is_zero(whole)


def jacobian(functions: Sequence[sp.Expr], variables: Sequence[sp.Symbol]) -> sp.ImmutableMatrix:
    """Return the partial derivatives in normal form, a row for each function."""
    entries = [[normal(sp.diff(f, x)) for x in variables] for f in functions]
    return sp.ImmutableMatrix(len(functions), len(variables), [entry for row in entries for entry in row])
