"""Usual mistakes with frequency responses: units, logarithms, the open loop, the sign of the phase."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip
from solver.lazy import exact
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from solver.derivation import Task
    from solver.systems import OpenLoop, System
    from solver.tasks.frequency.frequency_response import ResponseOptions

    Wrong = Attempt[OpenLoop, ResponseOptions]

RADIANS = Slip("radians", "the angle is in radians; degrees are asked for")
SIGN = Slip("phase_sign", "the sign of the phase is reversed")
DECIBELS = Slip("decibels", "this is the magnitude in dB; the ratio is asked for")
SQUARED = Slip("squared", "this is $|T|^2$; the root is missing")
HERTZ = Slip("hertz", "the frequency is in Hz; rad/s are asked for")
NORMALIZED = Slip("rad_per_sample", "this is ωT, the frequency in rad per sample; rad/s are asked for")
POINT_JW = Slip("jw_put_into_z", "jω is put in for z; on the unit circle it is e^{jωT}")
WITHOUT_T = Slip("period_left_out", "T is missing in e^{jωT}")
QUADRANT = Slip("quadrant", "the arctangent alone tells the angle up to 180° only: the quadrant is not looked at")
TEN_LOG = Slip("ten_log", "10 log is taken; of an amplitude it is 20 log, and the ratio is asked for")
WITHOUT_PHASE = Slip("without_phase", "the phase is missing")
DEGREES = Slip("degrees", "the phase in degrees stands beside $\\omega t$, which is in radians")
OF_T = Slip("amplitude", "the magnitude is not multiplied by the amplitude of the input")
OPEN_LOOP = Slip("open_loop", "this is the answer of the open loop")


def register(task: Task[OpenLoop, ResponseOptions]) -> None:
    """Register what goes wrong."""
    task.mistake(RADIANS, "phase", "resonant_phase")(in_radians)
    task.mistake(SIGN, "phase", "resonant_phase")(reversed_sign)
    task.mistake(DECIBELS, "magnitude", "resonant_peak")(in_decibels)
    task.mistake(TEN_LOG, "magnitude", "resonant_peak")(half_the_decibels)
    task.mistake(QUADRANT, "phase", "resonant_phase")(half_a_turn_away)
    task.mistake(WITHOUT_PHASE, "y_steady_state")(without_phase)
    task.mistake(DEGREES, "y_steady_state")(with_degrees)
    task.mistake(OF_T, "y_steady_state")(of_an_amplitude_of_one)
    task.mistake(SQUARED, "magnitude", "resonant_peak")(squared)
    task.mistake(HERTZ, "resonant_frequency", "bandwidth")(in_hertz)
    task.mistake(NORMALIZED, "resonant_frequency", "bandwidth")(in_rad_per_sample)
    task.mistake(POINT_JW, "magnitude", "phase")(with_jw_for_z)
    task.mistake(WITHOUT_T, "magnitude", "phase")(without_the_period)
    task.mistaken_question(OPEN_LOOP)(without_feedback)


def in_radians(wrong: Wrong) -> Iterable[Any]:
    """The angle times π/180."""
    yield sp.expand(wrong.ours * sp.pi / 180) if not wrong.ours.is_number else sp.N(wrong.ours * sp.pi / 180, 30)


def reversed_sign(wrong: Wrong) -> Iterable[Any]:
    """−φ."""
    yield -wrong.ours


def in_decibels(wrong: Wrong) -> Iterable[Any]:
    """20 log₁₀ |T|."""
    if wrong.ours.is_number:
        yield exact.in_decibels(wrong.ours)


def half_the_decibels(wrong: Wrong) -> Iterable[Any]:
    """10 log₁₀ |T|, and the ratio that it is read as where it is written with its dB."""
    if wrong.ours.is_number:
        yield from (exact.in_decibels(wrong.ours) / 2, sp.sqrt(wrong.ours))


def half_a_turn_away(wrong: Wrong) -> Iterable[Any]:
    """The angle whose tangent is the same, and that of the opposite sign."""
    if wrong.ours.is_number:
        other = wrong.ours + (180 if wrong.ours <= 0 else -180)
        yield from (other, -other)


def _steady_with(wrong: Wrong, shift: Any) -> Iterable[Any]:
    """The steady answer with another phase: radians, counted from that of the input."""
    if "phase" not in wrong.answers:  # of several sinusoids
        return
    ours, phase = wrong.ours, wrong.answers["phase"] * sp.pi / 180
    for wave in ours.atoms(sp.sin, sp.cos):
        yield ours.xreplace({wave: wave.func(wave.args[0] - phase + shift)})


def without_phase(wrong: Wrong) -> Iterable[Any]:
    """The input's own phase."""
    yield from _steady_with(wrong, sp.S.Zero)


def with_degrees(wrong: Wrong) -> Iterable[Any]:
    """The number of degrees for radians."""
    yield from _steady_with(wrong, wrong.answers.get("phase"))


def of_an_amplitude_of_one(wrong: Wrong) -> Iterable[Any]:
    """|T| as the amplitude."""
    for wave in wrong.ours.atoms(sp.sin, sp.cos) if "magnitude" in wrong.answers else ():
        yield wrong.answers["magnitude"] * wave


def squared(wrong: Wrong) -> Iterable[Any]:
    """|T|²."""
    yield sp.expand(wrong.ours**2)


def in_hertz(wrong: Wrong) -> Iterable[Any]:
    """The frequency over 2π."""
    yield sp.N(wrong.ours / (2 * sp.pi), 30)


def in_rad_per_sample(wrong: Wrong) -> Iterable[Any]:
    """ωT."""
    period = wrong.given.system.sample_time
    if wrong.given.system.discrete and period not in (None, 1):
        yield wrong.ours * period


def _at_the_frequency(wrong: Wrong, T: exact.OnAxis) -> Iterable[Any]:
    """Magnitude or phase of another function at the frequency of the question."""
    omega = wrong.given.options.frequency
    if wrong.given.system.discrete and omega is not None and omega.is_number:
        yield T.magnitude(omega) if wrong.name == "magnitude" else T.phase(omega)


def with_jw_for_z(wrong: Wrong) -> Iterable[Any]:
    """T(jω), as if z were s."""
    if wrong.given.system.discrete:
        above, below = _closed(wrong)
        yield from _at_the_frequency(wrong, exact.on_axis(above, below, wrong.given.system.variable))


def without_the_period(wrong: Wrong) -> Iterable[Any]:
    """T(e^{jω})."""
    if wrong.given.system.discrete and wrong.given.system.sample_time != 1:
        above, below = _closed(wrong)
        yield from _at_the_frequency(wrong, exact.on_circle(above, below, wrong.given.system.variable, sp.S.One))


def _closed(wrong: Wrong) -> tuple[Any, Any]:
    """Numerator and denominator of T."""
    loop = wrong.given.system
    L = loop.numerator / loop.denominator
    above, below = sp.fraction(sp.cancel(loop.C * loop.G / (1 + L) if loop.closed else L))
    return above, below


def without_feedback(system: System, options: ResponseOptions) -> tuple[System, ResponseOptions] | None:
    """C G in place of C G/(1 + C G H)."""
    return None if options.feedback is None else (system, replace(options, feedback=None))


__all__ = ["register"]
