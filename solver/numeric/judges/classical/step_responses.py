"""Step responses judged: the response by matrix exponentials, searched in samples and refined with 50 digits."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, lru_cache
from math import ceil
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.compare import with_many_digits, worst_of
from solver.numeric.judges.classical.poles import eigenvalues
from solver.numeric.judges.classical.sampled_responses import sampled_specification
from solver.numeric.judges.representation.minimal import MANY, minimal_part, numbers_at, points_of, quadruple_at

LATEST = 30.0
"""In units of a time constant: later than that its mode has died out."""
LEAST, MOST, EACH_TURN = 3000, 400_000, 40
"""Samples for a horizon, at least and at most, and for a turn of an oscillation."""
WRONG = float("inf")
ROUNDING = 1e-9


@dataclass(frozen=True)
class StepResponse:
    """Y after a unit step as y_f (1 + e): e = C e^{At} z with z the start less the state at rest, over y_f."""

    A: Array
    C: Array
    z: Array
    final: Any

    @cached_property
    def samples(self) -> tuple[Array, Array]:
        """Times and e there, relative to the size of what it is made of, for each mode's horizon."""
        A = np.array(self.A.tolist(), dtype=complex).real.astype(float)
        C, z = (np.array(M.tolist(), dtype=complex).real.astype(float) for M in (self.C, self.z))
        times, values = [np.zeros(0)], [np.zeros(0)]
        for mode in np.linalg.eigvals(A):
            horizon = LATEST / -mode.real
            turns = horizon * max(abs(np.linalg.eigvals(A).imag)) / (2 * np.pi)
            count = int(min(MOST, max(LEAST, EACH_TURN * turns)))
            found = _powers(A * (horizon / count), z, count)
            size = np.linalg.norm(found, axis=0) * np.linalg.norm(C) + 1e-300
            e = (C @ found).reshape(-1)
            times.append(np.arange(count) * (horizon / count))
            values.append(np.where(abs(e) > ROUNDING * 1e-3 * size, e, 0.0))
        order = np.argsort(np.concatenate(times), kind="stable")
        return np.concatenate(times)[order], np.concatenate(values)[order]

    def away(self, t: Any, slope: int = 0) -> Any:
        """E, or a derivative, with 50 digits."""
        m = MANY.context
        z = m.expm(m.matrix(self.A.tolist()) * m.mpf(t)) * m.matrix(self.z.tolist())
        for _ in range(slope):
            z = m.matrix(self.A.tolist()) * z
        return m.re((m.matrix(self.C.tolist()) * z)[0])

    @cached_property
    def peak(self) -> tuple[Any, Any] | None:
        """The time and the height of the largest value above the final one."""
        times, e = self.samples
        best = int(np.argmax(e))
        if e[best] <= 0:
            return None
        if times[best] == 0:
            return MANY.context.mpf(0), self.away(0)
        near = len(self.A) + 1  # samples of two modes can be as good as at one place, but not so many
        before, after = times[times < times[best]][: -near - 1 : -1], times[times > times[best]][:near]
        low = next((float(t) for t in before if self.away(t, 1) > 0), None)
        if low is None:  # it falls from the start
            return MANY.context.mpf(0), self.away(0)
        high = next((float(t) for t in after if self.away(t, 1) < 0), float(after[-1]))
        time = _bracketed(lambda t: self.away(t, 1), low, high)
        return time, self.away(time)


def _powers(A: Array, z: Array, count: int) -> Array:
    """The columns e^{Ak} z for k = 0, 1, …, by doubling."""
    from scipy.linalg import expm  # noqa: PLC0415 - only where a response is judged

    found, step = z.reshape(-1, 1), expm(A)
    for _ in range(ceil(np.log2(max(2, count)))):
        found = np.hstack([found, step @ found])
        step = step @ step
    return found[:, :count]


def step_response(plant: Any) -> StepResponse | None:
    """Return the response of a system of numbers; None where it does not settle, at zero, or has no state."""
    return _response_of(tuple(M.as_immutable() for M in plant))


@lru_cache(maxsize=8)
def _response_of(plant: Any) -> StepResponse | None:
    A, B, C, D = quadruple_at(plant, {})
    A, B, C = minimal_part(A, B, C)
    m = MANY.context
    if not len(A):
        return None
    if any(m.re(p) >= 0 for p in eigenvalues(A)):
        return None
    rest = np.array((-m.lu_solve(m.matrix(A.tolist()), m.matrix(B.tolist()))).tolist(), dtype=object).reshape(-1, 1)
    final = (C @ rest).reshape(-1)[0] + D.reshape(-1)[0]
    return StepResponse(A, C / final, -rest, m.re(final)) if abs(final) > 1e-30 else None


@dataclass(frozen=True)
class Specification:
    """What a step response is judged by: the delay, the band, whether the rise is asked for from 0 to 100 %.

    `formula` asks for c/(ζω_n) as settling time, of a system of second order; then it is c. `period` is that of a
    discrete system, 1 where times are counted in samples.
    """

    delay: Any
    band: Any
    whole: bool
    formula: int | None = None
    period: Any = None


def specification_residual(plant: Any, asked: Specification, name: str, answer: Any) -> float:
    """Return the largest relative difference of an answer and what the response shows, at values of the parameters."""
    worst = 0.0
    for found in points_of(*plant, answer, asked.delay, asked.period or sp.Integer(1)):
        point = {x: sp.Rational(complex(value).real) for x, value in dict(found).items()}
        at = tuple(M.xreplace(point) for M in plant)
        values = [each.xreplace(point) for each in (answer, asked.delay, asked.band)]
        value, delay, band = (MANY.context.re(each) for each in numbers_at(values, {}))
        right = specified(at, asked, name, band)
        if right is None:
            return WRONG
        if asked.period is not None and name.endswith("_time"):
            right *= MANY.context.re(numbers_at([asked.period.xreplace(point)], {})[0])
        right += delay if name in ("peak_time", "settling_time") else 0
        size = max(abs(right), abs(value), MANY.context.mpf("1e-12"))
        worst = worst_of((worst, float(abs(right - value) / size)))
    return with_many_digits(worst, answer)


