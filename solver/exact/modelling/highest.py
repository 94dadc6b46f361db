"""Equations solved for symbols that stand in them linearly, with nonlinear functions of the others as coefficients."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from solver.exact.modelling.derivatives import partial
from solver.exact.modelling.quotients import Polynomial, Quotients, quotients_in

Fraction = tuple[Polynomial, Polynomial]


def are_linear_in(expressions: Sequence[sp.Expr], wanted: Sequence[sp.Symbol]) -> bool:
    """Whether the expressions are sums of the wanted symbols with coefficients free of them, and of a rest."""
    return not any(partial(e, x).has(*wanted) for e in expressions for x in wanted if e.has(x))


def coefficients_of(
    expressions: Sequence[sp.Expr], wanted: Sequence[sp.Symbol]
) -> tuple[sp.ImmutableMatrix, sp.ImmutableMatrix]:
    """Return M and r of expressions M·wanted − r that are linear in the wanted symbols."""
    M = sp.ImmutableMatrix([[partial(e, x) for x in wanted] for e in expressions])
    nothing = dict.fromkeys(wanted, sp.S.Zero)
    return M, sp.ImmutableMatrix([-e.xreplace(nothing) for e in expressions])


def solved_linearly(expressions: Sequence[sp.Expr], wanted: Sequence[sp.Symbol]) -> dict[sp.Symbol, sp.Expr] | None:
    """Solve expressions that are zero, linear in the wanted symbols and as many; None where none or many values do.

    By Gaussian elimination; the pivot of a column is the shortest entry that is not zero.
    """
    n = len(wanted)
    if len(expressions) != n:
        return None
    coefficients = [[partial(e, x) for x in wanted] for e in expressions]
    rest = [e.xreplace(dict.fromkeys(wanted, sp.S.Zero)) for e in expressions]
    field = quotients_in([*rest, *(c for row in coefficients for c in row)])
    rows = [[field.of(c) for c in (*row, -r)] for row, r in zip(coefficients, rest, strict=True)]
    for j in range(n):
        pivot = min((i for i in range(j, n) if rows[i][j][0]), key=lambda i: _length(rows[i][j]), default=None)
        if pivot is None:
            return None
        rows[j], rows[pivot] = rows[pivot], rows[j]
        for i in range(n):
            if i != j and rows[i][j][0]:
                rows[i] = _cleared(field, rows[i], rows[j], j)
    return {
        x: field.expression(*_divided(field, row[n], row[j]))
        for j, (x, row) in enumerate(zip(wanted, rows, strict=True))
    }


def _length(entry: Fraction) -> int:
    return len(entry[0]) + len(entry[1])


def _divided(field: Quotients, a: Fraction, b: Fraction) -> Fraction:
    return field.reduced(a[0] * b[1], a[1] * b[0])


def _cleared(field: Quotients, row: Sequence[Fraction], pivot: Sequence[Fraction], j: int) -> list[Fraction]:
    """The row less the multiple of the pivot's row that leaves a zero in column j."""
    n, d = _divided(field, row[j], pivot[j])
    return [
        field.reduced(a[0] * d * b[1] - n * b[0] * a[1], a[1] * d * b[1]) if k >= j else a
        for k, (a, b) in enumerate(zip(row, pivot, strict=True))
    ]
