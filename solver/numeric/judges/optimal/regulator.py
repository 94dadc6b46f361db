"""The linear quadratic regulator judged by its defining properties, with scipy's own Riccati and Lyapunov solvers.

Everything is about (A, B, Q, R, N) at random admissible values of the parameters: R > 0, Q − N R⁻¹ Nᵀ ≥ 0, a
stabilizing solution exists. An observer's problem is judged as the regulator's of (Aᵀ, Cᵀ). In discrete time R + BᵀPB
takes the place of R, which may be singular, and costs are sums over the steps.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import lru_cache
from typing import Any, NamedTuple, Self

import numpy as np
import sympy as sp
from numpy.linalg import LinAlgError

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.compare import worst_of
from solver.numeric.evaluation.environment import Point
from solver.numeric.evaluation.expressions import evaluate
from solver.numeric.evaluation.inside import admits
from solver.numeric.evaluation.multiple_precision import solution
from solver.numeric.evaluation.points import PointSource, free_symbols
from solver.numeric.evaluation.values import NotEvaluable, ShapeMismatch, Undefined
from solver.numeric.judges.optimal.refined import MANY, Refined, many_at, sharpened
from solver.words import Phrase

TRIES = 40


class _Weights(NamedTuple):
    A: Any
    B: Any
    Q: Any
    R: Any
    N: Any


class Weights(_Weights):
    """The plant and the weights of xᵀQx + 2xᵀNu + uᵀRu: A n×n, B n×m, Q n×n, R m×m, N n×m (zero if not given)."""

    __slots__ = ()
    discrete = False

    def __new__(cls, A: Any, B: Any, Q: Any, R: Any, N: Any = None) -> Self:
        """Return them, with N in any case."""
        return super().__new__(cls, A, B, Q, R, sp.ImmutableMatrix(sp.zeros(*B.shape)) if N is None else N)


class DiscreteWeights(Weights):
    """The same in discrete time, for the cost Σ xᵀQx + 2xᵀNu + uᵀRu."""

    __slots__ = ()
    discrete = True


CANCELLED = 1e-6
"""The part of the products in a gain that is left where it is said to be other than zero."""


class Optimum(NamedTuple):
    """Numbers at one point: the plant, the weights, the stabilizing solution P and the gain K."""

    point: Point
    A: Array
    B: Array
    Q: Array
    R: Array
    N: Array
    P: Array
    K: Array
    discrete: bool = False

    @property
    def smallest_gain(self) -> Array:
        """What a gain is compared with where its products BᵀP (discrete: BᵀPA) cancel or are zero."""
        factors = (self.B, self.P, *([self.A] if self.discrete else []))
        sizes = float(np.prod([np.abs(each).max(initial=0.0) for each in factors]))
        products = np.full((self.B.shape[1], len(self.A)), sizes)
        return np.asarray(CANCELLED * np.abs(np.linalg.inv(self.weight(self.P))) @ products)

    def weight(self, P: Array) -> Array:
        """R, or R + BᵀPB in discrete time."""
        return self.R + self.B.T @ P @ self.B if self.discrete else self.R

    def gain_of(self, P: Array) -> Array:
        """R⁻¹ (BᵀP + Nᵀ), or (R + BᵀPB)⁻¹ (BᵀPA + Nᵀ) in discrete time."""
        seen = self.B.T @ P @ self.A if self.discrete else self.B.T @ P
        return np.asarray(np.linalg.solve(self.weight(P), seen + self.N.T))

    def without_products(self) -> tuple[Array, Array]:
        """A − BR⁻¹Nᵀ and Q − NR⁻¹Nᵀ."""
        if not np.any(self.N):
            return self.A, self.Q
        cross = np.linalg.solve(self.R, self.N.T)
        return self.A - self.B @ cross, self.Q - self.N @ cross

    @property
    def smallest_loop(self) -> Array:
        """What the matrix of the loop is compared with where all of it cancels, as where a step is enough."""
        sizes = np.abs(self.A) + np.abs(self.B) @ np.abs(self.K)
        return np.asarray(CANCELLED * sizes if self.discrete else 0 * sizes)

    @property
    def closed_loop(self) -> Array:
        """A − BK."""
        return np.asarray(self.A - self.B @ self.K)


def optima(weights: Weights, others: Iterable[Any] = (), count: int = 2) -> list[Optimum]:
    """Return the optimum at so many admissible points (at the only one if there are no symbols).

    `others` are formulas whose symbols take values too. Raises NotEvaluable if no admissible point is found.
    """
    symbols = frozenset().union(*map(free_symbols, weights), *map(free_symbols, others))
    source = PointSource(symbols)
    own = free_symbols(weights.Q) | free_symbols(weights.R)
    found: list[Optimum] = []
    for _ in range(TRIES if symbols else 1):
        drawn = source.draw()
        for point in ({s: abs(v) if s in own else v for s, v in drawn.items()}, {s: abs(v) for s, v in drawn.items()}):
            optimum = _optimum(weights, point) if admits(point) else None
            if optimum is not None:
                found.append(optimum)
                break
        if len(found) == (count if symbols else 1):
            break
    if not found:
        raise NotEvaluable("no values of the parameters were found for which the problem has a solution")
    return found


def _optimum(weights: Weights, point: Mapping[Any, Any]) -> Optimum | None:
    """Return scipy's solution at a point; None if the point is not admissible."""
    fixed = type(weights)(*(M.as_immutable() for M in weights))
    return _known_optimum(fixed, weights.discrete, tuple(point.items()))


