"""Gain and phase margin of a loop, from where L(jω) crosses the unit circle and the negative real axis."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Check, Derivation, Given, Step, Task
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.numeric.judges import frequency as judges
from solver.tasks.frequency import margin_mistakes
from solver.tasks.frequency.boundary import needs_a_sampling_period, on_boundary
from solver.tasks.frequency.closed_loop import is_stable
from solver.tasks.frequency.crossovers import crossovers_of
from solver.tasks.frequency.figures import bode_figure
from solver.tasks.frequency.lettered_loops import at_values, holds_where_the_poles_say, where_it_is_wrong
from solver.tasks.frequency.parametric_crossovers import has_letters
from solver.tasks.frequency.parametric_margins import margins_with_letters
from solver.tasks.plant_options import LoopOptions
from solver.tasks.stability.criterion import has_numbers, has_parameters

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import OpenLoop

stability_margins: Task[OpenLoop, LoopOptions] = Task(
    "stability_margins",
    title="Stability margins",
    doc="Crossover frequencies, gain margin and phase margin of the loop; of several crossovers the nearest to −1.",
    needs=("open_loop",),
    options=LoopOptions,
    example={"transfer_function": "10/(s(s + 1)(s + 5))"},
    answers=[
        AnswerName("gain_crossover", r"\omega_{g}",
                   r"the gain crossover, where $\lvert L\rvert = 1$ (oo: there is none)",
                   unit="rad/s", infinite=True, optional=True, principal=has_numbers, earned=("gain_crossovers",)),
        AnswerName("phase_crossover", r"\omega_{\varphi}",
                   r"the phase crossover, where $\angle L = -180$° (oo: there is none)",
                   unit="rad/s", infinite=True, optional=True, principal=has_numbers,
                   earned=("phase_crossovers", "late_crossovers")),
        AnswerName("gain_margin", r"G_{m}",
                   r"the gain margin, a ratio: $1/\lvert L\rvert$ at the phase crossover (oo: none)",
                   unit="ratio", infinite=True, optional=True, principal=has_numbers, earned=("gain_margin",)),
        AnswerName("gain_margin_db", r"G_{m,\text{dB}}", "the gain margin in decibels", unit="dB", infinite=True,
                   optional=True, principal=has_numbers, earned=("gain_margin",)),
        AnswerName("phase_margin", r"\varphi_{m}",
                   r"the phase margin 180° + $\angle L$ at the gain crossover, in degrees",
                   free=True, unit="°", infinite=True, optional=True, principal=has_numbers, earned=("phase",)),
        AnswerName("stable", r"\text{stable}", "whether the closed loop is stable", optional=True,
                   principal=has_numbers, earned=("verdict", "counted")),
        AnswerName("condition", r"\text{condition}", "where the closed loop is stable, with parameters", optional=True,
                   principal=has_parameters, earned=("array", "condition")),
    ],
)  # fmt: skip

margin_mistakes.register(stability_margins)
stability_margins.refusal(needs_a_sampling_period)


@stability_margins.method(source="Ogata, Modern Control Engineering, §7–7", time="both")
def on_the_axis(given: Given[OpenLoop, LoopOptions]) -> Derivation[Answers]:
    """|L(jω)| = 1 and Im L(jω) = 0 are solved for ω (at e^{jωT} of a discrete loop), the margins read off there."""
    loop = given.system
    if has_letters(loop):
        return (yield from margins_with_letters(loop))
    L = on_boundary(loop)
    found = yield from crossovers_of(L)
    stable = yield from is_stable(loop)
    yield _picture(L, found, stable=stable)
    return Answers(
        gain_crossover=found.gain_crossover,
        phase_crossover=found.phase_crossover,
        gain_margin=found.gain_margin,
        gain_margin_db=found.gain_margin_db,
        phase_margin=found.phase_margin,
        stable=stable,
    )


def _picture(L: exact.OnAxis, found: exact.Margins, *, stable: bool) -> Step:
    """Bode's diagram with the margins, and what they mean."""
    caption = "Bode diagram of $L$ with its margins"
    ratios = [each.magnitude for each in found.phases.found]
    above, below = ([x for x in ratios if (x > 1) == side and x != 1] for side in (True, False))
    gain, margin = found.gain_margin, found.phase_margin
    delay = None
    if stable and found.at_gain is not None and margin > 0:
        delay = sp.N(margin * sp.pi / 180 / found.at_gain.omega, 30)
    return Step(
        "picture",
        unclaimed="drawn from the numbers found above",
        figures=bode_figure(caption, ("L", L), margins=found),
        stable=stable,
        gain=gain,
        margin=margin,
        conditional=stable and bool(above),
        least=max((1 / x for x in above), default=None) if stable else None,
        most=min((1 / x for x in below), default=None) if stable else None,
        contradicts=not stable and bool(gain > 1) and bool(margin > 0),
        delay=delay,
        periods=None if delay is None or L.sample_time is None else sp.N(delay / L.sample_time, 30),
        hold=_turned_by_the_hold(L, found),
        T=L.sample_time,
        discrete=L.discrete,
        omega=found.gain_crossover,
        none=found.at_gain is None and found.at_phase is None,
    )


