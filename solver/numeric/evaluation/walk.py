"""The walk over an expression, and the rules for numbers, symbols, sums, products, powers and matrices."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

import numpy as np
import sympy as sp
from sympy.matrices.matrixbase import MatrixBase

from solver.matrices import entries
from solver.numeric.evaluation.arithmetic import Arithmetic
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import SAFETY, NoRule, NotEvaluable, Value
from solver.stated import Stated
from solver.words import Phrase

Rule = Callable[[Any, Environment], Value]
RULES: dict[type, Rule] = {}
"""How to evaluate an expression of a class; classes not listed take the rule of their nearest base."""


def rule(*classes: type) -> Callable[[Rule], Rule]:
    """Register the rule of some classes."""

    def register(function: Rule) -> Rule:
        RULES.update(dict.fromkeys(classes, function))
        return function

    return register


def walk(expression: Any, environment: Environment) -> Value:
    """Return the values at all points; entries that are not finite stay as nan or inf (in doubles)."""
    cls = type(expression)
    function = RULES.get(cls) or _rule_of_base(cls)
    if function is _symbol or function is _rational:  # as quick as to look up what is remembered
        return function(expression, environment)
    kept = _is_kept(expression)
    known = environment.memo.get(expression) if kept else None
    if known is not None:
        return known
    result = function(expression, environment)
    if kept:
        environment.memo[expression] = result
    return result


def _is_kept(formula: Any) -> bool:
    """Whether the value of a formula is remembered: not where it holds what may change, or a Python float.

    A float equals the decimal of sympy that is known to so many digits only.
    """
    if isinstance(formula, sp.Basic):
        return True
    if isinstance(formula, Stated):
        return all(isinstance(each, int) or _is_kept(each) for each in formula.operands)
    return False


def _rule_of_base(cls: type) -> Rule:
    for base in cls.__mro__:
        if base in RULES:
            RULES[cls] = RULES[base]
            return RULES[base]
    raise NoRule(cls.__name__)


def exactly(value: Any, arithmetic: Arithmetic) -> Value:
    """Return a value rounded once."""
    return Value(value, lambda: arithmetic.size(value))


@rule(sp.Symbol)
def _symbol(symbol: Any, environment: Environment) -> Value:
    if symbol not in environment.values:
        raise NotEvaluable(Phrase("no value for the symbol {name}", name=symbol.name))
    return exactly(environment.values[symbol], environment.arithmetic)


@rule(int, float, complex)
def _python_number(number: Any, environment: Environment) -> Value:
    return exactly(environment.arithmetic.number(number), environment.arithmetic)


@rule(Fraction)
def _fraction(number: Fraction, environment: Environment) -> Value:
    return exactly(environment.arithmetic.rational(number.numerator, number.denominator), environment.arithmetic)


@rule(sp.Rational)
def _rational(number: Any, environment: Environment) -> Value:
    return exactly(environment.arithmetic.rational(int(number.p), int(number.q)), environment.arithmetic)


@rule(sp.Float)
def _float(number: Any, environment: Environment) -> Value:
    """Return a decimal: known to its own digits only, whatever the arithmetic."""
    arithmetic = environment.arithmetic
    value = arithmetic.number(number._to_mpmath(max(number._prec, 53)))
    unit = max(2.0 ** -int(number._prec), arithmetic.eps)
    return Value(value, arithmetic.size(value) * (unit / arithmetic.eps))


@rule(type(sp.pi), type(sp.E))
def _constant(number: Any, environment: Environment) -> Value:
    return exactly(environment.arithmetic.constant("pi" if number is sp.pi else "e"), environment.arithmetic)


@rule(type(sp.oo), type(-sp.oo))
def _infinity(number: Any, _environment: Environment) -> Value:
    return Value(np.inf if number == sp.oo else -np.inf, 0.0)


@rule(type(sp.I))
def _imaginary_unit(_: Any, environment: Environment) -> Value:
    return Value(environment.arithmetic.imaginary(), 1.0)


@rule(sp.CRootOf)
def _root_of(root: Any, environment: Environment) -> Value:
    number = root.evalf(environment.arithmetic.digits + 10)
    real, imaginary = (part._to_mpmath(part._prec) for part in map(sp.Float, number.as_real_imag()))
    arithmetic = environment.arithmetic
    return exactly(arithmetic.number(real) + arithmetic.imaginary() * arithmetic.number(imaginary), arithmetic)


@rule(sp.Add)
def _add(expression: Any, environment: Environment) -> Value:
    value: Any = 0
    parts = [walk(term, environment) for term in expression.args]
    for part in parts:
        value = part.value + value  # in this order: a constant of mpmath on the left of an array is slow
    return Value(value, lambda: sum((part.magnitude for part in parts), 0.0))


@rule(sp.Mul)
def _multiply(expression: Any, environment: Environment) -> Value:
    first, *others = expression.args
    result = walk(first, environment)
    for factor in others:
        result = times(walk(factor, environment), result, environment.arithmetic)
    return result


def times(left: Value, right: Value, arithmetic: Arithmetic) -> Value:
    """Return the product of scalars; an error of one is multiplied by the size, not by the error, of the other."""

    def magnitude() -> Any:
        return arithmetic.size(left.value) * right.magnitude + left.magnitude * arithmetic.size(right.value)

    return Value(left.value * right.value, magnitude)


@rule(sp.Pow)
def _power(expression: Any, environment: Environment) -> Value:
    base, exponent = expression.args
    if exponent.is_Integer:
        return whole_power(walk(base, environment), int(exponent), environment.arithmetic)
    if exponent.is_Rational and exponent.q == 2:
        root = square_root(walk(base, environment), environment.arithmetic)
        return whole_power(root, int(exponent.p), environment.arithmetic)
    return general_power(walk(base, environment), walk(exponent, environment), environment.arithmetic)


def whole_power(base: Value, exponent: int, arithmetic: Arithmetic) -> Value:
    """Bⁿ of a scalar and a whole n."""
    value = base.value**exponent

    def magnitude() -> Any:
        if exponent < 0:
            return arithmetic.size(value) * (1.0 - exponent * (base.magnitude / floored(base, arithmetic)))
        rest = arithmetic.size(base.value) ** max(0, exponent - 1)
        return max(1, exponent) * base.magnitude ** min(1, exponent) * rest

    return Value(value, magnitude)


def square_root(base: Value, arithmetic: Arithmetic) -> Value:
    """√b, the principal value; near b = 0 its error is the root of the error of b."""
    value = arithmetic.apply("sqrt", on_the_cut(base, arithmetic))
    return Value(value, lambda: arithmetic.size(value) + base.magnitude / np.sqrt(floored(base, arithmetic)))


def general_power(base: Value, exponent: Value, arithmetic: Arithmetic) -> Value:
    """Return the principal value of a scalar power: b^r = e^{r log b}; |Δ| ≤ |b^r| (|r| |Δb|/|b| + |log b| |Δr|)."""
    value = arithmetic.power(on_the_cut(base, arithmetic), exponent.value)
    floor = floored(base, arithmetic)
    order = arithmetic.approximate(exponent.value)
    size = np.maximum(arithmetic.size(value), np.where(np.real(order) > 0, np.abs(floor ** np.real(order)), 0.0))
    return Value(
        value,
        size * (1.0 + np.abs(order) * base.magnitude / floor + (np.abs(np.log(floor)) + 4.0) * exponent.magnitude),
    )


def floored(value: Value, arithmetic: Arithmetic) -> Any:
    """|x|, but not less than its error: what to divide by when errors are estimated."""
    return np.maximum(arithmetic.size(value.value), np.maximum(arithmetic.eps * value.magnitude, 1e-300))


def on_the_cut(value: Value, arithmetic: Arithmetic) -> Any:
    """Return the argument of a function cut along the real axis: an imaginary part that is only rounding is +0.

    Else √(−5 − 1e-17 j) would be −2.236j where −5 is meant.
    """
    imaginary = arithmetic.apply("im", value.value)
    only_rounding = arithmetic.size(imaginary) <= SAFETY * arithmetic.eps * value.magnitude
    return np.where(only_rounding, arithmetic.apply("re", value.value), value.value)[()]


@rule(MatrixBase)
def _matrix(matrix: Any, environment: Environment) -> Value:
    return environment.stack([walk(entry, environment) for entry in entries(matrix)], matrix.shape)


class Entries(NamedTuple):
    """A matrix given by its entries, row by row: what is evaluated once need not be made a matrix of sympy's."""

    each: Sequence[Any]
    shape: tuple[int, int]


@rule(Entries)
def _entries(matrix: Entries, environment: Environment) -> Value:
    return environment.stack([walk(entry, environment) for entry in matrix.each], matrix.shape)


@rule(list, tuple)
def _list(items: Any, environment: Environment) -> Value:
    """Return a list of scalars (P, k), or of equal lists of scalars (P, rows, columns)."""
    rows = [list(item) for item in items if isinstance(item, list | tuple)]
    if not rows:
        return environment.stack([walk(item, environment) for item in items], (len(items),))
    if len(rows) != len(items) or len({len(row) for row in rows}) != 1:
        raise NotEvaluable("a list of lists of different lengths is not a matrix")
    return environment.stack([walk(entry, environment) for row in rows for entry in row], (len(rows), len(rows[0])))
