"""Kalman's decompositions: coordinates x = T ξ that keep apart what no input reaches and what no output shows.

Every subspace is found by row reduction over the field K of the entries; with parameters in it ranks are generic.
Source: R. E. Kalman, Mathematical description of linear dynamical systems, SIAM J. Control 1 (1963); bases as columns
of the controllability matrix and of the orthogonal complement: Lecture note, equations (2.4.20) and (2.4.21).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.fields import Algebraic, Modulus, domain_matrix, matrix_of
from solver.exact.linear_algebra.multiples import cleared
from solver.exact.linear_algebra.row_reduction import null_space, row_reduce
from solver.exact.linear_algebra.spectrum import spectrum


@dataclass(frozen=True)
class Decomposition:
    """T = [bases₁, bases₂, …] (n×n), A = T⁻¹ A₀ T, B = T⁻¹ B₀, C = C₀ T (None where not given).

    `orders` are the numbers of columns of the bases; some may be zero. The first part is what is controllable,
    observable, or both; the others are hidden. `reached` are independent columns of the controllability matrix,
    `unseen` a basis of the null space of the observability matrix (None where the question does not need them).
    """

    bases: tuple[sp.ImmutableMatrix, ...]
    T: sp.ImmutableMatrix
    T_inverse: sp.ImmutableMatrix
    A: sp.ImmutableMatrix
    B: sp.ImmutableMatrix | None
    C: sp.ImmutableMatrix | None
    reached: sp.ImmutableMatrix | None = None
    unseen: sp.ImmutableMatrix | None = None

    @property
    def orders(self) -> list[int]:
        """The dimensions of the parts."""
        return [basis.cols for basis in self.bases]

    @property
    def trivial(self) -> bool:
        """Whether nothing is hidden."""
        return self.orders[0] == self.T.rows

    @property
    def changes(self) -> bool:
        """Whether T is more than the identity."""
        return not self.T.is_Identity

    def block(self, i: int, j: int) -> sp.ImmutableMatrix:
        """The block of A in row i and column j of the partition (from 0)."""
        rows, columns = self._span(i), self._span(j)
        return sp.ImmutableMatrix(self.A[rows, columns])

    def input_block(self, i: int) -> sp.ImmutableMatrix | None:
        """The rows of B that act on part i."""
        return None if self.B is None else sp.ImmutableMatrix(self.B[self._span(i), :])

    def output_block(self, j: int) -> sp.ImmutableMatrix | None:
        """The columns of C that see part j."""
        return None if self.C is None else sp.ImmutableMatrix(self.C[:, self._span(j)])

    def modes(self, i: int) -> list[sp.Expr]:
        """The eigenvalues of part i with multiplicity; raises NotExact."""
        return spectrum(self.block(i, i)).eigenvalues if self.orders[i] else []

    @cached_property
    def hidden_modes(self) -> list[sp.Expr]:
        """The eigenvalues of all parts but the first."""
        return [mode for i in range(1, len(self.bases)) for mode in self.modes(i)]

    def _span(self, i: int) -> slice:
        ends = list(accumulate(self.orders, initial=0))
        return slice(ends[i], ends[i + 1])


class _Plant:
    """A, B, C over one field K."""

    def __init__(self, A: sp.MatrixBase, B: sp.MatrixBase | None, C: sp.MatrixBase | None) -> None:
        n, m, p = A.rows, B.cols if B is not None else 0, C.rows if C is not None else 0
        whole = sp.zeros(n + p, n + m)
        whole[:n, :n] = A
        if B is not None:
            whole[:n, n:] = B
        if C is not None:
            whole[n:, :n] = C
        M = domain_matrix(whole)
        self.n, self.K = n, M.domain
        self.A, self.B, self.C = M[:n, :n], M[:n, n:] if m else None, M[n:, :n] if p else None

    def reachable(self) -> DomainMatrix:
        """[B, AB, …, Aⁿ⁻¹B]."""
        if self.B is None:
            raise ValueError("what is reachable depends on B")
        return _krylov(self.A, self.B)

    def seen(self) -> DomainMatrix:
        """[Cᵀ, AᵀCᵀ, …], the transposed observability matrix."""
        if self.C is None:
            raise ValueError("what is seen depends on C")
        return _krylov(self.A.transpose(), self.C.transpose())

    def unseen(self) -> DomainMatrix:
        """A basis of the null space of the observability matrix, as columns."""
        return _null_space(self.seen().transpose())

    def in_bases(
        self, *bases: DomainMatrix, reached: DomainMatrix | None = None, unseen: DomainMatrix | None = None
    ) -> Decomposition:
        """The system in the coordinates of the bases, or as it stands if the first spans everything."""
        if bases[0].shape[1] == self.n:
            bases = (DomainMatrix.eye(self.n, self.K).to_dense(), *bases[1:])
        T = bases[0].hstack(*bases[1:])
        inverse = T.inv()
        return Decomposition(
            bases=tuple(_written(basis) for basis in bases),
            T=_written(T),
            T_inverse=_written(inverse),
            A=_written(inverse * self.A * T),
            B=None if self.B is None else _written(inverse * self.B),
            C=None if self.C is None else _written(self.C * T),
            reached=None if reached is None else _written(reached),
            unseen=None if unseen is None else _written(unseen),
        )


def controllable_decomposition(A: sp.MatrixBase, B: sp.MatrixBase, C: sp.MatrixBase | None = None) -> Decomposition:
    """Return A = [[A_c, A₁₂], [0, A_c̄]], B = [[B_c], [0]] (A n×n, B n×m, C p×n); raises NotExact.

    T = [independent columns of the controllability matrix, basis of their orthogonal complement].
    """
    plant = _Plant(A, B, C)
    reached = _independent(plant.reachable())
    return plant.in_bases(reached, _null_space(reached.transpose()), reached=reached)


def controllable_part(A: sp.MatrixBase, B: sp.MatrixBase) -> Decomposition:
    """The controllable decomposition with unit vectors in place of the orthogonal complement; raises NotExact.

    What is not reached is then shown by single states, and a gain may act on these as it likes.
    """
    plant = _Plant(A, B, None)
    reached = _independent(plant.reachable())
    rows = _pivots(reached.transpose()) if reached.shape[1] else ()
    others = [i for i in range(plant.n) if i not in rows]
    return plant.in_bases(reached, _units(plant, others))


def reached_in_echelon(A: sp.MatrixBase, B: sp.MatrixBase, C: sp.MatrixBase) -> Decomposition:
    """The controllable decomposition with the smallest entries that row operations give; raises NotExact.

    T = [nonzero rows of the echelon form of the transposed controllability matrix, unit vectors], so that the new
    states of the controllable part are some of the old ones as far as these are reached.
    """
    plant = _Plant(A, B, C)
    rows, others = _echelon(plant.reachable().transpose())
    return plant.in_bases(rows.transpose(), _units(plant, others))


def seen_in_echelon(A: sp.MatrixBase, B: sp.MatrixBase, C: sp.MatrixBase) -> Decomposition:
    """The observable decomposition with unit vectors for what is seen; raises NotExact.

    T = [unit vectors at the pivots of the observability matrix, basis of its null space], so that the observable part
    has their columns of C, and the nonzero rows of the echelon form times B.
    """
    plant = _Plant(A, B, C)
    _, others = _echelon(plant.seen().transpose())
    return plant.in_bases(_units(plant, [i for i in range(plant.n) if i not in others]), plant.unseen())


def observable_decomposition(A: sp.MatrixBase, B: sp.MatrixBase | None, C: sp.MatrixBase) -> Decomposition:
    """Return A = [[A_o, 0], [A₂₁, A_ō]], C = [C_o, 0] (A n×n, B n×m, C p×n); raises NotExact.

    T = [independent rows of the observability matrix as columns, basis of its null space].
    """
    plant = _Plant(A, B, C)
    return plant.in_bases(_independent(plant.seen()), plant.unseen(), unseen=plant.unseen())


def kalman_decomposition(A: sp.MatrixBase, B: sp.MatrixBase, C: sp.MatrixBase) -> Decomposition:
    """Return the four parts: controllable and observable, controllable only, observable only, neither.

    With R the reachable and N the unseen subspace: the second basis is of R ∩ N, the first completes it to R (columns
    of the controllability matrix), the fourth completes it to N, the third is of the orthogonal complement of R + N.
    Raises NotExact.
    """
    plant = _Plant(A, B, C)
    reachable, unseen = plant.reachable(), plant.unseen()
    reached = _independent(reachable)
    both = _cleared_columns(reached * _null_space(plant.seen().transpose() * reached))
    first = _completing(both, reachable)
    fourth = _completing(both, unseen)
    third = _null_space(first.hstack(both, fourth).transpose())
    return plant.in_bases(first, both, third, fourth, reached=reached, unseen=unseen)


def independent_columns(M: sp.MatrixBase) -> tuple[int, ...]:
    """The numbers (from 0) of the columns of M that do not depend on those before them; raises NotExact."""
    return _pivots(domain_matrix(M))


def _written(M: DomainMatrix) -> sp.ImmutableMatrix:
    """The matrix as expressions; over surds and parameters with monic denominators, which sympy does not make so."""
    K: Any = M.domain
    if not (K.is_FractionField and K.domain.is_Algebraic):
        return matrix_of(M)

    def monic(x: Any) -> Any:
        lead = x.denom.LC
        return x.raw_new(x.numer.quo_ground(lead), x.denom.quo_ground(lead))

    return matrix_of(DomainMatrix([[monic(x) for x in row] for row in M.to_list()], M.shape, K))


def _krylov(A: DomainMatrix, B: DomainMatrix) -> DomainMatrix:
    blocks = [B]
    for _ in range(A.shape[0] - 1):
        blocks.append(A * blocks[-1])
    return blocks[0].hstack(*blocks[1:])


def _columns(M: DomainMatrix, chosen: list[int]) -> DomainMatrix:
    return M.extract(list(range(M.shape[0])), chosen)


def _independent(M: DomainMatrix) -> DomainMatrix:
    """The columns of M that do not depend on those before them."""
    return _columns(M, list(_pivots(M)))


def _pivots(M: DomainMatrix) -> tuple[int, ...]:
    return row_reduce(tuple(map(tuple, M.to_list()))).pivots


def _echelon(M: DomainMatrix) -> tuple[DomainMatrix, list[int]]:
    """The nonzero rows of the reduced row echelon form, and the columns without a pivot."""
    found = row_reduce(tuple(map(tuple, M.to_list())))
    r = len(found.pivots)
    rows = DomainMatrix([list(row) for row in found.reduced[:r]], (r, M.shape[1]), M.domain)
    return rows, [j for j in range(M.shape[1]) if j not in found.pivots]


def _units(plant: _Plant, chosen: list[int]) -> DomainMatrix:
    """The unit vectors of these numbers as columns."""
    return _columns(DomainMatrix.eye(plant.n, plant.K).to_dense(), chosen)


def _completing(known: DomainMatrix, candidates: DomainMatrix) -> DomainMatrix:
    """The candidates that do not depend on the known columns and the candidates before them."""
    k = known.shape[1]
    return _columns(candidates, [j - k for j in _pivots(known.hstack(candidates)) if j >= k])


def _null_space(M: DomainMatrix) -> DomainMatrix:
    """A basis of {v : M v = 0} as columns, without fractions; all of Kⁿ if M has no rows."""
    K, columns = M.domain, M.shape[1]
    if not M.shape[0]:
        return DomainMatrix.eye(columns, K).to_dense()
    return _of_columns(null_space(row_reduce(tuple(map(tuple, M.to_list()))), K.one), columns, K)


def _cleared_columns(M: DomainMatrix) -> DomainMatrix:
    return _of_columns([tuple(column) for column in M.transpose().to_list()], M.shape[0], M.domain)


def _of_columns(vectors: list[tuple[Any, ...]], rows: int, K: Any) -> DomainMatrix:
    """Vectors as the columns of a matrix, each times the factor that clears its fractions; the last entry positive."""
    scaled = [_whole(v, K) for v in vectors]
    return DomainMatrix([list(v) for v in scaled], (len(scaled), rows), K).transpose()


def _whole(v: tuple[Any, ...], K: Any) -> tuple[Any, ...]:
    trivial = Modulus((K.zero,), K)
    multiple = [a.coefficients[0] for a in cleared(tuple(Algebraic((x,), trivial) for x in v))]
    last = next(x for x in reversed(multiple) if x)
    return tuple(-x for x in multiple) if K.is_QQ and last < 0 else tuple(multiple)
