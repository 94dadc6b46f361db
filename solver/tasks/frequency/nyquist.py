"""Nyquist's criterion: the path, the crossings of the real axis, the turns about −1, Z = N + P."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Attempt, Check, Derivation, Given, Slip, Step, Task, Unsolved
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.numeric.judges import frequency as judges
from solver.tasks.frequency.boundary import needs_a_sampling_period, on_boundary
from solver.tasks.frequency.crossovers import formula_of, on_axis_of, real_axis_of
from solver.tasks.frequency.figures import nyquist_figures
from solver.tasks.frequency.lettered_loops import at_values, holds_where_the_poles_say, where_it_is_wrong
from solver.tasks.frequency.parametric_crossovers import has_letters
from solver.tasks.frequency.parametric_nyquist import turns_with_letters
from solver.tasks.plant_options import LoopOptions
from solver.tasks.stability.criterion import has_numbers, has_parameters
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import OpenLoop

nyquist: Task[OpenLoop, LoopOptions] = Task(
    "nyquist",
    title="Nyquist criterion",
    doc="The curve of L(jω), its crossings of the real axis and its turns about −1: how many poles the loop has to the "
    "right.",
    needs=("open_loop",),
    options=LoopOptions,
    example={"transfer_function": "10/(s(s + 1)(s + 5))"},
    answers=[
        AnswerName("encirclements", "N", "the turns about −1, clockwise positive", count=True, optional=True,
                   principal=has_numbers, earned=("turns",)),
        AnswerName("open_loop_unstable_poles", "P", "the poles of $L$ in the right half plane (discrete: outside the "
                   "unit circle)", count=True, principal=True, earned=("path", "poles")),
        AnswerName("closed_loop_unstable_poles", "Z", "the poles of the closed loop in the right half plane (discrete: "
                   "outside the unit circle)", count=True, optional=True, principal=has_numbers, earned=("count",)),
        AnswerName("stable", r"\text{stable}", "whether the closed loop is stable", optional=True,
                   principal=has_numbers, earned=("count",)),
        AnswerName("condition", r"\text{condition}", "where the closed loop is stable, with parameters", optional=True,
                   principal=has_parameters, earned=("turns", "count")),
        AnswerName("real_axis_crossings", r"L(j\omega_{i})",
                   r"the values of $L$ where it is real, $0 < \omega < \infty$ (discrete: to $\pi/T$); "
                   "with a dead time the first ones, all others are smaller", principal=True,
                   earned=("real_axis",)),
    ],
)  # fmt: skip

nyquist.refusal(needs_a_sampling_period)

REVERSED = Slip("direction", "the direction is reversed: clockwise turns are positive")
HALF = Slip("half_of_the_curve", "only the half of the curve for ω > 0 is counted")
SUBTRACTED = Slip("subtracted", "it is Z = N + P, not N − P or P − N")
ON_THE_AXIS = Slip("on_the_axis", "poles on the axis are counted; the path leaves them outside, so they are not in P")
OPEN_LOOP = Slip("open_loop", "that is said of L; the closed loop is asked for")


@nyquist.method(source="Ogata, Modern Control Engineering, §§7–5, 7–6", time="both")
def by_turns(given: Given[OpenLoop, LoopOptions]) -> Derivation[Answers]:
    """The turns are counted where the curve crosses the real axis left of −1, with the half turns at infinity."""
    loop = given.system
    if has_letters(loop):
        return (yield from turns_with_letters(loop))
    N, D, s = loop.numerator, loop.denominator, loop.variable
    L = on_boundary(loop)
    if not L.late and sp.degree(sp.expand(N + D), s) < sp.degree(D, s):
        raise Unsolved("conversions/ill_posed_direct_path")
    found = exact.encirclements(N, D, s, loop.delay, sample_time=L.sample_time)
    yield _path(L, loop, found)
    yield from on_axis_of(L)
    phases = yield from real_axis_of(L)
    yield _ends(L)
    crossings = [value for _, value in phases.real_axis]
    figures = nyquist_figures("Nyquist diagram of $L$", "The same near $-1$", L, crossings)
    if found.through:
        yield Step("through", unclaimed="a root of D + N on the boundary of stability", figures=figures)
        raise Unsolved("frequency/through_minus_one", discrete=L.discrete)
    yield _turns(L, found, figures)
    yield Step("count", unclaimed="counted; the answers have checks of their own", found=found, stable=found.stable,
               discrete=L.discrete)  # fmt: skip
    return Answers(
        encirclements=sp.Integer(found.clockwise),
        open_loop_unstable_poles=sp.Integer(found.open_loop),
        closed_loop_unstable_poles=sp.Integer(found.closed_loop),
        stable=found.stable,
        real_axis_crossings=crossings,
    )


def _path(L: exact.OnAxis, loop: OpenLoop, found: exact.Encirclements) -> Step:
    """Round the right half plane, poles on the axis passed on the right; round the unit circle, passed outside."""
    return Step("path", unclaimed="counted by a Routh array; the answer has a check of its own", L=formula_of(L),
                s=L.variable, D=loop.denominator, P=found.open_loop,
                poles=[(each.omega, each.half_turns) for each in found.arcs], discrete=L.discrete,
                places=[(_place(L, each), each.half_turns) for each in found.arcs])  # fmt: skip


def _place(L: exact.OnAxis, arc: exact.Arc) -> Expr | None:
    """Where a pole on the unit circle is, the upper one of a pair: cos ωT + j sin ωT."""
    return L.place(arc.omega) + sp.I * L.unit(arc.omega) if L.discrete else None


def _ends(L: exact.OnAxis) -> Step:
    """Where the curve begins and ends."""
    c, power = L.start
    if L.end is not None:
        return _ends_on_circle(L, L.end.omega)
    angle = (90 * power - (180 if c < 0 else 0) + 180) % 360 - 180
    final = L.N.LC() / L.D.LC() if L.excess == 0 else sp.S.Zero
    lead = (-90 * L.excess + (180 if L.N.LC() / L.D.LC() < 0 else 0) + 180) % 360 - 180
    return Step("ends", unclaimed="limits, seen from the lowest and highest powers", start=c if power == 0 else None,
                power=power, angle=angle if angle != -180 else 180, final=final, excess=L.excess,
                lead=lead if lead != -180 else 180, late=L.late, discrete=False)  # fmt: skip


def _ends_on_circle(L: exact.OnAxis, last: Expr) -> Step:
    """Where the curve begins, z = 1, and where it ends, z = −1."""
    c, power = L.start
    angle = (90 * power - (180 if c < 0 else 0) + 180) % 360 - 180
    infinite = L.parts.below(L.place(last)) == 0
    return Step("ends", unclaimed="values of $L$ at both ends", start=c if power == 0 else None, power=power,
                angle=angle if angle != -180 else 180, final=None if infinite else L.value(last)[0], discrete=True,
                excess=0, lead=None, late=False)  # fmt: skip


def _turns(L: exact.OnAxis, found: exact.Encirclements, figures: Any) -> Step:
    """The crossings left of −1 with their directions, what the half turns and the way through infinity add."""
    rows = [(each.omega, -each.magnitude, each.clockwise, 1 if each.end else 2) for each in found.beyond]
    return Step("turns", unclaimed="counted; the answer has a check of its own", rows=rows, arcs=list(found.arcs),
                closing=found.closing, clockwise=found.clockwise, real=found.real, late=L.late,
                discrete=L.discrete, places=[_place(L, each) for each in found.arcs], figures=figures)  # fmt: skip


ORACLE = "numpy.roots, refined; with a dead time samples and bisection"


@nyquist.verification(
    "encirclements", "open_loop_unstable_poles", "closed_loop_unstable_poles", "stable", "real_axis_crossings"
)
def are_counted_by_numbers(given: Given[OpenLoop, LoopOptions], answers: Answers) -> Iterable[Check]:
    """Poles by numpy and mpmath, turns by the change of the argument of 1 + L, crossings by samples.

    With parameters at some of their values.
    """
    loop, where = given.system, "outside the unit circle" if given.system.discrete else "in the right half plane"
    points = list(at_values(loop, answers))
    if "open_loop_unstable_poles" in answers:
        fits = all(at.open_loop_poles() == own["open_loop_unstable_poles"] for at, own in points)
        yield Check.that(Phrase("poles of $L$ {where}", where=where), "mpmath.polyroots", fits,
                         answer="open_loop_unstable_poles")  # fmt: skip
    oracle = "mpmath.polyroots" if loop.delay == 0 else "numpy, the argument principle on a contour"
    if "closed_loop_unstable_poles" in answers:
        fits = all(at.closed_loop_poles()[0] == own["closed_loop_unstable_poles"] for at, own in points)
        yield Check.that(Phrase("poles of the loop {where}", where=where), oracle, fits,
                         answer="closed_loop_unstable_poles")  # fmt: skip
    if "stable" in answers:
        fits = all(bool(own["stable"]) == (not any(at.closed_loop_poles())) for at, own in points)
        yield Check.that(Phrase("no pole {where} or on its edge", where=where), oracle, fits, answer="stable")
    if "encirclements" in answers:
        fits = all(own["encirclements"] == judges.turns_about(at.numbers) for at, own in points)
        yield Check.that("the change of the argument of $1 + L$ along the path", "numpy, samples of the contour",
                         fits, answer="encirclements")  # fmt: skip
    if "real_axis_crossings" in answers:
        residual = max(judges.crossing_residual(at.numbers, own["real_axis_crossings"]) for at, own in points)
        yield Check.within("all real values of $L$ on the path", ORACLE, residual, 1e-12, answer="real_axis_crossings")


nyquist.verification("condition")(holds_where_the_poles_say)
nyquist.meaning("condition")(where_it_is_wrong)


@nyquist.consequence("closed_loop_unstable_poles", of=("encirclements", "open_loop_unstable_poles"), symbolic=False)
def their_sum(_given: Given[OpenLoop, LoopOptions], found: Mapping[str, Any]) -> Any:
    """Z = N + P."""
    return found["encirclements"] + found["open_loop_unstable_poles"]


@nyquist.consequence("stable", of=("closed_loop_unstable_poles",), symbolic=False)
def without_unstable_poles(_given: Given[OpenLoop, LoopOptions], found: Mapping[str, Any]) -> Any:
    """Stable where there is none."""
    return bool(found["closed_loop_unstable_poles"] == 0)


@nyquist.mistake(REVERSED, "encirclements")
def in_the_other_direction(wrong: Attempt[OpenLoop, LoopOptions]) -> Iterable[Any]:
    """−N."""
    yield -wrong.ours


@nyquist.mistake(HALF, "encirclements")
def of_half_the_curve(wrong: Attempt[OpenLoop, LoopOptions]) -> Iterable[Any]:
    """N/2."""
    yield wrong.ours / 2


@nyquist.mistake(ON_THE_AXIS, "open_loop_unstable_poles")
def with_those_on_the_axis(wrong: Attempt[OpenLoop, LoopOptions]) -> Iterable[Any]:
    """The poles to the right and on the axis."""
    loop = wrong.given.system
    counts = exact.root_counts(sp.Poly(loop.denominator, loop.variable).all_coeffs(), discrete=loop.discrete)
    if counts is not None and counts.on:
        yield sp.Integer(counts.outside + counts.on)


@nyquist.mistake(SUBTRACTED, "closed_loop_unstable_poles")
def subtracted(wrong: Attempt[OpenLoop, LoopOptions]) -> Iterable[Any]:
    """N − P and P − N."""
    N, P = wrong.answers["encirclements"], wrong.answers["open_loop_unstable_poles"]
    yield from (N - P, P - N)


@nyquist.mistake(OPEN_LOOP, "stable")
def of_the_open_loop(wrong: Attempt[OpenLoop, LoopOptions]) -> Iterable[Any]:
    """Whether L has no pole to the right or on the axis."""
    loop = wrong.given.system
    counts = exact.root_counts(sp.Poly(loop.denominator, loop.variable).all_coeffs(), discrete=loop.discrete)
    if counts is not None and (stable := not counts.outside and not counts.on) != wrong.ours:
        yield stable
