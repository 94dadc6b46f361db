"""For observers: coordinates in which the measured quantities come first, and gains by choice of A − LC."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from solver.exact.linear_algebra.fields import domain_matrix
from solver.exact.linear_algebra.matrices import inverse, multiply
from solver.exact.linear_algebra.radicals import complex_parts


@dataclass(frozen=True)
class Partition:
    """A system in coordinates η = Q x, of which the first p are the outputs: C T = [I, 0] with T = Q⁻¹ (n×n).

    `A` = Q A T, `B` = Q B; `unmeasured` are the states (from 0) that make up η₂; in a `permutation` η₁ are states too.
    """

    p: int
    T: sp.ImmutableMatrix
    Q: sp.ImmutableMatrix
    A: sp.ImmutableMatrix
    B: sp.ImmutableMatrix
    unmeasured: tuple[int, ...]
    permutation: bool

    @property
    def blocks(self) -> dict[str, sp.ImmutableMatrix]:
        """A11 (p×p), A12, A21, A22 (n−p × n−p), B1, B2."""
        p, A, B = self.p, self.A, self.B
        return {
            "A11": A[:p, :p],
            "A12": A[:p, p:],
            "A21": A[p:, :p],
            "A22": A[p:, p:],
            "B1": B[:p, :],
            "B2": B[p:, :],
        }


def measured_first(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix, C: sp.ImmutableMatrix) -> Partition:
    """Return the partition for A n×n, B n×m, C p×n: Q = [C; E], the rows of E being states in their order.

    Raises ValueError if the rows of C are dependent, NotExact for entries without exact arithmetic.
    """
    n, pivots = A.rows, _pivots(C)
    if len(pivots) < C.rows:
        raise ValueError("the outputs are not independent")
    unmeasured = tuple(j for j in range(n) if j not in pivots)
    Q = sp.ImmutableMatrix(sp.Matrix.vstack(C, *(sp.eye(n)[j, :] for j in unmeasured)))
    permutation = all(sorted(row, key=str) == [0] * (n - 1) + [1] for row in C.tolist())
    T = sp.ImmutableMatrix(Q.T) if permutation else inverse(Q)
    return Partition(C.rows, T, Q, multiply(multiply(Q, A), T), multiply(Q, B), unmeasured, permutation)


def _pivots(C: sp.ImmutableMatrix) -> tuple[int, ...]:
    """Columns of C that are independent, those without parameters before others: no division by what may be zero."""
    order = sorted(range(C.cols), key=lambda j: (any(entry.free_symbols for entry in C[:, j]), j))
    _, pivots = domain_matrix(C[:, order]).rref()
    return tuple(sorted(order[pivot] for pivot in pivots))


def chosen_error_matrix(poles: Sequence[sp.Expr]) -> sp.ImmutableMatrix:
    """A real matrix with these eigenvalues, on its diagonal: a pair σ ± jω as [[σ, ω], [−ω, σ]]."""
    blocks: list[sp.Matrix] = []
    left = list(poles)
    while left:
        pole = left.pop(0)
        sigma, omega = (sp.expand(part) for part in complex_parts(pole)) if pole.has(sp.I) else (pole, 0)
        if omega == 0:
            blocks.append(sp.Matrix([[sigma]]))
            continue
        left.remove(_nearest(left, sp.conjugate(pole)))
        blocks.append(sp.Matrix([[sigma, abs(omega)], [-abs(omega), sigma]]))
    return sp.ImmutableMatrix(sp.diag(*blocks))


def _nearest(values: Sequence[sp.Expr], wanted: sp.Expr) -> sp.Expr:
    """The value equal to the one wanted; of decimals the nearest."""
    exact = [value for value in values if sp.expand(value - wanted) == 0]
    return exact[0] if exact else min(values, key=lambda value: float(abs(sp.N(value - wanted))))


def left_inverse(C: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    """(CᵀC)⁻¹Cᵀ (n×p) of a C (p×n) whose columns are independent; raises ZeroDivisionError if they are not."""
    Ct = sp.ImmutableMatrix(C.T)
    return multiply(inverse(multiply(Ct, C)), Ct)
