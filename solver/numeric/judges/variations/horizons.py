"""The regulator over a finite horizon judged in floats: P by scipy's integration back from the end, K by what it costs.

Nothing of the Hamiltonian matrix takes part. The cost of a feedback is integrated for itself, so that a gain is optimal
where it costs xᵀP(0)x and others cost more.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.compare import worst_of
from solver.numeric.evaluation.environment import Point
from solver.numeric.evaluation.expressions import evaluate
from solver.numeric.evaluation.points import free_symbols
from solver.numeric.evaluation.values import Undefined
from solver.numeric.judges.variations.sampled import at_admissible_points, functions_at, real, relative

TIMES = np.array([0.0, 0.31, 0.73, 1.0])
"""Where functions of time are compared, as parts of the horizon."""
FINE, SMALL = 1e-10, 1e-13
"""Relative and absolute tolerance of integrations."""
LONG = (40.0, 80.0, 160.0, 320.0)
"""Horizons in which P settles, in units of the time scale of the plant."""
SETTLED = 1e-7
SLOWLY = 0.6
"""A gap to the limit closes where it is tiny in the end, or each doubling of the horizon leaves this part of it."""


class Horizon(NamedTuple):
    """The question: A n×n, B n×m, Q n×n, R m×m, S n×n, T, x₀ n×1 (zero if not given), the factor of the cost."""

    A: Any
    B: Any
    Q: Any
    R: Any
    S: Any
    T: Any
    x0: Any
    factor: Any


class Solved:
    """The question in numbers at one point of the parameters, and P in the time to go."""

    def __init__(self, horizon: Horizon, point: Point) -> None:
        self.point = point
        self.A, self.B, self.Q, self.R, self.S = (real(evaluate(M, point)) for M in horizon[:5])
        self.T = float(np.real(evaluate(horizon.T, point)))
        self.x0 = real(evaluate(horizon.x0, point))
        self.factor = float(np.real(evaluate(horizon.factor, point)))
        low = (np.linalg.eigvalsh(self.Q)[0], np.linalg.eigvalsh(self.S)[0])
        if np.linalg.eigvalsh(self.R)[0] <= 0 or self.T <= 0 or min(low) < -1e-9 * (1 + np.abs(self.Q).max()):
            raise Undefined("the weights are not admissible here")

    @cached_property
    def G(self) -> Array:
        """B R⁻¹ Bᵀ."""
        return np.asarray(self.B @ np.linalg.solve(self.R, self.B.T))

    def _slope(self, _tau: float, flat: Array) -> Array:
        P = flat.reshape(self.A.shape)
        return np.asarray(self.A.T @ P + P @ self.A - P @ self.G @ P + self.Q).ravel()

    @cached_property
    def _path(self) -> Any:
        return self._integrated(self._slope, self.S.ravel(), self.T)

    def _integrated(self, slope: Callable[[float, Array], Array], start: Array, end: float) -> Any:
        from scipy.integrate import solve_ivp  # noqa: PLC0415

        found = solve_ivp(slope, (0, end), start, method="DOP853", rtol=FINE, atol=SMALL, dense_output=True)
        if not found.success or not np.isfinite(found.y).all():
            raise Undefined("the integration fails here")
        return found

    def P(self, t: float) -> Array:
        """P at the time t (n×n), integrated back from the end."""
        return np.asarray(self._path.sol(self.T - t).reshape(self.A.shape))

    def K(self, t: float) -> Array:
        """R⁻¹ Bᵀ P (m×n)."""
        return np.asarray(np.linalg.solve(self.R, self.B.T @ self.P(t)))

    @cached_property
    def _motion(self) -> Any:
        def slope(t: float, x: Array) -> Array:
            return np.asarray((self.A - self.B @ self.K(t)) @ x)

        return self._integrated(slope, self.x0[:, 0], self.T)

    def x(self, t: float) -> Array:
        """The optimal motion (n), simulated."""
        return np.asarray(self._motion.sol(t))

    @property
    def cost(self) -> float:
        """The factor times x₀ᵀ P(0) x₀."""
        return self.factor * float((self.x0.T @ self.P(0.0) @ self.x0)[0, 0])

    def settling(self) -> list[Array]:
        """P for longer and longer horizons."""
        scale = max(float(np.abs(self.A).max()), float(np.sqrt(np.abs(self.G).max() * np.abs(self.Q).max())), 0.1)
        path = self._integrated(self._slope, self.S.ravel(), LONG[-1] / scale)
        return [path.sol(end / scale).reshape(self.A.shape) for end in LONG]


def solved(horizon: Horizon, *values: Any) -> list[Solved]:
    """Return the question at two admissible points; symbols of weights and times are positive there."""
    symbols = frozenset().union(*map(free_symbols, (*horizon, *values)))
    own = frozenset().union(*map(free_symbols, (*horizon[2:6], horizon.factor)))
    return at_admissible_points(lambda point: Solved(horizon, point), symbols, own)


def worst(horizon: Horizon, judge: Callable[[Solved], float], *values: Any) -> float:
    """Return the largest of a residual over the admissible points; infinite where a value is not defined."""
    try:
        return worst_of(judge(each) for each in solved(horizon, *values))
    except Undefined:
        return float("inf")


def path_residual(horizon: Horizon, P: Any) -> float:
    """Return how far P(t) (n×n) is from the solution integrated back from the end, relatively."""

    def judge(found: Solved) -> float:
        times = found.T * TIMES
        right = np.array([found.P(t) for t in times])
        return relative(functions_at(P, found.point, times, found.A.shape) - right, right)

    return worst(horizon, judge, P)


def gain_path_residual(horizon: Horizon, K: Any) -> float:
    """Return how far K(t) (m×n) is from R⁻¹BᵀP(t) with that P, relatively."""

    def judge(found: Solved) -> float:
        times = found.T * TIMES
        right = np.array([found.K(t) for t in times])
        return relative(functions_at(K, found.point, times, found.B.T.shape) - right, right)

    return worst(horizon, judge, K)


def optimal_motion_residual(horizon: Horizon, x: Any) -> float:
    """Return how far x(t) (n×1) is from the simulated optimal motion, relatively."""

    def judge(found: Solved) -> float:
        times = found.T * TIMES
        right = np.array([found.x(t)[:, None] for t in times])
        return relative(functions_at(x, found.point, times, found.x0.shape) - right, right, found.x0)

    return worst(horizon, judge, x)


def optimal_input_residual(horizon: Horizon, u: Any) -> float:
    """Return how far u(t) (m×1) is from −K(t)x(t) of the simulated optimal motion, relatively."""

    def judge(found: Solved) -> float:
        times = found.T * TIMES
        right = np.array([-(found.K(t) @ found.x(t))[:, None] for t in times])
        return relative(functions_at(u, found.point, times, (found.B.shape[1], 1)) - right, right)

    return worst(horizon, judge, u)


def horizon_cost_residual(horizon: Horizon, cost: Any) -> float:
    """Return the relative difference of a cost and the factor times x₀ᵀP(0)x₀."""

    def judge(found: Solved) -> float:
        value = complex(evaluate(cost, found.point))
        return abs(value - found.cost) / max(abs(value), abs(found.cost), 1e-300)

    return worst(horizon, judge, cost)


def long_horizon_residual(horizon: Horizon, P: Any) -> float:
    """Return 0 where P(0) comes to this matrix (n×n) as the horizon grows; else how far it stays away, relatively."""

    def judge(found: Solved) -> float:
        wanted = functions_at(P, found.point, np.zeros(1), found.A.shape)[0]
        gaps = [relative(each - wanted, each, wanted, found.S) for each in found.settling()]
        closing = all(after <= SLOWLY * before for before, after in itertools.pairwise(gaps))
        return 0.0 if gaps[-1] < SETTLED or closing else gaps[-1]

    return worst(horizon, judge, P)
