"""Products and inverses for changes of coordinates; complex entries (modal matrices) are allowed here."""

from __future__ import annotations

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.fields import NotExact, domain_matrix, matrix_of


def _field_matrix(M: sp.MatrixBase) -> DomainMatrix:
    """M over a field for its entries, which may hold j; raises NotExact."""
    if not M.has(sp.I):
        return domain_matrix(M)
    matrix = DomainMatrix.from_Matrix(M, extension=True).to_field().to_dense()
    if matrix.domain.is_EX or matrix.domain.is_EXRAW or not matrix.domain.is_Exact:
        raise NotExact("representation/mixed")
    return matrix


def product_of(left: sp.MatrixBase, right: sp.MatrixBase) -> sp.ImmutableMatrix:
    """L R, exact; raises NotExact."""
    a, b = _field_matrix(left).unify(_field_matrix(right))
    return matrix_of(a * b)


def is_singular(T: sp.MatrixBase) -> bool:
    """Whether det T = 0 (with parameters: for all their values)."""
    M = _field_matrix(T)
    return bool(M.rank() < T.rows)


def inverse_in_full(T: sp.MatrixBase) -> tuple[sp.Expr, sp.ImmutableMatrix, sp.ImmutableMatrix]:
    """Det T, adj T and T⁻¹ of an invertible T."""
    M = _field_matrix(T)
    det, inverse = M.det(), M.inv()
    determinant = matrix_of(DomainMatrix([[det]], (1, 1), M.domain))[0, 0]
    return determinant, matrix_of(inverse * det), matrix_of(inverse)
