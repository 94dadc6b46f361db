"""Whether a motion from a state begins with given outputs: by its Taylor coefficients, or its first samples."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.expressions import evaluate
from solver.numeric.evaluation.points import admissible, free_symbols
from solver.numeric.evaluation.values import NotEvaluable

TRIALS = 3


def beginning_residual(
    plant: tuple[Any, Any, Any, Any], x0: Any, y: Sequence[Any], u: Sequence[Any], *, discrete: bool
) -> float:
    """Return how far the outputs are from the given ones; inf for a state of another size.

    In continuous time x(t) is summed as a power series with u(t) = Σ u⁽ⁱ⁾ tⁱ/i!, whose k-th derivative at zero is
    what a discrete motion has at its k-th sample but for the input: x⁽ᵏ⁺¹⁾ = A x⁽ᵏ⁾ + B u⁽ᵏ⁾ either way.
    """
    A, *_ = plant
    if getattr(x0, "shape", None) != (A.rows, 1):
        return np.inf
    symbols = free_symbols([*(M for M in plant if M is not None), x0, *y, *u])
    worst = 0.0
    for point in admissible(symbols, TRIALS):
        try:
            worst = max(worst, _gap([_numbers(M, point) for M in plant], _numbers(x0, point),
                                    [_numbers(each, point) for each in y], [_numbers(each, point) for each in u],
                                    discrete=discrete))  # fmt: skip
        except NotEvaluable:
            return np.inf
    return worst


def _numbers(M: Any, point: Any) -> Array | None:
    if M is None:
        return None
    return np.array([evaluate(entry, point) for entry in M], dtype=complex).reshape(M.shape)


def _gap(plant: Sequence[Any], x: Any, y: Sequence[Any], u: Sequence[Any], *, discrete: bool) -> float:
    A, B, C, D = plant
    series = [x]  # coefficients of tᵏ; discrete: the samples
    for k in range(len(y) - 1):
        by = 1.0 if discrete else 1.0 / (k + 1)
        drive = B @ _coefficient(u, k, discrete=discrete) if B is not None else 0.0
        series.append(by * (A @ series[-1] + drive))
    worst = 0.0
    for k, wanted in enumerate(y):
        through = D @ _coefficient(u, k, discrete=discrete) if B is not None else 0.0
        found = (C @ series[k] + through) * _factorial(k, discrete=discrete)
        size = max(1.0, float(np.max(np.abs(wanted))), float(np.max(np.abs(C) @ np.abs(series[k]))))
        worst = max(worst, float(np.max(np.abs(found - wanted))) / size)
    return worst if np.isfinite(worst) else np.inf


def _coefficient(u: Sequence[Any], k: int, *, discrete: bool) -> Any:
    return u[k] / _factorial(k, discrete=discrete)


def _factorial(k: int, *, discrete: bool) -> float:
    return 1.0 if discrete else float(np.prod(np.arange(1.0, k + 1)))
