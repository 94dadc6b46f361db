"""Usual mistakes with root loci, and what wrong points mean."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.numeric.judges import root_locus as judges
from solver.tasks.root_locus.locus_equation import polynomial_of
from solver.tasks.told import short
from solver.words import Reason

if TYPE_CHECKING:
    from solver.derivation import Task
    from solver.systems import CharacteristicEquation
    from solver.tasks.root_locus.root_locus import RootLocusOptions

    Wrong = Attempt[CharacteristicEquation, RootLocusOptions]

OTHER = Slip(
    "other_multiples", "these are the even multiples of 180°/(n − m) in place of the odd ones, or the other way"
)
OVER_ALL = Slip("all_poles", "it is divided by the number of poles n; n − m branches go to infinity")
ADDED = Slip("zeros_added", "the zeros are added; their sum is subtracted from that of the poles")
TURNED = Slip("zeros_first", "the sum of the poles is subtracted from that of the zeros; it is the other way round")
CANDIDATES = Slip("not_on_the_locus", "all candidates are listed; those with K < 0 or complex K do not belong")
SIGN = Slip("departure_sign", "the sign is reversed: angles of zeros and of poles are taken the other way round")
RADIANS = Slip("radians", "the angles are in radians; degrees are asked for")
AXIS = Slip("axis_for_circle", "that is the imaginary axis; in the z-plane the unit circle bounds what is stable")
HALF_TURN = Slip("half_turn", "the 180° of the angle condition are missing")

NEAR = 1e-6
ROUGH = 1e-2
"""A point that is farther from another, relative to its size, is not the same rounded."""


def register(task: Task[CharacteristicEquation, RootLocusOptions]) -> None:
    """Register what goes wrong, and what tells a wrong point."""
    task.mistake(OTHER, "asymptote_angles")(other_multiples)
    task.mistake(RADIANS, "asymptote_angles", "departure_angles", "arrival_angles")(in_radians)
    task.mistake(OVER_ALL, "centroid")(divided_by_the_poles)
    task.mistake(ADDED, "centroid")(zeros_added)
    task.mistake(TURNED, "centroid")(zeros_first)
    task.mistake(CANDIDATES, "breakaway_points", "breakaway_gains")(all_candidates)
    task.mistake(SIGN, "departure_angles", "arrival_angles")(reversed_angles)
    task.mistake(AXIS, "imaginary_axis_crossings", "critical_gains")(of_the_imaginary_axis)
    task.mistake(HALF_TURN, "departure_angles", "arrival_angles")(without_half_turn)
    task.meaning("breakaway_points")(extra_or_missing_point)


def _equation(wrong: Wrong) -> exact.LocusEquation:
    p, K, _ = polynomial_of(wrong.given.system, wrong.given.options.parameter)
    constant = p.xreplace({K: sp.Integer(0)})
    slope = sp.expand(p.xreplace({K: sp.Integer(1)}) - constant)
    system = wrong.given.system
    return exact.locus_equation(slope, constant, system.variable, discrete=system.discrete)


def other_multiples(wrong: Wrong) -> Iterable[Any]:
    """The directions of the locus of the other sign."""
    equation = _equation(wrong)
    q, start = equation.excess, 0 if equation.positive else 180
    if q > 0:
        yield [sp.Rational(start + 360 * k, q) for k in range(q)]
        yield [sp.Rational(start + 360 * k, q) - (360 if 2 * (start + 360 * k) > 360 * q else 0) for k in range(q)]


def in_radians(wrong: Wrong) -> Iterable[Any]:
    """The angles times π/180, in (−π, π] and in [0, 2π)."""
    for start in (0, 360):
        turned = [each + start if each < 0 else each for each in wrong.ours]
        yield [sp.N(each * sp.pi / 180, 30) for each in turned]


def _sums(wrong: Wrong) -> tuple[exact.LocusEquation, exact.Asymptotes] | None:
    equation = _equation(wrong)
    lines = exact.asymptotes(equation)
    return None if lines is None else (equation, lines)


def divided_by_the_poles(wrong: Wrong) -> Iterable[Any]:
    """The difference of the sums over n."""
    if found := _sums(wrong):
        yield sp.expand((found[1].poles - found[1].zeros) / found[0].denominator.degree())


def zeros_added(wrong: Wrong) -> Iterable[Any]:
    """The sum of poles and zeros over n − m."""
    if found := _sums(wrong):
        yield sp.expand((found[1].poles + found[1].zeros) / found[0].excess)


def zeros_first(wrong: Wrong) -> Iterable[Any]:
    """The centroid with the sign reversed."""
    if found := _sums(wrong):
        yield sp.expand((found[1].zeros - found[1].poles) / found[0].excess)


def all_candidates(wrong: Wrong) -> Iterable[Any]:
    """All roots of N D' − N' D, and all real ones, or their gains."""
    found = [each for each in exact.meetings(_equation(wrong)) if each.why != "zero"]
    wanted = wrong.answers["breakaway_points"]
    for listed in (found, [each for each in found if each.point.real]):
        if all(each.point.value in wanted for each in listed):
            continue  # none is on it that does not belong
        yield [each.point.value if wrong.name == "breakaway_points" else each.gain for each in listed]


def reversed_angles(wrong: Wrong) -> Iterable[Any]:
    """−θ, and the sum with the signs of poles and zeros exchanged."""
    yield [-angle for angle in wrong.ours]
    yield [360 - angle for angle in wrong.ours]


def of_the_imaginary_axis(wrong: Wrong) -> Iterable[Any]:
    """Where branches of a discrete loop cross the imaginary axis, or their gains."""
    equation = _equation(wrong)
    if equation.discrete:
        found = exact.crossings(replace(equation, discrete=False))
        points = [sign * each.point for each in found for sign in ((1, -1) if each.point else (1,))]
        yield points if wrong.name == "imaginary_axis_crossings" else [each.gain for each in found]


def without_half_turn(wrong: Wrong) -> Iterable[Any]:
    """The sum of the angles alone."""
    yield [angle + 180 for angle in wrong.ours]
    yield [angle - 180 for angle in wrong.ours]


def extra_or_missing_point(wrong: Wrong) -> Reason | None:
    """A point at which no branches meet, with K there; or one that is missing."""
    p, K, _ = polynomial_of(wrong.given.system, wrong.given.options.parameter)
    locus = judges.locus_of(p, wrong.given.system.variable, K)
    wanted = [complex(point) for point, _ in judges.meeting_points(locus)]
    own = [complex(sp.N(each)) for each in wrong.value]
    for value, each in zip(own, wrong.value, strict=True):
        gain = complex(locus.gain(value))
        if all(abs(value - other) > ROUGH * (1 + abs(other)) for other in wanted):
            below = gain.real < 0 and abs(gain.imag) < NEAR * (1 + abs(gain))
            told = sp.Float(gain.real) if below else sp.Float(gain.real) + sp.I * sp.Float(gain.imag)
            values = {"point": short(each), "gain": short(told), "K": K}
            return Reason("root_locus/meets_below_zero" if below else "root_locus/meets_nowhere", values)
    missing = [other for other in wanted if all(abs(value - other) > ROUGH * (1 + abs(other)) for value in own)]
    return Reason("root_locus/meeting_missing", {"count": len(missing)}) if missing else None
