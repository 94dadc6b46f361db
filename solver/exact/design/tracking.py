"""Matrices of plants at rest and of plants with integrators, exact."""

from __future__ import annotations

import sympy as sp

from solver.exact.linear_algebra.affine import tidy


def at_rest(A: sp.MatrixBase, *, discrete: bool) -> sp.ImmutableMatrix:
    """Return A₀ with A₀ x + B u = 0 in a steady state: A, in discrete time A − I."""
    return sp.ImmutableMatrix(A - sp.eye(A.rows) if discrete else A)


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
