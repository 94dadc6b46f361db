"""Eigenvectors that a feedback u = −K x can give the closed loop, and of these the nearest to a wanted one.

(A − BK) v = λ v with w = K v is linear in both: (λI − A) v + B w = 0. So v is attainable for λ exactly if it is the
upper part of a vector of the null space of [λI − A, B].
Source: B. C. Moore, On the flexibility offered by state feedback in multivariable systems beyond closed loop eigenvalue
assignment, IEEE Trans. Automatic Control 21 (1976).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce
from math import lcm
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.affine import tidy
from solver.exact.linear_algebra.fields import domain_matrix, expression, matrix_of
from solver.exact.linear_algebra.matrices import pencil
from solver.exact.linear_algebra.row_reduction import null_space, row_reduce


@dataclass(frozen=True)
class Attainable:
    """For a pole λ: the solutions v = N p, w = M p (N n×d, M m×d, p any column) of B w + (λI − A) v = 0.

    The columns of N are independent. `matrix` is [B, λI − A], n×(m+n).
    """

    pole: sp.Expr
    matrix: sp.ImmutableMatrix
    N: sp.ImmutableMatrix
    M: sp.ImmutableMatrix


@dataclass(frozen=True)
class Nearest:
    """The attainable v = N p (n×1) nearest to a wanted vector, and w = M p = K v (m×1).

    p solves the normal equations `gram` p = `right`. `share` is ‖v‖²/‖wanted‖², the square of the cosine of the angle
    between the two: 1 where the wanted vector is attainable.
    """

    p: sp.ImmutableMatrix
    v: sp.ImmutableMatrix
    w: sp.ImmutableMatrix
    gram: sp.ImmutableMatrix
    right: sp.ImmutableMatrix
    share: sp.Expr


def attainable_eigenvectors(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix, pole: sp.Expr) -> Attainable:
    """Solve B w + (λI − A) v = 0 for λ = pole (A n×n, B n×m); raises NotExact for entries without exact arithmetic.

    w is eliminated first, so that p stands for entries of v. What moves w alone (inputs that do nothing or the same as
    others) is left out.
    """
    m = B.cols
    matrix = sp.ImmutableMatrix(sp.Matrix.hstack(B, pencil(A, pole)).applyfunc(sp.expand))
    over = domain_matrix(matrix, real=False)
    K = over.domain
    reduction = row_reduce(tuple(map(tuple, over.to_list())))
    columns = [_cleared([expression(K, c) for c in each], m) for each in null_space(reduction, K.one) if any(each[m:])]
    basis = sp.Matrix.hstack(*columns)
    return Attainable(pole, matrix, sp.ImmutableMatrix(basis[m:, :]), sp.ImmutableMatrix(basis[:m, :]))


def _cleared(vector: list[sp.Expr], m: int) -> sp.Matrix:
    """The column times what makes its entries from m on coprime integers, if they are rational (complex or real)."""
    parts: list[Any] = [part for entry in vector[m:] for part in _parts(entry)]
    if not all(part.is_Rational for part in parts):
        return sp.Matrix([tidy(entry) for entry in vector])
    below = reduce(lcm, (int(part.q) for part in parts), 1)
    whole = [int(part * below) for part in parts]
    pairs = zip(whole[::2], whole[1::2], strict=True)
    divisor = sp.ZZ_I.to_sympy(reduce(sp.ZZ_I.gcd, (sp.ZZ_I(*pair) for pair in pairs), sp.ZZ_I.zero))
    return sp.Matrix([tidy(sp.expand_complex(below * entry / divisor)) for entry in vector])


def _parts(entry: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Real and imaginary part of an expression in real symbols."""
    above = sp.expand((entry - conjugated(entry)) / (2 * sp.I))
    return sp.expand(entry - sp.I * above), above


def conjugated(value: Any) -> Any:
    """The conjugate of an expression in real symbols, or of a matrix of them."""
    return value.xreplace({sp.I: -sp.I})


def nearest_eigenvector(attainable: Attainable, wanted: sp.ImmutableMatrix) -> Nearest:
    """Return the orthogonal projection of the wanted vector (n×1) on what is attainable, by the normal equations."""
    N, d = attainable.N, attainable.N.cols
    joined = domain_matrix(sp.Matrix.hstack(N, wanted, conjugated(N)), real=False)
    N_, wanted_, barred = (_columns(joined, *ends) for ends in ((0, d), (d, d + 1), (d + 1, 2 * d + 1)))
    gram, right = barred.transpose() * N_, barred.transpose() * wanted_
    solution = gram.lu_solve(right)
    p, v = (_tidied(matrix_of(each)) for each in (solution, N_ * solution))
    w = _tidied(sp.ImmutableMatrix(attainable.M * p))
    share = tidy(sp.cancel(squared_length(v) / squared_length(wanted)))
    return Nearest(p, v, w, _tidied(matrix_of(gram)), _tidied(matrix_of(right)), share)


def _columns(M: DomainMatrix, first: int, end: int) -> DomainMatrix:
    return DomainMatrix([row[first:end] for row in M.to_list()], (M.shape[0], end - first), M.domain)


def parts_of_columns(v: sp.ImmutableMatrix) -> tuple[sp.ImmutableMatrix, sp.ImmutableMatrix]:
    """Return Re v and Im v of a matrix of expressions in real symbols."""
    found = [_parts(entry) for entry in v.flat()]
    real, imaginary = (sp.ImmutableMatrix(*v.shape, [tidy(pair[i]) for pair in found]) for i in (0, 1))
    return real, imaginary


def squared_length(vector: sp.ImmutableMatrix) -> sp.Expr:
    """‖v‖² of a column."""
    return sp.expand(sum(entry * conjugated(entry) for entry in vector.flat()))


def _tidied(M: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    return sp.ImmutableMatrix(M.applyfunc(tidy))
