"""Legendre's condition and Jacobi's equation in numbers, along an extremal.

The second variation is ∫ uᵀP u + 2 uᵀQ u' + u'ᵀR u' dt; with v = R u' + Qᵀu Jacobi's equation is v' = P u + Q u'. Its
coefficients are interpolated by polynomials of Chebyshev, one stretch of time after another.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.values import Undefined
from solver.numeric.judges.variations.direct import worst
from solver.numeric.judges.variations.problem import Along, Jet, Problem, is_known, numbers

TIMES = 9
DEGREE = 30
STRETCHES = 12
"""How many times the time from start to end is looked at for a conjugate point where none is told."""
BEYOND = 1.02
"""How far beyond a point that is told it is looked, relative to its distance."""


def legendre_residual(problem: Problem, x: Mapping[str, Any] | None, found: Any, t_f: Any = None) -> float:
    """Return how far second derivatives by the highest derivatives (a matrix for several functions) are from `found`.

    Relative to the largest of them, at several times.
    """
    highest = [(name, problem.orders[name]) for name in problem.functions]
    n, shape = len(highest), getattr(found, "shape", (1, 1))
    if shape != (n, n):
        return np.inf

    def judge(along: Along) -> float:
        if not is_known(found, along):
            return np.inf
        times = along.inner(TIMES)
        wanted = _matrices(along, highest, highest, times)
        entries = list(found.flat()) if n > 1 or hasattr(found, "shape") else [found]
        told = np.array([along.at_times(entry, times) for entry in entries]).T.reshape(-1, n, n)
        return float(np.max(np.abs(told - wanted)) / max(float(np.max(np.abs(wanted))), 1e-9))

    return worst(problem, x, t_f, judge)


def conjugate_residual(problem: Problem, x: Mapping[str, Any] | None, point: Any, t_f: Any = None) -> float:
    """Return the distance of a point from the first one conjugate to the start, relative to the distance from there.

    None as the point says that there is none: 0 where none is found in a long time, else infinite.
    """

    def judge(along: Along) -> float:
        if point is None:
            return 0.0 if first_conjugate(along, along.start + STRETCHES * along.span) is None else np.inf
        told = numbers(point, along.point, 1)[0] if is_known(point, along) else 1j
        if abs(told.imag) > 1e-9 or told.real <= along.start:
            return np.inf
        found = first_conjugate(along, along.start + BEYOND * (told.real - along.start))
        return np.inf if found is None else abs(found - told.real) / (told.real - along.start)

    return worst(problem, x, t_f, judge)


def first_conjugate(along: Along, until: float) -> float | None:
    """Return the first zero after the start of det U, U a matrix of solutions with U = 0, U' = I at the start."""
    names = along.problem.functions
    n, begin = len(names), along.start
    U, V = np.zeros((n, n)), _matrices(along, _jets(names, 1), _jets(names, 1), np.array([begin]))[0].real
    sign = np.sign(np.linalg.det(V))
    while begin < until - 1e-12 * (1 + abs(until)):
        end = min(begin + along.span, until)
        try:
            motion = solve_ivp(_jacobi(along, begin, end), (begin, end), np.concatenate([U.ravel(), V.ravel()]),
                               rtol=1e-11, atol=1e-13, dense_output=True, method="DOP853")  # fmt: skip
        except Undefined:
            return None
        if not motion.success:
            return None

        def determinant(time: float, motion: Any = motion) -> float:
            return float(np.linalg.det(motion.sol(time)[: n * n].reshape(n, n)))

        times = np.linspace(begin, end, 400)
        if begin == along.start:
            times = times[1:]
        values = np.array([determinant(time) for time in times])
        for i in range(len(times) - 1):
            if values[i] * values[i + 1] <= 0:
                return float(brentq(determinant, times[i], times[i + 1], xtol=1e-13, rtol=1e-13))
        U, V = (part.reshape(n, n) for part in np.split(motion.y[:, -1], 2))
        begin = end
    return None if sign else begin


def _jets(names: Sequence[str], order: int) -> list[Jet]:
    return [(name, order) for name in names]


def _matrices(along: Along, rows: Sequence[Jet], columns: Sequence[Jet], times: Array) -> Array:
    """The second derivatives of the integrand by these at some times (times × rows × columns)."""
    found = np.zeros((len(times), len(rows), len(columns)), dtype=complex)
    for i, one in enumerate(rows):
        for j, other in enumerate(columns):
            found[:, i, j] = along.second_partial(along.problem.integrand, one, other, times.astype(complex))
    return found


def _jacobi(along: Along, begin: float, end: float) -> Any:
    """The right side of Jacobi's equation for U and V, on a stretch of time."""
    names = along.problem.functions
    n = len(names)
    places = np.cos(np.pi * (np.arange(DEGREE + 1) + 0.5) / (DEGREE + 1))
    times = begin + (end - begin) * (places + 1) / 2
    parts = [_matrices(along, _jets(names, a), _jets(names, b), times).real for a, b in ((0, 0), (0, 1), (1, 1))]
    fits = [np.polynomial.chebyshev.chebfit(places, part.reshape(len(times), -1), DEGREE) for part in parts]

    def right(time: float, state: Array) -> Array:
        place = 2 * (time - begin) / (end - begin) - 1
        P, Q, R = (np.polynomial.chebyshev.chebval(place, fit).reshape(n, n) for fit in fits)
        U, V = (part.reshape(n, n) for part in np.split(state, 2))
        slope = np.linalg.solve(R, V - Q.T @ U)
        return np.concatenate([slope.ravel(), (P @ U + Q @ slope).ravel()])

    return right
