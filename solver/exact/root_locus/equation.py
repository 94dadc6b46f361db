"""D(s) + K N(s) = 0, which the poles of a loop with a gain K satisfy, in lowest terms; values at roots of polynomials.

Of a discrete loop the variable is z, and the unit circle the boundary of stability.

Source: W. R. Evans, Graphical Analysis of Control Systems, Trans. AIEE 67 (1948).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.fields import Algebraic, Modulus, domain_matrix, expression, in_powers
from solver.exact.linear_algebra.instances import element_at
from solver.exact.linear_algebra.spectrum import Root, roots_of

WORKING_DIGITS = 60


@dataclass(frozen=True)
class LocusEquation:
    """D + K N = 0 over a field of numbers; N and D have no common factor, `common` (monic) was divided out of both."""

    numerator: sp.Poly
    denominator: sp.Poly
    common: sp.Poly
    discrete: bool = False

    @property
    def variable(self) -> sp.Symbol:
        """The symbol s (discrete: z)."""
        found: sp.Symbol = self.denominator.gen
        return found

    @property
    def excess(self) -> int:
        """How many branches end at infinity: deg D − deg N."""
        return int(self.denominator.degree() - self.numerator.degree())

    @property
    def lead(self) -> sp.Expr:
        """The leading coefficient of N over that of D."""
        K = self.denominator.domain
        return expression(K, self.numerator.rep.to_list()[0] / self.denominator.rep.to_list()[0])

    @property
    def positive(self) -> bool:
        """Whether that is positive: the locus is that of 180°, else that of 0°."""
        return bool(sp.N(self.lead, WORKING_DIGITS) > 0)

    def coefficients(self, gain: sp.Expr) -> list[sp.Expr]:
        """The coefficients of D + K N at a gain, `common` left out, highest power first."""
        above, below = (expressions_of(p) for p in (self.numerator, self.denominator))
        above = [sp.Integer(0)] * (len(below) - len(above)) + above
        return [d + gain * n for d, n in zip(below, above, strict=True)]


@dataclass(frozen=True)
class PlacedRoot:
    """A root (with its multiplicity) of the irreducible polynomial `factor`."""

    root: Root
    factor: sp.Poly

    @property
    def value(self) -> sp.Expr:
        """The root as an expression."""
        return self.root.value

    @property
    def multiplicity(self) -> int:
        """How often it is a root of the polynomial that was asked about."""
        return self.root.multiplicity

    @property
    def real(self) -> bool:
        """Whether it is real."""
        return not (self.root.kind == "complex" or (self.root.kind == "decimal" and self.root.shift != 0))

    @property
    def upper(self) -> bool:
        """Whether it lies above the real axis."""
        return not self.real and bool(sp.N(sp.im(self.value)) > 0)


def affine_parts(coefficients: Sequence[sp.Expr], k: sp.Symbol) -> tuple[list[sp.Expr], list[sp.Expr]] | None:
    """The parts without k and with the factor k, of each coefficient; None where k enters otherwise."""
    constant, slopes = [], []
    for c in coefficients:
        if not c.is_polynomial(k) or sp.degree(c, k) > 1:
            return None
        p = sp.Poly(c, k)
        constant.append(p.nth(0))
        slopes.append(p.nth(1))
    return constant, slopes


def locus_equation(numerator: sp.Expr, denominator: sp.Expr, s: sp.Symbol, *, discrete: bool = False) -> LocusEquation:
    """The equation of two polynomials that are not zero, with numbers for coefficients; raises NotExact."""
    above, below = (sp.Poly(p, s).all_coeffs() for p in (numerator, denominator))
    (flat,) = (matrix := domain_matrix(sp.Matrix([[*above, *below]]))).to_list()
    N, D = (sp.Poly(c, s, domain=matrix.domain) for c in (flat[: len(above)], flat[len(above) :]))
    common = N.gcd(D).monic()
    return LocusEquation(N.quo(common), D.quo(common), common, discrete)


def expressions_of(p: sp.Poly) -> list[sp.Expr]:
    """The coefficients as expressions, highest power first."""
    K = p.domain
    return [expression(K, K.convert(c)) for c in p.rep.to_list()]


def written(p: sp.Poly) -> sp.Expr:
    """The polynomial as an expression, by falling powers."""
    return in_powers(p.rep.to_list(), p.domain, p.gen)


@lru_cache(maxsize=64)
def roots_with_factors(p: sp.Poly) -> tuple[PlacedRoot, ...]:
    """The distinct roots: real ones rising, then pairs by their real parts, the upper one first; none of a constant."""
    found = [
        PlacedRoot(root, factor.monic())
        for factor, multiplicity in (p.factor_list()[1] if p.degree() > 0 else ())
        for root in roots_of(factor.set_domain(p.domain), multiplicity)
    ]
    return tuple(sorted(found, key=_place))


def _place(each: PlacedRoot) -> tuple[bool, Any, Any, bool]:
    real, imaginary = sp.N(each.value, WORKING_DIGITS).as_real_imag()
    return (not each.real, sp.Float(real, 40), abs(imaginary), not each.upper)


def quotient_at(numerator: sp.Poly, denominator: sp.Poly, at: PlacedRoot) -> Algebraic:
    """N/D in K[x]/(p) for the factor p of a root at which D is not zero."""
    return element_of(numerator, at) / element_of(denominator, at)


def element_of(p: sp.Poly, at: PlacedRoot) -> Algebraic:
    """A polynomial in K[x]/(q) for the factor q of a root."""
    modulus = Modulus(tuple(reversed(at.factor.rep.to_list()[1:])), at.factor.domain)
    return Algebraic(modulus.reduce(list(reversed(p.rep.to_list()))), modulus)


def value_of(element: Algebraic, at: PlacedRoot) -> sp.Expr:
    """An element of that field as an expression, at the root."""
    found = element_at(element, at.root)
    return sp.radsimp(found) if not found.has(sp.Float) else found
