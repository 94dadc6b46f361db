"""Partial fractions of a matrix of rational functions, Σ R/(x − λ)ʲ + Σ (βx + γ)/p(x)ʲ, from its residues."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import sympy as sp

from solver.exact.functions.residues import (
    FactorResidues,
    Residue,
    divided_by,
    multiply_by,
    reduce_modulo,
)
from solver.exact.linear_algebra.biquadratic import tidied
from solver.exact.linear_algebra.constants import common_factors_below
from solver.exact.linear_algebra.fields import (
    Algebraic,
    Modulus,
    expressions,
    matrix_of,
)
from solver.exact.linear_algebra.instances import value_at
from solver.exact.linear_algebra.radicals import complex_parts
from solver.exact.linear_algebra.spectrum import Factor, Root, is_lower
from solver.matrices import entries
from solver.stated import Stated
from solver.stated.algebra import product, quotient

if TYPE_CHECKING:
    from solver.exact.functions.rational import RationalMatrix


@dataclass(frozen=True)
class Fraction:
    """A partial fraction (slope · x + constant)/baseʲ; the base is x − λ (no slope) or a real quadratic.

    `root` is λ, or the upper root σ + jω of the quadratic, a root of the irreducible `factor`; `variable` is x.
    """

    base: sp.Expr
    power: int
    constant: sp.ImmutableMatrix
    slope: sp.ImmutableMatrix | None
    factor: Factor
    root: Root
    variable: sp.Symbol

    @property
    def numerator(self) -> sp.ImmutableMatrix:
        """What stands over the power of the base."""
        return self.constant if self.slope is None else sp.ImmutableMatrix(self.slope * self.variable + self.constant)

    @property
    def stated(self) -> Stated:
        """The fraction as it is written: one over the denominator, times the matrix."""
        return product(quotient(sp.Integer(1), self.base**self.power), self.numerator)


def fractions_of(image: RationalMatrix, x: sp.Symbol) -> Sequence[Fraction]:
    """The partial fractions that are not zero.

    Factors with real roots are split into (x − λ)ʲ; a conjugate pair (or one whose nature is undecided) keeps its
    quadratic denominator.
    """
    if x not in image.fractions:
        image.fractions[x] = _fractions_of(image, x)
    return image.fractions[x]


def _fractions_of(image: RationalMatrix, x: sp.Symbol) -> tuple[Fraction, ...]:
    found: list[Fraction] = []
    for each in image.residues:
        of_factor = _quadratic(image, each.factor, x) if keeps_quadratic(each.factor) else _linear(each, image.shape, x)
        found += [fraction for fraction in of_factor if any(entries(fraction.numerator))]
    return tuple(found)


def keeps_quadratic(factor: Factor) -> bool:
    """Whether the partial fractions keep the factor as a quadratic: a conjugate pair, or one that may be."""
    return factor.degree == 2 and factor.roots[0].kind != "surd"


def highest_power(each: FactorResidues) -> int:
    """The highest power of the factor with a residue that is not zero; 0 if the factor cancels."""
    occurring = [j for j, Z in enumerate(each.residues, 1) if any(any(M.to_list_flat()) for M in Z)]
    return max(occurring, default=0)


def is_simple_pair(root: Root) -> bool:
    """Whether the root, of a factor that is no such quadratic itself, is one of a simple conjugate pair."""
    return root.kind in ("complex", "decimal") and root.shift != 0 and root.multiplicity == 1


def real_quadratic(root: Root, x: sp.Symbol) -> sp.Expr:
    """The real quadratic of a pair."""
    constant = root.sigma**2 + root.shift**2
    return x**2 - 2 * root.sigma * x + (constant if root.kind == "decimal" else tidied(constant))


def residue_at(Z: Residue, root: Root, shape: tuple[int, int]) -> sp.ImmutableMatrix:
    """A matrix over L at one root of its factor."""
    if len(Z) == 1 and Z[0].domain.is_QQ:
        return matrix_of(Z[0])
    parts = [expressions(M) for M in Z]
    entries = parts[0] if len(parts) == 1 else [value_at(list(c), root) for c in zip(*parts, strict=True)]
    return sp.ImmutableMatrix(*shape, [common_factors_below(entry) for entry in entries])


def upper_root(factor: Factor) -> Root:
    """The root σ + jω of a quadratic factor; of one whose nature is undecided the root σ + δ."""
    return factor.roots[-1 if factor.roots[0].kind == "symbolic" else 0]


def _quadratic(image: RationalMatrix, factor: Factor, x: sp.Symbol) -> Iterator[Fraction]:
    """The p-adic digits of N·(χ/pᵐ)⁻¹ mod pᵐ, the highest power of p first."""
    p, root = factor.polynomial(x), upper_root(factor)
    for k, (constant, linear) in enumerate(_digits(image, factor)):
        yield Fraction(p, factor.multiplicity - k, matrix_of(constant), matrix_of(linear), factor, root, x)


def _digits(image: RationalMatrix, factor: Factor) -> list[Residue]:
    """R_m, …, R_1 of one factor, as coefficients of 1, x, …."""
    p, m = factor.modulus, factor.multiplicity
    K = p.domain
    X = sp.Dummy("x")
    whole = sp.Poly([K.one, *reversed(p.low)], X, domain=K) ** m
    P = Modulus(tuple(reversed(whole.rep.to_list()[1:])), K)
    others = sp.Poly(list(reversed(image.chi)), X, domain=K).quo(whole)
    inverse = Algebraic(P.reduce([*reversed(others.rep.to_list())]), P).inverse()
    rest = multiply_by(reduce_modulo(list(image.numerator), P), inverse)
    digits = []
    for _ in range(m):
        rest, digit = divided_by(rest, p)
        digits.append(digit)
    return digits


def _linear(each: FactorResidues, shape: tuple[int, int], x: sp.Symbol) -> Iterator[Fraction]:
    """Z_j/(x − λ)ʲ for each root; a simple pair is put over its real quadratic."""
    for root in each.factor.roots:
        for j, Z in enumerate(each.residues, 1):
            matrix = residue_at(Z, root, shape)
            if not is_simple_pair(root):
                yield Fraction(x - root.value, j, matrix, None, each.factor, root, x)
            elif not is_lower(root):
                yield _of_pair(each.factor, root, matrix, x)


def _of_pair(factor: Factor, root: Root, residue: sp.ImmutableMatrix, x: sp.Symbol) -> Fraction:
    """(X + jY)/(x − σ − jω) and its conjugate, added: 2(Xx − σX − ωY) over the real quadratic."""
    parts = [complex_parts(entry) for entry in residue.flat()]
    slope = [2 * X for X, _ in parts]
    constant = [-2 * (root.sigma * X + root.shift * Y) for X, Y in parts]
    if root.kind == "complex":
        slope, constant = [tidied(sp.expand(c)) for c in slope], [tidied(sp.expand(c)) for c in constant]
    shape = residue.shape
    above = (sp.ImmutableMatrix(*shape, constant), sp.ImmutableMatrix(*shape, slope))
    return Fraction(real_quadratic(root, x), 1, *above, factor, root, x)
