"""Set points: the state and input at which a plant rests with its outputs at r, for every r."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.design.tracking import at_rest
from solver.exact.linear_algebra.fields import collected, domain_matrix, matrix_of, vanishing_factors


class NoSetPoint(Exception):  # noqa: N818 - a finding
    """Not every reference can be held; `rank` of the n + p equations is less than they need."""

    def __init__(self, rank: int) -> None:
        super().__init__(f"rank {rank}")
        self.rank = rank


@dataclass(frozen=True)
class SetPoint:
    """F (n×p) and N (m×p) with A F + B N = 0 (discrete: F) and C F + D N = I; `rank` is that of [[A, B], [C, D]].

    Where there are several, the one with the least xᵀx + uᵀu. `exceptions`: where the parameters make it another case.
    """

    matrix: sp.ImmutableMatrix
    F: sp.ImmutableMatrix
    N: sp.ImmutableMatrix
    rank: int
    exceptions: tuple[sp.Basic, ...] = ()

    @property
    def right(self) -> sp.ImmutableMatrix:
        """[0; I], the right side of the equations ((n+p)×p)."""
        return held(self.F.rows, self.F.cols)

    @property
    def stacked(self) -> sp.ImmutableMatrix:
        """[F; N], the solution of the equations ((n+m)×p)."""
        return sp.ImmutableMatrix(self.F.col_join(self.N))

    @property
    def unique(self) -> bool:
        """Whether there is only one."""
        return bool(self.rank == self.matrix.cols)


def held(n: int, p: int) -> sp.ImmutableMatrix:
    """[0; I]: the state (n) rests and the output (p) is the reference."""
    return sp.ImmutableMatrix(sp.zeros(n, p).col_join(sp.eye(p)))


def equations_of_rest(
    A: sp.MatrixBase, B: sp.MatrixBase, C: sp.MatrixBase, D: sp.MatrixBase, *, discrete: bool = False
) -> sp.ImmutableMatrix:
    """[[A, B], [C, D]] ((n+p)×(n+m)), in discrete time [[A − I, B], [C, D]]."""
    return sp.ImmutableMatrix(sp.Matrix(sp.BlockMatrix([[at_rest(A, discrete=discrete), B], [C, D]])))


def set_point(
    A: sp.MatrixBase, B: sp.MatrixBase, C: sp.MatrixBase, D: sp.MatrixBase, *, discrete: bool = False
) -> SetPoint:
    """Solve [[A, B], [C, D]] [F; N] = [0; I] (discrete: with A − I); A n×n, B n×m, C p×n, D p×m.

    The least solution is M⁺ [0; I], M⁺ the pseudoinverse. Raises NoSetPoint, NotExact.
    """
    n, m, p = A.rows, B.cols, C.rows
    whole = equations_of_rest(A, B, C, D, discrete=discrete)
    M, right = domain_matrix(whole).unify(domain_matrix(held(n, p)).to_field())
    order = int(M.rank())
    if M.hstack(right).rank() > order:
        raise NoSetPoint(order)
    found = _least(M, right, order)
    values = matrix_of(found).applyfunc(collected)
    exceptions = _exceptions(M) if order == n + p == n + m else ()
    return SetPoint(whole, sp.ImmutableMatrix(values[:n, :]), sp.ImmutableMatrix(values[n:, :]), order, exceptions)


def _least(M: DomainMatrix, right: DomainMatrix, rank: int) -> DomainMatrix:
    """The solution of M X = right in the row space of M: X = Wᵀ Y with independent rows W, (W Wᵀ) Y = their right."""
    rows = list(M.transpose().rref()[1])[:rank]  # rows that span the row space
    columns = list(range(M.shape[1]))
    W = M.extract(rows, columns)
    chosen = right.extract(rows, list(range(right.shape[1])))
    if len(rows) == M.shape[1]:
        return W.lu_solve(chosen)
    return W.transpose() * (W * W.transpose()).lu_solve(chosen)


def _exceptions(M: DomainMatrix) -> tuple[sp.Basic, ...]:
    """Where the determinant of a square M vanishes."""
    return tuple(sp.Eq(factor, 0) for factor in vanishing_factors(M.domain.to_sympy(M.det())))