def _turned_by_the_hold(L: exact.OnAxis, found: exact.Margins) -> Expr | None:
    """How far a zero-order hold turns the phase at the gain crossover, −ω_g T/2, in degrees."""
    if L.sample_time is None or found.at_gain is None:
        return None
    return sp.N(-found.at_gain.omega * L.sample_time * 90 / sp.pi, 30)


ORACLE = "numpy.roots, refined; with a dead time samples and bisection"
TOLERANCE = 1e-12
NAMES = {
    "gain_crossover": (0, "gains", "$|L(j\\omega)| = 1$, and of such frequencies the one that decides"),
    "phase_margin": (1, "gains", "$180° + \\angle L(j\\omega_g)$"),
    "phase_crossover": (0, "phases", "$L(j\\omega) < 0$, and of such frequencies the one that decides"),
    "gain_margin": (1, "phases", "$1/|L(j\\omega_\\varphi)|$"),
    "gain_margin_db": (1, "phases", "$-20\\log_{10}|L(j\\omega_\\varphi)|$"),
}


@stability_margins.verification("gain_crossover", "phase_crossover", "gain_margin", "gain_margin_db", "phase_margin")
def are_those_of_the_values(given: Given[OpenLoop, LoopOptions], answers: Answers) -> Iterable[Check]:
    """All crossovers are found anew in numbers; phase margins are judged up to full turns."""
    points = [(judges.numeric_margins(at.numbers), own) for at, own in at_values(given.system, answers)]
    for name, (place, of, label) in NAMES.items():
        if name in answers:
            residual = max(
                judges.margin_residual(own[name], [pair[place] for pair in getattr(wanted, of)], name)
                for wanted, own in points
            )
            yield Check.within(label, ORACLE, residual, TOLERANCE, answer=name)


@stability_margins.verification("stable")
def is_told_by_the_poles(given: Given[OpenLoop, LoopOptions], answers: Answers) -> Iterable[Check]:
    """The poles of the loop in numbers; with a dead time their number by the argument principle."""
    loop = given.system
    label = (
        "no pole of the closed loop outside or on the unit circle"
        if loop.discrete
        else "no pole of the closed loop in the right half plane or on the axis"
    )
    oracle = "numpy, the argument principle on a contour" if loop.delay != 0 else "mpmath.polyroots"
    fits = all(bool(own["stable"]) == (not any(at.closed_loop_poles())) for at, own in at_values(loop, answers))
    yield Check.that(label, oracle, fits)


stability_margins.verification("condition")(holds_where_the_poles_say)
stability_margins.meaning("condition")(where_it_is_wrong)


@stability_margins.consequence("gain_margin_db", of=("gain_margin",))
def in_decibels(_given: Given[OpenLoop, LoopOptions], found: Mapping[str, Any]) -> Any:
    """20 log₁₀ of the ratio."""
    value = found["gain_margin"]
    if value.free_symbols:
        return 20 * sp.log(value) / sp.log(10)
    return exact.in_decibels(value) if value.is_positive else None


@stability_margins.consequence("phase_margin", of=("gain_crossover",))
def at_the_gain_crossover(given: Given[OpenLoop, LoopOptions], found: Mapping[str, Any]) -> Any:
    """180° + ∠L at the student's own frequency."""
    omega = found["gain_crossover"]
    if not omega.is_positive or omega == sp.oo or has_letters(given.system):
        return None
    return exact.phase_margin_of(on_boundary(given.system).phase(omega))


@stability_margins.consequence("gain_margin", of=("phase_crossover",))
def at_the_phase_crossover(given: Given[OpenLoop, LoopOptions], found: Mapping[str, Any]) -> Any:
    """1/|L| at the student's own frequency."""
    omega = found["phase_crossover"]
    if not omega.is_positive or omega == sp.oo or has_letters(given.system):
        return None
    return 1 / on_boundary(given.system).magnitude(omega)
