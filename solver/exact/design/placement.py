"""Pole placement for one input, exact: polynomials, the linear equations for the gain, canonical coordinates.

Everything is about a pair (A, b), A n×n and b n×1, and k (1×n) in u = −k x. With χ(s) = sⁿ + a₁sⁿ⁻¹ + … + aₙ and
adj(sI − A) = Σ Nⱼ sⁿ⁻¹⁻ʲ, det(sI − A + bk) = χ(s) + k adj(sI − A) b, so the coefficient of sⁿ⁻¹⁻ʲ is aⱼ₊₁ + k Nⱼ b.
Coefficients of the desired polynomial may be any expressions (decimals, logarithms, symbols): the gain is affine in
them, and only A and b need exact arithmetic.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import reduce
from itertools import pairwise

import sympy as sp

from solver.exact.design.pole_mapping import without_squared_sines
from solver.exact.linear_algebra.affine import affine, tidy
from solver.exact.linear_algebra.faddeev import faddeev_leverrier
from solver.exact.linear_algebra.fields import domain_matrix, expression
from solver.exact.linear_algebra.matrices import inverse, multiply, powers
from solver.exact.linear_algebra.spectrum import spectrum
from solver.exact.structure.controllability import controllability_matrix

Coefficients = tuple[sp.Expr, ...]


def monic(roots: Iterable[sp.Expr]) -> Coefficients:
    """Return 1, c₁, …, cₙ of Π(x − root), highest power first; conjugate roots give real coefficients."""
    coefficients: list[sp.Expr] = [sp.Integer(1)]
    for root in roots:
        shifted = [*coefficients, sp.Integer(0)]
        coefficients = [shifted[0]] + [sp.expand(c - root * previous) for previous, c in pairwise(shifted)]
    return tuple(without_squared_sines(_real_part_of_decimals(c)) for c in coefficients)


def conjugate_pairs(roots: Sequence[sp.Expr]) -> tuple[list[tuple[sp.Expr, sp.Expr]], list[sp.Expr]]:
    """Return (σ, ω) of the pairs σ ± jω among roots, and the other roots."""
    pairs: list[tuple[sp.Expr, sp.Expr]] = []
    others: list[sp.Expr] = []
    left = list(roots)
    while left:
        root = left.pop(0)
        partner = next((each for each in left if root.has(sp.I) and _are_conjugate(root, each)), None)
        if partner is None:
            others.append(root)
            continue
        left.remove(partner)
        sigma, omega = sp.expand((root + partner) / 2), sp.expand((root - partner) / (2 * sp.I))
        pairs.append((sigma, -omega if omega.could_extract_minus_sign() else omega))
    return pairs, others


def _are_conjugate(root: sp.Expr, other: sp.Expr) -> bool:
    return not any(sp.expand(each).has(sp.I) for each in (root + other, root * other))


def _real_part_of_decimals(value: sp.Expr) -> sp.Expr:
    """Drop the imaginary rounding that conjugate decimals leave behind."""
    return sp.re(value) if value.has(sp.Float) and not value.free_symbols else value


def polynomial_in(x: sp.Symbol, coefficients: Sequence[sp.Expr]) -> sp.Expr:
    """Σ cᵢ xⁿ⁻ⁱ."""
    n = len(coefficients) - 1
    return sp.Add(*(c * x ** (n - i) for i, c in enumerate(coefficients)))


def polynomial_of_matrix(A: sp.ImmutableMatrix, coefficients: Sequence[sp.Expr]) -> sp.ImmutableMatrix:
    """Σ cᵢ Aⁿ⁻ⁱ (A square of any size)."""
    degree = len(coefficients) - 1
    total = sp.zeros(A.rows)
    for c, power in zip(coefficients, reversed(powers(A, degree + 1)), strict=True):
        total += c * power
    return sp.ImmutableMatrix(total.applyfunc(tidy))


def divided(coefficients: Sequence[sp.Expr], divisor: Sequence[sp.Expr]) -> Coefficients:
    """Return the quotient of a polynomial by a monic one that divides it (coefficients, highest power first)."""
    rest, quotient = list(coefficients), []
    while len(rest) >= len(divisor):
        lead = rest.pop(0)
        quotient.append(lead)
        for i, c in enumerate(divisor[1:]):
            rest[i] = tidy(rest[i] - lead * c)
    return tuple(quotient)


def gain_equations(A: sp.ImmutableMatrix, b: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    """Return the n×n matrix with the rows (Nⱼ b)ᵀ: the coefficient of sⁿ⁻¹⁻ʲ in det(sI − A + bk) is aⱼ₊₁ + row·kᵀ."""
    rows = [multiply(N, b).T for N in faddeev_leverrier(A).adjugate_coefficients]
    return sp.ImmutableMatrix(sp.Matrix.vstack(*map(sp.Matrix, rows)))


def toeplitz(coefficients: Sequence[sp.Expr]) -> sp.ImmutableMatrix:
    """Return W (n×n), upper triangular with 1, a₁, …, aₙ₋₁ in its first row: the matrix of Bass and Gura."""
    n = len(coefficients) - 1
    return sp.ImmutableMatrix(n, n, lambda i, j: coefficients[j - i] if j >= i else 0)


def companion_rows(A: sp.ImmutableMatrix, b: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    """Return P (n×n) with the rows q, qA, …, qAⁿ⁻¹, q the last row of [b, Ab, …, Aⁿ⁻¹b]⁻¹.

    ξ = P x brings the pair to controllable canonical form (coefficients in the last row). Raises ZeroDivisionError.
    """
    q = inverse(controllability_matrix(A, b)).row(A.rows - 1)
    rows = [sp.ImmutableMatrix(q)]
    for _ in range(A.rows - 1):
        rows.append(multiply(rows[-1], A))
    return sp.ImmutableMatrix(sp.Matrix.vstack(*map(sp.Matrix, rows)))


def combine(row: Sequence[sp.Expr], M: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    """Return row · M (1×columns) for a row of any expressions, each entry tidied."""
    product_ = sp.Matrix([list(row)]) * M
    return sp.ImmutableMatrix(product_.applyfunc(tidy))


def loop_coefficients(
    A: sp.ImmutableMatrix, b: sp.ImmutableMatrix, row: sp.ImmutableMatrix, unknowns: Sequence[sp.Symbol]
) -> Coefficients:
    """Return the coefficients of det(xI − A + b k), the row k affine in the unknowns."""
    moved = gain_equations(A, b) * row.T
    chi = faddeev_leverrier(A).coefficients
    return (
        sp.Integer(1),
        *(_collected(a + m, unknowns) for a, m in zip(chi[1:], moved.flat(), strict=True)),
    )


def _collected(value: sp.Expr, unknowns: Sequence[sp.Symbol]) -> sp.Expr:
    """Return c₀ + Σ cᵢ kᵢ with tidied coefficients."""
    M, (constant,) = affine([sp.expand(value)], unknowns)
    return sp.Add(constant, *(c * k for c, k in zip(M.flat(), unknowns, strict=True)))


def fixed_factor(
    A: sp.ImmutableMatrix, b: sp.ImmutableMatrix, row: sp.ImmutableMatrix, unknowns: Sequence[sp.Symbol]
) -> Coefficients:
    """Return the coefficients of the monic factor of det(xI − A + b k) that no values of the unknowns in k move.

    The determinant is p₀ + Σ θᵢ pᵢ with the unknowns θ; the factor is the greatest common divisor of p₀, p₁, ….
    """
    M, constant = affine(loop_coefficients(A, b, row, unknowns), unknowns)
    matrix = domain_matrix(sp.Matrix([constant, *M.T.tolist()]))
    x = sp.Dummy("x")
    polynomials = [sp.Poly.from_list(line, x, domain=matrix.domain) for line in matrix.to_list()]
    common = reduce(sp.gcd, polynomials).monic()
    return tuple(expression(common.domain, c) for c in common.rep.to_list())


def roots_of(coefficients: Sequence[sp.Expr]) -> list[sp.Expr]:
    """Return the roots of a monic polynomial with multiplicity, as `spectrum` finds them."""
    n = len(coefficients) - 1
    if n == 0:
        return []
    companion = sp.ImmutableMatrix(
        n, n, lambda i, j: -coefficients[n - j] if i == n - 1 else sp.Integer(int(j == i + 1))
    )
    return [root.value for root in spectrum(companion).roots for _ in range(root.multiplicity)]
