"""Linear differential (difference) equations in first-order form.

The derivatives of unknowns and inputs are symbols of their own ("jets"): x, x', x''. Derivatives of inputs on the right
are realized by shifting the states: X = Z + Σ S_k u^(k) with S_{k−1} = A S_k + B_k (K. Ogata, Modern Control
Engineering, §2–5, for several unknowns at once).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.matrices import determinant, inverse


@dataclass(frozen=True)
class Realized:
    """z' = A z + B u, y = C z + D u, where the states are x = z + Σ `shifts`[k] u^(k)."""

    A: sp.ImmutableMatrix
    B: sp.ImmutableMatrix
    C: sp.ImmutableMatrix
    D: sp.ImmutableMatrix
    shifts: tuple[sp.ImmutableMatrix, ...]


def is_linear(expressions: Sequence[sp.Expr], jets: Sequence[sp.Symbol]) -> bool:
    """Whether each expression is a sum of jets with coefficients free of them, and no term by itself."""
    return not any(_rest(e, jets) != 0 for e in expressions)


def _rest(expression: sp.Expr, jets: Sequence[sp.Symbol]) -> sp.Expr:
    """What is not linear in the jets."""
    coefficients = [sp.diff(expression, jet) for jet in jets]
    if any(c.has(*jets) for c in coefficients if jets):
        return sp.S.One
    linear = sp.Add(*(c * jet for c, jet in zip(coefficients, jets, strict=True)))
    return sp.cancel(expression - linear)


def solved_for(expressions: Sequence[sp.Expr], wanted: Sequence[sp.Symbol]) -> dict[sp.Symbol, sp.Expr] | None:
    """Solve expressions that are zero, linear in the wanted symbols, as many as these; None if that is not possible."""
    M = sp.ImmutableMatrix([[sp.diff(e, symbol) for symbol in wanted] for e in expressions])
    if M.rows != M.cols:
        return None
    rest = sp.ImmutableMatrix([e.subs(dict.fromkeys(wanted, 0)) for e in expressions])
    if M.is_diagonal():  # each by itself: no determinant of many symbols
        if any(M[i, i] == 0 for i in range(M.rows)):
            return None
        return {symbol: _by_jets(-rest[i] / M[i, i]) for i, symbol in enumerate(wanted)}
    if determinant(M) == 0:
        return None
    found = -(inverse(M) * rest)
    return {symbol: _by_jets(value) for symbol, value in zip(wanted, found, strict=True)}


def _by_jets(value: sp.Expr) -> sp.Expr:
    """A sum of terms, each without common factors."""
    above, below = sp.fraction(sp.cancel(value))
    if not below.is_Add and not below.is_Mul:
        return sp.expand(above / below)
    return sp.Add(*(sp.cancel(term / below) for term in sp.Add.make_args(sp.expand(above))))


def matrix_of(expressions: Sequence[sp.Expr], symbols: Sequence[sp.Symbol]) -> sp.ImmutableMatrix:
    """Return the coefficients of the symbols in linear expressions, one row each."""
    rows = [[sp.cancel(sp.diff(e, symbol)) for symbol in symbols] for e in expressions]
    return sp.ImmutableMatrix(len(expressions), len(symbols), [entry for row in rows for entry in row])


def realized(
    A: sp.ImmutableMatrix, drives: Sequence[sp.ImmutableMatrix], C: sp.ImmutableMatrix, through: Sequence[Any]
) -> Realized | None:
    """Realize x' = A x + Σ B_k u^(k), y = C x + Σ D_k u^(k); None where y depends on derivatives of u: improper."""
    shift = sp.zeros(A.rows, drives[0].cols)
    shifts: list[sp.ImmutableMatrix] = []
    for B in reversed(drives):
        shifts.insert(0, sp.ImmutableMatrix(shift))
        shift = (A * shift + B).applyfunc(sp.cancel)
    outputs = [(C * S + D).applyfunc(sp.cancel) for S, D in zip(shifts, through, strict=True)]
    if any(not D.is_zero_matrix for D in outputs[1:]):
        return None
    return Realized(A, sp.ImmutableMatrix(shift), C, sp.ImmutableMatrix(outputs[0]), tuple(shifts))
