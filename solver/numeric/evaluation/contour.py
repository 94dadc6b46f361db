"""Inverse transforms by their defining contour integrals.

ℒ⁻¹{F}(t) = (1/2πj) ∮ F(s) e^{st} ds and 𝒵⁻¹{F}(k) = (1/2πj) ∮ F(z) z^{k−1} dz around all poles. On a circle the
trapezoid rule converges geometrically (Trefethen and Weideman, SIAM Review 56 (2014), section 2).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache, partial, reduce
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import DOUBLE, Arithmetic, Array
from solver.numeric.evaluation.combining import add, multiply
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.linear_terms import linear_terms
from solver.numeric.evaluation.poles import Circle
from solver.numeric.evaluation.values import Value, gathered
from solver.numeric.evaluation.walk import walk


def accuracy(arithmetic: Arithmetic) -> float:
    """Return the relative error the trapezoid rule may have: the roundoff of doubles, two thirds of many digits."""
    return arithmetic.eps if arithmetic is DOUBLE else 10.0 ** (-0.65 * arithmetic.digits)


def number_of_nodes(arithmetic: Arithmetic, growth: float) -> int:
    """Return N with (1/2)^N and the tail of the series of e^{growth} below the accuracy."""
    return int(16 * np.ceil((-np.log2(accuracy(arithmetic)) + 4.0 * growth) / 16))


@cache
def unit_roots(count: int, arithmetic: Arithmetic) -> Array:
    """e^{2πj i/N} for i = 0 … N − 1."""
    turns = [arithmetic.rational(2 * i, count) for i in range(count)]
    angle = arithmetic.constant("pi") * arithmetic.imaginary()
    return np.asarray(arithmetic.apply("exp", np.array([turn * angle for turn in turns], dtype=arithmetic.dtype)))


def combined(environment: Environment, image: Any, variable: Any, transform: Callable[[Any], Value]) -> Value:
    """Return the transform of a sum of terms L f(s) R with constant L and R: Σ L (transform of f) R."""
    parts = []
    for term in linear_terms(image, variable):
        factors = (*(walk(each, environment) for each in term.left), transform(term.core))
        factors = (*factors, *(walk(each, environment) for each in term.right))
        parts.append(reduce(partial(multiply, arithmetic=environment.arithmetic), factors))
    return reduce(add, parts)


def columns(circle: Circle, arithmetic: Arithmetic) -> tuple[Array, Array]:
    """Return centre and radius as columns (P, 1) of the arithmetic."""
    return arithmetic.array(circle.centre)[:, None], arithmetic.array(circle.radius)[:, None]


def mean_on_circle(environment: Environment, image: Any, variable: Any, nodes: Array, weights: Array) -> Value:
    """Return the mean over the nodes (P×N) of the image times the weights (P×N)."""
    F = walk(image, environment.spread(variable, nodes))
    arithmetic = environment.arithmetic
    points, count = nodes.shape
    value, magnitude = gathered(F, points, count)
    factor = weights.reshape((points, count, *(1 for _ in value.shape[2:])))
    # what the rule itself leaves out, beside the rounding of the values
    left_out = arithmetic.size(value) * (accuracy(arithmetic) / arithmetic.eps)
    size = arithmetic.size(factor)
    return Value((value * factor).sum(axis=1) / count, ((magnitude + left_out) * size).sum(axis=1) / count)
