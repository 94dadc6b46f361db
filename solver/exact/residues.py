"""Residues of N(x)/χ(x) at a root of each irreducible factor of χ, in exact arithmetic over L = K[x]/(p).

At a root λ of multiplicity m the partial fractions are Σ_j Z_j/(x − λ)^j, j = 1 … m, with the Z_j from the Taylor
series of N(x)·(x − λ)^m/χ(x) at λ. Written in L, one computation gives the Z_j of all conjugate roots of p; nothing is
inverted but one element of L.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import comb
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.faddeev import faddeev_leverrier
from solver.exact.fields import Algebraic, Modulus
from solver.exact.spectrum import Factor, spectrum

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
    return tuple(residues_at(fl.N[::-1], fl.chi[::-1], factor) for factor in spectrum(A).factors)


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
    return tuple(residues_at(numerator, fl.chi[::-1], factor) for factor in spectrum(A).factors)


def residues_at(numerator: Sequence[DomainMatrix], chi: Sequence[Any], factor: Factor) -> FactorResidues:
    """The residues of Σ numerator[i] xⁱ/χ(x) at the roots of one factor; `chi` lists χ with the lowest power first."""
    m, p = factor.multiplicity, factor.modulus
    top = [_taylor_matrix(numerator, i, p) for i in range(m)]
    bottom = [Algebraic(p.reduce(_taylor_coefficients(chi, m + i, p.domain)), p) for i in range(m)]
    first = bottom[0].inverse()
    quotient: list[Residue] = []
    for i in range(m):  # power series division: quotient[i] = (top[i] − Σ bottom[i−l] quotient[l]) / bottom[0]
        rest = top[i]
        for earlier, q in enumerate(quotient):
            rest = _subtract(rest, multiply_by(q, bottom[i - earlier]))
        quotient.append(multiply_by(rest, first))
    return FactorResidues(factor, tuple(reversed(quotient)))


def _taylor_coefficients(polynomial: Sequence[Any], i: int, K: Any) -> list[Any]:
    """The polynomial p⁽ⁱ⁾(x)/i!, lowest power first."""
    return [K(comb(j, i)) * polynomial[j] for j in range(i, len(polynomial))] or [K.zero]


def _taylor_matrix(polynomial: Sequence[DomainMatrix], i: int, p: Modulus) -> Residue:
    derivative = [polynomial[j] * p.domain(comb(j, i)) if i else polynomial[j] for j in range(i, len(polynomial))]
    zero = polynomial[0] - polynomial[0]
    return reduce_modulo(derivative or [zero], p)


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


def _subtract(left: Residue, right: Residue) -> Residue:
    return [a - b for a, b in zip(left, right, strict=True)]
