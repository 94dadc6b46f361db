"""Ackermann's formula, exact.

Over the rational numbers everything is done in integers: A = F/f and b = g/h with common denominators f and h, so that
Aⁱb = Fⁱg/(fⁱh). Over other fields the same steps are taken with the field's own arithmetic.
"""

from __future__ import annotations

from collections.abc import Sequence
from operator import mul
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.affine import tidy
from solver.exact.linear_algebra.fields import domain_matrix, matrix_of
from solver.exact.linear_algebra.integers import (
    Integers,
    are_rational,
    common_denominator,
    integer_rows,
    over_denominator,
    times,
)
from solver.matrices import entries


def ackermann(A: sp.MatrixBase, b: sp.MatrixBase, coefficients: Sequence[Any]) -> sp.ImmutableMatrix:
    """Return the gain K (1×n) with det(sI − A + bK) = sⁿ + c₁sⁿ⁻¹ + … + cₙ, by Ackermann's formula.

    A is n×n, b is n×1, `coefficients` are 1, c₁, …, cₙ (highest power first). K = q φ(A) with the row q that solves
    q [b, Ab, …, Aⁿ⁻¹b] = (0, …, 0, 1); φ(A) is never formed, only the row, by Horner's rule.
    Raises ZeroDivisionError if (A, b) is not controllable, NotExact for entries without exact arithmetic.
    Source: J. Ackermann, Der Entwurf linearer Regelungssysteme im Zustandsraum, Regelungstechnik 20 (1972).
    """
    c: list[Any] = [each if isinstance(each, sp.Expr) else sp.Rational(each) for each in coefficients]
    flat_A, flat_b = entries(A), entries(b)
    if are_rational(flat_A) and are_rational(flat_b) and are_rational(c):
        return _rational_gain(flat_A, flat_b, c)
    if any(each.has(sp.Float, sp.Function, sp.NumberSymbol) for each in c):
        return _gain_of_any_coefficients(A, b, c)
    return _gain(A, b, c)


def _gain_of_any_coefficients(A: sp.MatrixBase, b: sp.MatrixBase, c: Sequence[sp.Expr]) -> sp.ImmutableMatrix:
    """Ackermann's formula for coefficients outside the field (decimals, logarithms): K = Σ cᵢ q Aⁿ⁻ⁱ, affine in c."""
    n = A.rows
    unit = [sp.Integer(int(i == 0)) for i in range(n + 1)]
    rows = [sp.Matrix(ackermann(A, b, unit))]  # q Aⁿ
    for i in range(1, n + 1):
        moved = [unit[j] + int(j == i) for j in range(n + 1)]
        rows.append(sp.Matrix(ackermann(A, b, moved)) - rows[0])
    total = sum((each * row for each, row in zip(c, rows, strict=True)), sp.zeros(1, n))
    return sp.ImmutableMatrix(total.applyfunc(tidy))


def _gain(A: sp.MatrixBase, b: sp.MatrixBase, c: Sequence[sp.Expr]) -> sp.ImmutableMatrix:
    """Ackermann's formula over any field K."""
    n = A.rows
    bordered = domain_matrix(sp.Matrix([[A, b], [sp.Matrix([[*c[1:], 0]])]]))
    field, flat = bordered.domain, bordered.to_list()
    M = DomainMatrix([row[:n] for row in flat[:n]], (n, n), field)
    column = DomainMatrix([row[n:] for row in flat[:n]], (n, 1), field)
    columns = [column]
    for _ in range(n - 1):
        columns.append(M * columns[-1])
    last = DomainMatrix([[field.one if i == n - 1 else field.zero] for i in range(n)], (n, 1), field)
    stacked = columns[0].hstack(*columns[1:]).transpose()
    if stacked.rank() < n:
        raise ZeroDivisionError("the pair (A, b) is not controllable")
    q = stacked.lu_solve(last).transpose()
    row = q
    for each in flat[n][:n]:
        row = row * M + q * each
    return sp.ImmutableMatrix(matrix_of(row).applyfunc(tidy))


def _rational_gain(A: Sequence[sp.Rational], b: Sequence[sp.Rational], c: Sequence[sp.Rational]) -> sp.ImmutableMatrix:
    """Ackermann's formula in integers: with q = Q/d and r = R/(d fᵏ) the rows of Horner's rule are integers."""
    n = len(b)
    F, f = integer_rows(A, n)
    h = common_denominator(b)
    krylov = [over_denominator(b, h)]
    for _ in range(n - 1):
        krylov.append(times(F, krylov[-1]))
    Q, d = _last_solution(krylov)
    e = common_denominator(c)
    weights, columns, scale = over_denominator(c, e), list(zip(*F, strict=True)), 1
    R = [e * x for x in Q]
    for weight in weights[1:]:
        scale *= f
        R = [sum(map(mul, R, column)) + weight * scale * x for column, x in zip(columns, Q, strict=True)]
    factor = f ** (n - 1) * h  # Fⁿ⁻¹g = fⁿ⁻¹h Aⁿ⁻¹b
    gain = {i: sp.QQ(x * factor, d * e * scale) for i, x in enumerate(R) if x}
    row = DomainMatrix({0: gain} if gain else {}, (1, n), sp.QQ)  # sparse, as sympy's matrices keep it: the fastest way
    return row.to_Matrix().as_immutable()


def _last_solution(rows: list[Integers]) -> tuple[Integers, int]:
    """Return Q and d > 0 with rows · Q/d = (0, …, 0, 1), by Bareiss elimination; raises ZeroDivisionError."""
    n = len(rows)
    M = [[*row, 1 if i == n - 1 else 0] for i, row in enumerate(rows)]
    previous = 1
    for k in range(n):
        pivot = next((i for i in range(k, n) if M[i][k]), None)
        if pivot is None:
            raise ZeroDivisionError("the pair (A, b) is not controllable")
        M[k], M[pivot] = M[pivot], M[k]
        top, lead = M[k], M[k][k]
        for i in range(k + 1, n):
            row, first = M[i], M[i][k]
            M[i] = [0] * (k + 1) + [
                (lead * x - first * y) // previous for x, y in zip(row[k + 1 :], top[k + 1 :], strict=True)
            ]
        previous = lead
    return _back_substituted(M, previous)


def _back_substituted(M: list[Integers], determinant: int) -> tuple[Integers, int]:
    """Return Q and d with U Q/d = v for the triangular M = [U, v]; d is the determinant, so Q is integer (Cramer)."""
    n = len(M)
    Q = [0] * n
    for i in reversed(range(n)):
        rest = determinant * M[i][n] - sum(map(mul, M[i][i + 1 : n], Q[i + 1 :]))
        Q[i] = rest // M[i][i]
    return Q, determinant
