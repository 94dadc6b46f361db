"""Rules for elementary functions, piecewise definitions and the functions of whole numbers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import sympy as sp
from sympy.functions.special.tensor_functions import KroneckerDelta
from sympy.logic.boolalg import BooleanFalse, BooleanTrue

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import NoRule, NotEvaluable, Value
from solver.numeric.evaluation.walk import exactly, floored, on_the_cut, rule, times, walk
from solver.words import Phrase

Slope = Callable[[Any], Any]

ENTIRE: dict[Any, tuple[str, Slope]] = {
    sp.exp: ("exp", np.exp),
    sp.sin: ("sin", np.cos),
    sp.cos: ("cos", np.sin),
    sp.tan: ("tan", lambda a: 1 / np.cos(a) ** 2),
    sp.cot: ("cot", lambda a: 1 / np.sin(a) ** 2),
    sp.sec: ("sec", lambda a: np.sin(a) / np.cos(a) ** 2),
    sp.csc: ("csc", lambda a: np.cos(a) / np.sin(a) ** 2),
    sp.sinh: ("sinh", np.cosh),
    sp.cosh: ("cosh", np.sinh),
    sp.tanh: ("tanh", lambda a: 1 / np.cosh(a) ** 2),
    sp.re: ("re", np.ones_like),
    sp.im: ("im", np.ones_like),
    sp.conjugate: ("conj", np.ones_like),
}
"""Functions without a cut: the name in mpmath and the derivative (or a bound of it)."""

CUT: dict[Any, tuple[str, Slope]] = {
    sp.log: ("log", lambda a: 1 / a),
    sp.asin: ("asin", lambda a: 1 / np.sqrt(1 - a * a)),
    sp.acos: ("acos", lambda a: 1 / np.sqrt(1 - a * a)),
    sp.atan: ("atan", lambda a: 1 / (1 + a * a)),
    sp.asinh: ("asinh", lambda a: 1 / np.sqrt(1 + a * a)),
    sp.acosh: ("acosh", lambda a: 1 / np.sqrt(a * a - 1)),
    sp.atanh: ("atanh", lambda a: 1 / (1 - a * a)),
    sp.arg: ("arg", lambda a: 1 / a),
}
"""Functions with a cut along the real axis; there the value is the one from above."""

RECIPROCALS = {"cot": "tan", "sec": "cos", "csc": "sin"}


@rule(*ENTIRE)
def _entire(expression: Any, environment: Environment) -> Value:
    name, slope = ENTIRE[expression.func]
    argument = walk(expression.args[0], environment)
    if name in RECIPROCALS:
        value = 1 / environment.arithmetic.apply(RECIPROCALS[name], argument.value)
    else:
        value = environment.arithmetic.apply(name, argument.value)
    return _with_slope(value, argument, slope, environment)


@rule(*CUT)
def _cut(expression: Any, environment: Environment) -> Value:
    name, slope = CUT[expression.func]
    if len(expression.args) != 1:
        raise NotEvaluable(Phrase("{name} of two arguments is not evaluated", name=name))
    argument = walk(expression.args[0], environment)
    if name == "log" and np.any(environment.arithmetic.size(argument.value) == 0):
        raise ZeroDivisionError("log 0")
    value = environment.arithmetic.apply(name, on_the_cut(argument, environment.arithmetic))
    return _with_slope(value, argument, slope, environment)


def _with_slope(value: Any, argument: Value, slope: Slope, environment: Environment) -> Value:
    """f(a) with magnitude |f(a)| + |f'(a)| m."""
    arithmetic = environment.arithmetic

    def magnitude() -> Any:
        steep = np.abs(slope(arithmetic.approximate(argument.value) + 0j))
        return arithmetic.size(value) + steep * argument.magnitude

    return Value(value, magnitude)


@rule(sp.Abs)
def _absolute(expression: Any, environment: Environment) -> Value:
    argument = walk(expression.args[0], environment)
    return Value(abs(argument.value) + 0 * argument.value, argument.magnitude)


@rule(sp.sign)
def _sign(expression: Any, environment: Environment) -> Value:
    argument = walk(expression.args[0], environment)
    size = abs(argument.value)
    zero = environment.arithmetic.size(argument.value) == 0
    value = np.where(zero, 0 * argument.value, argument.value / np.where(zero, 1, size))[()]
    return Value(value, argument.magnitude / floored(argument, environment.arithmetic))


@rule(sp.atan2)
def _direction(expression: Any, environment: Environment) -> Value:
    """atan2(y, x) = arg(x + jy) of real x, y."""
    y, x = (walk(argument, environment) for argument in expression.args)
    point = Value(x.value + environment.arithmetic.imaginary() * y.value, x.magnitude + y.magnitude)
    value = environment.arithmetic.apply("arg", on_the_cut(point, environment.arithmetic))
    return _with_slope(value, point, CUT[sp.arg][1], environment)


