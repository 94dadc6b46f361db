"""Integrals by the rule of Gauss and Legendre on panels; the difference of two refinements is the error."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import DOUBLE, Arithmetic, Array, multiple
from solver.numeric.evaluation.contour import accuracy
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import NotEvaluable, Value, gathered
from solver.numeric.evaluation.walk import walk

IN_DOUBLES = ((4, 20), (8, 20))
WITH_MANY_DIGITS = ((1, 16), (1, 28), (1, 40), (2, 40))
"""How an integral is refined: the number of panels, and of nodes on each."""


Samples = Callable[[Array], Value]
"""Evaluates an integrand at N nodes for each of P points (P×N), which it returns all at once (P·N, …)."""


def samples_of(integrand: Any, variable: Any, environment: Environment) -> Samples:
    """Return what evaluates a formula at values of a variable."""
    return lambda nodes: walk(integrand, environment.spread(variable, nodes))


def to_finite(environment: Environment, samples: Samples, a: Array, b: Array) -> Value:
    """∫ f dx from a to b (P,)."""
    arithmetic = environment.arithmetic
    finer = (
        _panels(environment, samples, (a, b - a), np.linspace(0.0, 1.0, count + 1), nodes)
        for count, nodes in (IN_DOUBLES if arithmetic is DOUBLE else WITH_MANY_DIGITS)
    )
    for coarse, fine in pairwise(finer):
        if np.all(arithmetic.size(fine.value - coarse.value) <= accuracy(arithmetic) * fine.magnitude):
            break
    return _with_error(coarse, fine, arithmetic)


DOUBLINGS = (10, 12, 14, 16)
"""How often the lengths of panels double before an integrand has died away: they end at a + 16 to a + 1024."""


def to_infinity(environment: Environment, samples: Samples, a: Array) -> Value:
    """∫ from a to ∞ on panels whose lengths double, from 1/64 on; refused unless the integrand dies away."""
    one, nodes = environment.full(1), 20 if environment.arithmetic is DOUBLE else 32
    whole: tuple[Value, Value] | None = None
    edges = np.array([0.0])
    for doublings in DOUBLINGS:  # no farther than needed: far away an exponential has overflown
        edges = np.array([edges[-1], *(2.0**i for i in range(-6, doublings - 5) if 2.0**i > edges[-1])])
        parts = []
        for added in (edges[:-1], edges[-2:]):
            halved = np.sort(np.concatenate([added, (added[1:] + added[:-1]) / 2]))
            parts.append(tuple(_panels(environment, samples, (a, one), each, nodes) for each in (halved, added)))
        (_, last), *_ = reversed(parts)
        for fine, coarse in parts:
            whole = (_sum(whole[0], fine), _sum(whole[1], coarse)) if whole else (fine, coarse)
        if whole and _has_died_away(environment, whole[0], last):
            fine, coarse = whole
            return _with_error(coarse, fine, environment.arithmetic)
    raise NotEvaluable("the integrand of an integral to infinity decays too slowly")


def _sum(one: Value, other: Value) -> Value:
    return Value(one.value + other.value, one.magnitude + other.magnitude)


def _has_died_away(environment: Environment, whole: Value, last: Value) -> bool:
    """Whether the last panel adds nothing to a finite value."""
    size = environment.arithmetic.size
    finite = np.all(size(whole.value) < np.inf)
    return bool(finite and np.all(size(last.value) <= 1e-12 * size(whole.value) + 1e-15 * whole.magnitude))


def _panels(environment: Environment, samples: Samples, span: tuple[Array, Array], edges: Array, nodes: int) -> Value:
    """∫ of f(a + w u) w du over the panels between the edges of u."""
    arithmetic = environment.arithmetic
    x, w = legendre(arithmetic, nodes)
    half = arithmetic.array((edges[1:] - edges[:-1]) / 2)[:, None]
    middle = arithmetic.array((edges[1:] + edges[:-1]) / 2)[:, None]
    u = (middle + half * x[None, :]).reshape(-1)
    weights = (half * w[None, :]).reshape(-1)
    start, width = span
    value, magnitude = gathered(samples(start[:, None] + width[:, None] * u[None, :]), environment.points, len(u))
    factor = (width[:, None] * weights[None, :]).reshape((environment.points, len(u), *(1 for _ in value.shape[2:])))
    return Value((value * factor).sum(axis=1), (magnitude * arithmetic.size(factor)).sum(axis=1))


def _with_error(coarse: Value, fine: Value, arithmetic: Arithmetic) -> Value:
    """Return the finer value; the difference counts as its error. It is refused beside the largest entry."""
    error = arithmetic.size(fine.value - coarse.value)
    size = arithmetic.size(fine.value) + fine.magnitude
    if np.any(error > 1e-6 * size.max(axis=tuple(range(1, size.ndim)), keepdims=True)):
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
