"""∫ f(τ) g(t − τ) dτ."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.combining import multiply
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.quadrature import to_finite
from solver.numeric.evaluation.stated import Oracle
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import walk

ORACLE = Oracle(70, "Gauss–Legendre quadrature")
SAMPLED = True


def evaluate(environment: Environment, left: Any, right: Any, time: Any) -> Value:
    """The integral of f at τ times g at t − τ for τ from 0 to t."""
    t = environment.full(walk(time, environment).value)

    def samples(tau: Any) -> Value:
        here, mirrored = (environment.spread(time, each) for each in (tau, t[:, None] - tau))
        return multiply(walk(left, here), walk(right, mirrored), environment.arithmetic)

    return to_finite(environment, samples, np.zeros_like(t), t)
