"""Extremals found directly: polynomials for which the functional is stationary, by Newton's method.

Neither Euler's nor Lagrange's equations are written down: the parameters of the polynomials, and a free end time, make
the Lagrangian of the functional and of all that is asked stationary (Ritz).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

import numpy as np
from numpy.polynomial import Legendre

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.values import NotEvaluable, Undefined
from solver.numeric.judges.variations.problem import Along, Function, Problem, given_motions, points_of
from solver.numeric.judges.variations.varied import Varied

DEGREE = 15
ITERATIONS, ARRIVED, NEARLY = 40, 1e-10, 1e-7
ENDS = (1.0, 0.4, 2.5)
"""Where a free end is looked for first."""


def motions(problem: Problem, x: Mapping[str, Any] | None, t_f: Any = None) -> Iterator[Along]:
    """Yield the functions at some points of the parameters; where there are none, the extremals found directly.

    Where only the end time is missing, it is the one of the extremal. Raises NotEvaluable where nothing is found.
    """
    if x is not None and (t_f is not None or problem.stop is not None):
        yield from given_motions(problem, x, t_f)
        return
    for point, first, last in points_of(problem, x or {}, problem.stop):
        found = extremal(problem, point, first, last)
        if found is None:
            continue
        if x is None:
            yield found
            continue
        yield from given_motions(problem, x, found.stop)


def worst(problem: Problem, x: Mapping[str, Any] | None, t_f: Any, judge: Callable[[Along], float]) -> float:
    """Return the largest residual at some points of the parameters; infinite where a function or a value is missing."""
    if x is not None and not {*problem.functions} <= {*x}:
        return np.inf
    found = []
    for along in motions(problem, x, t_f):
        try:
            residual = float(judge(along))
        except (KeyError, np.linalg.LinAlgError, Undefined):
            residual = np.inf
        found.append(residual if np.isfinite(residual) else np.inf)
    if not found:
        raise NotEvaluable("no extremal was found by numbers")
    return max(found)


def extremal(problem: Problem, point: Mapping[Any, complex], first: float, last: float) -> Along | None:
    """Return the extremal at a point of the parameters; None where Newton's method does not arrive."""
    for after in ENDS if np.isnan(last) else (last - first,):
        along = Along(problem, _start(problem, point, first, first + after), point, first, first + after)
        try:
            found = _newton(along)
        except (Undefined, np.linalg.LinAlgError):
            continue
        if found is not None:
            return found
    return None


def _start(problem: Problem, point: Mapping[Any, complex], first: float, last: float) -> dict[str, Function]:
    """Straight lines between the values at the ends; 1 where nothing is asked."""
    found: dict[str, Function] = {}
    empty = Along(problem, {}, point, first, last)
    for name in problem.functions:
        ends = [problem.end((name, 0), each) for each in (0, 1)]
        values = [
            None
            if end.free
            else empty.at_times(end.value if end.curve is None else end.curve, np.array([time]))[0].real
            for end, time in zip(ends, (first, last), strict=True)
        ]
        known = [value for value in values if value is not None] or [1.0]
        begin, end = (known[0] if values[0] is None else values[0]), (known[-1] if values[1] is None else values[1])
        found[name] = Legendre([(begin + end) / 2, (end - begin) / 2], domain=[first, last])
    return found


def _newton(along: Along) -> Along | None:
    distance = np.inf
    for _ in range(ITERATIONS):
        step = _step(Varied(along, DEGREE))
        along = _moved(along, step)
        before, distance = distance, float(np.linalg.norm(step))
        if distance < ARRIVED or (distance < NEARLY and distance >= before):
            return along
        if not np.isfinite(distance) or along.span <= 0:
            return None
    return None


def _step(varied: Varied) -> Array:
    """What Newton's method adds to the parameters, so that the Lagrangian becomes stationary."""
    slope, rows = varied.gradient(varied.functional), varied.gradient(varied.equations)
    missed = np.real(varied.equations(np.zeros((1, varied.size)))[0])
    count = len(missed)
    rows = rows.reshape(varied.size, count)
    weights = -np.linalg.lstsq(rows, slope, rcond=1e-12)[0] if count else np.zeros(0)
    H = varied.of_lagrangian(weights)
    M = np.block([[H, rows], [rows.T, np.zeros((count, count))]])
    left = np.concatenate([slope + rows @ weights, missed])
    step: Array = np.linalg.lstsq(M, -left, rcond=1e-13)[0][: varied.size]
    return step


def _moved(along: Along, step: Array) -> Along:
    """The motion with these parameters added, over the new time."""
    problem, polynomials = along.problem, Varied(along, DEGREE).polynomials
    stop = along.stop + (float(step[-1]) if problem.stop is None else 0.0)
    found: dict[str, Function] = {}
    for number, name in enumerate(problem.functions):
        own: Any = along.x[name]
        added = sum(a * p for a, p in zip(step[number * (DEGREE + 1) :], polynomials, strict=False))
        found[name] = Legendre(own.coef, domain=[along.start, stop]) + Legendre(added.coef, domain=[along.start, stop])
    return Along(problem, found, along.point, along.start, stop)
