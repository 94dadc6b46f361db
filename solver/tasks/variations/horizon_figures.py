"""Figures of functions over a horizon from 0 to T: motions, controls, solutions of Riccati equations, gains."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from solver.derivation.figures import Curve, Panels, Plot
from solver.lazy import sympy as sp
from solver.tasks.figures import numbered

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

MOST_CURVES = 6
"""Panels with more curves are not read."""


def signals_over(T: Expr, signals: Mapping[str, ImmutableMatrix], caption: str) -> tuple[Panels, ...]:
    """Return columns of functions of t, each in a panel under its letter; nothing where other symbols are left."""
    curves = {
        letter: [(function, name) for function, name in zip(column.flat(), numbered(letter, len(column)), strict=True)]
        for letter, column in signals.items()
    }
    return _panels(T, curves, caption)


def matrices_over(T: Expr, matrices: Mapping[str, ImmutableMatrix], caption: str) -> tuple[Panels, ...]:
    """Return the entries of matrices of functions of t, each matrix in a panel; of a symmetric one each entry once."""
    return _panels(T, {letter: _entries(letter, M) for letter, M in matrices.items()}, caption)


def _entries(letter: str, M: ImmutableMatrix) -> list[tuple[Any, str]]:
    small = letter.lower()
    if M.shape == (1, 1):
        return [(M[0, 0], letter)]
    if M.rows == 1:
        return [(M[0, j], f"{small}_{{{j + 1}}}") for j in range(M.cols)]
    once = M.rows == M.cols and M.T == M
    places = [(i, j) for i in range(M.rows) for j in range(i if once else 0, M.cols)]
    return [(M[i, j], f"{small}_{{{i + 1}{j + 1}}}") for i, j in places]


def _panels(T: Expr, curves: Mapping[str, list[tuple[Any, str]]], caption: str) -> tuple[Panels, ...]:
    t = sp.Symbol("t")
    functions = [function for each in curves.values() for function, _ in each]
    if T.free_symbols or any(function.free_symbols - {t} for function in functions):
        return ()
    plots = [
        Plot("", "t", letter, t, sp.S.Zero, T, tuple(Curve(function + 0 * t, name) for function, name in each))
        for letter, each in curves.items()
        if len(each) <= MOST_CURVES
    ]
    return (Panels(caption, tuple(plots)),) if plots else ()
