"""The pulse transfer function of a sampled plant, and of loops around it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Check,
    Claim,
    Derivation,
    Given,
    Refusal,
    Step,
    Task,
    Unsolved,
    lemma,
    option,
)
from solver.lazy import exact, numeric, systems
from solver.lazy import sympy as sp
from solver.numeric.judges import digital as judges
from solver.options.choice import Choice
from solver.options.number import Number
from solver.options.sampled_element import SampledElement
from solver.stated.algebra import product, quotient, total
from solver.tasks import meanings
from solver.tasks.digital import digital_mistakes
from solver.tasks.digital.discretization_checks import sampling_of
from solver.tasks.digital.pulse_steps import factors_sampled_apart, pulse_of, pulse_of_entry
from solver.tasks.plant_options import PlantOptions
from solver.tasks.sample_times import sample_time_of, sample_time_option, sample_time_refusals
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import DeadTime, System, TransferFunction

    Plant = TransferFunction | DeadTime


@dataclass(frozen=True, kw_only=True)
class PulseOptions(PlantOptions):
    """How the plant is driven and sampled, and what closes a loop around it."""

    sample_time: Expr | None = sample_time_option()
    hold: str = option(Choice(("zero_order", "none")), "what is before the plant: a hold of order zero, or impulses")
    delay: Expr | None = option(Number(), "a dead time of the plant, beside the one that it may have")
    controller: Expr | None = option(SampledElement(), "the controller C(z) before the hold")
    feedback: Expr | None = option(
        SampledElement(switched=True, analog=True),
        "what is in the feedback path: H in z behind the sampler, or in s before it",
    )


pulse_transfer_function: Task[Plant, PulseOptions] = Task(
    "pulse_transfer_function",
    title="Pulse transfer function",
    doc="From a sequence that drives a plant by a hold to the samples of its output; loops with a controller in z.",
    needs=("path",),
    options=PulseOptions,
    example={"transfer_function": "1/(s(s + 1))", "sample_time": "1"},
    answers=[
        AnswerName("G", "G(z)", "the pulse transfer function, in z", principal=True,
                   discrete=True, earned=("hold", "partial_fractions", "sampled", "result", "in_series", "closed")),
    ],
)  # fmt: skip


@pulse_transfer_function.refusal
def can_be_sampled(system: System, options: PulseOptions) -> Iterable[Refusal]:
    """There is a period, no dead time below zero, and a loop is around one input and one output."""
    yield from sample_time_refusals(system, options)
    if options.delay is not None and options.delay.is_negative:
        yield "delay", Reason("pulses/negative_delay")
    shape = (system.size("p"), system.size("m"))
    for name in ("controller", "feedback"):
        element = getattr(options, name)
        if element is not None and (hasattr(element, "shape") or (None not in shape and shape != (1, 1))):
            yield name, Reason("pulses/loop_of_matrices")


@pulse_transfer_function.method(
    source="Franklin, Powell, Workman, Digital Control of Dynamic Systems, §4.3", time="continuous"
)
def by_the_table(given: Given[Plant, PulseOptions]) -> Derivation[Answers]:
    """(1 − z⁻¹) 𝒵{G(s)/s} by partial fractions; then the loop, by what stands between two samplers."""
    options, plant, T = given.options, given.system, sample_time_of(given)
    C, H, held = options.controller, options.feedback, options.hold == "zero_order"
    delay = options.delay if options.delay is not None else sp.S.Zero
    if C is None and H is None:
        G = yield from pulse_of(plant, T, held=held, delay=delay)
        if not hasattr(G, "shape"):
            yield from factors_sampled_apart(_rational(plant), T, held=held, whole=G)
        return Answers(G=G)
    dead = plant.delay if isinstance(plant, systems.DeadTime) else sp.S.Zero
    G = _rational(plant)
    found = yield from pulse_of_entry(G, T, held=held, delay=delay + dead, name="G_{p}")
    return Answers(G=(yield from _loop_of(given, G, found, delay + dead)))


def _rational(plant: Any) -> Expr:
    """G without its dead time."""
    G: Expr = (plant.rational if isinstance(plant, systems.DeadTime) else plant).matrix[0, 0]
    return G


@lemma("sampled_loop")
def _loop_of(given: Given[Plant, PulseOptions], G: Expr, found: exact.Pulse, delay: Expr) -> Derivation[Expr]:
    """C G_p, or C G_p/(1 + C G_p H); returns it."""
    options, T, z = given.options, sample_time_of(given), sp.Symbol("z")
    C = sp.S.One if options.controller is None else options.controller
    H, held, Gp = options.feedback, options.hold == "zero_order", found.result
    if options.controller is not None:
        path = exact.in_series_in_z(C, Gp, z)
        claim = Claim(product(C, Gp.expression(z)), path.whole, "controller and plant in series")
        yield Step("in_series", claims={"path": claim}, C=C, G=Gp.expression(z), open=H is None)
        _causal(C, Gp.expression(z), z)
        if H is None:
            return path.whole
    if H is None:
        return Gp.expression(z)
    analog = H.has(sp.Symbol("s"))
    back: Any = H
    if analog:
        W = sp.cancel(G * H)
        claim = Claim(product(G, H), W, "plant and feedback in series")
        yield Step("between_samplers", claims={"W": claim}, H=H, G=G)
        known = [each.image(z) for each in found.terms]
        around = yield from pulse_of_entry(W, T, held=held, delay=delay, name="W", of="W", known=known)
        back = around.result
    loop = exact.closed_in_z(C, Gp, back, z)
    if loop.below == 0:
        raise Unsolved("conversions/ill_posed_loop")
    shown = back.expression(z) if analog else H
    forward = product(C, Gp.expression(z))
    inner = product(C, shown) if analog else product(C, Gp.expression(z), shown)
    claims = {
        "closed": Claim(quotient(forward, total(1, inner)), loop.whole, "the closed loop"),
        "below": Claim(quotient(loop.above, loop.below), loop.whole, "in lowest terms"),
    }
    yield Step("closed", claims=claims, whole=loop.whole, unity=H == 1, analog=analog, controlled=C != 1,
               H=H, C=C, G=Gp.expression(z), around=shown if analog else None)  # fmt: skip
    _causal(loop.whole, sp.S.One, z)
    return loop.whole


def _causal(C: Expr, G: Expr, z: Any) -> None:
    """Raise Unsolved where the product answers before it is asked."""
    above, below = sp.fraction(sp.together(C * G))
    if sp.degree(sp.expand(above), z) > sp.degree(sp.expand(below), z):
        raise Unsolved("pulses/not_causal")


@pulse_transfer_function.verification("G")
def has_the_samples_of_the_loop(given: Given[Plant, PulseOptions], answers: Answers) -> Iterable[Check]:
    """Its values at random z by matrix exponentials; its samples, those of the plant followed from one to the next."""
    z, G = sp.Symbol("z"), answers["G"]
    options, plant, T = given.options, given.system, sample_time_of(given)
    held, delay = options.hold == "zero_order", options.delay if options.delay is not None else sp.S.Zero
    forward = sampling_of(plant, T, held=held, delay=delay)
    C = sp.S.One if options.controller is None else options.controller
    H, back = options.feedback, None
    stated: Any = judges.stated_pulse(forward, z)
    if H is not None and H.has(sp.Symbol("s")):
        back, H = sampling_of(_with(plant, H), T, held=held, delay=delay), sp.S.One
        stated = quotient(product(C, stated), total(1, product(C, judges.stated_pulse(back, z))))
    elif H is not None:
        back = forward
        stated = quotient(product(C, stated), total(1, product(C, stated, H)))
    elif C != 1:
        stated = product(C, stated)
    yield numeric.check_claim(Claim(stated, G), Phrase("$G(z)$ by matrix exponentials"), answer="G")
    if not hasattr(G, "shape"):
        check = partial(judges.loop_residual, G, forward, back, C, sp.S.One if H is None else H, z)
        yield numeric.check_residual(Phrase("the samples after a unit pulse"), "matrix exponentials (40 digits)", check,
                                     answer="G")  # fmt: skip


def _with(plant: Any, H: Expr) -> Any:
    """The plant with H(s) behind it, nothing cancelled."""
    if isinstance(plant, systems.DeadTime):
        return systems.DeadTime(_with(plant.rational, H), plant.delay)
    p, q = (sp.expand(side) for side in sp.fraction(sp.together(H)))
    above, below = ((sp.expand(row[0][0] * side),) for row, side in ((plant.numerators, p), (plant.denominators, q)))
    return systems.TransferFunction(sp.ImmutableMatrix([[above[0] / below[0]]]), (above,), (below,), plant.variable)


digital_mistakes.name_mistakes_of_pulses(pulse_transfer_function)


@pulse_transfer_function.meaning("G")
def value_at_a_point(wrong: Attempt[Plant, PulseOptions]) -> Reason | None:
    """Its value, and that of the loop, at a point."""
    return meanings.at_a_point(wrong.value, wrong.ours)
