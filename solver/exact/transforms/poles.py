"""Residues of F(s) e^{st} at the poles of a rational F: derivatives of what is left when a pole is covered up."""

from __future__ import annotations

from dataclasses import dataclass
from math import comb, factorial

import sympy as sp

from solver.exact.functions.closed_forms import polar
from solver.exact.functions.covering import slope_of_quotient
from solver.exact.functions.fractions import highest_power, residue_at
from solver.exact.functions.rational import RationalMatrix, cancelled, in_lowest_terms
from solver.exact.linear_algebra.fields import in_powers
from solver.exact.linear_algebra.radicals import complex_parts
from solver.exact.linear_algebra.spectrum import Factor, Root, is_lower


@dataclass(frozen=True)
class Pole:
    """A pole of order m with G = (s − p)ᵐ F and its first m − 1 derivatives (`functions`).

    `coefficients` are those of 1/(s − p), …, 1/(s − p)ᵐ. Of a pair it is the upper one, and `paired`.
    """

    root: Root
    functions: tuple[sp.Expr, ...]
    coefficients: tuple[sp.Expr, ...]
    paired: bool

    @property
    def order(self) -> int:
        """The order m of the pole."""
        return len(self.functions)

    def derived(self, t: sp.Symbol) -> sp.Expr:
        """H with (G e^{st})^(m−1) = H e^{st}, by Leibniz' rule."""
        n = self.order - 1
        return sp.Add(*(comb(n, k) * t ** (n - k) * self.functions[k] for k in range(n + 1)))

    def derived_power(self, x: sp.Symbol, k: sp.Symbol) -> sp.Expr:
        """H with (G xᵏ)^(m−1) = H x^{k−m+1}, by Leibniz' rule."""
        n = self.order - 1
        terms = (comb(n, j) * sp.expand(sp.ff(k, j)) * x ** (n - j) * self.functions[n - j] for j in range(n + 1))
        return sp.Add(*terms)

    def in_samples(self, k: sp.Symbol) -> tuple[sp.Expr, ...]:
        """The cⱼ C(k, j − 1) p^{−(j−1)}, whose sum times pᵏ is the residue of F xᵏ, j = 1 … m; p ≠ 0."""
        p, conjugate = self.root.value, self.root.value.subs(sp.I, -sp.I)
        size = sp.expand(p * conjugate)
        return tuple(
            sp.expand(c * conjugate ** (j - 1)) / size ** (j - 1) * sp.expand(sp.ff(k, j - 1)) / factorial(j - 1)
            if self.paired
            else c / p ** (j - 1) * sp.expand(sp.ff(k, j - 1)) / factorial(j - 1)
            for j, c in enumerate(self.coefficients, 1)
        )

    def real_in_samples(self, k: sp.Symbol) -> sp.Expr:
        """The sum of both residues of a pair, 2 rᵏ Re(c e^{jθk})."""
        r, theta = polar(self.root)
        terms = []
        for c in self.in_samples(k):
            X, Y = _parts(c, k)
            terms.append(2 * X * sp.cos(theta * k) - 2 * Y * sp.sin(theta * k))
        return sp.expand(sp.Add(*terms)) * r**k

    def amplitude(self, t: sp.Symbol) -> sp.Expr:
        """The residue without its factor e^{pt}."""
        return sp.Add(*(c * t**j / factorial(j) for j, c in enumerate(self.coefficients)))


def poles_of(image: RationalMatrix, s: sp.Symbol) -> tuple[Pole, ...]:
    """The poles of F (1×1), of each conjugate pair the upper one."""
    numerator = [C.to_list_flat()[0] for C in reversed(image.numerator)]
    found = []
    for each in image.residues:
        order = highest_power(each)
        for root in each.factor.roots if order else ():
            paired = root.kind in ("complex", "decimal") and root.shift != 0
            if paired and is_lower(root):
                continue
            G = _covered(numerator, image, each.factor, root, order, s)
            functions = [G]
            for _ in range(order - 1):
                functions.append(slope_of_quotient(functions[-1], s))
            coefficients = tuple(residue_at(Z, root, (1, 1))[0] for Z in each.residues[:order])
            found.append(Pole(root, tuple(functions), coefficients, paired))
    return tuple(found)


def polar_pairs(image: RationalMatrix) -> list[tuple[Root, sp.Expr, sp.Expr]]:
    """The upper poles σ + jω of pairs, with r and θ of r e^{jθ}."""
    roots = [root for each, _ in image.poles for root in each.factor.roots]
    pairs = [each for each in roots if each.kind in ("complex", "decimal") and each.shift != 0 and not is_lower(each)]
    return [(each, *polar(each)) for each in pairs]


def _parts(c: sp.Expr, k: sp.Symbol) -> tuple[sp.Expr, sp.Expr]:
    """Real and imaginary part of a polynomial in k."""
    parts = [(n, complex_parts(each)) for (n,), each in sp.Poly(sp.expand(c), k).terms()]
    return sp.Add(*(X * k**n for n, (X, _) in parts)), sp.Add(*(Y * k**n for n, (_, Y) in parts))


def _covered(
    numerator: list[object], image: RationalMatrix, factor: Factor, root: Root, order: int, s: sp.Symbol
) -> sp.Expr:
    """(s − p)ᵐ F over the other factors, the factor of p itself in its other roots."""
    rest, left = cancelled(numerator, [(each.modulus, each.multiplicity) for each in image.factors])
    others = [(p, k) for p, k in left if p != factor.modulus]
    K = factor.modulus.domain
    apart = in_lowest_terms(rest, others, s) if others else in_powers(rest, K, s)
    beside = (s - each.value for each in factor.roots if each != root)
    return sp.Mul(apart, *(each**-order for each in beside))
