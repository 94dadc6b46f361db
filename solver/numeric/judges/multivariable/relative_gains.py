"""The relative gain array judged by G ∘ (G⁻¹)ᵀ in numbers, as near to the point as makes no difference."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.compare import with_many_digits, worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.multiple_precision import inverse
from solver.numeric.evaluation.values import Undefined
from solver.numeric.judges.representation.minimal import MANY, numbers_at, points_of, value_at_one

BESIDE = "1e-22"
"""So far beside the point G is taken: it may have a pole there."""
WRONG = float("inf")


def relative_gain_residual(G: Any, array: Any, x: Any, at: Any) -> float:
    """Return the largest difference of the entries of an array and those of G ∘ (G⁻¹)ᵀ where x is `at`.

    G (n×n) is a matrix or a stated formula in x; the difference is relative to the largest entry of the row.
    """
    worst = 0.0
    bound = value_at_one(G, x)
    for point in points_of(bound, array, at):
        try:
            found = _array(G, x, numbers_at([at], point)[0], point)
        except Undefined:
            return WRONG
        if found.shape != array.shape:
            return WRONG
        given = np.array(numbers_at(array.flat(), point), dtype=object).reshape(found.shape)
        for ours, theirs in zip(found, given, strict=True):
            size = max(MANY.context.mpf(1), *(abs(entry) for entry in ours))
            worst = worst_of((worst, float(max(abs(a - b) for a, b in zip(ours, theirs, strict=True)) / size)))
    return with_many_digits(worst, G, array)


def _array(G: Any, x: Any, at: Any, point: Any) -> Array:
    """Λ in numbers."""
    step = MANY.context.mpc(BESIDE, "3e-23") * (1 + abs(at))
    value = value_of(G, Environment.at([{**dict(point), x: at + step}], MANY)).value[0]
    K = np.asarray(value, dtype=object)
    return K * inverse(K).T
