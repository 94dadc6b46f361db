"""How fast a function of time grows: the exponent of e^{σt} that it follows, estimated from two late values."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.environment import Environment, Point
from solver.numeric.evaluation.values import NotEvaluable, filled
from solver.numeric.evaluation.walk import walk


def exponents(function: Any, time: Any, points: Sequence[Point], late: tuple[float, float]) -> Array:
    """Return σ at each point from |f| at two late times; of a matrix the largest.

    Raises NotEvaluable where f has no finite value there.
    """
    sizes = []
    for moment in late:
        environment = Environment.at([{**point, time: complex(moment)} for point in points])
        with np.errstate(all="ignore"):
            value = filled(walk(function, environment), len(points)).value
        sizes.append(np.abs(value).reshape(len(points), -1).max(axis=1))
    early, later = (np.log(np.maximum(size, 1e-300)) for size in sizes)
    if not np.all(np.isfinite(later)):
        raise NotEvaluable("the function grows too fast for its transform")
    return np.asarray(np.maximum(later - early, 0.0) / (late[1] - late[0]) + 0.05)
