"""Functions, matrices, conditions and collections as LaTeX."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import sympy as sp
from sympy.printing.latex import LatexPrinter

from solver.formula.pieces import parenthesized, summed
from solver.matrices import entries
from solver.render.numbers import NumberFormat
from solver.render.symbols import name_tex

FUNCTIONS = {
    **{name: f"\\{name}" for name in ["sin", "cos", "tan", "sinh", "cosh", "tanh", "cot", "coth", "sec", "csc"]},
    **{"asin": r"\arcsin", "acos": r"\arccos", "atan": r"\arctan", "log": r"\ln", "arg": r"\operatorname{arg}"},
    **{name: rf"\operatorname{{{name}}}" for name in ["asinh", "acosh", "atanh", "atan2", "sinc"]},
    **{"sign": r"\operatorname{sgn}", "re": r"\operatorname{Re}", "im": r"\operatorname{Im}"},
    **{"Heaviside": r"\mathbf{1}", "DiracDelta": r"\delta", "Min": r"\min", "Max": r"\max"},
}

_FRACTION_OF_LETTERS = re.compile(r"\\frac(\{(?:[^{}]|\{[^{}]*\})*\}\{[^{}]*[A-Za-z])")


class ObjectPrinter(LatexPrinter):
    """Prints what is made of expressions; how these are printed is the business of `latex.Printer`."""

    _inline = False  # inside an exponent fractions are written 1/2
    numbers: NumberFormat

    # Functions

    def _arguments(self, expr: Any) -> str:
        outside, self._inline = self._inline, False
        try:
            return parenthesized(", ".join(self._print(argument) for argument in expr.args))
        finally:
            self._inline = outside

    def _print_Function(self, expr: Any, exp: Any = None) -> str:
        name = type(expr).__name__
        written = FUNCTIONS.get(name) or name_tex(name)
        return f"{written}{f'^{{{exp}}}' if exp else ''}{self._arguments(expr)}"

    def _print_log(self, expr: Any, exp: Any = None) -> str:
        return self._print_Function(expr, exp)

    _print_DiracDelta = _print_re = _print_im = _print_Min = _print_Max = _print_arg = _print_Function

    def _print_Heaviside(self, expr: Any, _exp: Any = None) -> str:
        return rf"\mathbf{{1}}{parenthesized(self._print(expr.args[0]))}"

    def _print_KroneckerDelta(self, expr: Any, _exp: Any = None) -> str:
        shift = expr.args[0] - expr.args[1]
        rising = next((shift.coeff(symbol) > 0 for symbol in shift.free_symbols if symbol.name == "k"), True)
        return rf"\delta[{self._print(shift if rising else -shift)}]"

    def _print_Abs(self, expr: Any, exp: Any = None) -> str:
        return rf"\left|{self._print(expr.args[0])}\right|" + (f"^{{{exp}}}" if exp else "")

    def _print_Derivative(self, expr: Any) -> str:
        function, (variable, order) = expr.expr, expr.variable_count[0]
        if len(expr.variable_count) == 1 and function.is_Function and function.args == (variable,) and order in {1, 2}:
            dot = {1: r"\dot", 2: r"\ddot"}[int(order)]
            return rf"{dot}{{{name_tex(type(function).__name__)}}}{self._arguments(function)}"
        return str(LatexPrinter._print_Derivative(self, expr))

    # Matrices, conditions, collections

    def _print_MatrixBase(self, expr: Any) -> str:
        if 0 in expr.shape:
            return r"\text{empty}"
        with self._alike(expr):
            cells = [self._cell(entry) for entry in entries(expr)]
        rows = r" \\ ".join(" & ".join(cells[i : i + expr.cols]) for i in range(0, len(cells), expr.cols))
        return rf"\begin{{bmatrix}}{rows}\end{{bmatrix}}"

    @contextmanager
    def _alike(self, matrix: Any) -> Iterator[None]:
        """Where one number of a matrix is rounded, print all of them as decimals."""
        outside = self.numbers
        if any(map(outside.rounds_any, entries(matrix))):
            self.numbers = replace(outside, mode="decimal")
        try:
            yield
        finally:
            self.numbers = outside

    def _cell(self, entry: Any) -> str:
        """Print an entry; a fraction with letters below the bar is not made small, as TeX would."""
        cell = self._print(entry)
        return _FRACTION_OF_LETTERS.sub(r"\\dfrac\1", cell) if r"\frac" in cell else cell

    def _print_PolyBase(self, expr: Any) -> str:
        terms = (
            sp.Mul(coefficient, *(gen**power for gen, power in zip(expr.gens, powers, strict=True)), evaluate=True)
            for powers, coefficient in expr.terms()
        )
        return summed([self._print(term) for term in terms])

    _print_Poly = _print_PolyBase

    def _print_Relational(self, expr: Any) -> str:
        signs = {"==": "=", "!=": r"\ne", "<": "<", "<=": r"\le", ">": ">", ">=": r"\ge"}
        return f"{self._print(expr.lhs)} {signs[expr.rel_op]} {self._print(expr.rhs)}"

    def _print_And(self, expr: Any) -> str:
        parts = sorted(expr.args, key=sp.default_sort_key)
        chain = _chain(parts)
        if chain is not None:
            return " ".join(part if isinstance(part, str) else self._print(part) for part in chain)
        return r" \text{ and } ".join(self._print(part) for part in parts)

    def _print_Or(self, expr: Any) -> str:
        return r" \text{ or } ".join(self._print(part) for part in sorted(expr.args, key=sp.default_sort_key))

    def _print_BooleanTrue(self, _expr: Any) -> str:
        return r"\text{always}"

    def _print_BooleanFalse(self, _expr: Any) -> str:
        return r"\text{never}"

    def _print_bool(self, expr: Any) -> str:
        return r"\text{yes}" if expr else r"\text{no}"

    def _print_NoneType(self, _expr: None) -> str:
        return r"\text{none}"

    def _print_str(self, expr: str) -> str:
        return rf"\text{{{_text(expr)}}}"

    def _print_list(self, expr: Any) -> str:
        return r",\; ".join(self._print(item) for item in expr) or r"\text{none}"

    _print_tuple = _print_Tuple = _print_list

    def _print_FiniteSet(self, expr: Any) -> str:
        return self._print_list(sorted(expr.args, key=sp.default_sort_key))


def _chain(parts: list[Any]) -> list[Any] | None:
    """Return 0 < K < 6 as pieces, for two bounds of one symbol; else None."""
    if len(parts) != 2 or not all(
        isinstance(part, sp.StrictLessThan | sp.LessThan | sp.StrictGreaterThan | sp.GreaterThan) for part in parts
    ):
        return None
    rising = [part if isinstance(part, sp.StrictLessThan | sp.LessThan) else part.reversed for part in parts]
    for first, second in (rising, rising[::-1]):
        if first.rhs == second.lhs and first.rhs.is_Symbol:
            sign = {"<": "<", "<=": r"\le"}
            return [first.lhs, sign[first.rel_op], first.rhs, sign[second.rel_op], second.rhs]
    return None


def _text(words: str) -> str:
    r"""Return words as they stand in \text{..}: letters, digits and plain punctuation; anything else is left out."""
    return "".join(
        letter for letter in words if (letter.isascii() and letter.isalnum()) or letter in " .,;:!?()[]+-/='*"
    )
