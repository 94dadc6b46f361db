"""The z-transform by its defining series, at values of z for which it converges fast."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from solver.numeric.evaluation.combining import multiply
from solver.numeric.evaluation.contour import accuracy
from solver.numeric.evaluation.environment import Environment, Point
from solver.numeric.evaluation.growth import exponents
from solver.numeric.evaluation.stated import Oracle
from solver.numeric.evaluation.values import NotEvaluable, Value, gathered
from solver.numeric.evaluation.walk import walk

ORACLE = Oracle(85, "series")
SAMPLED = True

MARGIN = 2.5
"""How much larger |z| is than the factor by which the sequence grows."""

LATE = (40.0, 60.0)


def evaluate(environment: Environment, sequence: Any, k: Any, z: Any) -> Value:
    """Σ f(k) z^{−k}; refused where the terms have not died away."""
    arithmetic = environment.arithmetic
    count = 60 + 3 * arithmetic.digits
    steps = arithmetic.array(np.arange(count))[None, :] + environment.full(0)[:, None]
    inverse = 1 / environment.full(walk(z, environment).value)[:, None]
    powers = np.ravel(arithmetic.power(inverse + 0 * steps, steps))
    terms = multiply(walk(sequence, environment.spread(k, steps)), Value(powers, arithmetic.size(powers)), arithmetic)
    value, magnitude = gathered(terms, environment.points, count)
    total, size = value.sum(axis=1), magnitude.sum(axis=1)
    tail = arithmetic.size(value[:, -10:]).sum(axis=1)
    if np.any(tail > 10.0 * accuracy(arithmetic) * size):
        raise NotEvaluable("the series of a z-transform converges too slowly")
    return Value(total, size + tail / arithmetic.eps)


def admitted(points: Sequence[Point], sequence: Any, k: Any, z: Any) -> list[Point]:
    """Return points whose z, if it is a symbol of theirs, is so large that the series converges fast."""
    if z not in points[0]:
        return list(points)
    least = MARGIN * np.exp(np.maximum(exponents(sequence, k, points, LATE), 0.0))
    return [
        {**point, z: point[z] * max(1.0, float(bound) / abs(point[z]) + 0.1 * abs(point[z]))}
        for point, bound in zip(points, least, strict=True)
    ]
