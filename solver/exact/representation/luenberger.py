"""Companion forms of a plant with several inputs (outputs), of the plant's own order, by a change of coordinates.

From [b₁, …, b_m, Ab₁, …] the columns that do not depend on those before them are kept; μᵢ of them come from bᵢ (the
controllability indices). With P = [b₁, Ab₁, …, A^{μ₁−1}b₁, b₂, …] and qᵢ the row μ₁ + … + μᵢ of P⁻¹, the rows
qᵢ, qᵢA, …, qᵢA^{μᵢ−1} make T⁻¹. Source: D. G. Luenberger, Canonical forms for linear multivariable systems, IEEE Trans.
Automatic Control 12 (1967).
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.fields import domain_matrix, matrix_of
from solver.exact.linear_algebra.row_reduction import row_reduce
from solver.exact.representation.realization import Realization


@dataclass(frozen=True)
class CompanionCoordinates:
    """X = T ξ brings the plant into companion blocks of the orders `indices`; `P` are the columns chosen."""

    found: Realization
    T: sp.ImmutableMatrix
    T_inverse: sp.ImmutableMatrix
    P: sp.ImmutableMatrix
    indices: tuple[int, ...]


def controllable_coordinates(
    A: sp.MatrixBase, B: sp.MatrixBase, C: sp.MatrixBase, D: sp.MatrixBase, *, first_row: bool = False
) -> CompanionCoordinates | None:
    """The controllable canonical form of a plant; None if it is not controllable. Raises NotExact."""
    n = A.rows
    whole = domain_matrix(sp.Matrix(sp.BlockMatrix([[A, B], [C, D]]).as_explicit()))
    a, b, c = whole[:n, :n], whole[:n, n:], whole[n:, :n]
    chains = _chains(a, b)
    if sum(len(chain) for chain in chains) < n:
        return None
    P = _side_by_side([column for chain in chains for column in chain])
    inverse = P.inv()
    rows: list[DomainMatrix] = []
    last = -1
    for chain in chains:
        last += len(chain)
        block = [inverse[last, :]] if chain else []
        for _ in range(len(chain) - 1):
            block.append(block[-1] * a)
        rows += block[::-1] if first_row else block
    there = rows[0].vstack(*rows[1:])
    back = there.inv()
    found = Realization(
        matrix_of(there * a * back),
        matrix_of(there * b),
        matrix_of(c * back),
        sp.ImmutableMatrix(D),
        tuple(len(chain) for chain in chains if chain),
    )
    indices = tuple(len(chain) for chain in chains)
    return CompanionCoordinates(found, matrix_of(back), matrix_of(there), matrix_of(P), indices)


def observable_coordinates(
    A: sp.MatrixBase, B: sp.MatrixBase, C: sp.MatrixBase, D: sp.MatrixBase, *, first_row: bool = False
) -> CompanionCoordinates | None:
    """The dual: the observable canonical form; None if the plant is not observable."""
    dual = controllable_coordinates(A.T, C.T, B.T, D.T, first_row=first_row)
    if dual is None:
        return None
    T, T_inverse, P = (sp.ImmutableMatrix(M.T) for M in (dual.T_inverse, dual.T, dual.P))
    return CompanionCoordinates(dual.found.dual, T, T_inverse, P, dual.indices)


def _chains(a: DomainMatrix, b: DomainMatrix) -> list[list[DomainMatrix]]:
    """For each input its columns bᵢ, Abᵢ, … that do not depend on the columns before them, power by power."""
    n, m = b.shape
    blocks = [b]
    for _ in range(n - 1):
        blocks.append(a * blocks[-1])
    krylov = blocks[0].hstack(*blocks[1:])
    chains: list[list[DomainMatrix]] = [[] for _ in range(m)]
    for pivot in row_reduce(tuple(map(tuple, krylov.to_list()))).pivots:
        chains[pivot % m].append(krylov[:, pivot])
    return chains


def _side_by_side(columns: list[DomainMatrix]) -> DomainMatrix:
    return columns[0].hstack(*columns[1:])
