"""Matched poles and zeros: each of G goes to e^{sT}, zeros at infinity go to −1 but for one, the gain is kept.

Source: Franklin, Powell, Workman, Digital Control of Dynamic Systems, §6.2.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from solver.exact.digital.fractions import FractionInZ
from solver.exact.functions.fractions import keeps_quadratic
from solver.exact.linear_algebra.spectrum import Factor, Root, is_lower, spectrum_of_polynomial
from solver.exact.transforms.images import rational_image
from solver.exact.transforms.sampled import Base, base_of, multiplied, powered


@dataclass(frozen=True)
class MappedRoot:
    """A root of G, as often as `multiplicity` says, the upper one of a pair, and the base of its image."""

    root: sp.Expr
    pair: bool
    multiplicity: int
    base: Base


@dataclass(frozen=True)
class Matched:
    """Poles and zeros with their images, `at_minus_one` zeros from infinity, the gain that keeps G at low frequencies.

    With the `order` of the pole of G at s = 0 (negative: of a zero) it is sʳG(s) that is kept: `wanted` is its value
    at s = 0, `unscaled` that of ((z − 1)/T)ʳ times the fraction without its gain at z = 1.
    """

    poles: tuple[MappedRoot, ...]
    zeros: tuple[MappedRoot, ...]
    at_minus_one: int
    order: int
    wanted: sp.Expr
    unscaled: sp.Expr
    without_gain: FractionInZ

    @property
    def gain(self) -> sp.Expr:
        """What the fraction is multiplied by."""
        quotient: sp.Expr = self.wanted / self.unscaled
        return quotient

    def expression(self, z: sp.Symbol) -> sp.Expr:
        """The matched transfer function."""
        below = [base.polynomial(z) ** -m for base, m in self.without_gain.poles]
        above = [each.base.polynomial(z) ** each.multiplicity for each in self.zeros]
        return sp.Mul(self.gain, *above, (z + 1) ** self.at_minus_one, *below)


def matched(G: sp.Expr, s: sp.Symbol, T: sp.Expr) -> Matched:
    """The matched discrete equivalent of a rational proper G; raises NotExact where its roots have no usable form."""
    image = rational_image(G, s)
    N, D = (sp.Poly(each, s) for each in (image.numerator, image.denominator))
    zeros = mapped_roots(_factors(N), T)
    poles = mapped_roots(_factors(D), T)
    at_minus_one = max(int(D.degree() - N.degree()) - 1, 0)
    order = _power_of(D) - _power_of(N)
    above, below = (sp.cancel(p.as_expr() / s ** _power_of(p)).subs(s, 0) for p in (N, D))
    fraction = FractionInZ.of(_numerator(zeros, at_minus_one), {each.base: each.multiplicity for each in poles})
    unscaled = _value_at_one(zeros, at_minus_one) / (_value_at_one(poles, 0) * T**order)
    return Matched(poles, zeros, at_minus_one, order, above / below, unscaled, fraction)


def mapped_roots(factors: Sequence[Factor], T: sp.Expr) -> tuple[MappedRoot, ...]:
    """The roots of some factors with the bases of e^{sT}, those of a conjugate pair together."""
    found = []
    for factor in factors:
        for root in factor.roots:
            pair = root.shift != 0 and (root.kind in ("complex", "decimal") or keeps_quadratic(factor))
            if not (pair and is_lower(root)):
                found.append(_mapped(root, factor.multiplicity, T, pair=pair))
    return tuple(found)


def _mapped(root: Root, multiplicity: int, T: sp.Expr, *, pair: bool) -> MappedRoot:
    if not pair:
        return MappedRoot(root.value, False, multiplicity, base_of(root.value, sp.S.Zero, T)[0])
    base, _ = base_of(root.sigma, root.shift, T, sp.cosh if root.kind == "symbolic" else sp.cos)
    return MappedRoot(root.value, True, multiplicity * (2 if base.angle == 0 else 1), base)


def _factors(p: sp.Poly) -> Sequence[Factor]:
    return spectrum_of_polynomial(p.to_field()).factors if p.degree() > 0 else ()


def _power_of(p: sp.Poly) -> int:
    """How often s is a factor."""
    return min(power for (power,) in p.monoms())


def _numerator(zeros: Sequence[MappedRoot], at_minus_one: int) -> list[sp.Expr]:
    found = powered([sp.S.One, sp.S.One], at_minus_one)
    for each in zeros:
        found = multiplied(found, powered(each.base.coefficients, each.multiplicity))
    return found


def _value_at_one(roots: Sequence[MappedRoot], at_minus_one: int) -> sp.Expr:
    """The product of the polynomials at z = 1, those of z − 1 left out."""
    others = [sp.Add(*each.base.coefficients) ** each.multiplicity for each in roots if each.root != 0]
    return sp.Mul(2**at_minus_one, *others)
