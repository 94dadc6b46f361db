"""Steady states that hold an output at a reference, and plants with integrators, exact."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from solver.exact.fields import domain_matrix
from solver.exact.matrices import inverse, multiply
from solver.exact.placement import tidy


@dataclass(frozen=True)
class SteadyState:
    """The equations M [F; N] = [0; I] of x_d = F r, u_d = N r with their solution (None if there is none for every r).

    M = [[A₀, B], [C, D]] ((n+p)×(n+m)), A₀ = A, in discrete time A − I; `order` is its rank. `unique`: no other F, N.
    """

    M: sp.ImmutableMatrix
    right: sp.ImmutableMatrix
    order: int
    F: sp.ImmutableMatrix | None
    N: sp.ImmutableMatrix | None
    unique: bool


def at_rest(A: sp.ImmutableMatrix, *, discrete: bool) -> sp.ImmutableMatrix:
    """Return A₀ with A₀ x + B u = 0 in a steady state: A, in discrete time A − I."""
    return sp.ImmutableMatrix(A - sp.eye(A.rows)) if discrete else A


def steady_state(
    A: sp.ImmutableMatrix,
    B: sp.ImmutableMatrix,
    C: sp.ImmutableMatrix,
    D: sp.ImmutableMatrix,
    *,
    discrete: bool = False,
) -> SteadyState:
    """Solve A₀ F + B N = 0, C F + D N = I for F (n×m) and N (m×p); the shortest solution where there are many."""
    n, p = A.rows, C.rows
    M = sp.ImmutableMatrix(sp.BlockMatrix([[at_rest(A, discrete=discrete), B], [C, D]]).as_explicit())
    right = sp.ImmutableMatrix(sp.Matrix.vstack(sp.zeros(n, p), sp.eye(p)))
    order = int(domain_matrix(M).rank())
    if order < n + p:
        return SteadyState(M, right, order, None, None, False)
    square = M.rows == M.cols
    solution = multiply(inverse(M) if square else right_inverse(M), right)
    return SteadyState(
        M, right, order, sp.ImmutableMatrix(solution[:n, :]), sp.ImmutableMatrix(solution[n:, :]), square
    )


def right_inverse(M: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    """Return Mᵀ (M Mᵀ)⁻¹ of M with independent rows."""
    transposed = sp.ImmutableMatrix(M.T)
    return multiply(transposed, inverse(multiply(M, transposed)))


def with_integrators(
    A: sp.ImmutableMatrix,
    B: sp.ImmutableMatrix,
    C: sp.ImmutableMatrix,
    D: sp.ImmutableMatrix,
    *,
    discrete: bool = False,
) -> tuple[sp.ImmutableMatrix, sp.ImmutableMatrix]:
    """Return Ā and B̄ of (x, ξ) with ξ' = r − y (discrete: ξ(k+1) = ξ(k) + r(k) − y(k)), without r."""
    n, p = A.rows, C.rows
    corner = sp.eye(p) if discrete else sp.zeros(p)
    augmented = sp.Matrix.vstack(sp.Matrix.hstack(A, sp.zeros(n, p)), sp.Matrix.hstack(-C, corner))
    return sp.ImmutableMatrix(augmented), sp.ImmutableMatrix(sp.Matrix.vstack(sp.Matrix(B), sp.Matrix(-D)))


def added(*terms: sp.MatrixBase) -> sp.ImmutableMatrix:
    """Return the sum of matrices, entries tidied."""
    total = sp.Matrix(terms[0])
    for term in terms[1:]:
        total += term
    return sp.ImmutableMatrix(total.applyfunc(tidy))
