"""Whether a compensator does what is asked of the loop: margins by brentq on |L|, poles by numpy.roots.

With a dead time the roots of Q = D + N e^{−jωT} in the right half plane are counted by how far Q(jω)/(1 + jω)ⁿ turns.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.compare import worst_of
from solver.numeric.evaluation.expressions import evaluate
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.compensators.pid import coefficients_at
from solver.words import Phrase

SAMPLES = 4000
MARGIN = 0.05
"""Degrees by which a margin in rounded numbers may fall short."""

CROSSOVER = 1.001e-3
ROUNDED = 2e-3
"""What rounded numbers may cost of an error or of an error constant, relatively."""

POLES = {"lead": 0.01, "lag": 0.1, "lead_lag": 0.1}
"""How near the poles must be to those asked for, relatively."""

POWERS = {"error": 0, "position_constant": 0, "velocity_constant": 1, "acceleration_constant": 2}

Array = np.ndarray[Any, np.dtype[Any]]


@dataclass(frozen=True)
class CompensatorQuestion:
    """The kind "lead", "lag" or "lead_lag", the plant N/D e^{−delay s}, and what is asked of the loop."""

    kind: str
    method: str
    numerator: Any
    denominator: Any
    variable: Any
    delay: Any
    accuracy: tuple[str, Any] | None
    phase_margin: Any
    crossover: Any
    poles: tuple[Any, ...] | None


@dataclass(frozen=True)
class Numbers:
    """The loop in floats: C = c/d, L = N/D, its dead time; margins at the crossovers."""

    c: Array
    d: Array
    N: Array
    D: Array
    delay: float

    def size(self, omega: float) -> float:
        """|L(jω)|."""
        return float(abs(np.polyval(self.N, 1j * omega) / np.polyval(self.D, 1j * omega)))

    def margin(self, omega: float) -> float:
        """180° + ∠L(jω), in (−180, 180]."""
        value = np.polyval(self.N, 1j * omega) / np.polyval(self.D, 1j * omega) * np.exp(-1j * omega * self.delay)
        return float(np.degrees(np.angle(-value)))


def controller_from(K: Any, T: Any, alpha: Any, s: Any) -> Any:
    """Return K Π (T s + 1)/(α T s + 1); None where the lists do not fit."""
    times, ratios = ([*each] if isinstance(each, list | tuple) else [each] for each in (T, alpha))
    if len(times) != len(ratios):
        return None
    return K * sp.Mul(*((a * s + 1) / (b * a * s + 1) for a, b in zip(times, ratios, strict=True)))


def is_the_crossover(question: CompensatorQuestion, value: Any) -> bool:
    """Whether a frequency is the one asked for, as nearly as that is asked."""
    return bool(abs(_value(value) / _value(question.crossover) - 1) <= CROSSOVER)


def fits_the_sections(question: CompensatorQuestion, value: Any) -> bool:
    """Whether there is one value for each section."""
    return isinstance(value, list | tuple) and len(value) == 2 if question.kind == "lead_lag" else bool(value)


@lru_cache(maxsize=32)
def _numbers(question: CompensatorQuestion, controller: Any) -> Numbers:
    s = question.variable
    above, below = sp.fraction(sp.together(controller))
    if (above.free_symbols | below.free_symbols) - {s} or not (above.is_polynomial(s) and below.is_polynomial(s)):
        raise NotEvaluable("the compensator is no quotient of polynomials with numbers")
    if above == 0:
        raise NotEvaluable("the compensator is zero")
    c, d, N, D = (
        np.real(coefficients_at(sp.expand(p), s, {})) for p in (above, below, question.numerator, question.denominator)
    )
    return Numbers(c, d, np.polymul(c, N), np.polymul(d, D), float(evaluate(question.delay, {}).real))


def crossover_and_margin(loop: Numbers) -> tuple[float, float]:
    """Return the crossover whose margin is smallest, and that margin; infinite where there is none."""
    from scipy.optimize import brentq  # noqa: PLC0415 - 150 ms that most checks do not need

    roots = [abs(r) for p in (loop.N, loop.D) for r in np.roots(p) if abs(r) > 1e-12]
    low, high = min([*roots, 1.0]) * 1e-5, max([*roots, 1.0]) * 1e5
    grid = np.geomspace(low, high, SAMPLES)
    values = np.log([loop.size(w) for w in grid])
    found = [
        float(np.exp(brentq(lambda x: np.log(loop.size(np.exp(x))), np.log(a), np.log(b), xtol=1e-15, rtol=1e-14)))
        for a, b, v, w in zip(grid, grid[1:], values, values[1:], strict=False)
        if v * w < 0
    ]
    if not found:
        return np.inf, np.inf
    best = min(found, key=lambda omega: abs(loop.margin(omega)))
    return best, loop.margin(best)


def is_stable(loop: Numbers) -> bool:
    """Whether all roots of D + N e^{−sT} lie in the left half plane."""
    if not loop.delay:
        return bool(np.max(np.roots(np.polyadd(loop.D, loop.N)).real) < 0)
    n = len(loop.D) - 1
    stop = 1.0
    while np.polyval(np.abs(loop.N), stop) > 0.05 * abs(np.polyval(loop.D, 1j * stop)):
        stop *= 1.5
    grid = np.concatenate([np.geomspace(1e-7, stop, 20000), np.linspace(0, stop, 40000)])
    grid = np.sort(np.concatenate([grid, np.geomspace(stop, 1e6 * stop, 2000)]))
    Q = np.polyval(loop.D, 1j * grid) + np.polyval(loop.N, 1j * grid) * np.exp(-1j * grid * loop.delay)
    turned = np.unwrap(np.angle(Q / (1 + 1j * grid) ** n))
    return bool(round((turned[0] - turned[-1]) / np.pi) == 0)


def faults_of(question: CompensatorQuestion, controller: Any) -> Iterator[tuple[str, str, bool]]:
    """Yield what must hold of a compensator, by what it is checked, and whether it does."""
    try:
        loop = _numbers(question, controller)
    except NotEvaluable:
        yield "the compensator is a quotient of polynomials", "numpy", False
        return
    yield _shape_in_words(question.kind), "numpy.roots", has_the_shape(question.kind, loop)
    yield "the closed loop is stable", "numpy.roots", is_stable(loop)
    if question.accuracy is not None:
        yield "the error is small enough", "numpy.polyval", _is_accurate(question, loop)
    if question.poles is not None:
        yield "the poles asked for are poles of the loop, nearly", "numpy.roots", _has_poles(question, loop)
    if question.phase_margin is None:
        return
    omega, margin = crossover_and_margin(loop)
    yield "the phase margin is large enough", "scipy.optimize.brentq", margin >= _value(question.phase_margin) - MARGIN
    if question.crossover is not None:
        near = abs(omega / _value(question.crossover) - 1) <= CROSSOVER
        yield "the gain crossover is the one asked for", "scipy.optimize.brentq", bool(near)


def _value(x: Any) -> float:
    return float(evaluate(x, {}).real)


def _shape_in_words(kind: str) -> str:
    words = {"lead": "one lead section", "lag": "one lag section", "lead_lag": "a lead and a lag section"}[kind]
    return Phrase("the compensator is {words}", words=words)


def has_the_shape(kind: str, loop: Numbers) -> bool:
    """Whether zeros and poles are those of the sections, all in the left half plane, and the gain is positive."""
    count = 2 if kind == "lead_lag" else 1
    if len(loop.c) != count + 1 or len(loop.d) != count + 1 or loop.c[-1] / loop.d[-1] <= 0:
        return False
    zeros, poles = np.sort(np.roots(loop.c)), np.sort(np.roots(loop.d))
    if np.iscomplexobj(zeros) or np.iscomplexobj(poles) or zeros[-1] >= 0 or poles[-1] >= 0:
        return False
    if kind == "lead":
        return bool(poles[0] < zeros[0])
    if kind == "lag":
        return bool(zeros[0] < poles[0])
    return bool(poles[0] < zeros[0] and zeros[1] < poles[1])


def _constant(p: Array) -> tuple[float, int]:
    """The lowest coefficient that is not zero, and its power."""
    power = next((i for i, c in enumerate(p[::-1]) if abs(c) > 1e-13 * np.max(np.abs(p))), None)
    if power is None:
        raise NotEvaluable("the loop passes nothing")
    return float(p[::-1][power]), power


def _limit(N: Array, D: Array, power: int) -> float:
    """The limit of s^power N/D for s → 0."""
    (a, i), (b, j) = _constant(N), _constant(D)
    order = i - j + power
    return 0.0 if order > 0 else a / b if order == 0 else np.inf * np.sign(a / b)


def _is_accurate(question: CompensatorQuestion, loop: Numbers) -> bool:
    assert question.accuracy is not None  # noqa: S101 - the caller has seen to it
    name, value = question.accuracy
    limit = _limit(loop.N, loop.D, POWERS[name])
    if name == "error":
        return bool(abs(1 / (1 + limit)) <= _value(value) * (1 + ROUNDED))
    return bool(limit >= _value(value) * (1 - ROUNDED))


def _has_poles(question: CompensatorQuestion, loop: Numbers) -> bool:
    roots = np.roots(np.polyadd(loop.D, loop.N))
    near = POLES[question.kind]
    wanted = [evaluate(pole, {}) for pole in question.poles or ()]
    return all(np.min(np.abs(roots - pole)) <= near * abs(pole) for pole in wanted)


def least_gain_residual(question: CompensatorQuestion, value: Any) -> float:
    """Return the relative difference to the least gain for the error or the constant."""
    assert question.accuracy is not None  # noqa: S101 - the caller has seen to it
    name, asked = question.accuracy
    N, D = (np.real(coefficients_at(p, question.variable, {})) for p in (question.numerator, question.denominator))
    limit = _limit(N, D, POWERS[name])
    if not np.isfinite(limit) or limit == 0:
        raise NotEvaluable("every gain meets the specification of the error, or none does")
    wanted = (1 / _value(asked) - 1 if name == "error" else _value(asked)) / limit
    return abs(_value(value) - wanted) / abs(wanted)


def compensator_residual(question: CompensatorQuestion, controller: Any, name: str, value: Any) -> float:
    """Return the relative difference of an answer from what it is of the compensator."""
    loop = _numbers(question, controller)
    if name in ("T", "alpha"):
        return _sections_residual(loop, name, value)
    if name == "K":
        expected = float(loop.c[-1] / loop.d[-1])
    elif name == "error":
        expected = 1 / (1 + _limit(loop.N, loop.D, 0))
    else:
        omega, margin = crossover_and_margin(loop)
        expected = omega if name == "gain_crossover" else margin
    if not np.isfinite(expected):
        return 0.0 if value == sp.oo else np.inf
    if value == sp.oo:
        return np.inf
    return abs(_value(value) - expected) / max(abs(expected), 1e-9)


def _sections_residual(loop: Numbers, name: str, value: Any) -> float:
    """Of lead sections T is that of a zero, α T that of a pole; the zeros of a list, lead first, by their size."""
    values = [_value(each) for each in value] if isinstance(value, list | tuple) else [_value(value)]
    zeros, poles = (np.sort(-1 / np.real(np.roots(p))) for p in (loop.c, loop.d))
    expected = zeros if name == "T" else poles / zeros
    if len(values) != len(expected):
        return np.inf
    return worst_of([abs(a - b) / abs(b) for a, b in zip(values, expected, strict=True)])
