"""∫ f dx."""

from __future__ import annotations

from typing import Any

import sympy as sp

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.quadrature import samples_of, to_finite, to_infinity
from solver.numeric.evaluation.stated import Oracle
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import walk

ORACLE = Oracle(70, "Gauss–Legendre quadrature")
SAMPLED = True
ENTRYWISE = True


def evaluate(environment: Environment, integrand: Any, variable: Any, lower: Any, upper: Any) -> Value:
    """Limits are finite, or the upper one is ∞ and the integrand decays."""
    a = environment.full(walk(lower, environment).value)
    samples = samples_of(integrand, variable, environment)
    if upper == sp.oo:
        return to_infinity(environment, samples, a)
    return to_finite(environment, samples, a, environment.full(walk(upper, environment).value))
