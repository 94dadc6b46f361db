"""Expressions as functions of numbers of any kind mpmath has: doubles, many digits, intervals."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import reduce
from random import Random
from typing import Any

import mpmath
import sympy as sp

from solver.exact.linear_algebra.signs import possible_signs

Number = Any
Evaluator = Callable[[Any, Sequence[Number]], Number]
"""Takes a context of mpmath and the values of the symbols."""

DIGITS = 60
"""What decimals are computed with, so that none of those shown is lost."""
TRIALS = 3
SMALL = mpmath.mpf(10) ** -30
"""What 60 digits leave of an expression that is zero, in comparison to its parts."""


def evaluator(expression: Any, symbols: Sequence[sp.Symbol]) -> Evaluator:
    """Return the function of the values of some symbols; raises KeyError at a function that is not known."""
    places = {symbol: i for i, symbol in enumerate(symbols)}
    return _compiled(expression, places)


def _compiled(e: Any, places: Mapping[sp.Symbol, int]) -> Evaluator:
    if e in places:
        i = places[e]
        return lambda _ctx, values: values[i]
    if e.is_Rational:
        p, q = int(e.p), int(e.q)
        return (lambda ctx, _values: ctx.mpf(p)) if q == 1 else (lambda ctx, _values: ctx.mpf(p) / ctx.mpf(q))
    if e.is_Float:
        return _compiled(sp.Rational(e), places)
    if e in CONSTANTS:
        return CONSTANTS[e]
    if e.is_Pow:
        return _power(e, places)
    parts = [_compiled(each, places) for each in e.args]
    function = FUNCTIONS[e.func.__name__]
    return lambda ctx, values: function(ctx, *(part(ctx, values) for part in parts))


def _power(e: Any, places: Mapping[sp.Symbol, int]) -> Evaluator:
    base = _compiled(e.base, places)
    if e.exp.is_Integer:
        n = int(e.exp)
        return lambda ctx, values: base(ctx, values) ** n if n > 0 else 1 / base(ctx, values) ** -n
    if e.exp == sp.Rational(1, 2):
        return lambda ctx, values: ctx.sqrt(_not_negative(ctx, base(ctx, values)))
    exponent = _compiled(e.exp, places)
    if e.exp.is_integer and e.base.is_Number:
        number = int(e.base) if e.base.is_Integer else e.base
        return lambda ctx, values: ctx.mpf(number) ** int(exponent(ctx, values))
    return lambda ctx, values: ctx.exp(exponent(ctx, values) * ctx.log(base(ctx, values)))


class OutsideError(ArithmeticError):
    """A function is real nowhere in an interval."""


def _not_negative(ctx: Any, x: Any) -> Any:
    """The part of an interval where roots and logarithms are real; a number as it is."""
    if ctx is not mpmath.iv:
        return x
    if x.b < 0:
        raise OutsideError
    return ctx.mpf([max(mpmath.mpf(x.a), mpmath.mpf(0)), x.b])


def _monotone(name: str) -> Callable[[Any, Any], Any]:
    def function(ctx: Any, x: Any) -> Any:
        if ctx is not mpmath.iv:
            return getattr(ctx, name)(x)
        ends = [getattr(mpmath.mp, name)(mpmath.mpf(end)) for end in (x.a, x.b)]
        if any(isinstance(end, mpmath.mpc) for end in ends):
            return ctx.mpf([-mpmath.inf, mpmath.inf])
        return ctx.mpf([min(ends), max(ends)]) + ctx.mpf([-1, 1]) * ctx.mpf(2) ** -48 * (1 + abs(ctx.mpf(max(ends))))

    return function


CONSTANTS: dict[Any, Evaluator] = {
    sp.pi: lambda ctx, _values: +ctx.pi,
    sp.I: lambda ctx, _values: ctx.mpc(0, 1),
    sp.E: lambda ctx, _values: ctx.exp(ctx.mpf(1)),
}
FUNCTIONS: dict[str, Callable[..., Any]] = {
    "Add": lambda _ctx, *terms: reduce(lambda a, b: a + b, terms),
    "Mul": lambda _ctx, *factors: reduce(lambda a, b: a * b, factors),
    **{name: (lambda ctx, x, name=name: getattr(ctx, name)(x)) for name in ("sin", "cos", "tan", "exp")},
    "log": lambda ctx, x: ctx.log(_not_negative(ctx, x)),
    **{name: _monotone(name) for name in ("asin", "acos", "atan")},
    "atan2": lambda ctx, y, x: ctx.atan2(y, x),
    "sinh": lambda ctx, x: (ctx.exp(x) - ctx.exp(-x)) / 2,
    "cosh": lambda ctx, x: (ctx.exp(x) + ctx.exp(-x)) / 2,
    "tanh": lambda ctx, x: 1 - 2 / (ctx.exp(2 * x) + 1),
    "Abs": lambda _ctx, x: abs(x),
    "sign": lambda ctx, x: ctx.sign(x),
    "asinh": lambda ctx, x: ctx.asinh(x),
    "acosh": lambda ctx, x: ctx.acosh(x),
    "atanh": lambda ctx, x: ctx.atanh(x),
}


def random_values(symbols: Sequence[sp.Symbol], seed: int) -> list[Any]:
    """Return values for symbols: whole numbers for integers, numbers of the sign that is assumed."""
    random = Random(seed)  # noqa: S311 - nothing secret
    found = []
    for symbol in symbols:
        if symbol.is_integer:
            found.append(mpmath.mpf(random.randint(-9, 9)))
        else:
            sign = -1 if symbol.is_negative else 1
            found.append(sign * mpmath.mpf(random.randint(3000, 20000)) / 7919)
    return found


def vanishes(expression: Any) -> bool:
    """Whether an expression is zero whatever its symbols are, by its values at random points with 60 digits."""
    if expression.is_Rational:
        return bool(expression == 0)
    symbols = sorted(expression.free_symbols, key=str)
    parts = expression.args if expression.is_Add else (expression,)
    functions = [evaluator(part, symbols) for part in parts]
    with mpmath.workdps(DIGITS):
        for seed in range(TRIALS):
            point = random_values(symbols, seed)
            try:
                terms = [function(mpmath.mp, point) for function in functions]
            except (ZeroDivisionError, OverflowError):
                return False
            size = max([abs(term) for term in terms], default=0)
            bound = SMALL * (size if len(terms) > 1 else 1)
            if not abs(mpmath.fsum(terms)) <= bound:
                return False
    return True


def number_of(expression: Any, digits: int = DIGITS) -> Any:
    """Return the value of an expression without symbols as a number of mpmath."""
    with mpmath.workdps(digits):
        return evaluator(expression, [])(mpmath.mp, [])


def decimal(value: Any, digits: int = DIGITS) -> Any:
    """Return a number of mpmath as a decimal; zero where 60 digits leave nothing else."""
    if isinstance(value, mpmath.mpc):
        return decimal(value.real, digits) + decimal(value.imag, digits) * sp.I
    return sp.Float(value, digits) if abs(value) > SMALL else sp.S.Zero


def sign_of(expression: Any) -> int | None:
    """Return the sign of an expression where it is known: of a number, or by what is known of its symbols."""
    if not expression.free_symbols:
        if vanishes(expression):
            return 0
        value = number_of(expression)
        return None if isinstance(value, mpmath.mpc) else (1 if value > 0 else -1)
    signs = possible_signs(expression)
    return next(iter(signs)) if len(signs) == 1 else None


def is_not_negative(expression: Any) -> bool:
    """Whether an expression is known to be zero or positive."""
    sign = sign_of(expression)
    return sign >= 0 if sign is not None else possible_signs(expression) <= {0, 1}
