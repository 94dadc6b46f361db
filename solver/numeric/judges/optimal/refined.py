"""The optimum with many digits: Newton's method from what scipy finds in doubles (Kleinman, IEEE Trans. AC-13, 1968).

In discrete time it is that of Hewer (IEEE Trans. AC-16, 1971).
For values that are exact. Each step solves one Lyapunov equation and doubles the number of right digits.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from solver.numeric.evaluation.arithmetic import Array, multiple
from solver.numeric.evaluation.compare import Residual
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.multiple_precision import solution
from solver.numeric.evaluation.points import holds_decimals
from solver.numeric.evaluation.precision import EXACT
from solver.numeric.evaluation.values import NotEvaluable

if TYPE_CHECKING:
    from solver.numeric.judges.optimal.regulator import Optimum, Weights

MANY = multiple(50)
FLOATS = 1e-8
"""Tolerance of comparisons with what scipy finds in doubles."""
STEPS = 6
DOUBLINGS, ENOUGH_DOUBLED = 40, 1e-46
ENOUGH = 1e-30
"""A relative change after which the digits are more than what is compared."""


class Refined(NamedTuple):
    """Numbers of 50 digits at one point, as arrays of objects."""

    A: Array
    B: Array
    Q: Array
    R: Array
    N: Array
    P: Array
    K: Array


def sharpened(
    found: float, weights: Weights, optimum: Optimum, formulas: Any, gap: Callable[[Refined], tuple[Array, ...]]
) -> Residual:
    """Return a residual found in doubles; where all is exact, and doubles see no difference, the one of many digits.

    `gap` gives a difference that must be zero, and the values whose sizes it is compared with.
    """
    if not found <= FLOATS or holds_decimals([*weights, formulas]):
        return Residual(found, FLOATS)
    try:
        difference, *scales = gap(refined(weights, optimum))
    except NotEvaluable:
        return Residual(found, FLOATS)
    return Residual(_largest(difference) / (max(map(_largest, scales)) or 1.0), EXACT.tolerance)


def refined(weights: Weights, optimum: Optimum) -> Refined:
    """Return the optimum at the same point with 50 digits. Raises NotEvaluable where Newton's method finds none."""
    return _refined(weights, tuple(optimum.point.items()), optimum.K.tobytes(), optimum.K.shape, weights.discrete)


@lru_cache(maxsize=16)
def _refined(weights: Weights, items: tuple[Any, ...], start: bytes, shape: tuple[int, int], discrete: bool) -> Refined:
    """Return it; the checks of one part ask for the same ones."""
    point = dict(items)
    A, B, Q, R, N = (many_at(M, point) for M in weights)
    K = MANY.array(np.frombuffer(start).reshape(shape))
    P = None
    for _ in range(STEPS):
        cost = Q - N @ K - K.T @ N.T + K.T @ R @ K
        if discrete:
            found = stein(A - B @ K, cost)
            K = solution(R + B.T @ found @ B, B.T @ found @ A + N.T)
        else:
            found = lyapunov(A - B @ K, cost)
            K = solution(R, B.T @ found + N.T)
        if P is not None and _largest(found - P) <= ENOUGH * _largest(found):
            return Refined(A, B, Q, R, N, found, K)
        P = found
    raise NotEvaluable("Newton's method finds no solution with many digits")


def many_at(formula: Any, point: Any) -> Array:
    """Return a real matrix at a point, with 50 digits."""
    value = value_of(formula, Environment.at([dict(point)], MANY)).value
    flat = [entry.real for entry in np.ravel(np.asarray(value, dtype=object))]
    return np.array(flat, dtype=object).reshape(getattr(formula, "shape", (1, 1)))


def lyapunov(F: Array, W: Array) -> Array:
    """Return the symmetric X with FᵀX + XF + W = 0: one linear equation for each entry on and above the diagonal."""
    n = len(F)
    pairs = [(i, j) for i in range(n) for j in range(i, n)]
    place = {pair: k for k, pair in enumerate(pairs)}
    zero = MANY.number(0)
    rows = np.full((len(pairs), len(pairs)), zero, dtype=object)
    for row, (i, j) in enumerate(pairs):
        for k in range(n):
            rows[row, place[min(k, j), max(k, j)]] += F[k, i]
            rows[row, place[min(i, k), max(i, k)]] += F[k, j]
    right = np.array([[-W[i, j]] for i, j in pairs], dtype=object)
    found = solution(rows, right)
    return np.array([[found[place[min(i, j), max(i, j)], 0] for j in range(n)] for i in range(n)], dtype=object)


def stein(F: Array, W: Array) -> Array:
    """Return X with X = FᵀXF + W: the sum of (Fᵀ)ᵏ W Fᵏ over all k, the number of terms doubled each time."""
    found, power = W, F
    for _ in range(DOUBLINGS):
        added = power.T @ found @ power
        found = found + added
        if _largest(added) <= ENOUGH_DOUBLED * _largest(found):
            return found
        power = power @ power
    raise NotEvaluable("the loop is too slow to sum up its cost")


def _largest(M: Array) -> float:
    return max(float(abs(entry)) for entry in np.ravel(M))
