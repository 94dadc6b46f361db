"""The entries of a Riccati differential equation, at random values of P and P'; the recursion in discrete time."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.compare import worst_of
from solver.numeric.evaluation.expressions import evaluate
from solver.numeric.evaluation.points import PointSource, free_symbols
from solver.numeric.evaluation.values import NotEvaluable, ShapeMismatch, Undefined
from solver.numeric.judges.variations.horizons import Horizon, Solved, worst
from solver.numeric.judges.variations.sampled import real, relative
from solver.words import Phrase


def differential_equations_residual(
    horizon: Horizon, equations: Sequence[Any], names: Sequence[tuple[Any, Any]]
) -> float:
    """Return how far expressions are from the entries of P' + AᵀP + PA − PGP + Q, in any order and scale.

    `names` are the symbols of the entries and of their derivatives, row by row on and above the diagonal.
    """
    symbols = {symbol for pair in names for symbol in pair}
    listed = sp.ImmutableMatrix([list(equations)])
    inside = free_symbols(listed) & symbols

    def judge(found: Solved) -> float:
        n = len(found.A)
        source = PointSource(symbols)
        rows, right = [], []
        for draw in source.several(3 * len(names) + 2):
            at = {**found.point, **draw}
            rows.append(np.real(evaluate(listed, at))[0])
            P, rate = np.zeros((n, n)), np.zeros((n, n))
            places = [(i, j) for i in range(n) for j in range(i, n)]
            for (i, j), (entry, change) in zip(places, names, strict=True):
                P[i, j] = P[j, i] = np.real(draw[entry])
                rate[i, j] = rate[j, i] = np.real(draw[change])
            whole = rate + found.A.T @ P + P @ found.A - P @ found.G @ P + found.Q
            right.append([whole[i, j] for i, j in places])
        return _unmatched(np.array(rows), np.array(right))

    outside = free_symbols(listed) - inside
    if sp.Symbol("t") in outside:
        return float("inf")
    return worst(horizon, judge, sp.ImmutableMatrix([sorted(outside, key=str)]) if outside else sp.S.Zero)


def _unmatched(found: Array, right: Array) -> float:
    """How far columns are from being multiples of columns, each of another one."""
    if found.shape != right.shape:
        return float("inf")
    left, worst = list(range(right.shape[1])), 0.0
    for column in found.T:
        gaps = []
        for j in left:
            scale = float(column @ right[:, j]) / float(right[:, j] @ right[:, j])
            gap = np.abs(column - scale * right[:, j]).max() / max(np.abs(column).max(), 1e-300)
            gaps.append(gap if scale != 0 else float("inf"))
        best = int(np.argmin(gaps))
        worst = max(worst, gaps[best])
        left.pop(best)
    return worst


class Steps(NamedTuple):
    """The question in discrete time: A n×n, B n×m, Q n×n, R m×m, S n×n, N steps, x₀ n×1, the factor of the cost."""

    A: Any
    B: Any
    Q: Any
    R: Any
    S: Any
    N: int
    x0: Any
    factor: Any


class Batch:
    """All inputs of the steps that are left as one column, and the cost as one quadratic form in it and the state.

    x = Φ x_k + Γ u, so the cost is uᵀ(R̄ + ΓᵀQ̄Γ)u + 2uᵀΓᵀQ̄Φx + xᵀ(Q + ΦᵀQ̄Φ)x, which linear equations make least.
    """

    def __init__(self, steps: Steps, point: Any) -> None:
        self.point = point
        self.A, self.B, self.Q, self.R, self.S = (real(evaluate(M, point)) for M in steps[:5])
        self.x0 = real(evaluate(steps.x0, point))
        self.factor = float(np.real(evaluate(steps.factor, point)))
        self.count = steps.N
        if np.linalg.eigvalsh(self.R)[0] <= 0 or min(np.linalg.eigvalsh(M)[0] for M in (self.Q, self.S)) < -1e-9:
            raise Undefined("the weights are not admissible here")

    def least(self, k: int) -> tuple[Array, Array]:
        """P of the steps from k on (n×n), and the gains of all their inputs in the state (m(N − k)×n)."""
        n, m = self.B.shape
        left = self.count - k
        if left == 0:
            return self.S, np.zeros((0, n))
        powers = [np.linalg.matrix_power(self.A, i) for i in range(left + 1)]
        free = np.vstack(powers[1:])
        forced = np.zeros((n * left, m * left))
        for i in range(left):
            for j in range(i + 1):
                forced[i * n : (i + 1) * n, j * m : (j + 1) * m] = powers[i - j] @ self.B
        weight = np.kron(np.eye(left), self.Q)
        weight[-n:, -n:] = self.S
        square = np.kron(np.eye(left), self.R) + forced.T @ weight @ forced
        gains = np.linalg.solve(square, forced.T @ weight @ free)
        return self.Q + free.T @ weight @ free - free.T @ weight @ forced @ gains, gains


def batches(steps: Steps, *values: Any) -> list[Batch]:
    """Return the question at two admissible points; symbols of weights are positive there."""
    symbols = frozenset().union(*map(free_symbols, (*steps[:5], *steps[6:], *values)))
    own = frozenset().union(*map(free_symbols, (*steps[2:5], steps.factor)))
    source, found = PointSource(symbols), []
    for _ in range(20 if symbols else 1):
        point = {s: abs(v) if s in own else v for s, v in source.draw().items()}
        try:
            found.append(Batch(steps, point))
        except (np.linalg.LinAlgError, Undefined):
            continue
        if len(found) == (2 if symbols else 1):
            break
    if not found:
        raise NotEvaluable("no values of the parameters were found for which the problem has a solution")
    return found


def _listed(values: Sequence[Any], count: int, shape: tuple[int, int], point: Any) -> list[Array]:
    if len(values) != count:
        raise ShapeMismatch(Phrase("there must be {count} of them", count=count))
    found = []
    for each in values:
        value = each if hasattr(each, "shape") else sp.ImmutableMatrix([each])
        if value.shape != shape:
            raise ShapeMismatch(Phrase("each must be {rows}×{columns}", rows=shape[0], columns=shape[1]))
        found.append(real(evaluate(value, point)))
    return found


def cost_matrices_residual(steps: Steps, P: Sequence[Any]) -> float:
    """Return how far P₀ … P_N are from the least costs of the steps that are left, relatively."""

    def judge(batch: Batch) -> float:
        listed = _listed(P, steps.N + 1, batch.A.shape, batch.point)
        return worst_of(relative(each - (right := batch.least(k)[0]), each, right) for k, each in enumerate(listed))

    return worst_of(judge(batch) for batch in batches(steps, list(P)))


LONGEST, SETTLED_STEPS = 20_000, 1e-13


def long_steps_residual(steps: Steps, P: Any) -> float:
    """Return how far a matrix (n×n) is from P₀ of ever more steps, relatively; infinite where that does not settle."""

    def judge(batch: Batch) -> float:
        A, B, Q, R, found = batch.A, batch.B, batch.Q, batch.R, batch.S
        wanted = real(evaluate(P, batch.point))
        if wanted.shape != A.shape:
            raise ShapeMismatch("it must be a matrix like A")
        for _ in range(LONGEST):
            K = np.linalg.solve(R + B.T @ found @ B, B.T @ found @ A)
            loop = A - B @ K
            earlier = Q + K.T @ R @ K + loop.T @ found @ loop
            change, found = relative(earlier - found, earlier, Q), earlier
            if change < SETTLED_STEPS:
                return relative(found - wanted, found, wanted, batch.S)
        return float("inf")

    return worst_of(judge(batch) for batch in batches(steps, P))


def step_gains_residual(steps: Steps, K: Sequence[Any]) -> float:
    """Return how far K₀ … K_{N−1} are from the gains of the first input of the steps that are left, relatively."""

    def judge(batch: Batch) -> float:
        m = batch.B.shape[1]
        listed = _listed(K, steps.N, batch.B.T.shape, batch.point)
        return worst_of(relative(each - (right := batch.least(k)[1][:m]), each, right) for k, each in enumerate(listed))

    return worst_of(judge(batch) for batch in batches(steps, list(K)))


def step_inputs_residual(steps: Steps, u: Sequence[Any]) -> float:
    """Return how far u₀ … u_{N−1} are from the inputs that make the cost from x₀ least, relatively."""

    def judge(batch: Batch) -> float:
        m = batch.B.shape[1]
        right = -(batch.least(0)[1] @ batch.x0).reshape(steps.N, m, 1)
        found = np.array(_listed(u, steps.N, (m, 1), batch.point))
        return relative(found - right, right, found)

    return worst_of(judge(batch) for batch in batches(steps, list(u)))


def step_states_residual(steps: Steps, x: Sequence[Any]) -> float:
    """Return how far x₀ … x_N are from the motion under these inputs, relatively."""

    def judge(batch: Batch) -> float:
        m = batch.B.shape[1]
        inputs = -(batch.least(0)[1] @ batch.x0).reshape(steps.N, m, 1)
        right = [batch.x0]
        for each in inputs:
            right.append(batch.A @ right[-1] + batch.B @ each)
        found = np.array(_listed(x, steps.N + 1, batch.x0.shape, batch.point))
        return relative(found - np.array(right), found, np.array(right))

    return worst_of(judge(batch) for batch in batches(steps, list(x)))


def steps_cost_residual(steps: Steps, cost: Any) -> float:
    """Return the relative difference of a cost and the factor times x₀ᵀP₀x₀."""

    def judge(batch: Batch) -> float:
        right = batch.factor * float((batch.x0.T @ batch.least(0)[0] @ batch.x0)[0, 0])
        value = complex(evaluate(cost, batch.point))
        return abs(value - right) / max(abs(value), abs(right), 1e-300)

    return worst_of(judge(batch) for batch in batches(steps, cost))
