"""What the weights R and N of xᵀQx + 2xᵀNu + uᵀRu make of a plant."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from solver.exact.linear_algebra.fields import domain_matrix, matrix_of, side_by_side


def block_matrix(blocks: Sequence[Sequence[sp.MatrixBase]]) -> sp.ImmutableMatrix:
    """The matrix of these blocks, row by row."""
    rows = [[entry for M in line for entry in M.row(i)] for line in blocks for i in range(line[0].rows)]
    return sp.ImmutableMatrix(rows)


def weighted_input(B: sp.ImmutableMatrix, R: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    """G = B R⁻¹ Bᵀ (n×n)."""
    left, right = side_by_side(B, weighted_transpose(B, R))
    return matrix_of(left * right)


def weighted_transpose(B: sp.ImmutableMatrix, R: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    """R⁻¹ Bᵀ (m×n)."""
    wide = domain_matrix(sp.Matrix(sp.BlockMatrix([[R, B.T]])))
    return matrix_of(wide[:, : R.rows].lu_solve(wide[:, R.rows :]))


def completed_square(
    A: sp.ImmutableMatrix, B: sp.ImmutableMatrix, Q: sp.ImmutableMatrix, R: sp.ImmutableMatrix, N: sp.ImmutableMatrix
) -> tuple[sp.ImmutableMatrix, sp.ImmutableMatrix]:
    """A − B R⁻¹ Nᵀ and Q − N R⁻¹ Nᵀ (n×n): the problem of v = u + R⁻¹Nᵀx, whose cost has no products of x and v."""
    cross = domain_matrix(weighted_transpose(N, R))
    found = []
    for M, left in ((A, B), (Q, N)):
        whole, factor, right = domain_matrix(M).unify(domain_matrix(left), cross)
        found.append(matrix_of(whole - factor * right))
    return found[0], found[1]
