"""Ranks, what an input does not reach, and the parameters for which a rank drops; all by duality also for outputs.

For the pair (A, B) of n states the rows N of the left null space of [B, AB, …, Aⁿ⁻¹B] satisfy N B = 0 and N A = H N:
the combinations N x move by H alone, whatever the input does, so the eigenvalues of H are the hidden modes.
Transposed, (Aᵀ, Cᵀ) gives what the output does not see.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache, partial
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.fields import Algebraic, Modulus, domain_matrix, expression, matrix_of, side_by_side
from solver.exact.linear_algebra.instances import element_at
from solver.exact.linear_algebra.multiples import Vector, cleared
from solver.exact.linear_algebra.row_reduction import RowReduction, null_space, row_reduce
from solver.exact.linear_algebra.spectrum import Factor, Root, Spectrum, spectrum, split_over
from solver.exact.structure.controllability import controllability_matrix


def rank(M: sp.MatrixBase) -> int:
    """The rank of M over the field of its entries: with parameters the generic one. Raises NotExact."""
    return 0 if 0 in M.shape else int(domain_matrix(M).rank())


def row_reduction(M: sp.MatrixBase) -> RowReduction:
    """The row reduction of M (not empty, complex or real) with its operations, in expressions."""
    D = domain_matrix(M, real=False)
    return row_reduce(tuple(map(tuple, D.to_list()))).mapped(partial(expression, D.domain))


def null_basis(M: sp.MatrixBase) -> sp.ImmutableMatrix:
    """Columns that span {v : M v = 0} (q×k for M p×q), one for each free unknown, without fractions."""
    D = domain_matrix(M)
    trivial = Modulus((D.domain.zero,), D.domain)
    rows = tuple(tuple(Algebraic((c,), trivial) for c in row) for row in D.to_list())
    vectors = null_space(row_reduce(rows), Algebraic((D.domain.one,), trivial))
    columns = [[expression(D.domain, a.coefficients[0]) for a in _free_positive(cleared(v))] for v in vectors]
    return sp.ImmutableMatrix(len(columns), M.cols, [a for column in columns for a in column]).T


def _free_positive(v: Vector) -> Vector:
    """The vector or its negative, with a positive number for the free unknown: its last entry that is not zero."""
    last = next(a for a in reversed(v) if a)
    return tuple(-a for a in v) if last.modulus.domain.is_QQ and last.coefficients[0] < 0 else v


@dataclass(frozen=True)
class HiddenPart:
    """Rows N (k×n) with N [B, AB, …] = 0 and N A = H N, H k×k; k = n − rank is positive."""

    N: sp.ImmutableMatrix
    H: sp.ImmutableMatrix

    @cached_property
    def spectrum(self) -> Spectrum:
        """The spectrum of H; raises NotExact for a factor of degree ≥ 3 with parameters."""
        return spectrum(self.H)


@lru_cache(maxsize=64)
def hidden_part(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix) -> HiddenPart | None:
    """What the input of (A, B) does not reach (A n×n, B n×m); None if it reaches everything."""
    N = sp.ImmutableMatrix(null_basis(controllability_matrix(A, B).T).T)
    if N.rows == 0:
        return None
    D, M = side_by_side(N, A)
    columns = row_reduce(tuple(map(tuple, D.to_list()))).pivots
    chosen = D.extract(list(range(N.rows)), list(columns))
    H = (D * M).extract(list(range(N.rows)), list(columns)) * chosen.inv()
    return HiddenPart(N, matrix_of(H))


@dataclass(frozen=True)
class PencilRank:
    """The rank of [λI − A, B] at one eigenvalue λ, its row reduction, and rows w with w [λI − A, B] = 0."""

    root: Root
    rank: int
    pencil: sp.ImmutableMatrix
    unreached: sp.ImmutableMatrix
    over_L: RowReduction | None

    @cached_property
    def reduction(self) -> RowReduction | None:
        """The row reduction in expressions; None for decimal λ."""
        return self.over_L and self.over_L.mapped(partial(element_at, root=self.root))


@lru_cache(maxsize=64)
def pencil_ranks(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix) -> tuple[PencilRank, ...]:
    """The rank of [λI − A, B] (n×(n+m)) at each distinct eigenvalue, found once for all roots of a factor of χ."""
    K = domain_matrix(sp.Matrix.hstack(A, B)).domain
    return tuple(
        found for own in spectrum(A).factors for factor in split_over(own, K) for found in _ranks_at(factor, A, B)
    )


def _ranks_at(factor: Factor, A: sp.ImmutableMatrix, B: sp.ImmutableMatrix) -> Iterator[PencilRank]:
    """The rank of [xI − A, B] over L = K[x]/(p), instantiated at each root of p."""
    p, n = factor.modulus, A.rows
    rows = _pencil(p, A, B)
    reduction = row_reduce(rows)
    one = Algebraic([p.domain.one, *[p.domain.zero] * (p.degree - 1)], p)
    left = [cleared(w) for w in null_space(row_reduce(tuple(zip(*rows, strict=True))), one)]
    for root in factor.roots:
        yield PencilRank(
            root,
            len(reduction.pivots),
            sp.ImmutableMatrix(sp.Matrix.hstack(root.value * sp.eye(n) - A, B)),
            sp.ImmutableMatrix(len(left), n, [element_at(a, root) for w in left for a in w]),
            reduction if factor.degree < 3 else None,
        )


def _pencil(p: Modulus, A: sp.MatrixBase, B: sp.MatrixBase) -> tuple[tuple[Algebraic, ...], ...]:
    """[xI − A, B] over L = K[x]/(p), K the field of [A, B]."""
    K, d = p.domain, p.degree
    x = [-p.low[0]] if d == 1 else [K.zero, K.one, *[K.zero] * (d - 2)]

    def entry(i: int, j: int, a: Any) -> Algebraic:
        constant = [a, *[K.zero] * (d - 1)]
        return Algebraic([c + y for c, y in zip(constant, x, strict=True)] if i == j else constant, p)

    joined = domain_matrix(sp.Matrix.hstack(-A, B)).to_list()
    return tuple(tuple(entry(i, j, a) for j, a in enumerate(row)) for i, row in enumerate(joined))
