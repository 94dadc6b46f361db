"""Relative degrees, the decoupling matrix, the law of decoupling, and the motion that it hides."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.stated.algebra import power, product
from solver.stated.matrices import determinant, rank

ORACLE = "random points (30 digits)"
POINTS = 2


def of_interaction(found: Any, A: Any, B: Any, C: Any, D: Any) -> Iterator[Claim | Check]:
    """Before its last row, which is not zero, nothing of an input acts on an output; all rows are products."""
    for i, channel in enumerate(found.channels):
        c = C.row(i)
        for k, row in enumerate(channel.rows):
            yield Claim(product(c, power(A, k)) if k else c, row)
        for k, row in enumerate(channel.reached):
            yield Claim(product(c, power(A, k), B) if k else product(c, B), row)
            last = channel.degree is not None and k == len(channel.reached) - 1
            yield Claim(rank(row), sp.Integer(1 if last else 0))
        through = channel.degree == 0
        yield Claim(rank(sp.ImmutableMatrix(D.row(i))), sp.Integer(int(through)))
        rows, reached = (A.rows,) * 2 if channel.degree is None else (channel.degree + 1, channel.degree)
        counted = (len(channel.rows), len(channel.reached)) == (rows, reached)
        yield Check.that("the number of rows", "counted", counted)
        entry = D.row(i) if through else channel.reached[-1]
        yield Claim(sp.ImmutableMatrix(entry), channel.entry)


def of_decoupling_law(found: Any, of: Any, polynomials: Any) -> Iterator[Claim]:
    """B* F = I, B* K has the rows c α(A)."""
    E = of.matrix
    yield Claim(product(E, found.F), sp.ImmutableMatrix(sp.eye(E.rows)))
    yield Claim(product(E, found.K), found.rows)
    for i, (channel, wanted) in enumerate(zip(of.channels, polynomials, strict=True)):
        total = sp.zeros(1, found.rows.cols)
        for row, a in zip(reversed(channel.rows), wanted, strict=True):
            total += a * sp.Matrix(row)
        yield Claim(sp.ImmutableMatrix(total), sp.ImmutableMatrix(found.rows.row(i)))


def of_hidden_motion(found: Any, of: Any, loop: Any) -> Iterator[Claim]:
    """The derivatives of the outputs are independent, zero on N, which completes them, and (A − BK) N = N H."""
    Q = of.derivatives
    seen = Q.rows
    if seen:
        yield Claim(rank(Q), sp.Integer(seen))
    if found is None:
        yield Claim(sp.Integer(seen), sp.Integer(loop.rows))
        return
    N = found.N
    yield Claim(sp.Integer(N.cols + seen), sp.Integer(loop.rows))
    yield Claim(rank(N), sp.Integer(N.cols))
    if seen:
        yield Claim(product(Q, N), sp.ImmutableMatrix(sp.zeros(seen, N.cols)))
    yield Claim(product(loop, N), product(N, found.H))


def of_dynamically_decouplable(found: bool, A: Any, B: Any, C: Any, D: Any) -> Iterator[Claim]:
    """The system matrix [sI − A, −B; C, D] has full rank at general s, or it has not."""
    s = sp.Symbol("s")
    blocks = [[s * sp.eye(A.rows) - A, -sp.Matrix(B)], [sp.Matrix(C), sp.Matrix(D)]]
    P = sp.ImmutableMatrix(sp.Matrix(sp.BlockMatrix(blocks).as_explicit()))
    if found:
        yield Claim(rank(P), sp.Integer(P.rows))
    else:
        yield Claim(determinant(P), sp.Integer(0))


def of_interaction_conditions(found: Any, of: Any) -> Iterator[Check]:
    """Where a condition that is linear in a parameter holds, B* loses rank, or a row of it vanishes."""
    for condition in found:
        if isinstance(condition, sp.Eq) and (there := _solved(condition.lhs - condition.rhs)):
            E = of.matrix.subs(there)
            if of.determinant != 0:
                falls = _vanishes(E.det())
            else:
                falls = any(_row_vanishes(E, i) for i, r in enumerate(of.degrees) if r is not None)
            yield Check.that("a condition under which it is different", ORACLE, falls)


def _solved(gap: Any) -> dict[Any, Any]:
    """The parameter in which it is linear, with the value for which it is zero; nothing where there is none."""
    for x in sorted(gap.free_symbols, key=str):
        if gap.is_polynomial(x) and sp.degree(gap, x) == 1:
            a, b = sp.Poly(gap, x).all_coeffs()
            return {x: -b / a}
    return {}


def _row_vanishes(E: Any, i: int) -> bool:
    return all(_vanishes(entry) for entry in E.row(i))


def _vanishes(value: Any) -> bool:
    """Whether an expression is zero at random values of its parameters."""
    symbols = sorted(value.free_symbols, key=str)
    points = [{x: sp.Rational(7 + 3 * i + trial, 11) for i, x in enumerate(symbols)} for trial in range(POINTS)]
    return all(abs(sp.N(value.subs(point), 30)) < sp.Float(10) ** -20 for point in points)
