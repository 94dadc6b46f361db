"""Small exact matrix operations that sympy has slower: products, powers, inverse, series."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.faddeev import faddeev_leverrier
from solver.exact.linear_algebra.fields import domain_matrix, expression, matrix_of, side_by_side
from solver.matrices import entries

SYMBOLS = 2
"""With more of them quotients of polynomials are slow."""


def multiply(A: sp.MatrixBase, B: sp.MatrixBase) -> sp.ImmutableMatrix:
    """A B, exact."""
    left, right = side_by_side(A, B, real=False)
    return matrix_of(left * right)


@lru_cache(maxsize=64)
def pencil(A: sp.ImmutableMatrix, x: sp.Expr) -> sp.ImmutableMatrix:
    """xI − A (n×n)."""
    n = A.rows
    return sp.ImmutableMatrix(n, n, [x - a if i % (n + 1) == 0 else -a for i, a in enumerate(entries(A))])


def powers(A: sp.ImmutableMatrix, count: int) -> list[sp.ImmutableMatrix]:
    """I, A, A², …: `count` matrices n×n."""
    M = domain_matrix(A, real=False)
    current = DomainMatrix.eye(A.rows, M.domain).to_dense()
    found = []
    for _ in range(count):
        found.append(matrix_of(current))
        current = current * M
    return found


def inverse(A: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    """A⁻¹ (n×n); raises ZeroDivisionError if A is singular."""
    det, adj = determinant_and_adjugate(A)
    if det == 0:
        raise ZeroDivisionError("the matrix is singular")
    return sp.ImmutableMatrix(adj.applyfunc(lambda entry: sp.cancel(entry / det)))


def determinant(A: sp.ImmutableMatrix) -> sp.Expr:
    """Det A: (−1)ⁿ aₙ of the Faddeev–LeVerrier recursion, with parameters by elimination without fractions."""
    M = domain_matrix(A, real=False)
    if _is_large(M):
        return expression(M.domain, M.det())
    fl = faddeev_leverrier(A)
    return (-1) ** A.rows * expression(fl.domain, fl.chi[-1])


def determinant_and_adjugate(A: sp.ImmutableMatrix) -> tuple[sp.Expr, sp.ImmutableMatrix]:
    """Return det A and adj A: (−1)ⁿ⁻¹ Nₙ₋₁ of the Faddeev–LeVerrier recursion, with parameters det A · A⁻¹."""
    M = domain_matrix(A, real=False)
    if _is_large(M) and (det := M.det()):
        return expression(M.domain, det), matrix_of(M.inv() * det)
    return determinant(A), sp.ImmutableMatrix((-1) ** (A.rows - 1) * matrix_of(faddeev_leverrier(A).N[-1]))


def _is_large(M: DomainMatrix) -> bool:
    """Whether the recursion, which works with fractions, would take long: their polynomials have several symbols."""
    K: Any = M.domain
    return bool(K.is_Composite and len(K.symbols) > SYMBOLS and M.shape[0] > 2)


def truncated_series(A: sp.ImmutableMatrix, t: sp.Symbol, terms: int) -> sp.ImmutableMatrix:
    """I + At + A²t²/2! + …: the first `terms` terms of e^{At}."""
    M = sp.zeros(A.rows)
    for i, each in enumerate(powers(A, terms)):
        M += each * (t**i / sp.factorial(i))
    return sp.ImmutableMatrix(M)


def taylor(function: sp.Expr, t: sp.Symbol, terms: int) -> list[sp.Expr]:
    """The first `terms` terms of the Taylor series of a function of t at zero, by rising power; zeros are left out."""
    found, derivative = [], function
    for i in range(terms):
        found.append(sp.expand(derivative.subs(t, 0)) * t**i / sp.factorial(i))
        derivative = sp.diff(derivative, t)
    return [term for term in found if term != 0] or [sp.Integer(0)]
