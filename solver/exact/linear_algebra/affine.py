"""Linear equations whose right side may hold any expressions: decimals, logarithms, symbols."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from solver.exact.linear_algebra.fields import collected, domain_matrix, expression
from solver.exact.linear_algebra.row_reduction import row_reduce


def tidy(value: sp.Expr) -> sp.Expr:
    """Return an expression multiplied out, or factored where it holds symbols (and no decimals).

    One with exponentials is factored where a sum stands below a fraction line, which would be below each term.
    """
    if value.has(sp.Float) or (_grows(value) and not _has_sum_below(value)):
        return sp.expand(value)
    return minus_taken_in(collected(value))


def _has_sum_below(value: sp.Expr) -> bool:
    """Whether a sum with symbols stands below a fraction line."""
    powers = value.atoms(sp.Pow)
    return any(each.base.is_Add and each.base.free_symbols and each.exp.is_negative for each in powers)


def _grows(value: sp.Expr) -> bool:
    """Whether a symbol stands in an exponent; e^{−t} + e^{−2t} is not to be factored."""
    return any(each.args[-1].free_symbols for each in value.atoms(sp.exp, sp.Pow))


def multiplied_out(value: sp.Expr, x: sp.Symbol | None = None) -> sp.Expr:
    """The value without brackets, with x in powers of x; factored where parameters stand below a fraction line."""
    expanded = sp.expand(value)
    if x is not None and x in expanded.free_symbols:
        return sp.Add(*(multiplied_out(c) * x**k for (k,), c in sp.Poly(expanded, x).terms()))
    below = any(each.exp.could_extract_minus_sign() and each.base.free_symbols for each in expanded.atoms(sp.Pow))
    return tidy(value) if below else expanded


def minus_taken_in(value: sp.Expr) -> sp.Expr:
    """(2b − a)/c in place of −(a − 2b)/c: the minus before a product goes into a sum with terms of both signs."""
    number, rest = value.as_coeff_Mul()
    if not number.is_negative or rest.is_Add:
        return value
    factors: tuple[sp.Expr, ...] = sp.Mul.make_args(rest)
    mixed = [each for each in factors if each.is_Add and any(term.could_extract_minus_sign() for term in each.args)]
    return sp.Mul(-number, *(-each if each is mixed[0] else each for each in factors)) if mixed else value


@dataclass(frozen=True)
class Solution:
    """All solutions of M v = r: `values` in terms of the free unknowns, `free` their positions, `residue` ≠ 0 if none.

    `conditions` are the independent equations that are left, each as an expression that is zero.
    """

    values: tuple[sp.Expr, ...]
    free: tuple[int, ...]
    residue: tuple[sp.Expr, ...]
    conditions: tuple[sp.Expr, ...]


def solve_affine(M: sp.ImmutableMatrix, right: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> Solution:
    """Solve M v = r (M p×q over a field, r of any expressions) for the unknowns v by row reduction of [M, I]."""
    width = M.cols
    matrix = domain_matrix(sp.Matrix.hstack(M, sp.eye(M.rows)))
    K = matrix.domain
    reduction = row_reduce(tuple(tuple(row) for row in matrix.to_list()))
    values: list[sp.Expr] = list(unknowns)
    residue: list[sp.Expr] = []
    conditions: list[sp.Expr] = []
    for row in reduction.reduced:
        entries = [expression(K, c) if c else sp.Integer(0) for c in row]
        value = tidy(sp.Add(*(c * r for c, r in zip(entries[width:], right, strict=True))))
        pivot = next((j for j in range(width) if entries[j] != 0), None)
        if pivot is None:
            residue.append(value)
            continue
        others = [entries[j] * unknowns[j] for j in range(pivot + 1, width)]
        conditions.append(tidy(sp.Add(unknowns[pivot], *others, -value)))
        values[pivot] = tidy(sp.Add(value, *(-each for each in others)))
    pivots = {j for j in reduction.pivots if j < width}
    left = tuple(r for r in residue if not vanishes(r))
    return Solution(tuple(values), tuple(j for j in range(width) if j not in pivots), left, tuple(conditions))


def vanishes(value: sp.Expr) -> bool:
    """Whether a value is zero, in decimals nearly so."""
    if not value.has(sp.Float):
        return bool(value == 0)
    return not value.free_symbols and abs(value) < sp.Float("1e-18")


def affine(expressions: Sequence[sp.Expr], unknowns: Sequence[sp.Symbol]) -> tuple[sp.ImmutableMatrix, list[sp.Expr]]:
    """Return M and c with expressions = M · unknowns + c; the expressions are affine in the unknowns."""
    M = sp.ImmutableMatrix(len(expressions), len(unknowns), lambda i, j: tidy(sp.diff(expressions[i], unknowns[j])))
    nothing = dict.fromkeys(unknowns, sp.Integer(0))
    return M, [tidy(each.subs(nothing)) for each in expressions]
