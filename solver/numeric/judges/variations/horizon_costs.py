"""What a feedback costs over a finite horizon, integrated for itself: the best costs less than others."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.judges.variations.horizons import TIMES, Horizon, Solved, solved
from solver.numeric.judges.variations.sampled import functions_at

STAGES = 400
"""Steps in which the cost of a feedback is integrated, by Runge and Kutta."""
OTHERS = (0.9, 1.1)
"""Factors of gains that cost more."""
CHEAPER = 1e-9


def cost_of_feedback(found: Solved, K: Any, factor: float = 1.0) -> Array:
    """Return M with the cost xᵀMx from the state x at t = 0 on, under u = −`factor` K(t) x."""
    n, m = found.B.shape
    times = np.linspace(found.T, 0.0, 2 * STAGES + 1)
    gains = factor * functions_at(K, found.point, times, (m, n))

    def slope(M: Array, gain: Array) -> Array:
        loop = found.A - found.B @ gain
        return np.asarray(loop.T @ M + M @ loop + found.Q + gain.T @ found.R @ gain)

    M, h = found.S, found.T / STAGES
    for k in range(STAGES):
        first, middle, last = gains[2 * k : 2 * k + 3]
        a = slope(M, first)
        b = slope(M + h / 2 * a, middle)
        c = slope(M + h / 2 * b, middle)
        M = M + h / 6 * (a + 2 * b + 2 * c + slope(M + h * c, last))
    return np.asarray(M)


def others_cost_more(horizon: Horizon, K: Any) -> bool:
    """Whether gains a tenth larger or smaller than K(t) cost no less from any state, and more from some."""
    for found in solved(horizon, K):
        best = cost_of_feedback(found, K)
        size = np.abs(best).max(initial=0.0)
        for factor in OTHERS:
            more = np.linalg.eigvalsh(cost_of_feedback(found, K, factor) - best)
            idle = np.abs(functions_at(K, found.point, found.T * TIMES, found.B.T.shape)).max() == 0.0
            if more[0] < -1e-7 * size or (more[-1] <= CHEAPER * size and not idle):
                return False
    return True
