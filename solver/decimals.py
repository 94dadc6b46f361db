"""Decimals between parts: what an earlier part found goes on as exact numbers, and is short again in what comes out."""

from __future__ import annotations

from typing import Any

from solver.lazy import sympy as sp

DIGITS = 15
"""Significant digits of decimals that a later part takes from an earlier one."""


LONG = 10**9
"""A fraction of larger numbers, where decimals went in, is a decimal again in what comes out."""


def exactly(value: Any) -> Any:
    """Return expressions and matrices with decimals as exact numbers, also in a list or mapping; else the same."""
    if isinstance(value, list):
        return [exactly(each) for each in value]
    if isinstance(value, dict):
        return {name: exactly(each) for name, each in value.items()}
    return as_printed(value) if isinstance(value, (sp.MatrixBase, sp.Expr)) else value


def as_printed(matrix: Any) -> Any:
    """Return a matrix with its decimals taken as exact numbers of 15 digits, so that exact algebra goes on."""
    exactly = {each: sp.Rational(str(sp.Float(each, DIGITS))) for each in matrix.atoms(sp.Float)}
    return matrix.xreplace(exactly) if exactly else matrix


def short_again(value: Any) -> Any:
    """Return an answer with decimals in place of the long fractions that exact algebra made of decimals."""
    if isinstance(value, list):
        return [short_again(each) for each in value]
    if isinstance(value, dict):
        return {name: short_again(each) for name, each in value.items()}
    if not isinstance(value, (sp.MatrixBase, sp.Basic)):
        return value
    long = [each for each in value.atoms(sp.Rational) if max(abs(each.p), each.q) > LONG]
    decimals: Any = {each: sp.Float(each, DIGITS) for each in long}
    return value.xreplace(decimals) if long else value  # type: ignore[no-untyped-call]
