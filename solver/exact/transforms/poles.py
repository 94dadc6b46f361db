"""Residues of F(s) e^{st} at the poles of a rational F: derivatives of what is left when a pole is covered up."""

from __future__ import annotations

from dataclasses import dataclass
from math import comb, factorial

import sympy as sp

from solver.exact.functions.covering import slope_of_quotient
from solver.exact.functions.fractions import highest_power, residue_at
from solver.exact.functions.rational import RationalMatrix, cancelled, in_lowest_terms
from solver.exact.linear_algebra.fields import in_powers
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
