"""Formulas as a person writes them, not carried out.

A worked solution shows `det(λI − A) = λ² + 3λ + 2`. The right side is an exact sympy object; the left side is a
`Stated` formula: `render` prints it as it stands and `numeric` evaluates it with its own algorithms. So a wrong
right side cannot hide: nothing that derived it takes part in checking it.

Operands are sympy expressions or matrices, numbers, or further `Stated` formulas.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class Stated:
    """An operation and its operands, not carried out."""

    operation: str
    operands: tuple[Any, ...]


def determinant(matrix: Any) -> Stated:
    """det M of a square matrix."""
    return Stated("determinant", (matrix,))


def adjugate(matrix: Any) -> Stated:
    """adj M, the transposed matrix of cofactors."""
    return Stated("adjugate", (matrix,))


def partitioned(matrix: Any, rows: Sequence[int], columns: Sequence[int]) -> Stated:
    """M itself, drawn with lines after some rows and columns (counted from 1, e.g. (2,) and (2,))."""
    return Stated("partitioned", (matrix, tuple(rows), tuple(columns)))


def rank(matrix: Any) -> Stated:
    """rank M; with parameters the generic one."""
    return Stated("rank", (matrix,))


def trace(matrix: Any) -> Stated:
    """Tr M."""
    return Stated("trace", (matrix,))


def inverse(matrix: Any) -> Stated:
    """M⁻¹."""
    return Stated("inverse", (matrix,))


def transpose(matrix: Any) -> Stated:
    """Mᵀ."""
    return Stated("transpose", (matrix,))


def product(*factors: Any) -> Stated:
    """F₁ F₂ … in the order written; factors are scalars or matrices of fitting shapes."""
    return Stated("product", factors)


def total(*terms: Any) -> Stated:
    """T₁ + T₂ + … in the order written."""
    return Stated("total", terms)


def difference(left: Any, right: Any) -> Stated:
    """L − R."""
    return Stated("difference", (left, right))


def quotient(numerator: Any, denominator: Any) -> Stated:
    """A fraction; the numerator may be a matrix, the denominator is a scalar."""
    return Stated("quotient", (numerator, denominator))


def power(base: Any, exponent: Any) -> Stated:
    """Bᵏ; a square matrix takes an integer exponent."""
    return Stated("power", (base, exponent))


def exponential(exponent: Any) -> Stated:
    """e^X of a scalar or of a square matrix."""
    return Stated("exponential", (exponent,))


def inverse_laplace(image: Any, s: Any, t: Any) -> Stated:
    """ℒ⁻¹{F(s)}(t), t ≥ 0, of a rational F (a scalar or a matrix)."""
    return Stated("inverse_laplace", (image, s, t))


def inverse_z(image: Any, z: Any, k: Any) -> Stated:
    """𝒵⁻¹{F(z)}(k), k = 0, 1, …, of a rational F (a scalar or a matrix)."""
    return Stated("inverse_z", (image, z, k))


def derivative(function: Any, variable: Any, order: int = 1) -> Stated:
    """dᵐf/dxᵐ."""
    return Stated("derivative", (function, variable, order))


def integral(integrand: Any, variable: Any, lower: Any, upper: Any) -> Stated:
    """∫ f dx from `lower` to `upper`."""
    return Stated("integral", (integrand, variable, lower, upper))


def summation(term: Any, index: Any, lower: Any, upper: Any) -> Stated:
    """Σ T(i) for i from `lower` to `upper`, whole numbers."""
    return Stated("summation", (term, index, lower, upper))


def value_at(function: Any, variable: Any, value: Any) -> Stated:
    """f(x) at x = `value`."""
    return Stated("value_at", (function, variable, value))
