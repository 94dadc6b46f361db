"""Eigenvalues by the irreducible factors of the characteristic polynomial.

Factors of degree 1 and 2 give exact roots, and so do x⁴ + bx² + c whose roots are short. Another factor of degree ≥ 3
gives decimals (Cardano's formulas help nobody).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import mpmath
import sympy as sp
from sympy.polys.polyclasses import DMP

from solver.exact.linear_algebra.assembly import product_of_powers
from solver.exact.linear_algebra.biquadratic import biquadratic_roots, has_rational_coefficients
from solver.exact.linear_algebra.faddeev import faddeev_leverrier
from solver.exact.linear_algebra.fields import (
    Modulus,
    NotExact,
    expression,
    in_powers,
    is_real_field,
    vanishing_factors,
)
from solver.exact.linear_algebra.integers import small_integer_roots
from solver.exact.linear_algebra.radicals import complex_root, is_negative, square_root
from solver.exact.linear_algebra.signs import possible_signs

DIGITS = 30
"""Decimal digits carried for the roots of factors of degree ≥ 3."""


@dataclass(frozen=True)
class Root:
    """An eigenvalue σ + δ: `kind` is rational, surd, complex (δ = jω), symbolic (sign of δ² undecided) or decimal.

    `shift` is ω for a complex root (positive: the one above the real axis), δ for a surd or symbolic one, else 0.
    """

    value: sp.Expr
    multiplicity: int
    kind: str
    sigma: sp.Expr
    shift: sp.Expr


def is_lower(root: Root) -> bool:
    """Whether a complex root is the lower one of its pair; with an undecided sign the one with a minus before it."""
    signs = possible_signs(root.shift)
    return signs == {-1} if len(signs) == 1 else bool(root.shift.could_extract_minus_sign())


@dataclass(frozen=True)
class Factor:
    """An irreducible monic factor p of χ over K, with its multiplicity and roots. `coefficients`: highest first."""

    modulus: Modulus
    multiplicity: int
    roots: tuple[Root, ...]

    @property
    def degree(self) -> int:
        """The degree of p."""
        return self.modulus.degree

    @cached_property
    def coefficients(self) -> tuple[sp.Expr, ...]:
        """The coefficients 1, c_{d−1}, …, c₀ as expressions."""
        return (sp.Integer(1), *(expression(self.modulus.domain, c) for c in reversed(self.modulus.low)))

    def polynomial(self, x: sp.Symbol) -> sp.Expr:
        """p(x), expanded."""
        return sp.Add(*(c * x ** (self.degree - i) for i, c in enumerate(self.coefficients)))


@dataclass(frozen=True)
class Spectrum:
    """The factors of χ in order; `exceptions` are conditions on parameters under which multiplicities change."""

    factors: tuple[Factor, ...]
    exceptions: tuple[sp.Basic, ...]

    @property
    def roots(self) -> tuple[Root, ...]:
        """The distinct roots: real ones ascending, pairs with the upper root first, factor by factor."""
        return tuple(root for factor in self.factors for root in factor.roots)

    @property
    def eigenvalues(self) -> list[sp.Expr]:
        """The eigenvalues, repeated by multiplicity."""
        return [root.value for root in self.roots for _ in range(root.multiplicity)]


@lru_cache(maxsize=64)
def spectrum(A: sp.ImmutableMatrix) -> Spectrum:
    """The spectrum of A (n×n); raises NotExact for a factor of degree ≥ 3 with parameters."""
    listed = irreducible_factors(A)
    factors = [_factor(p, multiplicity) for p, multiplicity in listed]
    return Spectrum(tuple(sorted(factors, key=_order)), _exceptions([p for p, _ in listed]))


@lru_cache(maxsize=64)
def characteristic_factors(A: sp.ImmutableMatrix) -> tuple[Factor, ...]:
    """The factors of the spectrum of A (n×n), those of degree ≥ 3 with parameters last and without their roots."""
    found = []
    for p, multiplicity in irreducible_factors(A):
        try:
            found.append(_factor(p, multiplicity))
        except NotExact:
            found.append(Factor(_modulus(p), multiplicity, ()))
    solved = [factor for factor in found if factor.roots]
    return (*sorted(solved, key=_order), *(factor for factor in found if not factor.roots))


@lru_cache(maxsize=64)
def irreducible_factors(A: sp.ImmutableMatrix) -> list[tuple[sp.Poly, int]]:
    """The monic irreducible factors of χ over K with their multiplicities."""
    result = faddeev_leverrier(A)
    x, K = sp.Dummy("x"), result.domain
    roots, rest = small_integer_roots(list(result.chi)) if K.is_QQ else ([], list(result.chi))
    found = [(sp.Poly.new(DMP([K.one, K(-root)], K), x), roots.count(root)) for root in dict.fromkeys(roots)]
    if len(rest) == 1:
        return found
    _, listed = sp.Poly(rest, x, domain=K).factor_list()
    return found + [(p.set_domain(K).monic(), multiplicity) for p, multiplicity in listed]


def _modulus(p: sp.Poly) -> Modulus:
    return Modulus(tuple(reversed(p.rep.to_list()[1:])), p.domain)


@lru_cache(maxsize=64)
def factored(A: sp.ImmutableMatrix, x: sp.Symbol) -> sp.Expr:
    """χ(x) as the product of its irreducible factors over K."""
    listed = irreducible_factors(A)
    powers = [polynomial(p, x) ** m for p, m in listed]
    if listed and listed[0][0].domain.is_QQ:
        return product_of_powers(sp.S.One, powers)
    return sp.Mul(*sorted(powers, key=sp.default_sort_key))


def polynomial(p: sp.Poly, x: sp.Symbol) -> sp.Expr:
    """A polynomial over K as an expression in x."""
    return in_powers(p.rep.to_list(), p.domain, x)


def spectrum_of_polynomial(p: sp.Poly) -> Spectrum:
    """The roots of a polynomial over a field, factor by factor; raises NotExact as `spectrum` does."""
    _, listed = p.factor_list()
    monic = [(q.set_domain(p.domain).monic(), multiplicity) for q, multiplicity in listed]
    factors = [_factor(q, multiplicity) for q, multiplicity in monic]
    return Spectrum(tuple(sorted(factors, key=_order)), _exceptions([q for q, _ in monic]) if monic else ())


def roots_of(p: sp.Poly, multiplicity: int = 1) -> tuple[Root, ...]:
    """The roots of an irreducible polynomial over a field; raises NotExact as `spectrum` does."""
    return _factor(p.to_field().monic(), multiplicity).roots


def split_over(factor: Factor, K: Any) -> tuple[Factor, ...]:
    """The factors over a field K that holds the factor's own field: there it may be reducible."""
    p, own = factor.modulus, factor.modulus.domain
    if own == K:
        return (factor,)
    lifted = sp.Poly([K.one, *(K.convert(c, own) for c in reversed(p.low))], sp.Dummy("x"), domain=K)
    _, listed = lifted.factor_list()
    split = [_factor(q.set_domain(K).monic(), factor.multiplicity * m) for q, m in listed]
    return tuple(sorted(split, key=_order))


