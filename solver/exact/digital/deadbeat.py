"""States that an input brings to rest in so many steps, exact: S₀ = 0, Sₖ₊₁ = {x : A x ∈ Sₖ + im B}.

A state x(k+1) = A x(k) + B u(k) can be brought to zero in ν steps exactly if it is in S_ν; with u = −K x, where
A v − B K v ∈ Sₖ for each v of Sₖ₊₁, it is. Source: C. T. Mullis, Time optimal discrete regulator gains, IEEE Trans.
Automatic Control 17 (1972).
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.fields import domain_matrix, matrix_of
from solver.exact.linear_algebra.row_reduction import null_space, row_reduce


@dataclass(frozen=True)
class Stage:
    """States V (n×r) that need a step more than those before: the inputs −W (m×r) take them to `image` among these."""

    V: sp.ImmutableMatrix
    W: sp.ImmutableMatrix
    image: sp.ImmutableMatrix


def stages_to_rest(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix) -> tuple[Stage, ...]:
    """Return the stages of A n×n and B n×m; their V side by side are a basis of the states that can be brought to rest.

    Raises NotExact.
    """
    n = A.rows
    whole = domain_matrix(sp.Matrix.hstack(A, B))
    a, b = whole[:, :n], whole[:, n:]
    known = DomainMatrix.zeros((n, 0), whole.domain).to_dense()
    stages: list[Stage] = []
    while known.shape[1] < n:
        reached = known.hstack(b)
        V = _completing(known, _mapped_into(a, reached))
        if not V.shape[1]:
            break
        W = _solved(reached, a * V)[known.shape[1] :, :]
        stages.append(Stage(matrix_of(V), matrix_of(W), matrix_of(a * V - b * W)))
        known = known.hstack(V)
    return tuple(stages)


def _mapped_into(a: DomainMatrix, reached: DomainMatrix) -> DomainMatrix:
    """A basis of {x : A x ∈ im M} as columns: where N A x = 0 for all N with N M = 0."""
    K, n = a.domain, a.shape[0]
    left = null_space(row_reduce(_rows(reached.transpose())), K.one)
    if not left:
        return DomainMatrix.eye(n, K).to_dense()
    N = DomainMatrix([list(row) for row in left], (len(left), n), K)
    found = null_space(row_reduce(_rows(N * a)), K.one)
    return DomainMatrix([list(v) for v in found], (len(found), n), K).transpose()


def _rows(M: DomainMatrix) -> tuple[tuple[object, ...], ...]:
    return tuple(map(tuple, M.to_list()))


def _completing(known: DomainMatrix, candidates: DomainMatrix) -> DomainMatrix:
    """The candidates that do not depend on the known columns and the candidates before them."""
    k = known.shape[1]
    chosen = [j - k for j in row_reduce(_rows(known.hstack(candidates))).pivots if j >= k]
    return candidates.extract(list(range(candidates.shape[0])), chosen)


def _solved(M: DomainMatrix, right: DomainMatrix) -> DomainMatrix:
    """A solution X of M X = right, which has one; zero where X is free."""
    reduction = row_reduce(_rows(M.hstack(right)))
    X = [[M.domain.zero] * right.shape[1] for _ in range(M.shape[1])]
    for i, pivot in enumerate(reduction.pivots):
        X[pivot] = list(reduction.reduced[i][M.shape[1] :])
    return DomainMatrix(X, (M.shape[1], right.shape[1]), M.domain)
