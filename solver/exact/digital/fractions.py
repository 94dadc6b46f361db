"""Quotients of polynomials in z whose poles are known: c N(z)/Π pᵢ(z)^{mᵢ}, pᵢ of a real number or of a pair."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property, reduce

import sympy as sp

from solver.exact.transforms.sampled import Base, Coefficients, in_z, multiplied, powered, trimmed

FEW = 5
"""Greatest common divisors in more symbols take too long."""


@dataclass(frozen=True)
class FractionInZ:
    """N over the product of pᵢ^{mᵢ}; `poles` are the pairs (base of pᵢ, mᵢ), coefficients of N the highest first."""

    numerator: tuple[sp.Expr, ...]
    poles: tuple[tuple[Base, int], ...]

    @classmethod
    def of(cls, numerator: Coefficients, poles: Mapping[Base, int]) -> FractionInZ:
        """The fraction of these coefficients."""
        return cls(tuple(trimmed(numerator)), tuple((base, m) for base, m in poles.items() if m))

    def times_zero(self, base: Base) -> FractionInZ:
        """The fraction times the polynomial of a base, which cancels where it stands below."""
        below = dict(self.poles)
        if below.get(base):
            return FractionInZ.of([*self.numerator], {**below, base: below[base] - 1})
        return replace(self, numerator=tuple(multiplied([*self.numerator], base.coefficients)))

    def times_pole(self, base: Base) -> FractionInZ:
        """The fraction over the polynomial of z − 0 or of another base; a power of z that stands above cancels."""
        if base.radius == 0 and self.numerator and self.numerator[-1] == 0:
            return replace(self, numerator=self.numerator[:-1])
        below = dict(self.poles)
        return FractionInZ.of([*self.numerator], {**below, base: below.get(base, 0) + 1})

    @cached_property
    def denominator(self) -> Coefficients:
        """The denominator multiplied out, monic."""
        return reduce(multiplied, [powered(base.coefficients, m) for base, m in self.poles], [sp.S.One])

    @cached_property
    def content(self) -> tuple[sp.Expr, Coefficients]:
        """What all coefficients of the numerator have in common, and what is left of them."""
        return content_of([*self.numerator])

    def expression(self, z: sp.Symbol) -> sp.Expr:
        """The fraction as it is shown: a factor, a numerator by powers of z, a denominator in factors."""
        if not self.numerator:
            return sp.S.Zero
        common, above = self.content
        below = [base.polynomial(z) ** -m for base, m in self.poles]
        return sp.Mul(common, in_z(above, z), *below)


def content_of(p: Coefficients) -> tuple[sp.Expr, Coefficients]:
    """(c, q) with p = c q, where q has no factor common to its coefficients and none below them."""
    if not p or any(c.has(sp.Float) for c in p):
        return sp.S.One, p
    marks = marks_of(p)
    back = {dummy: each for each, dummy in marks.items()}
    x = sp.Dummy("x")
    above, below = sp.fraction(sp.together(in_z([c.xreplace(marks) for c in p], x)))
    coefficients = sp.Poly(above, x).all_coeffs()
    common = _common(coefficients)
    if _is_negative(sp.cancel(coefficients[0] / common).xreplace(back)):
        common = -common
    left = [sp.expand(sp.cancel(c / common)).xreplace(back) for c in coefficients]
    return (sp.factor(common) / sp.factor(below)).xreplace(back), left


def _common(coefficients: Coefficients) -> sp.Expr:
    """A factor that all have: the greatest one of few symbols, of many only powers of symbols and a number."""
    symbols = sorted(set().union(*(c.free_symbols for c in coefficients)), key=str)
    if len(symbols) <= FEW:
        return reduce(sp.gcd, coefficients)
    polynomials = [sp.Poly(c, *symbols) for c in coefficients if c != 0]
    least = [min(monom[i] for p in polynomials for monom in p.monoms()) for i in range(len(symbols))]
    number = reduce(sp.gcd, [c for p in polynomials for c in p.coeffs()])
    return sp.Mul(number, *(x**k for x, k in zip(symbols, least, strict=True)))


def _is_negative(c: sp.Expr) -> bool:
    """Whether a coefficient is negative, with parameters where these are one."""
    value = sp.N(c.xreplace(dict.fromkeys(c.free_symbols, sp.S.One)))
    return bool(value.is_negative) if value.is_real else bool(c.could_extract_minus_sign())


def marks_of(p: Coefficients) -> dict[sp.Expr, sp.Symbol]:
    """A symbol for each function and root in some coefficients."""
    return {each: sp.Dummy() for c in p for each in _atoms(c)}


def _atoms(c: sp.Expr) -> set[sp.Expr]:
    """The functions and roots in a coefficient, which are taken for independent of each other."""
    roots = {each for each in c.atoms(sp.Pow) if not each.exp.is_Integer}
    found: set[sp.Expr] = c.atoms(sp.Function) | roots
    return {each for each in found if not any(each != other and other.has(each) for other in found)}