def _order(factor: Factor) -> tuple[int, Any, str]:
    """Rational roots ascending, then surds and pairs by σ, then symbols by name, decimals last.

    Complex ones of a complex matrix by their real parts, the upper one first.
    """
    first = factor.roots[0]
    if first.kind == "decimal":
        return (3, factor.degree, str(first.value))
    if first.sigma.free_symbols or first.shift.free_symbols:
        return (2, 0, str(first.value))
    if first.kind == "rational":
        return (0, (first.sigma, 0), "")
    real, imaginary = sp.N(first.sigma).as_real_imag()
    return (1, (real, -imaginary), str(first.shift))


def _factor(p: sp.Poly, multiplicity: int) -> Factor:
    K = p.domain
    modulus = _modulus(p)
    c = [expression(K, each) for each in modulus.low]
    if p.degree() > 1 and not is_real_field(K):
        return Factor(modulus, multiplicity, _complex_roots(c, multiplicity))
    if p.degree() == 1:
        value = sp.factor(-c[0]) if c[0].free_symbols else -c[0]
        kind = "rational" if value.is_Rational else "symbolic" if value.free_symbols else "surd"
        return Factor(modulus, multiplicity, (Root(value, multiplicity, kind, value, sp.Integer(0)),))
    if p.degree() == 2:
        return Factor(modulus, multiplicity, _pair(c[1], c[0], multiplicity))
    roots = (
        _biquadratic(c, multiplicity)
        if p.degree() == 4 and c[1] == c[3] == 0 and has_rational_coefficients(K)
        else None
    )
    return Factor(modulus, multiplicity, roots or _decimal_roots(p, multiplicity))


