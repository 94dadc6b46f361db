"""What an expression would cost, judged on its syntax tree before any algebra sees a number.

Numbers are added, multiplied and raised to powers as soon as the algebra meets them, so that a short text can stand
for a number that fills the memory: 9^9^9, but also exp(10^9 log(2)). Constants are evaluated numerically where their
sign matters, so exponentials of large numbers are bounded as well: exp(exp(exp(9))).
"""

from __future__ import annotations

import cmath
from collections.abc import Callable
from typing import Any

from solver.problem.expressions import size
from solver.problem.expressions.errors import ExpressionError
from solver.problem.expressions.names import Names
from solver.problem.expressions.size import Size
from solver.problem.expressions.syntax import Call, Name, Node, Number, Power, Product, Signal, Sum

MAX_BITS = 2048
MAX_ROOT_BITS = 64
MAX_OTHER_ROOT_BITS = 256
MAX_EXPONENT = 64
MAX_POWER_OF_MATRIX = 10_000
"""The largest whole exponent of a matrix by itself, which is never multiplied out as a polynomial."""

MAX_ARGUMENT = {"exp": 1e3, "sinh": 1e3, "cosh": 1e3, "tanh": 1e3, "sin": 1e30, "cos": 1e30, "tan": 1e30}
"""How large the argument of a function may be if it is a constant."""

_EVALUATE: dict[str, Callable[[complex], complex]] = {
    "sqrt": cmath.sqrt,
    "exp": cmath.exp,
    "log": cmath.log,
    "sin": cmath.sin,
    "cos": cmath.cos,
    "tan": cmath.tan,
    "asin": cmath.asin,
    "acos": cmath.acos,
    "atan": cmath.atan,
    "sinh": cmath.sinh,
    "cosh": cmath.cosh,
    "tanh": cmath.tanh,
    "abs": lambda x: complex(abs(x)),
    "step": lambda x: complex(x.real > 0),
    "delta": lambda _: 0,
    "inv": lambda x: 1 / x,
}


def check_numbers(node: Node, names: Names, plus_minus: int = 1) -> None:
    """Raise ExpressionError, with the place, if a number that sympy would make of the expression is too large.

    `plus_minus` (1 or -1) says which of the two values of ± is meant.
    """
    _Bounds(names, plus_minus).size(node)


class _Bounds:
    """Sizes of the parts of one expression; each rule raises an error where a limit is passed."""

    def __init__(self, names: Names, plus_minus: int) -> None:
        self.names = names
        self.signs = {"+": "+", "-": "-", "±": "+" if plus_minus > 0 else "-"}

    def size(self, node: Node) -> Size:
        result = _RULES[type(node)](self, node)
        if result.bits > MAX_BITS:
            raise _error(f"a number of more than {MAX_BITS} bits may arise here", node)
        return result

    def number(self, node: Number) -> Size:
        return size.of_number(node.value)

    def name(self, node: Name) -> Size:
        for table in (self.names.variables, self.names.values):
            if node.name in table:
                return size.of_value(table[node.name])
        return size.CONSTANTS[node.name] if self.names.is_constant(node.name) else size.SYMBOL

    def signal(self, node: Signal) -> Size:
        if node.argument:
            self.size(node.argument)
        return size.SYMBOL

    def sum(self, node: Sum) -> Size:
        return size.plus([(self.signs[sign], self.size(term)) for sign, term in node.terms])

    def product(self, node: Product) -> Size:
        above = size.times([self.size(factor) for operator, factor in node.factors if operator == "*"])
        divisors = []
        for factor in (factor for operator, factor in node.factors if operator == "/"):
            divisors.append(self.size(factor))
            if divisors[-1].value == 0:
                raise _error("division by zero", factor)
        if not divisors:
            return above
        return size.times([above, size.inverse(size.times(divisors))])

    def power(self, node: Power) -> Size:
        base, exponent = self.size(node.base), self.size(node.exponent)
        if isinstance(node.base, Name) and node.base.name == "e" and self.names.is_constant("e"):
            return self.function("exp", exponent, node.exponent)
        most = MAX_POWER_OF_MATRIX if self.names.is_matrix(node.base) else MAX_EXPONENT
        if not exponent.as_exponent <= most:
            raise _error(f"exponents go from -{most} to {most}", node.exponent)
        if exponent.value is not None and exponent.value.denominator == 1:
            if base.value == 0 and exponent.value <= 0:
                raise _error("division by zero" if exponent.value else "0^0 has no value", node)
            result = size.integer_power(base, int(exponent.value))
        else:
            self.check_root(base, node.base)
            result = size.power(base, exponent)
        if result.logs and result.reach > MAX_EXPONENT:
            raise _error("a power of an exponential of a logarithm is too large", node)
        return result

    def call(self, node: Call) -> Size:
        return self.function(node.function, self.size(node.argument), node.argument)

    def function(self, name: str, argument: Size, node: Node) -> Size:
        """The size of a function's value; `node` is its argument."""
        if name in ("sqrt", "abs"):
            self.check_root(argument, node)
        if name == "inv":
            if argument.value == 0:
                raise _error("division by zero", node)
            return size.inverse(argument)
        if name == "log" and argument.value == 0:
            raise _error("log(0) has no value", node)
        limit = MAX_ARGUMENT.get(name)
        if limit and argument.constant and not argument.magnitude <= limit:
            raise _error(f"the argument of {name} is too large, or cannot be bounded", node)
        if name == "exp" and argument.logs and not argument.weight <= MAX_EXPONENT:
            raise _error("an exponential of a logarithm is too large", node)
        return size.function(name, argument, _EVALUATE[name])

    def check_root(self, base: Size, node: Node) -> None:
        """Roots of whole numbers are simplified by looking for factors, which takes time if they are long."""
        too_long = base.bits > MAX_OTHER_ROOT_BITS
        if base.value is not None:
            too_long = max(abs(base.value.numerator), base.value.denominator).bit_length() > MAX_ROOT_BITS
        if too_long:
            raise _error("the numbers under a root are too long", node)


def _error(message: str, node: Node) -> ExpressionError:
    return ExpressionError(message, node.at, node.end - node.at)


_RULES: dict[type[Node], Callable[[_Bounds, Any], Size]] = {
    Number: _Bounds.number,
    Name: _Bounds.name,
    Signal: _Bounds.signal,
    Sum: _Bounds.sum,
    Product: _Bounds.product,
    Power: _Bounds.power,
    Call: _Bounds.call,
}
