"""Limits and peaks of an output with many digits, from what a simulation in doubles finds; for values that are exact.

Only where the input is constant from the start on: then x(t) is a matrix exponential.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array, multiple
from solver.numeric.evaluation.compare import Residual, worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.multiple_precision import exponential, solution
from solver.numeric.evaluation.points import free_symbols, holds_decimals
from solver.numeric.evaluation.precision import EXACT
from solver.numeric.evaluation.values import NotEvaluable, Undefined
from solver.numeric.judges.time_response.trajectory import (
    Simulation,
    difference,
    final_output,
    largest_output,
    samples_of_output,
)

MANY = multiple(50)
DOUBLES = 1e-7
"""Tolerance of comparisons with a simulation in doubles."""
STEPS = 4


def limit_residual(found: Sequence[tuple[Mapping[Any, complex], Simulation]], value: Any, *, discrete: bool) -> float:
    """Return how far a column is from the limits of the output at some points, relative to the largest entry."""
    return worst_of(
        sharpened(
            difference(final_output(each, discrete=discrete), value, point),
            value,
            each,
            _limit(each, discrete=discrete),
        )
        for point, each in found
    )


def peak_residual(
    found: Sequence[tuple[Mapping[Any, complex], Simulation]], value: Any, which: int, *, discrete: bool
) -> float:
    """Return how far the time (`which` 0) or the value (1) of the peak of |y| is off, relatively."""
    worst = []
    for point, each in found:
        seen = _peak_in_samples(each) if discrete else largest_output(each)
        many = _peak(each, seen[0], discrete=discrete)
        wanted = np.array([many[which]], dtype=object) if many is not None else None
        worst.append(sharpened(difference(seen[which], value, point), value, each, wanted))
    return worst_of(worst)


def _peak_in_samples(simulation: Simulation) -> tuple[float, float]:
    y = samples_of_output(simulation, 400)[:, 0]
    k = int(abs(y).argmax())
    k = next(i for i in range(len(y)) if abs(y[i]) >= abs(y[k]) * (1 - 1e-12))
    return float(k), float(y[k])


def sharpened(found: float, value: Any, simulation: Simulation, wanted: Array | None) -> Residual:
    """Return the residual of doubles, or where all is exact and they see no difference, that of many digits."""
    if wanted is None or not found <= DOUBLES or holds_decimals(value):
        return Residual(found, DOUBLES)
    own = np.ravel(_at(value, simulation.point))
    size = max((float(abs(each)) for each in wanted), default=0.0)
    gap = max((float(abs(a - b)) for a, b in zip(own, wanted, strict=True)), default=0.0)
    return Residual(gap / size if size > 1e-30 else gap, EXACT.tolerance)


def _limit(simulation: Simulation, *, discrete: bool) -> Array | None:
    """Return the output at rest (p) with 50 digits; None where the input is not constant, or A is singular."""
    matrices = _matrices(simulation)
    if matrices is None:
        return None
    A, B, C, D, _, u = matrices
    M = A - np.eye(len(A), dtype=int).astype(object) if discrete else A
    try:
        x = -solution(M, B @ u) if len(A) else B @ u
    except Undefined:
        return None
    return np.asarray((C @ x + D @ u)[:, 0])


def _peak(simulation: Simulation, time: float, *, discrete: bool) -> tuple[Any, Any] | None:
    """Return time and value of the peak next to a time, by Newton's method; of samples the value at that time."""
    matrices = _matrices(simulation)
    if matrices is None:
        return None
    A, B, C, D, x0, u = matrices
    if discrete:
        x = x0
        for _ in range(round(time)):
            x = A @ x + B @ u
        return MANY.number(round(time)), (C @ x + D @ u)[0, 0]
    n, t = len(A), MANY.number(time)
    whole = np.vstack([np.hstack([A, B @ u]), np.full((1, n + 1), MANY.number(0), dtype=object)])
    for _ in range(STEPS):
        try:
            moved, _ = exponential(whole * t, MANY.context)
        except NotEvaluable:
            return None
        x = moved[:n, :n] @ x0 + moved[:n, n:]
        speed = A @ x + B @ u
        first, second = (C @ speed)[0, 0], (C @ A @ speed)[0, 0]
        if second == 0:
            return None
        step = first / second
        t = t - step
    return (t.real, (C @ x + D @ u)[0, 0]) if abs(step) <= 1e-40 * abs(t) else None


def _matrices(simulation: Simulation) -> tuple[Array, ...] | None:
    """Return A, B, C, D, x₀ and the constant input with 50 digits."""
    inputs = simulation.exact[-1]
    if inputs is not None and (simulation.time in free_symbols(inputs) or holds_decimals(inputs)):
        return None
    if holds_decimals(simulation.exact[:-1]):
        return None
    A, B, C, D, x0 = (_at(M, simulation.point) for M in simulation.exact[:-1])
    u = _at(inputs, simulation.point) if inputs is not None else MANY.array(np.zeros((B.shape[1], 1)))
    return A, B, C, D, x0, u


def _at(M: Any, point: Any) -> Array:
    if 0 in M.shape:
        return np.zeros(M.shape, dtype=object)
    return np.asarray(np.broadcast_to(value_of(M, Environment.at([dict(point)], MANY)).value, (1, *M.shape))[0])
