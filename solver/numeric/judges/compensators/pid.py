"""The gains of PID controllers in numbers: tables of Ziegler and Nichols, loops at their stability limit, placed poles.

The limit of stability by numpy.roots and bisection, the steepest tangent by scipy.linalg.expm and brentq.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from solver.numeric.evaluation.compare import worst_of
from solver.numeric.evaluation.expressions import evaluate
from solver.numeric.evaluation.points import PointSource, free_symbols
from solver.numeric.evaluation.values import NotEvaluable

SAMPLES = 6000
LONGEST = 45.0
"""In units of the slowest time constant: later nothing is steep any more."""

AT = (0.37 + 1.1j, 2.3 - 0.4j, -0.9 + 0.2j)
"""Values of s at which controllers are compared."""

LIMIT = 1e-6
"""Relative distance from the limit of stability at which roots are counted."""

Values = dict[str, float]
Array = np.ndarray[Any, np.dtype[Any]]


@dataclass(frozen=True)
class PidQuestion:
    """What is asked: the method, the kind "P", "PI" or "PID", a plant N/D e^{−delay s} (or the tangent), poles."""

    method: str
    kind: str
    numerator: Any = None
    denominator: Any = None
    variable: Any = None
    delay: Any = 0
    slope: Any = None
    dead_time: Any = None
    poles: Sequence[Any] = ()

    @property
    def formulas(self) -> list[Any]:
        """Everything given that may hold parameters."""
        given = (self.numerator, self.denominator, self.delay, self.slope, self.dead_time, *self.poles)
        return [each for each in given if each is not None]


def pid_residual(question: PidQuestion, name: str, value: Any) -> float:
    """Return the relative error of an answer, at random values of the parameters where there are some."""
    symbols = free_symbols(question.formulas) - {question.variable}
    source = PointSource(symbols)
    worst = 0.0
    for _ in range(3 if symbols else 1):
        point = source.draw() if symbols else {}
        expected = _expected(question, point)
        if name == "controller":
            for s in AT:
                own = evaluate(value, {**point, question.variable: s})
                other = expected["K_p"] + expected["K_i"] / s + expected["K_d"] * s
                worst = worst_of((worst, abs(own - other) / abs(other)))
            continue
        if name not in expected:
            raise NotEvaluable("the method does not give this answer")
        size = max(abs(expected[name]), 1e-12)
        worst = worst_of((worst, abs(evaluate(value, point) - expected[name]) / size))
    return worst


def _expected(question: PidQuestion, point: Mapping[Any, complex]) -> Mapping[str, Any]:
    if question.method == "pole_placement":
        return _placed(question, point)
    if question.method == "ziegler_nichols_ultimate":
        delay = evaluate(question.delay, point).real
        K, omega = ultimate_in_numbers(*_plant(question, point), delay)
        T = 2 * np.pi / omega
        rows = {"P": (K / 2, 0, 0), "PI": (0.45 * K, T / 1.2, 0), "PID": (0.6 * K, T / 2, T / 8)}
        return {"K_u": K, "T_u": T, **_gains(*rows[question.kind])}
    if question.slope is not None:
        R, L = (evaluate(each, point) for each in (question.slope, question.dead_time))
    else:
        R, L = tangent_in_numbers(*_plant(question, point))
        L += evaluate(question.delay, point).real
    rows = {"P": (1 / R / L, 0, 0), "PI": (0.9 / R / L, L / 0.3, 0), "PID": (1.2 / R / L, 2 * L, L / 2)}
    return _gains(*rows[question.kind])


def _gains(K: Any, T_i: Any, T_d: Any) -> dict[str, Any]:
    return {"K_p": K, "K_i": K / T_i if T_i else 0.0, "K_d": K * T_d}


def _plant(question: PidQuestion, point: Mapping[Any, complex]) -> tuple[Array, Array]:
    return tuple(  # type: ignore[return-value]  # two
        coefficients_at(p, question.variable, point) for p in (question.numerator, question.denominator)
    )


def coefficients_at(p: Any, s: Any, point: Mapping[Any, complex]) -> Array:
    """Return the coefficients of a polynomial in s, highest first, by its values on the unit circle."""
    degree = int(p.as_poly(s).degree()) if p.has(s) else 0
    nodes = np.exp(2j * np.pi * np.arange(degree + 1) / (degree + 1))
    values = [evaluate(p, {**point, s: complex(z)}, tolerance=1e-15) for z in nodes]
    found = np.fft.fft(values) / (degree + 1)
    size = np.max(np.abs(found))
    return np.where(np.abs(found) < 1e-14 * size, 0, found)[::-1]


def ultimate_in_numbers(N: Array, D: Array, delay: float = 0.0) -> tuple[float, float]:
    """Return the least K > 0 at which D + K N stops being stable by a pair ±jω, and ω. Raises NotEvaluable."""
    N, D = np.real(N), np.real(D)
    if delay:
        return _first_crossing(N, D, delay)
    for omega in _real_on_the_axis(N, D):
        K = float((-np.polyval(D, 1j * omega) / np.polyval(N, 1j * omega)).real)
        if K > 0 and _excess(N, D, K * (1 - LIMIT)) < 0 < _excess(N, D, K * (1 + LIMIT)):
            return K, omega
    raise NotEvaluable("no gain was found at which the loop begins to oscillate")


def _real_on_the_axis(N: Array, D: Array) -> list[float]:
    """The ω > 0 at which D/N is real, by rising gain."""
    product = np.polymul(_turned(D), np.conj(_turned(N)))
    roots = np.roots(np.trim_zeros(product.imag, "f"))
    found = [float(r.real) for r in roots if abs(r.imag) < 1e-7 * max(1.0, abs(r)) and r.real > 1e-9]
    polished = [_polished(product.imag, omega) for omega in found]
    return sorted(polished, key=lambda omega: abs(np.polyval(D, 1j * omega) / np.polyval(N, 1j * omega)))


def _first_crossing(N: Array, D: Array, delay: float) -> tuple[float, float]:
    """Of the ω with K N/D e^{−jωT} = −1 for some K > 0 that with the least K, for a loop that is stable at first."""
    from scipy.optimize import brentq  # noqa: PLC0415 - 150 ms that most checks do not need

    def value(omega: float) -> complex:
        return complex(np.polyval(N, 1j * omega) / np.polyval(D, 1j * omega) * np.exp(-1j * omega * delay))

    sizes = [abs(r) for p in (N, D) for r in np.roots(p)] + [1 / delay]
    grid = np.concatenate([np.geomspace(1e-4, 1, 2000), np.linspace(1, 30, 6000)[1:]]) * max(sizes)
    parts = [value(float(omega)) for omega in grid]
    found = [
        float(brentq(lambda x: value(x).imag, a, b, xtol=1e-15, rtol=1e-14))
        for a, b, u, v in zip(grid, grid[1:], parts, parts[1:], strict=False)
        if u.imag * v.imag < 0 and u.real < 0 and v.real < 0
    ]
    if not found:
        raise NotEvaluable("no gain was found at which the loop begins to oscillate")
    best = max(found, key=lambda omega: abs(value(omega)))
    return 1 / abs(value(best)), best


def _turned(p: Array) -> Array:
    """p(jω) as a polynomial in ω."""
    return np.array([c * 1j ** (len(p) - 1 - i) for i, c in enumerate(p)])


def _polished(p: Array, x: float) -> float:
    slope = np.polyder(p)
    for _ in range(4):
        step = np.polyval(p, x) / (np.polyval(slope, x) or 1.0)
        x = float(x - step) if abs(step) < 1e-3 * abs(x) else x
    return x


def _excess(N: Array, D: Array, K: float) -> float:
    return float(np.max(np.roots(np.polyadd(D, K * N)).real))


def tangent_in_numbers(N: Array, D: Array) -> tuple[float, float]:
    """Return the largest slope of the step response of N/D, and where its tangent meets the time axis."""
    from scipy.linalg import expm  # noqa: PLC0415 - 150 ms that most checks do not need
    from scipy.optimize import brentq  # noqa: PLC0415

    N, D = np.real(N) / np.real(D[0]), np.real(D) / np.real(D[0])
    n = len(D) - 1
    A = np.zeros((n + 1, n + 1))
    A[:n, :n] = np.eye(n, k=1)
    A[n - 1, :n] = -D[:0:-1]
    A[n, : len(N)] = N[::-1]  # the last state is the step response
    b = np.zeros(n + 1)
    b[n - 1] = 1.0
    c = A[n]
    rates = [-r.real for r in np.roots(D) if r.real < -1e-9]
    times = np.linspace(0.0, LONGEST / min(rates), SAMPLES + 1)
    step, states = expm(A * times[1]), [b]
    for _ in range(SAMPLES):
        states.append(step @ states[-1])
    slopes = np.array([c @ A @ z for z in states])  # of the slope
    best = int(np.argmax([abs(c @ z) for z in states]))
    if best >= SAMPLES - 1 or abs(c @ states[best]) <= abs(c @ states[-1]) * (1 + 1e-9) > 0:
        z = states[-1]
        return float(c @ z), float(times[-1] - z[n] / (c @ z))
    at = lambda t: float(c @ A @ expm(A * t) @ b)  # noqa: E731 - the derivative of the slope
    low, high = times[max(best - 1, 0)], times[best + 1]
    time = 0.0 if best == 0 and slopes[0] * slopes[1] > 0 else brentq(at, low, high, xtol=1e-14, rtol=1e-14)
    z = expm(A * time) @ b
    return float(c @ z), float(time - z[n] / (c @ z))


def _placed(question: PidQuestion, point: Mapping[Any, complex]) -> dict[str, Any]:
    """The gains by least squares; raises NotEvaluable where none fit."""
    N, D = _plant(question, point)
    poles = [evaluate(pole, point) for pole in question.poles]
    wanted, names = np.poly(poles), {"P": ("K_p",), "PI": ("K_p", "K_i"), "PID": ("K_p", "K_i", "K_d")}[question.kind]
    s = np.array([1.0, 0.0])
    own = D if question.kind == "P" else np.polymul(D, s)
    factors = {"K_i": np.array([1.0]), "K_p": s, "K_d": np.array([1.0, 0.0, 0.0])}
    columns = [np.polymul(N, np.array([1.0]) if question.kind == "P" else factors[name]) for name in names]
    length = len(wanted)

    def filled(p: Array) -> Array:
        return np.concatenate([np.zeros(length - len(p)), p])

    base, matrix = filled(own), np.array([filled(column) for column in columns]).T
    rows = matrix - np.outer(wanted, matrix[0])  # the leading coefficient is the loop's own
    right = wanted * base[0] - base
    gains, _, rank, _ = np.linalg.lstsq(rows, right, rcond=None)
    if rank < len(names) or np.max(np.abs(rows @ gains - right)) > 1e-8 * max(1.0, float(np.max(np.abs(right)))):
        raise NotEvaluable("the poles do not fix the gains")
    return {"K_p": 0.0, "K_i": 0.0, "K_d": 0.0, **dict(zip(names, gains, strict=True))}
