"""Lyapunov equations, exact: one linear system for the entries of P on and above the diagonal.

AᵀP + PA = −Q; dual: AP + PAᵀ = −Q; in discrete time AᵀPA − P = −Q, dual: APAᵀ − P = −Q.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.fields import domain_matrix, matrix_of


class SingularEquation(ArithmeticError):  # noqa: N818 - the equation is singular; nothing went wrong
    """The Lyapunov equation has no solution, or more than one; `solvable` tells which."""

    def __init__(self, solvable: bool) -> None:
        super().__init__(solvable)
        self.solvable = solvable


def lyapunov(A: sp.MatrixBase, Q: sp.MatrixBase, *, dual: bool = False, discrete: bool = False) -> sp.ImmutableMatrix:
    """Return the symmetric P (n×n) of the Lyapunov equation for symmetric Q (n×n).

    Raises SingularEquation where two eigenvalues add up to zero (discrete: multiply to one), NotExact for entries
    without exact arithmetic, ValueError for a Q that is not symmetric.
    """
    n = A.rows
    if Q.shape != (n, n) or Q != Q.T:
        raise ValueError("Q must be symmetric and of the size of A")
    F, constant = _over_one_field(A, Q)
    pairs = _pairs(n)
    M = _operator(F.transpose() if dual else F, pairs, discrete=discrete)
    negative = DomainMatrix([[-constant.to_list()[i][j]] for i, j in pairs], (len(pairs), 1), F.domain)
    reduced, pivots = M.hstack(negative).rref()
    if pivots != tuple(range(len(pairs))):
        raise SingularEquation(len(pairs) not in pivots)
    flat = matrix_of(reduced.extract(list(range(len(pairs))), [len(pairs)])).flat()
    values = dict(zip(pairs, flat, strict=True))
    return sp.ImmutableMatrix(n, n, lambda i, j: values[min(i, j), max(i, j)])


def lyapunov_residual(
    A: sp.MatrixBase, P: sp.MatrixBase, Q: sp.MatrixBase, *, dual: bool = False, discrete: bool = False
) -> sp.ImmutableMatrix:
    """Return AᵀP + PA + Q (discrete: AᵀPA − P + Q; dual: with Aᵀ for A), entries expanded; zero for a solution."""
    F = A.T if dual else A
    left = F.T * P * F - P if discrete else F.T * P + P * F
    return sp.ImmutableMatrix(left + Q).applyfunc(sp.expand)


@dataclass(frozen=True)
class Unknowns:
    """The unknown symmetric P, its entries on and above the diagonal, and the linear equations for them (= 0)."""

    P: sp.ImmutableMatrix
    symbols: tuple[sp.Symbol, ...]
    equations: tuple[sp.Expr, ...]


def lyapunov_equations(A: sp.MatrixBase, Q: sp.MatrixBase, *, dual: bool = False, discrete: bool = False) -> Unknowns:
    """Write the Lyapunov equation entry by entry with unknowns p11, p12, … of a symmetric P."""
    n = A.rows
    P = sp.ImmutableMatrix(n, n, lambda i, j: sp.Symbol(f"p{min(i, j) + 1}{max(i, j) + 1}"))
    residual = lyapunov_residual(A, P, Q, dual=dual, discrete=discrete)
    pairs = _pairs(n)
    return Unknowns(P, tuple(P[i, j] for i, j in pairs), tuple(residual[i, j] for i, j in pairs))


def _over_one_field(A: sp.MatrixBase, Q: sp.MatrixBase) -> tuple[DomainMatrix, DomainMatrix]:
    n = A.rows
    stacked = domain_matrix(sp.Matrix.vstack(sp.Matrix(A), sp.Matrix(Q)))
    columns = list(range(n))
    return stacked.extract(columns, columns), stacked.extract([n + i for i in columns], columns)


def _pairs(n: int) -> list[tuple[int, int]]:
    return [(i, j) for i in range(n) for j in range(i, n)]


def _operator(F: DomainMatrix, pairs: list[tuple[int, int]], *, discrete: bool) -> DomainMatrix:
    """The matrix of P ↦ FᵀP + PF (discrete: FᵀPF − P) on the entries on and above the diagonal."""
    K, a = F.domain, F.to_list()
    place = {pair: index for index, pair in enumerate(pairs)}
    rows = [[K.zero] * len(pairs) for _ in pairs]
    indices = range(len(a))
    for (i, j), row in zip(pairs, rows, strict=True):
        for k in indices:
            if discrete:
                for m in indices:
                    row[place[min(k, m), max(k, m)]] += a[k][i] * a[m][j]
            else:
                row[place[min(k, j), max(k, j)]] += a[k][i]
                row[place[min(i, k), max(i, k)]] += a[k][j]
        if discrete:
            row[place[i, j]] -= K.one
    return DomainMatrix(rows, (len(pairs), len(pairs)), K)
