"""Where L(jω) with parameters is real, or of size one: exact where an equation in w = ω² has a formula for its roots.

What depends on a sign that is not known raises NotExact, which names what must be assumed.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp

from solver.exact.frequency.parts import Parts, parts_by_squares
from solver.exact.frequency.places import real_roots
from solver.exact.frequency.surds import decimal, root_of
from solver.exact.frequency.with_parameters import ParametricFactors, decided_sign
from solver.exact.linear_algebra.fields import NotExact
from solver.exact.stability.inequalities import sign_of


@dataclass(frozen=True)
class ParametricCrossing:
    """ω ≥ 0 and ω², and the value of L there; `turn` is 1 where the curve crosses the real axis upward, −1 downward.

    `start`: it is the beginning of the curve, where it goes on as that of −ω.
    """

    omega: sp.Expr
    square: sp.Expr
    value: sp.Expr
    turn: int
    start: bool = False


@dataclass(frozen=True)
class PositiveRoot:
    """A root w > 0 of an irreducible `factor`, which rises there (`slope` 1) or falls, of multiplicity `power`."""

    value: sp.Expr
    factor: sp.Poly
    power: int
    slope: int

    @property
    def frequency(self) -> sp.Expr:
        """√w, squares taken from below the root."""
        if not self.value.free_symbols:
            return root_of(self.value)
        return sp.sqrt(sp.factor(self.value) if self.factor.degree() == 1 else self.value)

    def value_of(self, p: sp.Poly, q: sp.Poly | None = None) -> sp.Expr:
        """p/q at the root; q has no root there."""
        f = self.factor
        if f.degree() > 2:
            above, below = (_at(each, self.value) for each in (p, q or p.one))
            return above / below
        field = f.domain.get_field()
        f, p = f.set_domain(field), p.set_domain(field).rem(f.set_domain(field))
        if q is not None:
            p = (p * q.set_domain(field).rem(f).invert(f)).rem(f)
        slope, rest = (sp.factor(p.nth(i)) for i in (1, 0))
        whole = slope * self.value + rest
        return whole if self.value.free_symbols else sp.factor_terms(sp.expand(whole))

    def sign_of(self, p: sp.Poly) -> int:
        """The sign of p at the root, where it is not zero; raises NotExact where that is not known."""
        return decided_sign(self.value_of(p))


@dataclass(frozen=True)
class ParametricAxis:
    """N and D of L without what is common, polynomials in s with parameters in their coefficients."""

    N: sp.Poly
    D: sp.Poly

    @cached_property
    def parts(self) -> Parts:
        """What N and D are made of on the axis."""
        return parts_by_squares(self.N, self.D)

    @property
    def start(self) -> tuple[sp.Expr, int]:
        """The c and ν of L ≈ c s^ν about s = 0."""
        (a, k), (b, m) = (_lowest(p) for p in (self.N, self.D))
        return sp.factor(a / b), k - m

    @property
    def excess(self) -> int:
        """The degree of D less that of N."""
        return int(self.D.degree() - self.N.degree())


def parametric_axis(L: ParametricFactors) -> ParametricAxis:
    """Return N and D of a quotient given by its factors."""
    letters = sorted(set().union(L.number.free_symbols, *(c.free_symbols for f, _ in L.factors for c in f)), key=str)
    domain = sp.QQ[letters] if letters else sp.QQ
    above, below = (sp.Poly(part, L.s, domain=domain) for part in sp.fraction(sp.together(L.number)))
    for coefficients, m in L.factors:
        power = sp.Poly(list(coefficients), L.s, domain=domain) ** abs(m)
        above, below = (above * power, below) if m > 0 else (above, below * power)
    return ParametricAxis(above, below)


def parametric_real_axis(L: ParametricAxis) -> tuple[ParametricCrossing, ...]:
    """All ω > 0 where L is real and not zero, before them the start of the curve where that is negative."""
    I, found = L.parts.imaginary, list(_starts(L))
    if I.is_zero:
        raise NotExact("frequency/real_with_parameters")
    for root in positive_roots(I):
        if L.parts.real.rem(root.factor).is_zero:
            continue  # a pole or zero on the axis
        value = root.value_of(L.parts.real, L.parts.below)
        turn = 0
        if root.power % 2:
            turn = root.slope * root.sign_of(I.quo(root.factor**root.power))
        found.append(ParametricCrossing(root.frequency, root.value, value, turn))
    return tuple(found)


def parametric_gain_crossovers(L: ParametricAxis) -> tuple[tuple[sp.Expr, sp.Expr], ...]:
    """All ω > 0 with |L| = 1, each with its ω²; raises NotExact where the equation in ω² has no formula."""
    p = L.parts.above - L.parts.below
    if p.is_zero:
        raise NotExact("frequency/gain_of_one_everywhere")
    return tuple((root.frequency, root.value) for root in positive_roots(p))


def positive_roots(p: sp.Poly) -> Iterator[PositiveRoot]:
    """The positive roots of a polynomial in w; raises NotExact where they have no formula, or a sign is not known."""
    for factor, power in p.factor_list()[1]:
        if not any(c.free_symbols for c in factor.all_coeffs()):
            numbers = sp.Poly(factor.as_expr(), factor.gen, domain=sp.QQ)
            for root, _ in real_roots(numbers):
                if decimal(root) > 0:
                    yield PositiveRoot(root, factor, power, int(sp.sign(numbers.diff().as_expr().subs(p.gen, root))))
        elif factor.degree() == 1:
            a, b = factor.all_coeffs()
            if _known(-b / a) == 1:
                yield PositiveRoot(sp.cancel(-b / a), factor, power, decided_sign(a))
        elif factor.degree() == 2:
            yield from _of_square(factor, power)
        else:
            raise NotExact("frequency/equation_with_parameters", p=factor.as_expr(), n=factor.degree())


def _of_square(factor: sp.Poly, power: int) -> Iterator[PositiveRoot]:
    """Those of a w² + b w + c."""
    a, b, c = factor.all_coeffs()
    under, middle, lead = sp.factor(b**2 - 4 * a * c), sp.cancel(-b / (2 * a)), decided_sign(a)
    root = sp.sqrt(sp.factor(under / (4 * a**2)))
    if _known(c / a) == -1:
        yield PositiveRoot(middle + root, factor, power, lead)
        return
    if sign_of(under) == -1 or sign_of(sp.cancel(b / a)) in (0, 1):
        return
    if _known(-b / a) == 1 and _known(under) == 1:
        yield PositiveRoot(middle - root, factor, power, -lead)
        yield PositiveRoot(middle + root, factor, power, lead)


def _known(x: sp.Expr) -> int:
    return decided_sign(sp.factor(x))


def _starts(L: ParametricAxis) -> Iterator[ParametricCrossing]:
    """L(0) where it is finite and negative."""
    value, power = L.start
    if power == 0 and decided_sign(value) < 0 and not L.parts.imaginary.is_zero:
        turn = decided_sign(_lowest(L.parts.imaginary)[0])
        yield ParametricCrossing(sp.S.Zero, sp.S.Zero, value, turn, start=True)


def _lowest(p: sp.Poly) -> tuple[sp.Expr, int]:
    """The coefficient of the lowest power, and the power."""
    power = next(i for i, c in enumerate(reversed(p.all_coeffs())) if c != 0)
    return p.nth(power), power


def _at(p: sp.Poly, x: Any) -> sp.Expr:
    """p at a decimal number; a common factor of letters stays before it."""
    content, rest = p.primitive()
    return sp.S.Zero + content * sp.factor_terms(sp.expand(rest.as_expr().subs(p.gen, x)))


__all__ = [
    "ParametricAxis",
    "ParametricCrossing",
    "parametric_axis",
    "parametric_gain_crossovers",
    "parametric_real_axis",
    "positive_roots",
]