@rule(sp.Heaviside)
def _step(expression: Any, environment: Environment) -> Value:
    """The unit step away from its jump; at the jump conventions differ, so there it has only a value that is given."""
    argument = _real(walk(expression.args[0], environment), environment)
    if expression.args[1] == 1:
        return _truth(argument >= 0, environment)
    if np.any(argument == 0):
        raise ZeroDivisionError("the unit step at its jump")
    return _truth(argument > 0, environment)


@rule(sp.DiracDelta)
def _impulse(*_: Any) -> Value:
    raise NotEvaluable("an impulse has no values")


@rule(KroneckerDelta)
def _kronecker(expression: Any, environment: Environment) -> Value:
    left, right = (walk(argument, environment) for argument in expression.args)
    return _truth(environment.arithmetic.size(left.value - right.value) == 0, environment)


def _truth(holds: Any, environment: Environment) -> Value:
    """1 where it holds, else 0."""
    one, zero = environment.arithmetic.number(1), environment.arithmetic.number(0)
    return exactly(np.where(holds, one, zero)[()], environment.arithmetic)


@rule(sp.FallingFactorial)
def _falling(expression: Any, environment: Environment) -> Value:
    x, n = expression.args
    return _falling_power(walk(x, environment), n, environment)


@rule(sp.RisingFactorial)
def _rising(expression: Any, environment: Environment) -> Value:
    x, n = expression.args
    return _falling_power(walk(x, environment), n, environment, direction=1)


@rule(sp.binomial)
def _binomial(expression: Any, environment: Environment) -> Value:
    """x (x − 1) … (x − n + 1)/n!."""
    x, n = expression.args
    falling = _falling_power(walk(x, environment), n, environment)
    scale = environment.arithmetic.rational(1, int(sp.factorial(n)))
    return Value(falling.value * scale, falling.magnitude * environment.arithmetic.size(scale))


def _falling_power(x: Value, n: Any, environment: Environment, direction: int = -1) -> Value:
    if not n.is_Integer or not 0 <= int(n) <= 200:
        raise NotEvaluable("a factorial power is evaluated for a whole number of factors only")
    result = exactly(environment.arithmetic.number(1), environment.arithmetic)
    for i in range(int(n)):
        factor = Value(x.value + direction * i, x.magnitude + i)
        result = times(factor, result, environment.arithmetic).known()
    return result


@rule(sp.factorial)
def _factorial(expression: Any, environment: Environment) -> Value:
    argument = _real(walk(expression.args[0], environment), environment)
    flat = [_factorial_of(float(each), environment) for each in np.ravel(argument)]
    value = flat[0] if np.ndim(argument) == 0 else np.array(flat, dtype=environment.arithmetic.dtype)
    return exactly(value, environment.arithmetic)


def _factorial_of(n: float, environment: Environment) -> Any:
    if n != int(n) or not 0 <= n <= 1000:
        raise NotEvaluable("the factorial is evaluated for whole numbers only")
    return environment.arithmetic.rational(int(sp.factorial(int(n))))


@rule(sp.Piecewise)
def _piecewise(expression: Any, environment: Environment) -> Value:
    """Return the first piece whose condition holds, point by point; pieces needed nowhere are not evaluated."""
    value = np.full(environment.points, environment.arithmetic.number(0), dtype=environment.arithmetic.dtype)
    magnitude = np.zeros(environment.points)
    left = np.ones(environment.points, dtype=bool)
    for piece, condition in expression.args:
        here = left & _holds(condition, environment)
        if np.any(here):
            part = walk(piece, environment)
            value = np.where(here, part.value, value)
            magnitude = np.where(here, part.magnitude, magnitude)
            left = left & ~here
    if np.any(left):
        raise NotEvaluable("no piece of a piecewise definition applies")
    return Value(value, magnitude)


COMPARISONS: dict[Any, Callable[[Any, Any], Any]] = {
    sp.Eq: np.equal,
    sp.Ne: np.not_equal,
    sp.Lt: np.less,
    sp.Le: np.less_equal,
    sp.Gt: np.greater,
    sp.Ge: np.greater_equal,
}


def _holds(condition: Any, environment: Environment) -> Any:
    """Where a condition holds: an array of P truth values (or one for all points)."""
    if isinstance(condition, BooleanTrue | BooleanFalse):
        return np.bool_(isinstance(condition, BooleanTrue))
    parts = {sp.And: np.logical_and, sp.Or: np.logical_or}.get(condition.func)
    if parts is not None:
        return parts.reduce([np.broadcast_to(_holds(each, environment), environment.points) for each in condition.args])
    if isinstance(condition, sp.Not):
        return ~_holds(condition.args[0], environment)
    compare = COMPARISONS.get(condition.func)
    if compare is None:
        raise NoRule(Phrase("the condition {condition}", condition=str(condition)))
    left, right = (_real(walk(side, environment), environment) for side in condition.args)
    return compare(left, right)


def _real(value: Value, environment: Environment) -> Any:
    """Return the values as real doubles; raises NotEvaluable if one is not real."""
    approximate = np.asarray(environment.arithmetic.approximate(value.value))
    if np.any(np.abs(approximate.imag) > 1e-9 * (1 + np.abs(approximate.real))):
        raise NotEvaluable("a comparison of numbers that are not real")
    return approximate.real
