"""What a gain costs, by scipy's Lyapunov solver or step by step, and whether it is optimal by its own cost."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.expressions import evaluate
from solver.numeric.evaluation.points import free_symbols
from solver.numeric.judges.optimal.refined import Refined, many_at, sharpened
from solver.numeric.judges.optimal.regulator import Optimum, Weights, matrix_at, optima, relative, stable, worst

DOUBLINGS, ENOUGH_DOUBLED = 48, 1e-18


def gain_residual(weights: Weights, K: Any) -> float:
    """Return how far K (m×n) is from R⁻¹(BᵀP + Nᵀ) with the P of its own cost; infinite if not stable.

    A stabilizing K with that property is optimal (Kleinman; in discrete time Hewer): P solves the Riccati equation.
    """

    def judge(optimum: Optimum) -> float:
        value = matrix_at(K, optimum.point, (optimum.B.shape[1], optimum.A.shape[0]))
        P = cost_matrix(optimum, value)
        if P is None:
            return float("inf")
        best = optimum.gain_of(P)
        found = relative(value - best, value, best, optimum.K, optimum.smallest_gain)

        def gap(many: Refined) -> tuple[Array, ...]:
            return many_at(K, optimum.point) - many.K, many.K, optimum.smallest_gain

        return sharpened(found, weights, optimum, K, gap)

    return worst(weights, judge, K)


def cost_matrix(optimum: Optimum, K: Array) -> Array | None:
    """Return X with x₀ᵀXx₀ = ∫ xᵀ(Q − NK − KᵀNᵀ + KᵀRK)x dt under u = −Kx, by scipy; None if A − BK is not stable.

    The states are first scaled so that rows and columns of A − BK are of about the same size. In discrete time the
    costs of 1, 2, 4, … steps are summed up.
    """
    from scipy.linalg import matrix_balance, solve_continuous_lyapunov  # noqa: PLC0415

    loop = optimum.A - optimum.B @ K
    if not stable(loop, discrete=optimum.discrete):
        return None
    weight = optimum.Q - optimum.N @ K - K.T @ optimum.N.T + K.T @ optimum.R @ K
    if optimum.discrete:
        return summed(loop, weight)
    balanced, (scale, _) = matrix_balance(loop, permute=False, separate=True)
    weight = weight * np.outer(scale, scale)
    return np.asarray(solve_continuous_lyapunov(balanced.T, -weight) / np.outer(scale, scale))


def summed(loop: Array, weight: Array) -> Array:
    """Σ (Fᵀ)ᵏ W Fᵏ over all k for F with eigenvalues inside of the unit circle, by doubling the number of steps."""
    total, power = weight, loop
    for _ in range(DOUBLINGS):
        added = power.T @ total @ power
        total = total + added
        if float(np.abs(added).max()) <= ENOUGH_DOUBLED * float(np.abs(total).max()):
            break
        power = power @ power
    return np.asarray(total)


def costs(weights: Weights, K: Any) -> tuple[Array, Array] | None:
    """Return X of the cost x₀ᵀXx₀ under u = −Kx, and of the least one; None with symbols, or an unstable K."""
    if any(map(free_symbols, (*weights, K))):
        return None
    (optimum,) = optima(weights)
    own = cost_matrix(optimum, matrix_at(K, {}, (optimum.B.shape[1], optimum.A.shape[0])))
    return None if own is None else (own, optimum.P)


def cost_residual(weights: Weights, cost: Any, x0: Any, factor: Any) -> float:
    """Return the relative difference of a cost and the factor times the optimal integral from x(0) = x₀."""

    def judge(optimum: Optimum) -> float:
        value = matrix_at(cost, optimum.point, (1, 1))
        X = cost_matrix(optimum, optimum.K)
        start = matrix_at(x0, optimum.point, (optimum.A.shape[0], 1))
        best = float(np.real(evaluate(factor, optimum.point))) * (start.T @ X @ start)
        found = relative(value - best, value, best)

        def gap(many: Refined) -> tuple[Array, ...]:
            first = many_at(x0, optimum.point)
            own = many_at(factor, optimum.point) * (first.T @ many.P @ first)
            return many_at(cost, optimum.point) - own, own

        return sharpened(found, weights, optimum, [cost, x0, factor], gap)

    return worst(weights, judge, cost, x0, factor)
