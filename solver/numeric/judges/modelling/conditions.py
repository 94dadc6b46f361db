"""Whether conditions on parameters are those under which a point is one of rest: they hold there, and are enough."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from random import Random
from typing import Any

import numpy as np

from solver.numeric.evaluation.expressions import evaluate
from solver.numeric.evaluation.points import SEED, PointSource, free_symbols, whole_symbols
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.modelling.equations import Question
from solver.numeric.judges.modelling.linearized import ATTEMPTS, TRIALS, jets_at, resting_points, speed_at


def condition_residual(
    question: Question, values: Mapping[Any, Any], conditions: Sequence[Any], *, discrete: bool
) -> float:
    """Return how far conditions are from holding where the point is one of rest; nan where it is nowhere found."""
    sides = [side for each in conditions for side in (each.lhs, each.rhs)]
    worst = []
    for around in resting_points(question, values, sides, discrete=discrete):
        gaps = [evaluate(each.lhs, around.numbers) - evaluate(each.rhs, around.numbers) for each in conditions]
        worst.append(float(np.max(np.abs(gaps), initial=0.0)))
    return max(worst) if worst else np.nan


def motion_where(question: Question, values: Mapping[Any, Any], conditions: Sequence[Any], *, discrete: bool) -> float:
    """Return how fast the states move at a point, in comparison to it, where conditions hold; nan if that is nowhere.

    Numbers are moved to where the conditions hold by Newton's method, each as little as possible.
    """
    random = Random(SEED)  # noqa: S311 - nothing secret
    gaps = [each.lhs - each.rhs for each in conditions]
    known = {symbol for symbol in question.jets if symbol not in values or values[symbol] != symbol}
    symbols = sorted(free_symbols([*question.equations, *values.values(), *gaps]) - known, key=str)
    source, found = PointSource(symbols, whole_symbols(symbols=frozenset(symbols))), []
    moved = sorted(free_symbols(gaps), key=str)
    for _ in range(ATTEMPTS):
        numbers = _solved_near(gaps, dict(source.draw()), moved)
        at = None if numbers is None else jets_at(question, values, numbers, random, discrete=discrete)
        if at is not None and np.isfinite(speed_at(at)):
            found.append(speed_at(at) / max(1.0, *(abs(value) for value in at.jets.values())))
        if len(found) == TRIALS:
            return float(max(found))
    return float(np.nan)


def _solved_near(gaps: Sequence[Any], numbers: dict[Any, complex], moved: Sequence[Any]) -> dict[Any, complex] | None:
    """Numbers near to some at which expressions are zero; None where Newton's method does not arrive."""
    move = 1e-6
    for _ in range(40):
        try:
            now = np.array([evaluate(gap, numbers) for gap in gaps], dtype=complex)
            slopes = np.array([
                [(evaluate(gap, numbers | {x: numbers[x] + move}) - value) / move for x in moved]
                for gap, value in zip(gaps, now, strict=True)
            ])  # fmt: skip
        except (NotEvaluable, KeyError):
            return None
        if not (np.isfinite(now).all() and np.isfinite(slopes).all()):
            return None
        if np.max(np.abs(now), initial=0.0) < 1e-12 * max(1.0, *map(abs, numbers.values())):
            return numbers
        step = np.linalg.lstsq(slopes, -now, rcond=1e-9)[0]
        numbers = numbers | {x: numbers[x] + by for x, by in zip(moved, step, strict=True)}
    return None