def _biquadratic(c: list[sp.Expr], multiplicity: int) -> tuple[Root, ...] | None:
    """The roots of x⁴ + c₂x² + c₀ with square roots; None where these are long."""
    found = biquadratic_roots(c[2], c[0])
    if found is None:
        return None
    roots: list[Root] = []
    for each in found:
        sigma, shift = each.sigma, each.shift
        if each.real:
            roots.append(Root(sigma + shift, multiplicity, "surd", sigma, shift))
        else:
            roots += [
                Root(sigma + sign * sp.I * shift, multiplicity, "complex", sigma, sign * shift) for sign in (1, -1)
            ]
    return tuple(roots)


def _complex_roots(c: list[sp.Expr], multiplicity: int) -> tuple[Root, ...]:
    """The roots σ ± δ of a quadratic with complex coefficients, each for itself; raises NotExact for other factors."""
    if len(c) > 2:
        raise NotExact("linear_algebra/complex_factor", degree=len(c))
    sigma = sp.expand(-c[1] / 2)
    delta = complex_root(sp.expand(sigma**2 - c[0]))
    if delta is None:
        raise NotExact("linear_algebra/complex_factor", degree=2)
    return tuple(Root(sigma + d, multiplicity, "surd", sigma, d) for d in (-delta, delta))


def _pair(b: sp.Expr, c: sp.Expr, multiplicity: int) -> tuple[Root, ...]:
    """The roots σ ± δ of x² + bx + c = (x − σ)² − δ², δ² = b²/4 − c."""
    sigma, square = -b / 2, sp.expand(b**2 / 4 - c)
    negative = is_negative(square)
    if negative:
        omega = square_root(-square)
        return tuple(
            Root(sigma + sign * omega * sp.I, multiplicity, "complex", sigma, sign * omega) for sign in (1, -1)
        )
    kind = "symbolic" if negative is None else "surd"
    delta = square_root(square)
    return tuple(Root(sigma + sign * delta, multiplicity, kind, sigma, sign * delta) for sign in (-1, 1))


def _decimal_roots(p: sp.Poly, multiplicity: int) -> tuple[Root, ...]:
    """Roots of an irreducible p of degree ≥ 3 to 30 digits: real ones ascending, then pairs, the upper root first."""
    if p.domain.is_Composite:
        raise NotExact("linear_algebra/roots_of_parameters", degree=p.degree())
    with mpmath.workdps(2 * DIGITS):
        coefficients = [mpmath.mpmathify(sp.N(c, 2 * DIGITS)) for c in p.all_coeffs()]
        found = mpmath.polyroots(coefficients, maxsteps=500, extraprec=400)
        near_axis = [abs(z.imag) < mpmath.mpf(10) ** (-DIGITS) * (1 + abs(z)) for z in found]
        real = sorted(z.real for z, flat in zip(found, near_axis, strict=True) if flat)
        upper = [z for z, flat in zip(found, near_axis, strict=True) if not flat and z.imag > 0]
        upper.sort(key=lambda z: (z.real, z.imag))
        roots = [Root(_decimal(r), multiplicity, "decimal", _decimal(r), sp.Integer(0)) for r in real]
        for z in upper:
            sigma, omega = _decimal(z.real), _decimal(z.imag)
            roots += [
                Root(sigma + sign * omega * sp.I, multiplicity, "decimal", sigma, sign * omega) for sign in (1, -1)
            ]
    return tuple(roots)


def _decimal(x: Any) -> sp.Float:
    return sp.Float(x, DIGITS)


def _exceptions(factors: list[sp.Poly]) -> tuple[sp.Basic, ...]:
    """Where parameters make roots meet: discriminants and resultants of the factors that can vanish."""
    found: dict[sp.Basic, None] = {}
    if not factors[0].domain.is_Composite:
        return ()
    for i, p in enumerate(factors):
        conditions = [p.resultant(q) for q in factors[:i]]
        if p.degree() > 1:
            conditions.append(p.discriminant())
        for condition in conditions:
            for factor in vanishing_factors(condition.as_expr() if isinstance(condition, sp.Poly) else condition):
                found[sp.Eq(factor, 0)] = None
    return tuple(found)
