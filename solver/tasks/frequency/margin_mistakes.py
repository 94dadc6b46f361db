"""Usual mistakes with margins: units, logarithms, the 180°, the crossover of the other kind."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks.frequency.boundary import on_boundary

if TYPE_CHECKING:
    from solver.derivation import Task
    from solver.systems import OpenLoop
    from solver.tasks.plant_options import LoopOptions

    Wrong = Attempt[OpenLoop, LoopOptions]

RADIANS = Slip("radians", "the angle is in radians; degrees are asked for")
NO_HALF_TURN = Slip("half_turn", "this is the phase itself; the margin is 180° more")
HALF_TURN_LESS = Slip("half_turn_sign", "the phase is subtracted from 180°; it is added")
TEN_LOG = Slip("ten_log", "10 log is taken; of an amplitude it is 20 log")
DECIBELS = Slip("decibels", "this is the value in dB; the ratio is asked for")
RATIO = Slip("ratio", "this is the ratio; the value in dB is asked for")
NATURAL_LOG = Slip("natural_log", "the natural logarithm is taken; decibels are 20 log to the base 10")
INVERTED = Slip("inverted", "this is |L| at the crossover; the margin is 1/|L|")
HERTZ = Slip("hertz", "the frequency is in Hz; rad/s are asked for")
OTHER = Slip("other_crossover", "the gain crossover and the phase crossover are exchanged")
NOT_NEAREST = Slip("not_nearest", "of several crossovers the one nearest to −1 decides, not this one")
NORMALIZED = Slip("rad_per_sample", "this is ωT, the frequency in rad per sample; rad/s are asked for")
POINT_JW = Slip("jw_put_into_z", "jω is put in for z; on the unit circle it is e^{jωT}")
WITHOUT_T = Slip("period_left_out", "T is missing in e^{jωT}")
OPEN_LOOP = Slip("open_loop", "that is said of L; the closed loop is asked for")


AT_FREQUENCIES = ("gain_crossover", "phase_crossover", "gain_margin", "gain_margin_db", "phase_margin")


def register(task: Task[OpenLoop, LoopOptions]) -> None:
    """Register what goes wrong."""
    task.mistake(RADIANS, "phase_margin")(in_radians)
    task.mistake(NO_HALF_TURN, "phase_margin")(the_phase)
    task.mistake(HALF_TURN_LESS, "phase_margin")(the_phase_subtracted)
    task.mistake(TEN_LOG, "gain_margin_db")(half_the_decibels)
    task.mistake(TEN_LOG, "gain_margin")(with_half_the_decibels)
    task.mistake(NATURAL_LOG, "gain_margin_db")(by_natural_logarithm)
    task.mistake(DECIBELS, "gain_margin")(in_decibels)
    task.mistake(RATIO, "gain_margin_db")(as_a_ratio)
    task.mistake(INVERTED, "gain_margin", "gain_margin_db")(inverted)
    task.mistake(HERTZ, "gain_crossover", "phase_crossover")(in_hertz)
    task.mistake(NORMALIZED, "gain_crossover", "phase_crossover")(in_rad_per_sample)
    task.mistake(POINT_JW, *AT_FREQUENCIES)(with_jw_for_z)
    task.mistake(WITHOUT_T, "gain_margin", "phase_margin")(at_the_frequency_without_period)
    task.mistake(OTHER, "gain_crossover", "phase_crossover")(exchanged)
    task.mistake(NOT_NEAREST, "gain_crossover", "phase_crossover", "gain_margin", "gain_margin_db", "phase_margin")(
        of_another_crossover
    )
    task.mistake(OPEN_LOOP, "stable")(of_the_open_loop)


def _finite(wrong: Wrong) -> bool:
    return bool(wrong.ours.is_finite)


def in_radians(wrong: Wrong) -> Iterable[Any]:
    """The margin times π/180."""
    if _finite(wrong):
        yield sp.N(wrong.ours * sp.pi / 180, 30)


def the_phase(wrong: Wrong) -> Iterable[Any]:
    """∠L at the crossover, also without its sign."""
    if _finite(wrong):
        yield wrong.ours - 180
        yield 180 - wrong.ours


def the_phase_subtracted(wrong: Wrong) -> Iterable[Any]:
    """180° − ∠L at the crossover."""
    if _finite(wrong):
        yield 360 - wrong.ours


def half_the_decibels(wrong: Wrong) -> Iterable[Any]:
    """10 log of the ratio."""
    if _finite(wrong):
        yield wrong.ours / 2


def with_half_the_decibels(wrong: Wrong) -> Iterable[Any]:
    """10 log of the ratio, and the ratio that it is read as where it is written with its dB."""
    if _finite(wrong):
        yield from (exact.in_decibels(wrong.ours) / 2, sp.sqrt(wrong.ours))


def by_natural_logarithm(wrong: Wrong) -> Iterable[Any]:
    """ln of the ratio, 20 ln of it."""
    ratio = wrong.answers["gain_margin"]
    if _finite(wrong) and ratio.is_positive:
        yield from (factor * sp.N(sp.log(ratio), 30) for factor in (1, 20))


def in_decibels(wrong: Wrong) -> Iterable[Any]:
    """The margin in dB where the ratio is asked for."""
    if _finite(wrong):
        yield exact.in_decibels(wrong.ours)


def as_a_ratio(wrong: Wrong) -> Iterable[Any]:
    """The ratio where decibels are asked for."""
    if _finite(wrong):
        yield wrong.answers["gain_margin"]


def inverted(wrong: Wrong) -> Iterable[Any]:
    """|L|, or its decibels."""
    if _finite(wrong):
        yield -wrong.ours if wrong.name == "gain_margin_db" else 1 / wrong.ours


def in_hertz(wrong: Wrong) -> Iterable[Any]:
    """The frequency over 2π."""
    if _finite(wrong):
        yield sp.N(wrong.ours / (2 * sp.pi), 30)


def in_rad_per_sample(wrong: Wrong) -> Iterable[Any]:
    """ωT."""
    period = wrong.given.system.sample_time
    if wrong.given.system.discrete and _finite(wrong) and period != 1:
        yield wrong.ours * period


def with_jw_for_z(wrong: Wrong) -> Iterable[Any]:
    """The margins of L(jω), as if the loop were continuous."""
    loop = wrong.given.system
    if not loop.discrete:
        return
    try:
        found = exact.margins_of(exact.on_axis(loop.numerator, loop.denominator, loop.variable))
    except exact.NotExact:  # such a loop has no margins
        return
    yield getattr(found, wrong.name)


def at_the_frequency_without_period(wrong: Wrong) -> Iterable[Any]:
    """The phase margin, or 1/|L|, at the right frequency, but at e^{jω}."""
    loop, kind = wrong.given.system, wrong.name == "phase_margin"
    omega = wrong.answers["gain_crossover" if kind else "phase_crossover"]
    if loop.discrete and loop.sample_time != 1 and omega.is_finite and omega != 0:
        L = exact.on_circle(loop.numerator, loop.denominator, loop.variable, sp.S.One)
        omega = sp.N(omega, 30)
        yield exact.phase_margin_of(L.phase(omega)) if kind else 1 / L.magnitude(omega)


def exchanged(wrong: Wrong) -> Iterable[Any]:
    """The crossover of the other kind."""
    other = {"gain_crossover": "phase_crossover", "phase_crossover": "gain_crossover"}[wrong.name]
    if wrong.answers[other] != wrong.ours:
        yield wrong.answers[other]


def of_another_crossover(wrong: Wrong) -> Iterable[Any]:
    """The values at the crossovers that do not decide."""
    loop = wrong.given.system
    found = exact.margins_of(on_boundary(loop))
    for each in found.gains.found:
        if each is not found.at_gain:
            yield from {"gain_crossover": [each.omega], "phase_margin": [exact.phase_margin_of(each.phase)]}.get(
                wrong.name, []
            )
    for each in found.phases.found:
        if each is not found.at_phase:
            ratio = 1 / each.magnitude
            yield from {"phase_crossover": [each.omega], "gain_margin": [ratio],
                        "gain_margin_db": [exact.in_decibels(ratio)]}.get(wrong.name, [])  # fmt: skip


def of_the_open_loop(wrong: Wrong) -> Iterable[Any]:
    """Whether L itself is stable."""
    loop = wrong.given.system
    counts = exact.root_counts(sp.Poly(loop.denominator, loop.variable).all_coeffs(), discrete=loop.discrete)
    if counts is not None and (stable := not counts.outside and not counts.on) != wrong.ours:
        yield stable


__all__ = ["register"]
