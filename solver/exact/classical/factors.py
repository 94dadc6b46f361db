"""A rational function in its pole-zero form k Π(x − zᵢ)/Π(x − pᵢ), and its value at a point where poles may lie."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.fields import expression
from solver.exact.linear_algebra.spectrum import Factor
from solver.exact.representation.polynomials import expanded, roots_of
from solver.exact.representation.transfer import TransferMatrix


@dataclass(frozen=True)
class PoleZeroForm:
    """The gain k, zeros and poles with multiplicity; `top` and `bottom` are the monic products of real factors."""

    variable: sp.Symbol
    gain: sp.Expr
    zeros: list[sp.Expr]
    poles: list[sp.Expr]
    top: sp.Expr
    bottom: sp.Expr

    @property
    def function(self) -> sp.Expr:
        """The rational function as the product of its factors."""
        return sp.Mul(self.gain, self.top, 1 / self.bottom)


def pole_zero_factors(G: TransferMatrix) -> PoleZeroForm:
    """The form of the only entry (1×1, in lowest terms); raises NotExact where a factor has no usable roots."""
    top, bottom = G.tops[0][0], G.bottoms[0][0]
    if top.is_zero:
        return PoleZeroForm(G.variable, sp.Integer(0), [], [], sp.Integer(1), sp.Integer(1))
    (zeros, above), (poles, below) = (_taken_apart(p, G.variable) for p in (top.monic(), bottom))
    gain = expression(G.domain, top.rep.to_list()[0])
    return PoleZeroForm(G.variable, sp.factor(gain) if gain.free_symbols else gain, zeros, poles, above, below)


def pole_factors(G: TransferMatrix) -> sp.Expr:
    """The denominator of the only entry (1×1, in lowest terms) as a product of real factors; raises NotExact."""
    return _taken_apart(G.bottoms[0][0], G.variable)[1]


def _taken_apart(p: sp.Poly, x: sp.Symbol) -> tuple[list[sp.Expr], sp.Expr]:
    """The roots of a monic polynomial, and the polynomial as a product of real factors of degree one and two."""
    found = roots_of(p)
    if found is None:
        return [], sp.Integer(1)
    factors = [f**each.multiplicity for each in found.factors for f in real_factors(each, x)]
    return found.eigenvalues, sp.Mul(*factors)


def real_factors(factor: Factor, x: sp.Symbol) -> list[sp.Expr]:
    """An irreducible factor as linear factors, and quadratic ones of conjugate pairs or of roots not known real."""
    if factor.degree == 1:
        return [x - factor.roots[0].value]
    listed = []
    for root in factor.roots:
        turning = root.kind == "complex" or root.value.has(sp.I)
        if root.kind == "symbolic" and factor.degree == 2:
            return [factor.polynomial(x)]
        if not turning:
            listed.append(x - root.value)
        elif root.shift.is_positive:
            listed.append(x**2 - 2 * root.sigma * x + sp.expand(root.sigma**2 + root.shift**2))
    if 2 * sum(sp.degree(each, x) == 2 for each in listed) + sum(sp.degree(each, x) == 1 for each in listed) < len(
        factor.roots
    ):
        return [factor.polynomial(x)]  # of a pair with parameters the sign of ω is not known
    return listed


@dataclass(frozen=True)
class ValueAtZero:
    """G(0), or where G = G₀/xʳ has a pole at the origin, r > 0, the value G₀(0), which is not zero.

    In discrete time G(1), or where G = G₀/(x − 1)ʳ the value G₀(1).
    """

    order: int
    value: sp.Expr
    below: sp.Expr


def value_at_zero(G: TransferMatrix, *, discrete: bool = False) -> ValueAtZero:
    """The value at x = 0, in discrete time at 1, of the only entry (1×1, in lowest terms), `below` what is left."""
    K, x = G.domain, G.variable
    at = K.one if discrete else K.zero
    factor = sp.Poly([K.one, -at], x, domain=K)
    order, rest = 0, G.bottoms[0][0]
    while _at(rest, at) == K.zero:
        order, rest = order + 1, rest.quo(factor)
    value = sp.factor(expression(K, _at(G.tops[0][0], at) / _at(rest, at)))
    return ValueAtZero(order, value, expanded(rest))


def _at(p: sp.Poly, point: Any) -> Any:
    """The value of a polynomial at 0 or 1, an element of its domain."""
    listed = p.rep.to_list()
    zero = p.domain.zero
    return sum(listed, zero) if point != zero else listed[-1] if listed else zero
