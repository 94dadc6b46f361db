"""Usual mistakes with the specifications of a step response."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks.classical.paths import path_of, quietly
from solver.tasks.classical.step_formulas import BANDS

if TYPE_CHECKING:
    from solver.derivation import Task

BAND = Slip("band", "the settling time is that of another band: $4/(\\sym{damping_ratio}\\,\\omega_n)$ belongs to 2 %, "
            "$3/(\\sym{damping_ratio}\\,\\omega_n)$ to 5 %")  # fmt: skip
FORMULA = Slip("formula", "it is what the formula of second order estimates; the response itself enters the band "
               "for good at another time")  # fmt: skip
FREQUENCY = Slip(
    "frequency", "it is found with $\\omega_n$; the response oscillates with the damped frequency $\\omega_d$"
)
HALF = Slip("coefficient", "the damping ratio is taken from the wrong coefficient: that of $s$ is "
            "$2\\,\\sym{damping_ratio}\\,\\omega_n$")  # fmt: skip
PEAK = Slip(
    "peak_value",
    "it is the value at the peak; the overshoot is what it is above the final value, as a fraction of that",
)
PERIOD = Slip("period", "it is the whole period $2\\pi/\\omega_d$; the peak comes after half of it")
HERTZ = Slip("hertz", "a frequency in Hz is taken for one in rad/s")
ONE_POLE = Slip(
    "final_gain", "it is the gain before the fraction; the final value is $G(0)$, of a discrete system $G(1)$"
)
COUNTED = Slip("counted", "it is a number of samples; the time is that many sampling periods")
LAST_OUTSIDE = Slip("last_outside", "it is the last sample outside the band; the next one is settled")
AT_ZERO = Slip("at_zero", "it is $G$ at $z = 0$, the first sample; the final value is $G(1)$")


def register(task: Task[Any, Any]) -> None:
    """Register what goes wrong; by the formulas of second order, whatever the method."""
    _with_formulas(task)
    _with_values(task)
    _at_samples(task)


def _with_formulas(task: Task[Any, Any]) -> None:
    """Other formulas than the right ones."""

    def other_band(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        found = _damping(wrong)
        if found is not None:
            own = BANDS[wrong.given.options.settling_band]
            yield from (c / (found.twice / 2) for c in (3, 4, 5) if c != own)

    def estimated(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        found = _damping(wrong)
        if found is not None:
            yield BANDS[wrong.given.options.settling_band] / (found.twice / 2)

    def undamped(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        found = _damping(wrong)
        if found is not None:
            yield sp.pi / found.omega_n if wrong.name == "peak_time" else (sp.pi - sp.acos(found.zeta)) / found.omega_n

    def whole_period(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        found = _damping(wrong)
        if found is not None:
            yield 2 * sp.pi / exact.damped_frequency(found)

    def wrong_ratio(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        found = _damping(wrong)
        if found is None:
            return
        zeta = 2 * found.zeta
        if wrong.name == "settling_time":
            yield from (c / found.twice for c in (3, 4))
        elif zeta < 1:
            turn = found.omega_n * sp.sqrt(1 - zeta**2)
            yield {
                "overshoot": sp.exp(-sp.pi * zeta / sp.sqrt(1 - zeta**2)),
                "peak_time": sp.pi / turn,
                "rise_time": (sp.pi - sp.acos(zeta)) / turn,
            }[wrong.name]

    task.mistake(BAND, "settling_time")(other_band)
    task.mistake(FORMULA, "settling_time")(estimated)
    task.mistake(FREQUENCY, "peak_time", "rise_time")(undamped)
    task.mistake(PERIOD, "peak_time")(whole_period)
    task.mistake(HALF, "overshoot", "peak_time", "rise_time", "settling_time")(wrong_ratio)


def _with_values(task: Task[Any, Any]) -> None:
    """Other values than those asked for."""

    def in_hertz(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        if not wrong.given.system.discrete:
            yield from (wrong.ours / (2 * sp.pi), wrong.ours * 2 * sp.pi)

    def value_at_the_peak(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        path = quietly(path_of(wrong.given))
        final = exact.value_at_zero(path.fraction, discrete=path.discrete).value
        yield from (1 + wrong.ours, final * (1 + wrong.ours), final * wrong.ours)

    def leading(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        path = quietly(path_of(wrong.given))
        yield from {sp.LC(p, path.variable) for p in (path.top, path.shown[0])}

    task.mistake(HERTZ, "peak_time", "rise_time", "settling_time")(in_hertz)
    task.mistake(PEAK, "overshoot")(value_at_the_peak)
    task.mistake(ONE_POLE, "final_value")(leading)


def _at_samples(task: Task[Any, Any]) -> None:
    """What goes wrong with samples."""

    def number_of_samples(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        T = _period(wrong)
        if T is not None:
            yield wrong.ours / T

    def sample_before(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        T = _period(wrong)
        if wrong.given.system.discrete and wrong.ours != 0:
            yield wrong.ours - (1 if T is None else T)

    def first_sample(wrong: Attempt[Any, Any]) -> Iterable[Any]:
        path = quietly(path_of(wrong.given))
        if path.discrete and path.bottom.subs(path.variable, 0) != 0:
            yield (path.top / path.bottom).subs(path.variable, 0)

    task.mistake(COUNTED, "peak_time", "rise_time", "settling_time")(number_of_samples)
    task.mistake(LAST_OUTSIDE, "settling_time")(sample_before)
    task.mistake(AT_ZERO, "final_value")(first_sample)


def _period(wrong: Attempt[Any, Any]) -> Any:
    """The sampling period of a discrete system, None without."""
    system = wrong.given.system
    return system.sample_time if system.discrete else None


def _damping(wrong: Attempt[Any, Any]) -> exact.Damping | None:
    """ω_n and ζ of the denominator where it has a conjugate pair alone."""
    if wrong.given.system.discrete:
        return None
    path = quietly(path_of(wrong.given))
    listed = sp.Poly(path.bottom, path.variable).all_coeffs()
    if len(listed) != 3:
        return None
    try:
        found = exact.damping_of(listed)
    except exact.NoFrequency:
        return None
    return found if found.damping == "underdamped" else None