def specified(plant: Any, asked: Specification, name: str, band: Any) -> Any:
    """Return a quantity of the response, without its delay; None where there is none."""
    m = MANY.context
    if asked.period is not None:
        return sampled_specification(plant, name, band, whole=asked.whole)
    found = step_response(plant)
    if found is None:
        return _static(plant, name)
    if name == "final_value":
        return found.final
    if name == "settling_time":
        return _decay(found, asked.formula) if asked.formula else _settling(found, band)
    peak = found.peak
    if name in ("overshoot", "peak_time"):
        return (m.mpf(0) if name == "overshoot" else None) if peak is None else peak[name == "overshoot"]
    reached = peak is not None or _crosses(found)
    levels = (None, m.mpf(0)) if asked.whole and reached else (m.mpf(-9) / 10, m.mpf(-1) / 10)
    begins, ends = (_first(found, level) if level is not None else m.mpf(0) for level in levels)
    return ends - begins


def _static(plant: Any, name: str) -> Any:
    """Of a constant: its value, reached at once."""
    A, B, C, D = quadruple_at(plant, {})
    if len(minimal_part(A, B, C)[0]):
        return None
    values = {"final_value": MANY.context.re(D.reshape(-1)[0]), "peak_time": None}
    return values.get(name, MANY.context.mpf(0))


def _decay(found: StepResponse, c: int) -> Any:
    m = MANY.context
    rates = [-m.re(p) for p in eigenvalues(found.A)]
    return c / (sum(rates) / len(rates))


def _crosses(found: StepResponse) -> bool:
    return bool(np.any(found.samples[1] > 0)) or bool(found.away(0) >= 0)


def _first(found: StepResponse, level: Any) -> Any:
    """When e is first at a level."""
    times, e = found.samples
    above = np.nonzero(e >= float(level))[0] if level else np.nonzero(e > 0)[0]
    if not len(above) or times[above[0]] == 0:
        return MANY.context.mpf(0)
    before = times[times < times[above[0]]]
    return _bracketed(lambda t: found.away(t) - level, float(before[-1]), float(times[above[0]]))


def _settling(found: StepResponse, band: Any) -> Any:
    """When |e| is at the edge of the band last."""
    times, e = found.samples
    outside = np.nonzero(abs(e) > float(band))[0]
    if not len(outside):
        return MANY.context.mpf(0)
    last = int(outside[-1])
    edge, after = (band if e[last] > 0 else -band), times[times > times[last]]
    return _bracketed(lambda t: found.away(t) - edge, float(times[last]), float(after[0]))


def _bracketed(f: Callable[[Any], Any], low: float, high: float) -> Any:
    """The zero between two places where f has different signs."""
    m = MANY.context
    try:
        return m.findroot(f, (m.mpf(low), m.mpf(high)), solver="anderson", tol=m.mpf("1e-60"), maxsteps=30)
    except ValueError:
        return m.findroot(f, (m.mpf(low), m.mpf(high)), solver="ridder", tol=m.mpf("1e-40"), verify=False)


def undershoot_residual(plant: Any, time: Any, share: Any) -> float:
    """Return how far y at a time is from a share of the final value, and that from being the lowest of all."""
    found = step_response(plant)
    if found is None:
        return WRONG
    at, height = (MANY.context.re(each) for each in numbers_at([time, share], {}))
    lowest = max(0.0, float(height) - 1 - float(np.min(found.samples[1])))
    return max(float(abs(1 + found.away(at) - height)), lowest)


def largest_size_residual(plant: Any, time: Any, value: Any) -> float:
    """Return how far a value is from that of a step response at a time, and from the largest size of all samples."""
    m = MANY.context
    A, B, C, D = quadruple_at(plant, {})
    A, B, C = minimal_part(A, B, C)
    if not len(A):
        return float(abs(D.reshape(-1)[0] - numbers_at([value], {})[0]))
    rest = np.array((-m.lu_solve(m.matrix(A.tolist()), m.matrix(B.tolist()))).tolist(), dtype=object).reshape(-1, 1)
    final = m.re((C @ rest).reshape(-1)[0] + D.reshape(-1)[0])
    found, height = StepResponse(A, C, -rest, final), m.re(numbers_at([value], {})[0])
    largest = max(float(abs(final)), float(np.max(abs(float(final) + found.samples[1]))))
    infinite = time in (sp.oo, -sp.oo)
    at = final if infinite else final + found.away(m.re(numbers_at([time], {})[0]))
    size = max(abs(height), m.mpf("1e-30"))
    return max(float(abs(at - height) / size), 0.0, largest / float(size) - 1 - ROUNDING)


def largest_sampled_difference(plant: Any, modes: Any) -> float | None:
    """Return the largest size of a step response less modes c t^{j−1}/(j−1)! e^{λt}; None where it does not settle."""
    found = step_response(plant)
    if found is None or any(j > 1 for _, j, _ in modes):
        return None
    times, e = found.samples
    other = np.sum([complex(c) * np.exp(complex(m) * times) for m, _, c in modes], axis=0)
    return float(np.max(abs(float(found.final) * (1 + e) - np.real(other))))
