"""F(argument) = value for the usual functions: the equations that the argument satisfies, over the real numbers."""

from __future__ import annotations

from typing import Any

import sympy as sp

from solver.exact.modelling.branches import Outcome, toward
from solver.exact.modelling.evaluation import is_not_negative, sign_of
from solver.exact.modelling.factors_of_equations import without_known_signs


def inverted(function: Any, value: Any, n: sp.Symbol) -> list[Outcome] | None:
    """Return what function = value leads to; None where the function is not known. `n` is any whole number."""
    if function.is_Pow:
        return _root(function, value)
    rule = RULES.get(function.func.__name__)
    return None if rule is None else rule(function.args[0], value, n)


def sine_is(x: Any, value: Any, n: sp.Symbol) -> list[Outcome]:
    """Return what sin x = value leads to, whatever sympy makes of the sine."""
    return _sine(x, value, n)


def _at(argument: Any, *values: Any, n: sp.Symbol | None = None, needs: tuple[Any, ...] = ()) -> list[Outcome]:
    return [toward(argument, value, integer=n, needs=needs) for value in values]


def _within_one(value: Any) -> tuple[bool, tuple[Any, ...]]:
    """Whether |value| < 1 is possible, and the condition on parameters where it is not decided."""
    below, above = sign_of(1 - value), sign_of(1 + value)
    if below == -1 or above == -1:
        return False, ()
    decided = is_not_negative(1 - value) and is_not_negative(1 + value)
    return True, () if decided else (sp.Le(sp.Abs(value), 1),)


def _sine(x: Any, value: Any, n: sp.Symbol) -> list[Outcome]:
    if value == 0:
        return _at(x, n * sp.pi, n=n)
    if value in (1, -1):
        return _at(x, value * sp.pi / 2 + 2 * n * sp.pi, n=n)
    possible, needs = _within_one(value)
    a = sp.asin(value)
    return _at(x, a + 2 * n * sp.pi, sp.pi - a + 2 * n * sp.pi, n=n, needs=needs) if possible else []


def _cosine(x: Any, value: Any, n: sp.Symbol) -> list[Outcome]:
    if value == 0:
        return _at(x, sp.pi / 2 + n * sp.pi, n=n)
    if value in (1, -1):
        return _at(x, (1 - value) * sp.pi / 2 + 2 * n * sp.pi, n=n)
    possible, needs = _within_one(value)
    a = sp.acos(value)
    return _at(x, a + 2 * n * sp.pi, -a + 2 * n * sp.pi, n=n, needs=needs) if possible else []


def _where_positive(value: Any, *, zero: bool = False) -> tuple[bool, tuple[Any, ...]]:
    sign = sign_of(value)
    if sign == -1 or (sign == 0 and not zero):
        return False, ()
    if sign is not None or (zero and is_not_negative(value)):
        return True, ()
    left = without_known_signs(value)
    return True, (sp.Ge(left, 0) if zero else sp.Gt(left, 0),)


def _exponential(x: Any, value: Any, _n: sp.Symbol) -> list[Outcome]:
    possible, needs = _where_positive(value)
    return _at(x, sp.log(value), needs=needs) if possible else []


def _modulus(x: Any, value: Any, _n: sp.Symbol) -> list[Outcome]:
    if value == 0:
        return _at(x, sp.S.Zero)
    possible, needs = _where_positive(value)
    return _at(x, value, -value, needs=needs) if possible else []


def _hyperbolic_cosine(x: Any, value: Any, _n: sp.Symbol) -> list[Outcome]:
    possible, needs = _where_positive(value - 1, zero=True)
    if value == 1:
        return _at(x, sp.S.Zero)
    return _at(x, sp.acosh(value), -sp.acosh(value), needs=needs) if possible else []


def _within(rule: Any) -> Any:
    def inverse(x: Any, value: Any, _n: sp.Symbol) -> list[Outcome]:
        possible, needs = _within_one(value)
        return _at(x, rule(value), needs=needs) if possible else []

    return inverse


def _angle(function: Any, least: Any, most: Any) -> Any:
    """asin(x) = value and the like, where the value is among those the function has."""

    def inverse(x: Any, value: Any, _n: sp.Symbol) -> list[Outcome]:
        signs = sign_of(value - least), sign_of(most - value)
        if -1 in signs:
            return []
        needs = () if None not in signs else (sp.Ge(value, least), sp.Le(value, most))
        return _at(x, function(value), needs=needs)

    return inverse


def _root(function: Any, value: Any) -> list[Outcome] | None:
    """argument^(1/q) = value: of an even root the value is not negative."""
    p, q = function.exp.p if function.exp.is_Rational else 0, getattr(function.exp, "q", 0)
    if abs(p) != 1 or q < 2:
        return None
    if p == -1:
        if sign_of(value) == 0:
            return []
        value = 1 / value
    possible, needs = _where_positive(value, zero=True)
    return _at(function.base, value**q, needs=needs) if possible else []


RULES: dict[str, Any] = {
    "sin": _sine,
    "cos": _cosine,
    "tan": lambda x, value, n: _at(x, sp.atan(value) + n * sp.pi, n=n),
    "exp": _exponential,
    "log": lambda x, value, _n: _at(x, sp.exp(value)),
    "Abs": _modulus,
    "sinh": lambda x, value, _n: _at(x, sp.asinh(value)),
    "cosh": _hyperbolic_cosine,
    "tanh": _within(sp.atanh),
    "asin": _angle(sp.sin, -sp.pi / 2, sp.pi / 2),
    "acos": _angle(sp.cos, sp.S.Zero, sp.pi),
    "atan": _angle(sp.tan, -sp.pi / 2, sp.pi / 2),
}
