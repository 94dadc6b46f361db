"""Sensitivities judged in numbers: by 1 + L, and by differences of the transfer function in many digits."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from solver.numeric.evaluation.compare import with_many_digits, worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import PointSource, free_symbols
from solver.numeric.judges.representation.minimal import MANY

POINTS = 3
STEP = "1e-16"
"""The relative step of a difference."""


def loop_sensitivity_residual(factors: Sequence[Any], S: Any) -> float:
    """Return the largest difference of S (1 + C G H) and 1 at some points."""
    worst = 0.0
    for point in _points([*factors, S]):
        C, G, H, found = (_number(each, point) for each in (*factors, S))
        worst = worst_of((worst, float(abs(found * (1 + C * G * H) - 1))))
    return with_many_digits(worst, *factors, S)


def parameter_sensitivity_residual(factors: Sequence[Any], S: Any, p: Any, *, closed: bool) -> float:
    """Return the largest difference of S and the relative change of T over that of p, relative to S where it is large.

    T is C G/(1 + C G H), or C G where the loop is not `closed`.
    """
    worst = 0.0
    for point in _points([*factors, S, p]):
        at = MANY.context.mpmathify(point[p])
        step = at * MANY.context.mpf(STEP)
        before, here, after = (_transfer(factors, {**point, p: value}, closed) for value in (at - step, at, at + step))
        wanted = (after - before) / (2 * step) * at / here
        worst = worst_of((worst, float(abs(_number(S, point) - wanted) / max(1, abs(wanted)))))
    return with_many_digits(worst, *factors, S)


def _points(formulas: Sequence[Any]) -> list[dict[Any, complex]]:
    symbols = free_symbols(formulas)
    return PointSource(symbols).several(POINTS if symbols else 1)


def _transfer(factors: Sequence[Any], point: Mapping[Any, Any], closed: bool) -> Any:
    C, G, H = (_number(each, point) for each in factors)
    return C * G / (1 + C * G * H) if closed else C * G


def _number(value: Any, point: Mapping[Any, Any]) -> Any:
    return np.ravel(value_of(value, Environment.at([dict(point)], MANY)).value)[0]
