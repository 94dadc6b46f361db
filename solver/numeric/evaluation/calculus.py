"""Derivatives, integrals and values at a point of formulas as stated."""

from __future__ import annotations

from functools import cache, lru_cache, reduce
from itertools import pairwise
from math import factorial
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import DOUBLE, Arithmetic, Array, multiple
from solver.numeric.evaluation.contour import accuracy, unit_roots
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.stated import add, operation
from solver.numeric.evaluation.values import NotEvaluable, Undefined, Value, gathered
from solver.numeric.evaluation.walk import walk

RADII = (1.0, 0.25, 0.0625, 2.0**-6, 2.0**-8, 2.0**-12, 2.0**-18)
IN_DOUBLES = ((4, 20), (8, 20))
WITH_MANY_DIGITS = ((1, 28), (1, 40), (2, 40))
"""How an integral is refined: the number of panels, and of nodes on each."""

MOST_TERMS = 200


@operation
def value_at(environment: Environment, function: Any, variable: Any, value: Any) -> Value:
    """F(x) at x = value. Where x is a decimal, it is known to its own digits only, and F as far as it moves with x."""
    x, arithmetic = walk(value, environment), environment.arithmetic
    found = walk(function, environment.having({variable: x.value}))
    unsure = np.broadcast_to(np.asarray(x.magnitude - 4 * arithmetic.size(x.value), dtype=float), environment.points)
    if arithmetic is DOUBLE or not np.any(unsure > 0):
        return found
    shift = arithmetic.array(np.maximum(unsure, 0.0) * arithmetic.eps)
    moved = walk(function, environment.having({variable: x.value + shift}))
    return Value(found.value, found.magnitude + arithmetic.size(moved.value - found.value) / arithmetic.eps)


@operation
def summation(environment: Environment, term: Any, index: Any, lower: Any, upper: Any) -> Value:
    """Σ T(i), added up one by one at each point; an empty sum has no shape, so there it has no value."""
    first, last = (
        [
            round(float(each.real))
            for each in environment.arithmetic.approximate(environment.full(walk(end, environment).value))
        ]
        for end in (lower, upper)
    )
    if any(b < a or b - a > MOST_TERMS for a, b in zip(first, last, strict=True)):
        raise Undefined("an empty sum, or one of too many terms")
    sums = []
    for p, (a, b) in enumerate(zip(first, last, strict=True)):
        point = {symbol: environment.full(value)[p : p + 1] for symbol, value in environment.values.items()}
        here = Environment(point, 1, environment.arithmetic)
        sums.append(reduce(add, (walk(term, here.having({index: i})) for i in range(a, b + 1))))
    values, magnitudes = (
        np.stack([np.reshape(part, np.shape(part)[1:]) for part in parts]) for parts in zip(*sums, strict=True)
    )
    return Value(values, magnitudes)


@operation
def derivative(environment: Environment, function: Any, variable: Any, order: Any = 1) -> Value:
    """dᵐf/dxᵐ by Cauchy's integral formula on the largest of some circles in which f is analytic.

    Raises NotEvaluable where f is not analytic near x.
    """
    m = int(order)
    if m == 0:
        return walk(function, environment)
    arithmetic = environment.arithmetic
    count = _points_on(arithmetic)
    x = environment.full(walk(variable, environment).value)
    roots = unit_roots(count, arithmetic)
    for radius in RADII:
        scale = arithmetic.rational(1, round(1 / radius))
        samples = _on_circle(environment, function, variable, x, radius)
        value, magnitude = gathered(samples, environment.points, count)
        if _known(value, magnitude, arithmetic) and _analytic(np.asarray(arithmetic.approximate(value)), magnitude):
            weights = (arithmetic.power(roots, arithmetic.number(-m)) * factorial(m)).reshape(
                (1, count, *(1 for _ in value.shape[2:]))
            )
            # the division by scale^m comes last: in doubles it is exact, scale being a power of two
            result = (value * weights).sum(axis=1) / count / scale**m
            return Value(result, magnitude.sum(axis=1) / count * factorial(m) / radius**m)
    raise NotEvaluable("the function to differentiate is not analytic near the point")


