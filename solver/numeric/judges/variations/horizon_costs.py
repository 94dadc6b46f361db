"""What a feedback costs over a finite horizon, integrated for itself: the best costs less than others."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.judges.variations.horizons import Horizon, Solved, solved
from solver.numeric.judges.variations.sampled import functions_at

STAGES = 400
"""Steps in which the cost of a feedback is integrated, by Runge and Kutta."""
OTHERS = (0.9, 1.1)
"""Factors of gains that cost more."""
CHEAPER = 1e-9


def costs_of_feedback(found: Solved, gains: Array) -> Array:
    """Return the matrices M with the cost xᵀMx from the state x at t = 0 on, under u = −F x, for several F at once.

    `gains` (k×f×m×n) are the F at the k = 2 STAGES + 1 times from the end of the horizon to its beginning.
    """

    def slope(M: Array, gain: Array) -> Array:
        loop = found.A - found.B @ gain
        return np.asarray(
            np.swapaxes(loop, -1, -2) @ M + M @ loop + found.Q + np.swapaxes(gain, -1, -2) @ found.R @ gain
        )

    M, h = np.broadcast_to(found.S, (gains.shape[1], *found.S.shape)), found.T / STAGES
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
        times = np.linspace(found.T, 0.0, 2 * STAGES + 1)
        gains = functions_at(K, found.point, times, found.B.T.shape)
        best, *others = costs_of_feedback(found, np.stack([factor * gains for factor in (1.0, *OTHERS)], axis=1))
        size, idle = np.abs(best).max(initial=0.0), np.abs(gains).max() == 0.0
        for other in others:
            more = np.linalg.eigvalsh(other - best)
            if more[0] < -1e-7 * size or (more[-1] <= CHEAPER * size and not idle):
                return False
    return True
