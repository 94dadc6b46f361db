"""The controllability matrix, over the rational numbers in integers: with A = F/f and B = G/h it is Aⁱb = Fⁱg/(fⁱh)."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from solver.exact.linear_algebra.fields import domain_matrix, matrix_of, side_by_side
from solver.exact.linear_algebra.integers import are_rational, integer_rows, times
from solver.matrices import entries


def controllability_matrix(A: sp.MatrixBase, B: sp.MatrixBase) -> sp.ImmutableMatrix:
    """Return [B, AB, …, Aⁿ⁻¹B] (n × nm) for A n×n and B n×m; raises NotExact."""
    flat_A, flat_B = entries(A), entries(B)
    if are_rational(flat_A) and are_rational(flat_B):
        return _integer_controllability_matrix(flat_A, flat_B, B.cols)
    M, block = side_by_side(A, B)
    blocks = [block]
    for _ in range(A.rows - 1):
        blocks.append(M * blocks[-1])
    return matrix_of(blocks[0].hstack(*blocks[1:]))


def reachable_order(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix) -> int:
    """Return the rank of the controllability matrix (for general parameters)."""
    return int(domain_matrix(controllability_matrix(A, B)).rank())


def _integer_controllability_matrix(A: Sequence[sp.Rational], B: Sequence[sp.Rational], m: int) -> sp.ImmutableMatrix:
    n = len(B) // m
    (F, f), (G, h) = integer_rows(A, n), integer_rows(B, m)
    vectors = [list(column) for column in zip(*G, strict=True)]
    columns: list[list[sp.Rational]] = []
    scale = h
    for _ in range(n):
        columns += [[sp.Rational(x, scale) for x in v] for v in vectors]
        vectors, scale = [times(F, v) for v in vectors], scale * f
    return sp.ImmutableMatrix(n, n * m, [columns[j][i] for i in range(n) for j in range(n * m)])
