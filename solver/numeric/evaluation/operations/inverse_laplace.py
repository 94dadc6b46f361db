"""The inverse Laplace transform by its contour integral."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import DOUBLE, Array
from solver.numeric.evaluation.contour import columns, combined, mean_on_circle, number_of_nodes, turns
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.poles import circle_around_poles
from solver.numeric.evaluation.stated import Oracle
from solver.numeric.evaluation.values import NotEvaluable, Value
from solver.numeric.evaluation.walk import walk

ORACLE = Oracle(90, "contour integral")
SAMPLED = True
ENTRYWISE = True


REACH = 6.0
"""radius · t up to which doubles lose less than three digits to e^{st}."""

FARTHEST = 120.0
"""radius · t beyond which 100 digits would not do."""


def evaluate(environment: Environment, image: Any, s: Any, t: Any) -> Value:
    """ℒ⁻¹{F(s)}(t) of a rational F, term by term where F is stated as a sum."""
    return combined(environment, image, s, lambda core: _laplace_integral(environment, core, s, t))


def _laplace_integral(environment: Environment, image: Any, s: Any, t: Any) -> Value:
    arithmetic = environment.arithmetic
    circle = circle_around_poles(image, s, environment, centred=False)
    time = environment.full(walk(t, environment).value)
    growth = float(np.max(circle.radius * np.abs(arithmetic.approximate(time))))
    limit = 25.0 if arithmetic is DOUBLE else FARTHEST
    if growth > FARTHEST:
        raise NotEvaluable("t is too large for the inversion integral to keep its digits")
    turned = turns(environment, image, t, number_of_nodes(arithmetic, min(growth, limit)))
    centre, radius = columns(circle, arithmetic)
    nodes = centre + radius * turned.roots[None, :]
    weights = arithmetic.apply("exp", nodes * time[:, None]) * radius * turned.roots[None, :]
    return mean_on_circle(environment, image, s, nodes, weights, turned)


def reach(environment: Environment, image: Any, s: Any, t: Any) -> dict[Any, Array]:
    """Return, if t is a symbol with values, at each point the t at which radius · t is REACH."""
    if t not in environment.values:
        return {}
    return {t: REACH / circle_around_poles(image, s, environment, centred=False).radius}