def _points_on(arithmetic: Arithmetic) -> int:
    """How many points a circle gets."""
    return 64 if arithmetic is DOUBLE else 16 * (arithmetic.digits // 8)


def _on_circle(environment: Environment, function: Any, variable: Any, x: Array, radius: float) -> Value:
    """F at the points of the circles about x; kept for the derivatives of other orders, where f is an expression."""
    if not isinstance(function, sp.Basic):
        return _walked_round(environment, function, variable, x, radius)
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
    return _walked_round(environment, function, variable, environment.full(arithmetic.array(x)), radius)


def _walked_round(environment: Environment, function: Any, variable: Any, x: Array, radius: float) -> Value:
    arithmetic = environment.arithmetic
    roots = unit_roots(_points_on(arithmetic), arithmetic)
    scale = arithmetic.rational(1, round(1 / radius))
    return walk(function, environment.spread(variable, x[:, None] + scale * roots[None, :]))


def _known(value: Array, magnitude: Array, arithmetic: Any) -> bool:
    """Whether the samples have digits at all; they have none where a pole lies on the circle, at a node."""
    noise = arithmetic.eps * np.max(magnitude, initial=0.0)
    return bool(noise <= 1e-6 * max(1.0, float(np.max(np.abs(arithmetic.approximate(value)), initial=0.0))))


def _analytic(values: Array, magnitude: Array) -> bool:
    """Whether samples on circles (P, N, …) have no negative and no high positive powers in their Laurent series.

    Negative powers tell of a pole or cut inside, high ones that N nodes are too few.
    """
    count = values.shape[1]
    if not np.all(np.isfinite(values)):
        return False
    laurent = np.abs(np.fft.fft(values, axis=1)) / count
    allowed = 1e-13 * np.abs(values).max(axis=1, keepdims=True) + 1e-14 * magnitude.max(axis=1, keepdims=True)
    return bool(np.all(laurent[:, count // 2 - 4 :] <= allowed))


@operation
def integral(environment: Environment, integrand: Any, variable: Any, lower: Any, upper: Any) -> Value:
    """∫ f dx by the rule of Gauss and Legendre on some panels; the difference of two refinements is the error.

    Limits are finite, or the upper one is ∞ and the integrand decays.
    """
    a = environment.full(walk(lower, environment).value)
    if upper == sp.oo:
        return _to_infinity(environment, integrand, variable, a)
    b = environment.full(walk(upper, environment).value)
    arithmetic = environment.arithmetic
    finer = (
        _panels(environment, integrand, variable, (a, b - a), np.linspace(0.0, 1.0, count + 1), nodes)
        for count, nodes in (IN_DOUBLES if arithmetic is DOUBLE else WITH_MANY_DIGITS)
    )
    for coarse, fine in pairwise(finer):
        if np.all(arithmetic.size(fine.value - coarse.value) <= accuracy(arithmetic) * fine.magnitude):
            break
    return _with_error(coarse, fine, arithmetic)


def _to_infinity(environment: Environment, integrand: Any, variable: Any, a: Array) -> Value:
    """∫ from a to ∞ on panels whose lengths double, from 1/64 to 1024; refused unless the integrand has died away."""
    edges = np.array([0.0, *(2.0**i for i in range(-6, 11))])
    one, nodes = environment.full(1), 20 if environment.arithmetic is DOUBLE else 40
    halved = np.sort(np.concatenate([edges, (edges[1:] + edges[:-1]) / 2]))
    coarse, fine, last = (
        _panels(environment, integrand, variable, (a, one), each, nodes) for each in (edges, halved, edges[-2:])
    )
    size = environment.arithmetic.size
    if np.any(size(last.value) > 1e-12 * size(fine.value) + 1e-15 * fine.magnitude):
        raise NotEvaluable("the integrand of an integral to infinity decays too slowly")
    return _with_error(coarse, fine, environment.arithmetic)


def _panels(
    environment: Environment, integrand: Any, variable: Any, span: tuple[Array, Array], edges: Array, nodes: int
) -> Value:
    """∫ of f(a + w u) w du over the panels between the edges of u."""
    arithmetic = environment.arithmetic
    x, w = legendre(arithmetic, nodes)
    half = arithmetic.array((edges[1:] - edges[:-1]) / 2)[:, None]
    middle = arithmetic.array((edges[1:] + edges[:-1]) / 2)[:, None]
    u = (middle + half * x[None, :]).reshape(-1)
    weights = (half * w[None, :]).reshape(-1)
    start, width = span
    samples = walk(integrand, environment.spread(variable, start[:, None] + width[:, None] * u[None, :]))
    value, magnitude = gathered(samples, environment.points, len(u))
    factor = (width[:, None] * weights[None, :]).reshape((environment.points, len(u), *(1 for _ in value.shape[2:])))
    return Value((value * factor).sum(axis=1), (magnitude * arithmetic.size(factor)).sum(axis=1))


def _with_error(coarse: Value, fine: Value, arithmetic: Arithmetic) -> Value:
    """Return the finer value; the difference counts as its error."""
    error = arithmetic.size(fine.value - coarse.value)
    if np.any(error > 1e-6 * (arithmetic.size(fine.value) + fine.magnitude)):
        raise NotEvaluable("the integrand is not smooth enough for the quadrature")
    return Value(fine.value, fine.magnitude + error / arithmetic.eps)


@cache
def legendre(arithmetic: Arithmetic, count: int) -> tuple[Array, Array]:
    """Return nodes and weights of Gauss and Legendre on [−1, 1]."""
    x, w = np.polynomial.legendre.leggauss(count)
    if arithmetic is DOUBLE:
        return x, w
    many = multiple(arithmetic.digits).context
    nodes = [_refined(many.mpf(float(each)), count) for each in x]
    weights = [2 / ((1 - x * x) * _legendre(x, count)[1] ** 2) for x in nodes]
    return arithmetic.array(nodes), arithmetic.array(weights)


def _refined(x: Any, count: int) -> Any:
    """Return the zero of P_n next to x, by Newton's method."""
    for _ in range(8):
        value, slope = _legendre(x, count)
        x = x - value / slope
    return x


def _legendre(x: Any, count: int) -> tuple[Any, Any]:
    """P_n(x) and P_n'(x), by the recurrence of three terms."""
    before, value = x * 0 + 1, x
    for k in range(2, count + 1):
        before, value = value, ((2 * k - 1) * x * value - (k - 1) * before) / k
    return value, count * (x * value - before) / (x * x - 1)