@lru_cache(maxsize=64)
def _known_optimum(weights: Weights, discrete: bool, items: tuple[Any, ...]) -> Optimum | None:
    """Return it; the checks of one part ask for the same one."""
    point = dict(items)
    try:
        matrices = [_real(evaluate(M, point)) for M in weights]
    except Undefined:
        return None
    parametric = any(map(free_symbols, (weights.Q, weights.R, weights.N)))
    return optimum_in_floats(matrices, discrete=discrete, point=point, definite=parametric)


def optimum_in_floats(
    matrices: Sequence[Array], *, discrete: bool, point: Point | None = None, definite: bool = True
) -> Optimum | None:
    """Return scipy's solution for A, B, Q, R, N; None where R or (if asked) Q is not definite, or no loop is stable."""
    from scipy.linalg import solve_continuous_are, solve_discrete_are  # noqa: PLC0415

    A, B, Q, R, N = matrices
    try:
        if np.linalg.eigvalsh(R)[0] <= (-1e-12 if discrete else 0):
            return None
        P = (solve_discrete_are if discrete else solve_continuous_are)(A, B, Q, R, s=N)
        found = Optimum(point or {}, A, B, Q, R, N, P, P, discrete)
        if definite and np.linalg.eigvalsh(found.without_products()[1])[0] < -1e-9 * (1 + np.abs(Q).max()):
            return None
        if np.linalg.eigvalsh(found.weight(P))[0] <= 0:
            return None
        found = found._replace(K=found.gain_of(P))
    except (LinAlgError, ValueError):
        return None
    return found if stable(found.closed_loop, discrete=discrete) else None


def _real(matrix: Any) -> Array:
    if np.abs(np.imag(matrix)).max(initial=0.0) > 1e-9 * (1 + np.abs(matrix).max(initial=0.0)):
        raise Undefined("the matrix is not real here")
    return np.real(matrix)


def stable(matrix: Array, *, discrete: bool = False) -> bool:
    """Whether all eigenvalues lie in the open left half plane, or inside of the unit circle."""
    eigenvalues = np.linalg.eigvals(matrix)
    if discrete:
        return bool(np.all(np.abs(eigenvalues) < 1 - 1e-12))
    return bool(np.all(eigenvalues.real < -1e-12 * (1 + np.abs(eigenvalues).max(initial=0.0))))


def matrix_at(formula: Any, point: Point, shape: tuple[int, int]) -> Array:
    """Return a real matrix at a point; raises ShapeMismatch for another shape, NotEvaluable for unknown symbols."""
    if getattr(formula, "shape", (1, 1)) != shape:
        raise ShapeMismatch(Phrase("it must be {rows}×{columns}", rows=shape[0], columns=shape[1]))
    unknown = free_symbols(formula) - set(point)
    if unknown:
        listed = ", ".join(sorted(map(str, unknown)))
        raise ShapeMismatch(Phrase("it holds {unknown}, which the question does not", unknown=listed))
    value = evaluate(formula, point)
    return np.reshape(_real(value), shape)


def relative(difference_: Array, *scales: Array) -> float:
    """Return the largest entry of a difference over the largest of what was compared."""
    size = max((float(np.abs(scale).max(initial=0.0)) for scale in scales), default=0.0)
    gap = float(np.abs(difference_).max(initial=0.0))
    return gap / size if size > 0 else gap


def worst(weights: Weights, judge: Callable[[Optimum], float], *others: Any) -> float:
    """Return the largest of a residual over the admissible points; infinite where a value is not real or defined."""
    try:
        return worst_of(judge(optimum) for optimum in optima(weights, others))
    except Undefined:
        return float("inf")


def current_gain_residual(weights: Weights, K: Any) -> float:
    """Return the relative difference of K (m×n) and (R + BᵀPB)⁻¹ BᵀP with scipy's P."""

    def judge(optimum: Optimum) -> float:
        value = matrix_at(K, optimum.point, (optimum.B.shape[1], optimum.A.shape[0]))
        best = np.linalg.solve(optimum.weight(optimum.P), optimum.B.T @ optimum.P)

        def gap(many: Refined) -> tuple[Array, ...]:
            own = solution(many.R + many.B.T @ many.P @ many.B, many.B.T @ many.P)
            return many_at(K, optimum.point) - own, own

        return sharpened(relative(value - best, value, best), weights, optimum, K, gap)

    return worst(weights, judge, K)


def loop_residual(weights: Weights, loop: Any) -> float:
    """Return the relative difference of a matrix and A − BK with scipy's K."""

    def judge(optimum: Optimum) -> float:
        value = matrix_at(loop, optimum.point, optimum.A.shape)
        found = relative(value - optimum.closed_loop, value, optimum.closed_loop, optimum.smallest_loop)

        def gap(many: Refined) -> tuple[Array, ...]:
            own = many.A - many.B @ many.K
            return many_at(loop, optimum.point) - own, own, optimum.smallest_loop

        return sharpened(found, weights, optimum, loop, gap)

    return worst(weights, judge, loop)


def control_residual(weights: Weights, u: Any, states: Sequence[Any]) -> float:
    """Return the relative difference of u (m×1, or an expression for m = 1) and −Kx at random states, K scipy's."""

    def judge(optimum: Optimum) -> float:
        value = matrix_at(u, optimum.point, (optimum.B.shape[1], 1))
        x = np.array([[optimum.point[state]] for state in states])
        found = relative(value + optimum.K @ x, value, optimum.K, optimum.smallest_gain)

        def gap(many: Refined) -> tuple[Array, ...]:
            return many_at(u, optimum.point) + many.K @ MANY.array(x), many.K, optimum.smallest_gain

        return sharpened(found, weights, optimum, u, gap)

    return worst(weights, judge, u, sp.ImmutableMatrix([list(states)]))
