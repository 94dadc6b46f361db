"""Exact objects as plain text: what `sympy.sympify` reads back exactly, and two-dimensional text for a terminal."""

from __future__ import annotations

from collections.abc import Collection
from functools import cache
from typing import Any

import sympy as sp
from sympy.printing.str import StrPrinter

from solver.formula.terminal import drawn
from solver.render.latex import DEFAULT, tex
from solver.render.numbers import NumberFormat
from solver.stated import Stated

DIGITS = 15
"""Significant digits of decimals in data."""


def unicode_text(value: Any, numbers: NumberFormat = DEFAULT) -> str:
    """Return a value as lines of Unicode text, with the numbers and the order of terms of the printed page."""
    return "\n".join(drawn(tex(value, numbers)))


def sympy_text(value: Any, names: Collection[str] = ()) -> str:
    """Return a value as text for `sympy.sympify(text, locals={name: Symbol(name), ...})`.

    Matrices are `Matrix([[..]])`, an empty basis `Matrix(n, 0, [])`, lists `[..]`, truth values `True` and `False`,
    decimals have 15 digits. A text stands for itself (in a list with quotes); a `Stated` formula is its operation with
    its operands.
    `names` are all names that the reader will take for symbols; if I or E is among them, j and e are spelled out.
    """
    return value if isinstance(value, str) else _printer("I" in names, "E" in names).text(_data(value))


def _data(value: Any) -> Any:
    """Return floats and tuples as sympy has them; the numbers in lists too."""
    if isinstance(value, list | tuple):
        return [_data(item) for item in value]
    if isinstance(value, dict):
        return {name: _data(item) for name, item in value.items()}
    if isinstance(value, float):
        return sp.Float(value, DIGITS)
    return value


class _Printer(StrPrinter):
    """sympy's own text, with matrices and collections spelled the way they are read back."""

    def __init__(self, spell_j: bool, spell_e: bool) -> None:
        StrPrinter.__init__(self, {"order": "none"})  # sympy's canonical order: sorting again takes long
        self.j = "sqrt(-1)" if spell_j else "I"
        self.e = "exp(1)" if spell_e else "E"

    def text(self, value: Any) -> str:
        return str(StrPrinter.doprint(self, value))

    def _print_ImaginaryUnit(self, _expr: Any) -> str:
        return self.j

    def _print_Exp1(self, _expr: Any) -> str:
        return self.e

    def _print_MatrixBase(self, expr: Any) -> str:
        if 0 in expr.shape:
            return f"Matrix({expr.rows}, {expr.cols}, [])"
        return f"Matrix({self._print(expr.tolist())})"

    _print_ImmutableDenseMatrix = _print_MutableDenseMatrix = _print_DenseMatrix = _print_MatrixBase

    def _print_PolyBase(self, expr: Any) -> str:
        return self._print(expr.as_expr())

    _print_Poly = _print_PolyBase

    def _print_Relational(self, expr: Any) -> str:
        if isinstance(expr, sp.Eq | sp.Ne):
            return f"{'Eq' if isinstance(expr, sp.Eq) else 'Ne'}({self._print(expr.lhs)}, {self._print(expr.rhs)})"
        return f"{self._print(expr.lhs)} {expr.rel_op} {self._print(expr.rhs)}"

    def _print_Float(self, expr: Any) -> str:
        return str(sp.Float(expr, DIGITS)) if expr.is_finite else str(expr)

    def _print_Tuple(self, expr: Any) -> str:
        return self._print(list(expr))

    _print_FiniteSet = _print_Tuple

    def _print_str(self, expr: str) -> str:
        return expr

    def _print_list(self, expr: Any) -> str:
        """Words in a list have quotes, or the list could not be read."""
        return f"[{', '.join(repr(item) if isinstance(item, str) else self._print(item) for item in expr)}]"

    def _print_dict(self, expr: Any) -> str:
        """Names with their values, in their order."""
        return f"{{{', '.join(f'{self._print(name)}: {self._print(value)}' for name, value in expr.items())}}}"

    def _print_Stated(self, expr: Stated) -> str:
        return f"{expr.operation}({', '.join(self._print(operand) for operand in expr.operands)})"


@cache
def _printer(spell_j: bool, spell_e: bool) -> _Printer:
    return _Printer(spell_j, spell_e)
