"""Matched poles and zeros: each of G goes to e^{sT}, zeros at infinity go to −1 but for one, the gain is kept.

Source: Franklin, Powell, Workman, Digital Control of Dynamic Systems, §6.2.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce

import sympy as sp

from solver.exact.functions.fractions import keeps_quadratic
from solver.exact.linear_algebra.fields import NotExact
from solver.exact.linear_algebra.spectrum import Factor, Root, is_lower, spectrum_of_polynomial
from solver.exact.transforms.images import rational_image
from solver.exact.transforms.sampled import Base, base_of, in_z, multiplied, powered


@dataclass(frozen=True)
class MappedRoot:
    """A root of G, as often as `multiplicity` says, the other one of its `pair`, and the base of their images."""

    root: sp.Expr
    mirror: sp.Expr | None
    multiplicity: int
    base: Base

    @property
    def pair(self) -> bool:
        """Whether it stands for two roots."""
        return self.mirror is not None

    def polynomial(self, z: sp.Symbol) -> sp.Expr:
        """What the root gives once, with its conjugate: z − a, or the quadratic of the pair."""
        p = self.base.polynomial(z)
        return p**2 if self.pair and self.base.angle == 0 else p


@dataclass(frozen=True)
class Matched:
    """Poles and zeros with their images, `at_minus_one` zeros of `excess` ones at infinity, and the gain.

    With the `order` r of the pole of G at s = 0 (negative: of a zero) it is sʳG(s) that is kept at low frequencies:
    `wanted` is its value at s = 0, `unscaled` that of ((z − 1)/T)ʳ times the fraction without its gain at z = 1.
    """

    poles: tuple[MappedRoot, ...]
    zeros: tuple[MappedRoot, ...]
    excess: int
    at_minus_one: int
    order: int
    wanted: sp.Expr
    unscaled: sp.Expr

    @property
    def gain(self) -> sp.Expr:
        """What the fraction is multiplied by."""
        quotient: sp.Expr = self.wanted / self.unscaled
        return quotient

    def expression(self, z: sp.Symbol) -> sp.Expr:
        """The matched transfer function."""
        return sp.Mul(self.gain, self._fraction(z, set()))

    def coefficients(self) -> tuple[list[sp.Expr], list[sp.Expr]]:
        """Numerator and denominator multiplied out, the denominator monic."""
        above = reduce(multiplied, self._rows(self.zeros), powered([sp.S.One, sp.S.One], self.at_minus_one))
        return multiplied([self.gain], above), reduce(multiplied, self._rows(self.poles), [sp.S.One])

    @staticmethod
    def _rows(roots: Sequence[MappedRoot]) -> list[list[sp.Expr]]:
        return [powered(each.base.coefficients, each.multiplicity) for each in roots]

    def cleared(self, z: sp.Symbol) -> sp.Expr:
        """The fraction without its gain and without the poles and zeros at z = 1."""
        return self._fraction(z, {each.base for each in (*self.poles, *self.zeros) if each.root == 0})

    def _fraction(self, z: sp.Symbol, without: set[Base]) -> sp.Expr:
        powers = [(each.base, each.multiplicity) for each in self.zeros]
        powers += [(each.base, -each.multiplicity) for each in self.poles]
        parts = [base.polynomial(z) ** m for base, m in powers if base not in without]
        return sp.Mul((z + 1) ** self.at_minus_one, *parts)


def matched(G: sp.Expr, s: sp.Symbol, T: sp.Expr) -> Matched:
    """The matched discrete equivalent of a rational proper G; raises NotExact where its roots have no usable form."""
    image = rational_image(G, s)
    N, D = (sp.Poly(each, s) for each in (image.numerator, image.denominator))
    zeros = mapped_roots(_factors(N), T)
    poles = mapped_roots(_factors(D), T)
    excess = int(D.degree() - N.degree())
    at_minus_one = max(excess - 1, 0)
    order = _power_of(D) - _power_of(N)
    above, below = (sp.cancel(p.as_expr() / s ** _power_of(p)).subs(s, 0) for p in (N, D))
    unscaled = _value_at_one(zeros, at_minus_one) / (_value_at_one(poles, 0) * T**order)
    return Matched(poles, zeros, excess, at_minus_one, order, above / below, unscaled)


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
        return MappedRoot(root.value, None, multiplicity, base_of(root.value, sp.S.Zero, T)[0])
    base, _ = base_of(root.sigma, root.shift, T, sp.cosh if root.kind == "symbolic" else sp.cos)
    mirror = sp.expand(2 * root.sigma - root.value)
    return MappedRoot(root.value, mirror, multiplicity * (2 if base.angle == 0 else 1), base)


def _factors(p: sp.Poly) -> Sequence[Factor]:
    return spectrum_of_polynomial(p.to_field()).factors if p.degree() > 0 else ()


def _power_of(p: sp.Poly) -> int:
    """How often s is a factor."""
    return min(power for (power,) in p.monoms())


def _value_at_one(roots: Sequence[MappedRoot], at_minus_one: int) -> sp.Expr:
    """The product of the polynomials at z = 1, those of z − 1 left out."""
    others = [sp.Add(*each.base.coefficients) ** each.multiplicity for each in roots if each.root != 0]
    return sp.Mul(2**at_minus_one, *others)


def factors_in_z(poles: Sequence[sp.Expr], T: sp.Expr) -> list[MappedRoot]:
    """The poles (closed under conjugation) with the bases of e^{sT}, pairs together, in the order of their first."""
    found: list[MappedRoot] = []
    rest = list(poles)
    while rest:
        s = rest.pop(0)
        sigma, omega = (sp.expand(part) for part in s.as_real_imag())
        if omega == 0:
            base, _ = base_of(s, sp.S.Zero, T)
            found.append(MappedRoot(s, None, 1, base))
            continue
        mirror = next((each for each in rest if sp.expand(each - sigma + sp.I * omega) == 0), None)
        if mirror is None:
            raise NotExact("pole_mapping/not_conjugate", pole=s)
        rest.remove(mirror)
        base, _ = base_of(sigma, omega, T, sp.cos)
        found.append(MappedRoot(s, mirror, 2 if base.angle == 0 else 1, base))
    return found


def product_in_z(factors: Sequence[MappedRoot], z: sp.Symbol) -> sp.Expr:
    """The product of the polynomials of the bases, multiplied out by powers of z."""
    rows = [powered(each.base.coefficients, each.multiplicity) for each in factors]
    return in_z(reduce(multiplied, rows, [sp.S.One]), z)
