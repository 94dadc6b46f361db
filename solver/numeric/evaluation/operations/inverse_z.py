"""The inverse z-transform by its contour integral."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.contour import columns, combined, mean_on_circle, number_of_nodes, turns
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.poles import circle_around_poles
from solver.numeric.evaluation.stated import Oracle
from solver.numeric.evaluation.values import NotEvaluable, Value
from solver.numeric.evaluation.walk import walk

ORACLE = Oracle(80, "contour integral")
SAMPLED = True
ENTRYWISE = True


def evaluate(environment: Environment, image: Any, z: Any, k: Any) -> Value:
    """𝒵⁻¹{F(z)}(k) of a rational F, k whole, term by term where F is stated as a sum."""
    return combined(environment, image, z, lambda core: _z_integral(environment, core, z, k))


def _z_integral(environment: Environment, image: Any, z: Any, k: Any) -> Value:
    arithmetic = environment.arithmetic
    circle = circle_around_poles(image, z, environment, centred=True)
    order = environment.full(walk(k, environment).value)
    steps = np.asarray(arithmetic.approximate(order))
    if np.any(steps != np.round(steps.real)) or np.any(np.abs(steps) > 100):
        raise NotEvaluable("the inverse z-transform is evaluated at whole numbers k up to 100")
    turned = turns(environment, image, k, number_of_nodes(arithmetic, float(np.max(np.abs(steps))) / 4 + 4))
    _, radius = columns(circle, arithmetic)
    nodes = radius * turned.roots[None, :]
    return mean_on_circle(environment, image, z, nodes, arithmetic.power(nodes, order[:, None]), turned)
