"""Inverses as on paper: the determinant, the cofactors entry by entry, the adjugate, the division."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.arithmetic.determinants import first_line, worked_out
from solver.arithmetic.exactness import where_exact
from solver.arithmetic.products import multiplied
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, quotient
from solver.stated.matrices import adjugate, inverse, matrix_of, transpose
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.stated import Stated

LARGEST = 3
"""A larger matrix is not inverted by its cofactors: the inverse is multiplied back."""


@where_exact
def inverted(name: str, M: ImmutableMatrix, value: ImmutableMatrix) -> tuple[Step, ...]:
    """M⁻¹ = value; `name` is the LaTeX by which the page calls M. None for a diagonal matrix."""
    if M.rows == 1 or M.is_diagonal():
        return ()
    if M.rows > LARGEST:
        return multiplied(M, value, sp.ImmutableMatrix(sp.eye(M.rows)))
    det, adj = exact.determinant_and_adjugate(M)
    det = exact.tidy(det)
    if M.rows == 2:
        return tuple(_of_two_rows(name, M, det, adj, value))
    return (*worked_out(rf"\det {name}", M, det), *cofactors(M, adj), *_divided(name, M, det, adj, value))


@where_exact
def cofactors(M: ImmutableMatrix, adj: ImmutableMatrix) -> tuple[Step, ...]:
    """adj M of a matrix of order three: the determinants with their signs, transposed."""
    return tuple(_cofactors(M, adj)) if M.rows == LARGEST and not M.is_diagonal() else ()


@lemma("arithmetic/inverses")
def _of_two_rows(
    name: str, M: ImmutableMatrix, det: Expr, adj: ImmutableMatrix, value: ImmutableMatrix
) -> Derivation[None]:
    """Exchange the entries of the diagonal, change the sign of the others, divide."""
    claims = {
        "stated": Claim(inverse(M), quotient(adj, first_line(M)), Phrase("inverse by the adjugate")),
        "divided": Claim(quotient(adj, det), value, Phrase("entries of the inverse")),
    }
    yield Step("two_rows", detail="tutor", claims=claims, name=name, M=M, one=det == 1)


@lemma("arithmetic/inverses")
def _cofactors(M: ImmutableMatrix, adj: ImmutableMatrix) -> Derivation[None]:
    n = M.rows
    written = matrix_of([[_cofactor(M, i, j) for j in range(n)] for i in range(n)])
    claims = {
        "written": Claim(adjugate(M), transpose(written), Phrase("adjugate by cofactors")),
        "value": Claim(transpose(written), adj, Phrase("the cofactors worked out")),
    }
    yield Step("cofactors", detail="tutor", claims=claims)


def _cofactor(M: ImmutableMatrix, i: int, j: int) -> Stated:
    line = first_line(sp.ImmutableMatrix(M.minor_submatrix(i, j)))
    return line if (i + j) % 2 == 0 or not line.operands else product(-1, line)


@lemma("arithmetic/inverses")
def _divided(
    name: str, M: ImmutableMatrix, det: Expr, adj: ImmutableMatrix, value: ImmutableMatrix
) -> Derivation[None]:
    claims = {
        "quotient": Claim(inverse(M), quotient(adj, det), Phrase("inverse by the adjugate")),
        "entries": Claim(quotient(adj, det), value, Phrase("entries of the inverse")),
    }
    yield Step("divided", detail="tutor", claims=claims, name=name, M=M, one=det == 1)
