"""The Laplace transform by its defining integral, at values of s for which it converges."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from solver.numeric.evaluation.combining import multiply
from solver.numeric.evaluation.environment import Environment, Point
from solver.numeric.evaluation.growth import exponents
from solver.numeric.evaluation.quadrature import to_infinity
from solver.numeric.evaluation.stated import Oracle
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import walk

ORACLE = Oracle(85, "Gauss–Legendre quadrature")
SAMPLED = True

MARGIN = 1.5
"""How much faster than f grows e^{st} must grow: at t = 64 the integrand is below e^{−96}, whatever f is."""

LATE = (20.0, 40.0)


def evaluate(environment: Environment, function: Any, t: Any, s: Any) -> Value:
    """∫ f(t) e^{−st} dt from 0 to ∞; refused where the integrand does not decay."""
    arithmetic = environment.arithmetic
    rate = environment.full(walk(s, environment).value)[:, None]

    def samples(time: Any) -> Value:
        kernel = np.ravel(arithmetic.apply("exp", -rate * time))
        return multiply(walk(function, environment.spread(t, time)), Value(kernel, arithmetic.size(kernel)), arithmetic)

    return to_infinity(environment, samples, environment.full(0))


def admitted(points: Sequence[Point], function: Any, t: Any, s: Any) -> list[Point]:
    """Return points whose s, if it is a symbol of theirs, has a real part for which the integral converges."""
    if s not in points[0]:
        return list(points)
    least = np.maximum(exponents(function, t, points, LATE), 0.0) + MARGIN
    return [
        {**point, s: point[s] + max(0.0, float(bound) + abs(point[s].real) - point[s].real)}
        for point, bound in zip(points, least, strict=True)
    ]
