"""Functions, matrices, conditions and collections as formulas."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from functools import lru_cache
from operator import is_
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.printing.latex import LatexPrinter

from solver.formula import MathProblem, read
from solver.formula.building import as_factor, over, parenthesized, power, row, separated, summed, walk
from solver.formula.nodes import (
    Accent,
    Fenced,
    Fraction,
    Function,
    Node,
    Operator,
    Root,
    Row,
    Scripts,
    Space,
    Styled,
    Symbol,
    Table,
    Text,
)
from solver.matrices import entries
from solver.render.numbers import NumberFormat
from solver.render.symbols import named

FUNCTIONS: dict[str, Node] = {
    **{name: Function(name) for name in ["sin", "cos", "tan", "sinh", "cosh", "tanh", "cot", "coth", "sec", "csc"]},
    **{"asin": Function("arcsin"), "acos": Function("arccos"), "atan": Function("arctan"), "log": Function("ln")},
    **{name: Function(name, named=True) for name in ["arg", "asinh", "acosh", "atanh", "atan2", "sinc"]},
    **{name: Function(each, named=True) for name, each in [("sign", "sgn"), ("re", "Re"), ("im", "Im")]},
    **{"Heaviside": Styled(r"\mathbf", row("1")), "DiracDelta": Symbol(r"\delta")},
    **{"Min": Function("min"), "Max": Function("max")},
}
_SYMPY = {"imaginary_unit": "j", "ln_notation": True, "mat_str": "bmatrix", "mat_delim": ""}


class ObjectPrinter:
    """Prints what is made of expressions; how these are printed is the business of `latex.Printer`.

    The method that prints an object has the name of its class, or of the nearest above that has one, after `_print_`.
    """

    _inline = False  # inside an exponent fractions are written 1/2
    numbers: NumberFormat

    def _print(self, expr: Any) -> Row:
        name = _method_for(type(self), type(expr))  # type: ignore[arg-type]  # mypy takes classes for not hashable
        shown: Row = getattr(self, name)(expr)
        return shown

    @staticmethod
    def _by_sympy(expr: Any) -> Row:
        """Print what has no method here as sympy does, as far as its LaTeX is of our dialect."""
        try:
            return read(sp.latex(expr, **_SYMPY))
        except MathProblem:
            return row(Text(_words(str(expr))))

    # Functions

    def _arguments(self, expr: Any) -> Node:
        outside, self._inline = self._inline, False
        try:
            return parenthesized(separated([self._print(argument) for argument in expr.args], COMMA))
        finally:
            self._inline = outside

    def _print_Function(self, expr: Any) -> Row:
        name = type(expr).__name__
        if name in FUNCTIONS:
            return row(FUNCTIONS[name], self._arguments(expr))
        if hasattr(LatexPrinter, f"_print_{name}"):
            return self._by_sympy(expr)
        return row(named(name), self._arguments(expr))

    def _print_Heaviside(self, expr: Any) -> Row:
        return row(FUNCTIONS["Heaviside"], parenthesized(self._print(expr.args[0])))

    def _print_DiracDelta(self, expr: Any) -> Row:
        """An impulse; its derivatives with dots, from the third on with their order in brackets."""
        order = int(expr.args[1]) if len(expr.args) > 1 else 0
        sign: Node = FUNCTIONS["DiracDelta"]
        if order in {1, 2}:
            sign = Accent({1: r"\dot", 2: r"\ddot"}[order], sign)
        elif order:
            sign = Scripts(sign, None, row(Fenced("(", row(str(order)), ")")))
        return row(sign, parenthesized(self._print(expr.args[0])))

    def _print_Piecewise(self, expr: Any) -> Row:
        pieces = (tuple(each.args) for each in expr.args)
        return row(Table("cases", tuple((self._print(value), self._span(when)) for value, when in pieces)))

    def _span(self, condition: Any) -> Row:
        """The condition a ≤ x < b in one."""
        if not isinstance(condition, sp.And) or len(condition.args) != 2:
            return row(self._print(condition))
        bounds: tuple[Any, ...] = condition.args
        low, high = sorted(bounds, key=lambda each: isinstance(each, sp.StrictLessThan))
        cells = (low.rhs, r"\le", low.lhs, "<", high.rhs)
        return row(*(each if isinstance(each, str) else self._print(each) for each in cells))

    def _print_KroneckerDelta(self, expr: Any) -> Row:
        shift = expr.args[0] - expr.args[1]
        rising = next((shift.coeff(symbol) > 0 for symbol in shift.free_symbols if symbol.name == "k"), True)
        return row(r"\delta", Fenced("(", self._print(shift if rising else -shift), ")"))

    def _print_Abs(self, expr: Any) -> Row:
        return row(Fenced("|", self._print(expr.args[0]), "|", tall=True))

    def _print_Derivative(self, expr: Any) -> Row:
        """A derivative of a function of one variable as a quotient of differentials, dv/dt."""
        function, (variable, order) = expr.expr, expr.variable_count[0]
        if len(expr.variable_count) > 1 or not function.is_Function or function.args != (variable,):
            return self._by_sympy(expr)
        d, x, times = row("d"), self._print(variable), self._print(order)
        above, below = (d, x) if order == 1 else (power(d, times), power(x, times))
        return over(row(above, named(type(function).__name__)), row(d, below))

    def _print_Integral(self, expr: Any) -> Row:
        """Integrals with their limits, the innermost variable last but for those around it."""
        if any(len(each) != 3 for each in expr.limits):
            return self._by_sympy(expr)
        signs = [Scripts(INTEGRAL, self._print(low), self._print(high)) for _, low, high in reversed(expr.limits)]
        ends = [
            item for variable, *_ in expr.limits for item in (Space(r"\,"), Symbol("d"), *self._print(variable).items)
        ]
        return row(*signs, as_factor(self._print(expr.function)), *ends)

    def _print_Framed(self, expr: Any) -> Row:
        return row(Styled(r"\boxed", self._print(expr.args[0])))

    # Matrices, conditions, collections

    def _print_MatrixBase(self, expr: Any) -> Row:
        if 0 in expr.shape:
            return row(Text("empty"))
        with self._alike(expr):
            cells = [_readable(self._print(entry)) for entry in entries(expr)]
        return row(Table("bmatrix", tuple(tuple(cells[i : i + expr.cols]) for i in range(0, len(cells), expr.cols))))

    @contextmanager
    def _alike(self, matrix: Any) -> Iterator[None]:
        """Where one number of a matrix is a decimal, print all of them as decimals."""
        outside = self.numbers
        if outside.mode == "exact" and any(entry.has(sp.Float) for entry in entries(matrix) if not entry.is_Rational):
            self.numbers = replace(outside, mode="decimal")
        try:
            yield
        finally:
            self.numbers = outside

    def _print_PolyBase(self, expr: Any) -> Row:
        terms = (
            sp.Mul(coefficient, *(gen**power for gen, power in zip(expr.gens, powers, strict=True)), evaluate=True)
            for powers, coefficient in expr.terms()
        )
        return summed([self._print(term) for term in terms])

    _print_Poly = _print_PolyBase

    def _print_Relational(self, expr: Any) -> Row:
        return row(self._print(expr.lhs), SIGNS[expr.rel_op], self._print(expr.rhs))

    def _print_And(self, expr: Any) -> Row:
        parts = sorted(expr.args, key=sp.default_sort_key)
        shown = []
        while parts:
            first, *parts = parts
            second = next((each for each in parts if _chain([first, each])), None)
            chain = [first] if second is None else _chain([first, second])
            parts = [each for each in parts if each is not second]
            shown.append(row(*(part if isinstance(part, Operator) else self._print(part) for part in chain or ())))
        return separated(shown, Text(" and "))

    def _print_Or(self, expr: Any) -> Row:
        return separated(map(self._print, sorted(expr.args, key=sp.default_sort_key)), Text(" or "))

    def _print_BooleanTrue(self, _expr: Any) -> Row:
        return row(Text("always"))

    def _print_BooleanFalse(self, _expr: Any) -> Row:
        return row(Text("never"))

    def _print_bool(self, expr: Any) -> Row:
        return row(Text("yes" if expr else "no"))

    def _print_NoneType(self, _expr: None) -> Row:
        return row(Text("none"))

    def _print_str(self, expr: str) -> Row:
        return row(Text(_words(expr)))

    def _print_list(self, expr: Any) -> Row:
        return separated([self._print(item) for item in expr], COMMA, Space(r"\;")) if expr else row(Text("none"))

    _print_tuple = _print_Tuple = _print_list

    def _print_dict(self, expr: Any) -> Row:
        """Names with their values, in their order; an unknown that is its own value may have any."""
        if not expr:
            return row(Text("none"))
        shown = [self._named_value(name, value) for name, value in expr.items()]
        body = separated(shown, COMMA, Space(r"\;"))
        return row(Fenced(r"\{", body, r"\}", tall=any(isinstance(each, Fraction) for each in walk(body))))

    _print_Dict = _print_dict

    def _named_value(self, name: Any, value: Any) -> Row:
        if isinstance(name, str):
            return row(self._print(name.replace("_", " ")), Text(": "), self._print(value))
        return row(self._print(name), *((Text(" free"),) if name == value else (Operator("="), self._print(value))))

    def _print_FiniteSet(self, expr: Any) -> Row:
        return self._print_list(sorted(expr.args, key=sp.default_sort_key))


@lru_cache(maxsize=512)
def _method_for(printer: type[ObjectPrinter], kind: type) -> str:
    """Return the name of the method that prints objects of a class."""
    classes = kind.__mro__
    if AppliedUndef in classes:  # the class of f(t) is called f
        classes = classes[classes.index(AppliedUndef) :]
    names = (f"_print_{each.__name__}" for each in classes)
    return next((name for name in names if hasattr(printer, name)), "_by_sympy")


COMMA = Operator(",")
INTEGRAL = Operator(r"\int")
SIGNS = {sign: Operator(each) for sign, each in [("==", "="), ("!=", r"\ne"), ("<", "<"), ("<=", r"\le"), (">", ">"),
                                                 (">=", r"\ge")]}  # fmt: skip


def _readable(entry: Row) -> Row:
    """Return an entry of a matrix; a fraction with letters below the bar is not made small, as TeX would."""
    items = tuple(map(_displayed, entry.items))
    return entry if all(map(is_, items, entry.items)) else Row(items)


def _displayed(node: Node) -> Node:
    """Return the node itself where there is no such fraction in it: it is shared."""
    if isinstance(node, Fraction):
        letters = any(isinstance(each, Symbol | Root | Function) for each in walk(node.below))
        return replace(node, command=r"\dfrac") if letters else node
    if isinstance(node, Fenced):
        body = _readable(node.body)
        return node if body is node.body else replace(node, body=body)
    if isinstance(node, Scripts):
        base = _displayed(node.base)
        return node if base is node.base else replace(node, base=base)
    return node


def _chain(parts: list[Any]) -> list[Any] | None:
    """Return 0 < K < 6 as pieces, for two bounds of one symbol; else None."""
    if len(parts) != 2 or not all(
        isinstance(part, sp.StrictLessThan | sp.LessThan | sp.StrictGreaterThan | sp.GreaterThan) for part in parts
    ):
        return None
    rising = [part if isinstance(part, sp.StrictLessThan | sp.LessThan) else part.reversed for part in parts]
    for first, second in (rising, rising[::-1]):
        if first.rhs == second.lhs and first.rhs.is_Symbol:
            return [first.lhs, SIGNS[first.rel_op], first.rhs, SIGNS[second.rel_op], second.rhs]
    return None


def _words(words: str) -> str:
    r"""Return words as they stand in \text{..}: letters, digits and plain punctuation; anything else is left out."""
    return "".join(
        letter for letter in words if (letter.isascii() and letter.isalnum()) or letter in " .,;:!?()[]+-/='*"
    )
