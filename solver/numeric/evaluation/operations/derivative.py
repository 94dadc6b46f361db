"""dᵐf/dxᵐ by Cauchy's integral formula."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import lru_cache
from math import factorial
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import DOUBLE, Arithmetic, Array
from solver.numeric.evaluation.contour import unit_roots
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.stated import Oracle
from solver.numeric.evaluation.values import SAFETY, NotEvaluable, Undefined, Value, gathered
from solver.numeric.evaluation.walk import walk

ORACLE = Oracle(65, "Cauchy's integral formula")
SAMPLED = True
ENTRYWISE = True


RADII = (1.0, 0.25, 0.0625, 2.0**-6, 2.0**-8, 2.0**-12, 2.0**-18)


def evaluate(environment: Environment, function: Any, variable: Any, order: Any = 1) -> Value:
    """dᵐf/dxᵐ by Cauchy's integral formula on the largest of some circles in which f is analytic.

    Raises Undefined where f is not analytic near x.
    """
    m = int(order)
    if m == 0:
        return walk(function, environment)
    x = environment.full(walk(variable, environment).value)
    radii = (each for each in RADII if not _in_vain(environment, function, variable, x, each))
    return by_cauchy(environment, m, lambda radius: _on_circle(environment, function, variable, x, radius), radii)


def by_cauchy(
    environment: Environment, m: int, on_circle: Callable[[float], Value], radii: Iterable[float] = RADII
) -> Value:
    """Return the derivative of order m from values on circles: on the largest in which f is analytic."""
    arithmetic = environment.arithmetic
    count = points_on(arithmetic)
    roots = unit_roots(count, arithmetic)
    for radius in radii:
        scale = arithmetic.rational(1, round(1 / radius))
        samples = on_circle(radius)
        value, magnitude = gathered(samples, environment.points, count)
        if _known(value, magnitude, arithmetic) and _analytic(np.asarray(arithmetic.approximate(value)), magnitude):
            weights = (arithmetic.power(roots, arithmetic.number(-m)) * factorial(m)).reshape(
                (1, count, *(1 for _ in value.shape[2:]))
            )
            # the division by scale^m comes last: in doubles it is exact, scale being a power of two
            result = (value * weights).sum(axis=1) / count / scale**m
            return Value(result, magnitude.sum(axis=1) / count * factorial(m) / radius**m)
    raise Undefined("the function to differentiate is not analytic near the point")


def points_on(arithmetic: Arithmetic) -> int:
    """How many points a circle gets."""
    return 64 if arithmetic is DOUBLE else 16 * (arithmetic.digits // 8)


def _in_vain(environment: Environment, function: Any, variable: Any, x: Array, radius: float) -> bool:
    """Whether doubles tell already that many digits will find f not analytic within the circle.

    They cannot tell of decimals, whose size is another with many digits. Where they have no value, one of many digits
    is asked for.
    """
    arithmetic = environment.arithmetic
    if arithmetic is DOUBLE or not isinstance(function, sp.Basic) or function.has(sp.Float):
        return False
    count, doubles = points_on(arithmetic), environment.approximate()
    around = np.asarray(arithmetic.approximate(x))
    try:
        samples = _walked_round(doubles, function, variable, around, radius, count)
        value, magnitude = gathered(samples, doubles.points, count)
        without = np.argwhere(~np.isfinite(value))
        if len(without):
            p, node = map(int, without[0][:2])
            at = x[p] + arithmetic.rational(1, round(1 / radius)) * unit_roots(count, arithmetic)[node]
            values = {each: environment.full(known)[p] for each, known in environment.values.items()}
            there = walk(function, Environment({**values, variable: at}, 1, arithmetic)).value
            return not np.all(np.isfinite(arithmetic.approximate(there)))
    except (NotEvaluable, ZeroDivisionError, OverflowError):
        return False
    return not _analytic(value, magnitude, 2 * SAFETY * DOUBLE.eps)


def _on_circle(environment: Environment, function: Any, variable: Any, x: Array, radius: float) -> Value:
    """F at the points of the circles about x; kept for the derivatives of other orders, where f is an expression."""
    if not isinstance(function, sp.Basic):
        return _walked_round(environment, function, variable, x, radius, points_on(environment.arithmetic))
    others = tuple(
        (each, tuple(environment.full(value)))
        for each, value in sorted(environment.values.items(), key=lambda pair: str(pair[0]))
        if each != variable and each in function.free_symbols
    )
    return _remembered(function, variable, tuple(x), others, environment.arithmetic, radius)


@lru_cache(maxsize=4)
def _remembered(
    function: Any,
    variable: Any,
    x: tuple[Any, ...],
    others: tuple[tuple[Any, tuple[Any, ...]], ...],
    arithmetic: Arithmetic,
    radius: float,
) -> Value:
    values = {symbol: arithmetic.array(listed) for symbol, listed in others}
    environment = Environment(values, len(x), arithmetic)
    around = environment.full(arithmetic.array(x))
    return _walked_round(environment, function, variable, around, radius, points_on(arithmetic))


def _walked_round(environment: Environment, function: Any, variable: Any, x: Array, radius: float, count: int) -> Value:
    arithmetic = environment.arithmetic
    roots = unit_roots(count, arithmetic)
    scale = arithmetic.rational(1, round(1 / radius))
    return walk(function, environment.spread(variable, x[:, None] + roots[None, :] * scale))


def _known(value: Array, magnitude: Array, arithmetic: Any) -> bool:
    """Whether the samples have digits at all; they have none where a pole lies on the circle, at a node."""
    noise = arithmetic.eps * np.max(magnitude, initial=0.0)
    return bool(noise <= 1e-6 * max(1.0, float(np.max(np.abs(arithmetic.approximate(value)), initial=0.0))))


def _analytic(values: Array, magnitude: Array, noise: float = 0.0) -> bool:
    """Whether samples on circles (P, N, …) have no negative and no high positive powers in their Laurent series.

    Negative powers tell of a pole or cut inside, high ones that N nodes are too few. `noise` is what the samples may be
    wrong by, for a magnitude of one.
    """
    count = values.shape[1]
    if not np.all(np.isfinite(values)):
        return False
    laurent = np.abs(np.fft.fft(values, axis=1)) / count
    allowed = 1e-13 * np.abs(values).max(axis=1, keepdims=True) + (1e-14 + noise) * magnitude.max(axis=1, keepdims=True)
    return bool(np.all(laurent[:, count // 2 - 4 :] <= allowed))
