"""The syntax tree as a sympy expression: exact, evaluated as sympy does by itself, never expanded.

Only trees that passed `check_shape` and `check_numbers` may come here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from typing import Any

from solver.lazy import sympy as sp
from solver.problem.expressions.errors import ExpressionError
from solver.problem.expressions.names import Names
from solver.problem.expressions.syntax import Call, Name, Node, Number, Power, Product, Signal, Sum

_SHORT = 12
"""The number of operations up to which an absolute value is looked for."""


def build(node: Node, names: Names, plus_minus: int = 1, decimals: Mapping[int, sp.Symbol] | None = None) -> sp.Expr:
    """Return the expression; `plus_minus` (1 or -1) says which of the two values of ± is meant.

    `decimals` has symbols to stand for the decimals at some places of the text. Raises ExpressionError, with the place,
    where there is no value (1/(x - x), tan(pi/2), inf - inf).
    """
    expression: sp.Expr = _Builder(names, plus_minus, decimals).build(node)
    return expression


def build_fraction(node: Node, names: Names) -> tuple[sp.Expr, sp.Expr]:
    """Return numerator and denominator as written: (s+1)/((s+1)(s+2)) keeps the factor that sympy would cancel.

    Only what is above and below the outermost fraction bars is told apart. Raises ExpressionError.
    """
    builder, sides = _Builder(names, 1), {"*": [sp.Integer(1)], "/": [sp.Integer(1)]}
    for operator, factor in _factors(node):
        sides[operator].append(builder.build(factor) if operator == "*" else 1 / builder.factor("/", factor))
    return sp.Mul(*sides["*"]), sp.Mul(*sides["/"])


def _factors(node: Node, operator: str = "*") -> Iterator[tuple[str, Node]]:
    """Yield the factors above ("*") and below ("/") the fraction bars of a product and the products in it."""
    other = {"*": "/", "/": "*"}[operator]
    match node:
        case Product():
            for own, factor in node.factors:
                yield from _factors(factor, operator if own == "*" else other)
        case Sum(terms=((sign, term),)):
            if sign == "-":
                yield "*", Number(node.at, node.at, Fraction(-1))
            yield from _factors(term, operator)
        case _:
            yield operator, node


class _Builder:
    """Builds the parts of one expression."""

    def __init__(self, names: Names, plus_minus: int, decimals: Mapping[int, sp.Symbol] | None = None) -> None:
        self.names = names
        self.plus_minus = plus_minus
        self.decimals = decimals or {}

    def build(self, node: Node) -> Any:
        result = _RULES[type(node)](self, node)
        if result in (sp.nan, sp.zoo) or isinstance(result, sp.AccumBounds) or result.has(sp.nan, sp.zoo):
            raise ExpressionError("this has no value", node.at, node.end - node.at)
        return result

    def number(self, node: Number) -> Any:
        if node.place in self.decimals:
            return self.decimals[node.place]
        return sp.Rational(node.value.numerator, node.value.denominator)

    def name(self, node: Name) -> Any:
        names = self.names
        for table in (names.variables, names.values, names.symbols):
            if node.name in table:
                return table[node.name]
        if node.name in _CONSTANTS:
            return getattr(sp, _CONSTANTS[node.name])
        return sp.Symbol(node.name, real=True)

    def signal(self, node: Signal) -> Any:
        """x(t), its derivative, or x at another argument."""
        function = self.names.functions[node.name]
        variable = function.args[0]
        argument = variable if node.argument is None else self.build(node.argument)
        if not node.order:
            return function.func(argument)
        if argument != variable:
            message = f"a derivative is a function of {variable}: {node.name}' or {node.name}'({variable}) is expected"
            raise ExpressionError(message, node.at, node.end - node.at, f"{node.name}'")
        return sp.Derivative(function, (variable, node.order))

    def sum(self, node: Sum) -> Any:
        signs = {"+": 1, "-": -1, "±": self.plus_minus}
        return sp.Add(*[signs[sign] * self.build(term) for sign, term in node.terms])

    def product(self, node: Product) -> Any:
        return sp.Mul(*[self.factor(operator, factor) for operator, factor in node.factors])

    def factor(self, operator: str, node: Node) -> Any:
        factor = self.build(node)
        if operator == "*":
            return factor
        if factor == 0:
            raise ExpressionError("division by zero", node.at, node.end - node.at)
        return 1 / factor

    def power(self, node: Power) -> Any:
        return _power(self.build(node.base), self.build(node.exponent))

    def call(self, node: Call) -> Any:
        argument = self.build(node.argument)
        if node.function in ("step", "delta"):
            return self.distribution(node, argument)
        if node.function == "inv":
            return self.factor("/", node.argument)
        if node.function == "abs":
            return _absolute(argument)
        if node.function == "sqrt":
            return _power(argument, sp.S.Half)
        return getattr(sp, node.function)(argument)  # the parser lets only names of the table through

    def distribution(self, node: Call, argument: Any) -> Any:
        """A step or an impulse; its argument must not be known to be complex."""
        if argument.is_extended_real is False:
            place = node.argument
            message = f"the argument of {node.function} is expected to be real"
            raise ExpressionError(message, place.at, place.end - place.at)
        if node.order:
            return sp.DiracDelta(argument, node.order, evaluate=False)
        function = sp.Heaviside if node.function == "step" else sp.DiracDelta
        return function(argument) if argument.is_extended_real else function(argument, evaluate=False)


def _power(base: Any, exponent: Any) -> Any:
    """A power; roots of functions of functions are only stated, since sympy would look for the signs of all factors."""
    nested = any(function.args[0].has(sp.Function) for function in base.atoms(sp.Function))
    return sp.Pow(base, exponent, evaluate=bool(exponent.is_Integer or not nested))


def _absolute(argument: Any) -> Any:
    """|x|, found where x is a short polynomial; else stated, since sympy would multiply x by its conjugate."""
    short = argument.count_ops() <= _SHORT and not argument.has(sp.Function)
    return sp.Abs(argument) if short else sp.Abs(argument, evaluate=False)


_CONSTANTS = {"pi": "pi", "e": "E", "j": "I", "inf": "oo"}
"""Constants and their names in sympy, which is imported only when something is built."""

_RULES: dict[type[Node], Callable[[_Builder, Any], Any]] = {
    Number: _Builder.number,
    Name: _Builder.name,
    Signal: _Builder.signal,
    Sum: _Builder.sum,
    Product: _Builder.product,
    Power: _Builder.power,
    Call: _Builder.call,
}
