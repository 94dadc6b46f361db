"""Whether a value written with decimals agrees with another one to the digits written."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.expressions import evaluate
from solver.numeric.evaluation.points import PointSource, free_symbols, nodes, whole_symbols

NOTHING = 1e-40
"""What is left of a zero evaluated with 100 digits."""

SLACK = 1e-6
"""Relative to half a unit: a number half way between two decimals may be rounded either way."""

STEPS = 8
"""Of Newton's method; with decimals in exponents it takes about four."""

Point = Mapping[Any, complex]


def agrees_to_digits(form: Any, decimals: Mapping[Any, tuple[Any, Any]], target: Any) -> bool:
    """Whether `form` = `target` for one choice of all decimals within half a unit of their last digits.

    `decimals` gives for each symbol that stands for a decimal its value and half a unit of its last digit. The same
    choice must do at all points: at random values of the other symbols what is left is linearized in the decimals and
    made as small as the half units allow (Gauss and Newton, bounded least squares). Raises NotEvaluable.
    """
    own = [symbol for symbol in decimals if symbol in form.free_symbols]
    points = _points(form, target, (free_symbols(form) | free_symbols(target)) - set(own), len(own))
    wanted = np.array([evaluate(target, point) for point in points])
    centre, half = (np.array([float(decimals[symbol][i]) for symbol in own]) for i in (0, 1))
    slopes = [sp.diff(form, symbol) for symbol in own]

    def at(moved: Array, formula: Any) -> Array:
        choice = dict(zip(own, map(complex, centre + half * moved), strict=True))
        return np.array([evaluate(formula, {**point, **choice}) for point in points])

    moved = np.zeros(len(own))
    for _ in range(STEPS):
        left = at(moved, form) - wanted
        effects = np.array([at(moved, slope) for slope in slopes]).reshape(len(own), len(points)).T * half
        reach = np.abs(effects).sum(axis=1)
        if np.all(np.abs(left) <= 1e-9 * np.abs(wanted) + SLACK * reach + NOTHING):
            return True
        scale = 1.0 / np.maximum(reach, 1e-9 * np.abs(wanted) + NOTHING)
        better = _nearest(effects * scale[:, None], left * scale, moved)
        if np.allclose(better, moved, rtol=0.0, atol=SLACK * SLACK):
            return False
        moved = better
    return False


def _nearest(effects: Array, left: Array, moved: Array) -> Array:
    """Return where in the box |u| ≤ 1 the linearized rest, left + effects (u − moved), is least."""
    if not len(moved):
        return moved
    A, b = (np.concatenate([part.real, part.imag]) for part in (effects, effects @ moved - left))
    free = np.linalg.lstsq(A, b, rcond=None)[0]
    if np.all(np.abs(free) <= 1.0 + SLACK):
        return np.asarray(free)
    from scipy.optimize import lsq_linear  # noqa: PLC0415 - only what is wrong, or has a choice, needs it

    return np.asarray(lsq_linear(A, b, bounds=(-1.0 - SLACK, 1.0 + SLACK), method="bvls").x)


def _points(form: Any, target: Any, symbols: Collection[Any], decimals: int) -> Sequence[Point]:
    """Values of the other symbols, more of them than there are decimals to be chosen.

    More, and at later times, where a function of time is made of pieces.
    """
    if not symbols:
        return [{}]
    whole = whole_symbols(form, target) & frozenset(symbols)
    source = PointSource(symbols, whole)
    pieces = any(isinstance(each, sp.Heaviside | sp.Piecewise) for side in (form, target) for each in nodes(side))
    drawn = source.several(max(12 if pieces else 6 if whole else 3, decimals + 2))
    return [_later(point, 1 + i if pieces else 1) for i, point in enumerate(drawn)]


def _later(point: Point, factor: int) -> Point:
    return {symbol: value * factor if symbol.name == "t" else value for symbol, value in point.items()}
