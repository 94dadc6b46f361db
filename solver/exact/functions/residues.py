"""Residues of N(x)/χ(x) at a root of each irreducible factor of χ, in exact arithmetic over L = K[x]/(p).

At a root λ of multiplicity m the partial fractions are Σ_j Z_j/(x − λ)^j, j = 1 … m, with the Z_j from the Taylor
series of N(x)·(x − λ)^m/χ(x) at λ. Written in L, one computation gives the Z_j of all conjugate roots of p; nothing is
inverted but one element of L.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache, reduce
from math import comb, lcm
from operator import mul
from typing import Any

import sympy as sp
from sympy import QQ
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.faddeev import faddeev_leverrier
from solver.exact.linear_algebra.fields import Algebraic, Modulus
from solver.exact.linear_algebra.spectrum import Factor, spectrum

Residue = list[DomainMatrix]
"""A matrix over L: its coefficients (matrices over K) of 1, x, …, x^{d−1}."""


@dataclass(frozen=True)
class FactorResidues:
    """Z₁ … Z_m at the roots of one factor (`residues[j − 1]` is Z_j)."""

    factor: Factor
    residues: tuple[Residue, ...]


@lru_cache(maxsize=64)
def resolvent_residues(A: sp.ImmutableMatrix) -> tuple[FactorResidues, ...]:
    """The residues of (xI − A)⁻¹ = adj(xI − A)/χ(x), n×n."""
    fl = faddeev_leverrier(A)
    adjugate = MatrixPolynomial(fl.N[::-1])
    return tuple(residues_at(adjugate, fl.chi[::-1], factor) for factor in spectrum(A).factors)


@lru_cache(maxsize=64)
def interpolation_residues(A: sp.ImmutableMatrix) -> tuple[FactorResidues, ...]:
    """The residues of the images of α₀ … αₙ₋₁ (n×1), where f(A) = Σ αᵢ Aⁱ.

    From adj(xI − A) = Σ_i (x^{n−1−i} + a₁ x^{n−2−i} + … + a_{n−1−i}) Aⁱ, the numerator of αᵢ is the bracket.
    """
    fl = faddeev_leverrier(A)
    n, K = A.rows, fl.domain
    numerator = []
    for power in range(n):  # the coefficient of x^power in each of the n brackets
        column = [[fl.chi[n - 1 - i - power] if power <= n - 1 - i else K.zero] for i in range(n)]
        numerator.append(DomainMatrix(column, (n, 1), K))
    brackets = MatrixPolynomial(numerator)
    return tuple(residues_at(brackets, fl.chi[::-1], factor) for factor in spectrum(A).factors)


class MatrixPolynomial:
    """Σ C_i xⁱ with matrices C_i over K, prepared for linear combinations of the C_i."""

    def __init__(self, coefficients: Sequence[DomainMatrix]) -> None:
        self.coefficients = coefficients
        self.shape, self.domain = coefficients[0].shape, coefficients[0].domain
        if self.domain.is_QQ:  # integers with one denominator a matrix: no fraction is reduced before the end
            flat = [C.to_list_flat() for C in coefficients]
            self._denominators = [lcm(*(int(x.denominator) for x in entries)) for entries in flat]
            integers = [
                [int(x.numerator) * (d // int(x.denominator)) for x in entries]
                for entries, d in zip(flat, self._denominators, strict=True)
            ]
            self._columns = list(zip(*integers, strict=True))

    def combination(self, scalars: Sequence[Any]) -> DomainMatrix:
        """Σ scalars[i] C_i."""
        if self.domain.is_QQ:
            return self._integer_combination(scalars)
        total: DomainMatrix = self.coefficients[0] * self.domain.zero
        for C, scalar in zip(self.coefficients, scalars, strict=True):
            if scalar:
                total = total + C * scalar
        return total

    def _integer_combination(self, scalars: Sequence[Any]) -> DomainMatrix:
        scaled = [w / d for w, d in zip(scalars, self._denominators, strict=True)]
        common = lcm(*(int(w.denominator) for w in scaled))
        weights = [int(w.numerator) * (common // int(w.denominator)) for w in scaled]
        rows, columns = self.shape
        entries = [QQ(sum(map(mul, column, weights)), common) for column in self._columns]
        return DomainMatrix([entries[i * columns : (i + 1) * columns] for i in range(rows)], self.shape, QQ)


def residues_at(
    numerator: MatrixPolynomial | Sequence[DomainMatrix], chi: Sequence[Any], factor: Factor
) -> FactorResidues:
    """The residues of Σ numerator[i] xⁱ/χ(x) at the roots of one factor; `chi` lists χ with the lowest power first.

    The expansion is that of the scalars xⁱ/χ(x); each residue is then one linear combination of matrices.
    """
    matrices = numerator if isinstance(numerator, MatrixPolynomial) else MatrixPolynomial(numerator)
    weights = _weights(len(matrices.coefficients), chi, factor)
    residues = [
        [matrices.combination([w.coefficients[r] for w in of_powers]) for r in range(factor.degree)]
        for of_powers in weights
    ]
    return FactorResidues(factor, tuple(reversed(residues)))


def _weights(count: int, chi: Sequence[Any], factor: Factor) -> list[list[Algebraic]]:
    """For l = 0 … m − 1 and i < count: the coefficient of (x − λ)ˡ in xⁱ(x − λ)^m/χ(x), an element of L."""
    m, p = factor.multiplicity, factor.modulus
    if m == p.degree == 1:
        return [_weights_at_a_simple_root(count, chi, p)]
    h = _reciprocal([Algebraic(p.reduce(_taylor_coefficients(chi, m + i, p.domain)), p) for i in range(m)])
    powers = [Algebraic([p.domain.one, *[p.domain.zero] * (p.degree - 1)], p)]
    for _ in range(count - 1):
        powers.append(Algebraic(p.reduce([p.domain.zero, *powers[-1].coefficients]), p))
    return [
        [_total([powers[i - a] * h[level - a] * comb(i, a) for a in range(min(i, level) + 1)]) for i in range(count)]
        for level in range(m)
    ]


def _weights_at_a_simple_root(count: int, chi: Sequence[Any], p: Modulus) -> list[Algebraic]:
    """λⁱ/χ′(λ) for i < count, p = x − λ."""
    root, slope = -p.low[0], p.domain.zero
    for j in range(len(chi) - 1, 0, -1):
        slope = slope * root + chi[j] * j
    weights = [p.domain.one / slope]
    for _ in range(count - 1):
        weights.append(weights[-1] * root)
    return [Algebraic((weight,), p) for weight in weights]


def _total(terms: list[Algebraic]) -> Algebraic:
    return reduce(lambda a, b: a + b, terms)


def _reciprocal(series: list[Algebraic]) -> list[Algebraic]:
    """The power series 1/Σ sᵢ eⁱ, to as many terms."""
    first = series[0].inverse()
    found = [first]
    for level in range(1, len(series)):
        found.append(-(first * _total([series[i] * found[level - i] for i in range(1, level + 1)])))
    return found


def _taylor_coefficients(polynomial: Sequence[Any], i: int, K: Any) -> list[Any]:
    """The polynomial p⁽ⁱ⁾(x)/i!, lowest power first."""
    return [K(comb(j, i)) * polynomial[j] for j in range(i, len(polynomial))] or [K.zero]


def reduce_modulo(coefficients: list[DomainMatrix], p: Modulus) -> Residue:
    """A polynomial with matrix coefficients modulo p; for degree one, Horner's rule at the root."""
    d = p.degree
    if d == 1:
        root = -p.low[0]
        value = coefficients[-1]
        for c in reversed(coefficients[:-1]):
            value = value * root + c
        return [value]
    return divided_by(coefficients, p)[1]


def multiply_by(matrix: Residue, scalar: Algebraic) -> Residue:
    """A matrix over L times an element of L."""
    p = scalar.modulus
    if p.degree == 1:
        return [matrix[0] * scalar.coefficients[0]]
    zero = matrix[0] - matrix[0]
    long = [zero] * (2 * p.degree - 1)
    for i, M in enumerate(matrix):
        for j, c in enumerate(scalar.coefficients):
            if c:
                long[i + j] = long[i + j] + M * c
    return reduce_modulo(long, p)


def divided_by(matrix: Residue, p: Modulus) -> tuple[Residue, Residue]:
    """Quotient and remainder of a polynomial with matrix coefficients by p (remainder: d coefficients)."""
    rest, quotient = list(matrix), []
    for top in range(len(rest) - 1, p.degree - 1, -1):
        lead = rest.pop()
        quotient.append(lead)
        for i, c in enumerate(p.low):
            if c:
                rest[top - p.degree + i] = rest[top - p.degree + i] - lead * c
    zero = matrix[0] - matrix[0]
    padded = rest + [zero] * (p.degree - len(rest))
    return (quotient[::-1] or [zero]), padded
