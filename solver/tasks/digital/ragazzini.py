"""Direct design after Ragazzini: the controller that gives a sampled loop the transfer function asked for."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Check,
    Claim,
    Derivation,
    Given,
    Options,
    Refusal,
    Slip,
    Task,
    Unsolved,
    option,
)
from solver.derivation.conversion import converted_to
from solver.lazy import numeric, systems
from solver.lazy import sympy as sp
from solver.numeric.judges import design
from solver.numeric.judges import digital as judges
from solver.options.poles import Poles
from solver.options.transfer_function import TransferFunctionOption
from solver.stated.algebra import product
from solver.tasks.digital.direct_steps import controller_that_gives
from solver.tasks.digital.pulse_steps import pulse_of
from solver.tasks.sample_times import sample_time_of, sample_time_option, sample_time_refusals
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import Expr

    from solver.systems import System
    from solver.tasks.needed import InputOutput


@dataclass(frozen=True, kw_only=True)
class RagazziniOptions(Options):
    """What the loop is to become."""

    target: Expr | None = option(TransferFunctionOption(), "the transfer function T(z) of the closed loop")
    poles: tuple[Expr, ...] | None = option(
        Poles(), "poles of T in place of the whole: missing ones are at 0, and T(1) = 1"
    )
    zeros: tuple[Expr, ...] | None = option(Poles(), "zeros of T, beside its poles (default: none)")
    sample_time: Expr | None = sample_time_option()


EARNED = ("target", "placed", "controller", "cancellations")

ragazzini: Task[InputOutput, RagazziniOptions] = Task(
    "ragazzini",
    title="Direct design (Ragazzini)",
    doc="The controller D(z) = (1/G) T/(1 − T) in a loop with unity feedback; a continuous plant is held and sampled.",
    needs=("transfer_function",),
    options=RagazziniOptions,
    answers=[
        AnswerName("controller", "D(z)", "the controller", discrete=True, principal=True, earned=EARNED),
        AnswerName("T", "T(z)", "the transfer function of the closed loop", discrete=True, earned=("target", "placed")),
    ],
    example={"transfer_function": "1/(s + 1)", "poles": "[0.5]", "sample_time": "0.1"},
)


@ragazzini.refusal
def incomplete_question(system: System, options: RagazziniOptions) -> Iterable[Refusal]:
    """One channel; a target or poles, in z; a sampling period where the plant is continuous."""
    yield from sample_time_refusals(system, options, needed=not system.discrete)
    sizes = {system.size(each) for each in "pm"} - {None}
    if sizes - {1}:
        yield "", Reason("ragazzini/several_channels")
    if not options.has("target") and not options.has("poles"):
        yield "", Reason("ragazzini/no_target")
    for name in ("poles", "zeros"):
        if options.has("target") and options.has(name):
            yield name, Reason("ragazzini/twice", {"name": name})
    if options.target is not None and options.target.has(sp.Symbol("s")):
        yield "target", Reason("ragazzini/in_s")


def _plant(given: Given[InputOutput, RagazziniOptions]) -> Derivation[tuple[Expr, Expr]]:
    """Numerator and denominator of G(z), not cancelled; of a continuous plant those of the held and sampled one."""
    G = yield from converted_to(given.system, systems.TransferFunction)
    if G.discrete:
        return G.numerators[0][0], G.denominators[0][0]
    if G.numerators[0][0] == 0:
        raise Unsolved("ragazzini/zero_plant")
    sampled = yield from pulse_of(G, sample_time_of(given), held=True)
    above, below = sp.fraction(sp.together(sampled))
    return above, below


@ragazzini.method(source="Franklin, Powell, Workman, Digital Control of Dynamic Systems, §7.3")
def by_the_closed_loop(given: Given[InputOutput, RagazziniOptions]) -> Derivation[Answers]:
    """Solve T = D G/(1 + D G) for D; T must be late enough, and nothing may be cancelled that does not decay."""
    plant = yield from _plant(given)
    if plant[0] == 0:
        raise Unsolved("ragazzini/zero_plant")
    options = given.options
    found = yield from controller_that_gives(plant, options.target, options.poles or (), options.zeros or ())
    return Answers(controller=found.controller, T=found.target)


@ragazzini.verification("T")
def is_the_target(given: Given[InputOutput, RagazziniOptions], answers: Answers) -> Iterable[Check]:
    """The target itself; by its poles: these and zeros, T(1) = 1, no more delays than the plant asks for."""
    wanted = judges.wanted_loop(_question(given), sp.Symbol("z"))
    yield numeric.check_claim(Claim(answers["T"], wanted), "the transfer function asked for", answer="T")


@ragazzini.verification("controller")
def gives_the_target(given: Given[InputOutput, RagazziniOptions], answers: Answers) -> Iterable[Check]:
    """The loop equation at random points; the loop simulated sample by sample; its modes, hidden ones too, decay."""
    question, z = _question(given), sp.Symbol("z")
    D, G, wanted = answers["controller"], judges.direct_plant(question, z), judges.wanted_loop(question, z)
    balance = Claim(product(D * (1 - wanted), G), sp.ImmutableMatrix([[wanted]]))
    yield numeric.check_claim(balance, "$D(1 - T)G = T$", answer="controller")
    stated = [D, wanted, *([question.T] if question.sampled else []), *question.plant]
    if not set().union(*(each.free_symbols for each in stated)) - {z}:
        fault = judges.loop_fault(question, D, z)
        label = "the loop followed after a step, and its characteristic polynomial"
        yield replace(Check.that(label, "scipy.signal, numpy.roots", not fault, answer="controller"), reason=fault)


def _question(given: Given[InputOutput, RagazziniOptions]) -> judges.DirectQuestion:
    """The question in the terms of its judges."""
    system, options = given.system, given.options
    plant: tuple[Any, ...]
    if isinstance(system, systems.StateSpace):
        through = sp.ImmutableMatrix([[0]]) if system.D is None else system.D
        plant = (system.A, system.B, system.C, through)
        plant = design.fraction_of(plant, sp.Symbol("z")) if system.discrete else plant
    else:
        plant = (system.numerators[0][0], system.denominators[0][0])
        plant = plant if system.discrete else design.first_row_form(plant, sp.Symbol("s"))
    T = options.sample_time if options.sample_time is not None else system.sample_time
    return judges.DirectQuestion(plant, T, options.target, options.poles or (), options.zeros or ())


NOT_SUBTRACTED = Slip("without_rest", "the denominator $1 - T$ is forgotten: this is $T/G$")
ADDED = Slip("plus_for_minus", "$1 + T$ stands where $1 - T$ belongs")
WITHOUT_PLANT = Slip("without_plant", "$1/G$ is forgotten: this is $T/(1 - T)$")
GAIN = Slip("gain_of_target", "$T(1) = 1$ is forgotten: the gain of $T$ is not chosen")
DELAYS = Slip("delays_of_target", "a delay is missing or one too many: poles at $0$ fill $T$ up")

Wrong = Attempt["InputOutput", RagazziniOptions]


@ragazzini.mistake(NOT_SUBTRACTED, "controller")
def without_the_rest(wrong: Wrong) -> Iterable[Any]:
    """T/G = D (1 − T)."""
    yield wrong.ours * (1 - wrong.answers["T"])


@ragazzini.mistake(ADDED, "controller")
def plus_for_minus(wrong: Wrong) -> Iterable[Any]:
    """(1/G) T/(1 + T)."""
    T = wrong.answers["T"]
    if T != -1:
        yield wrong.ours * (1 - T) / (1 + T)


@ragazzini.mistake(WITHOUT_PLANT, "controller")
def without_the_plant(wrong: Wrong) -> Iterable[Any]:
    """T/(1 − T)."""
    T = wrong.answers["T"]
    yield T / (1 - T)


@ragazzini.mistake(GAIN, "T")
def gain_not_chosen(wrong: Wrong) -> Iterable[Any]:
    """Π(z − zero)/Π(z − pole)."""
    if wrong.given.options.poles:
        z = sp.Symbol("z")
        above, below = sp.fraction(sp.cancel(wrong.ours))
        yield wrong.ours * sp.LC(below, z) / sp.LC(above, z)


@ragazzini.mistake(DELAYS, "T")
def other_delays(wrong: Wrong) -> Iterable[Any]:
    """One pole at 0 more or less."""
    if wrong.given.options.poles:
        z = sp.Symbol("z")
        yield from (wrong.ours * z, wrong.ours / z)


def _held_or_given(given: Given[InputOutput, RagazziniOptions]) -> Any:
    """G(z) of a plant in discrete time; None of another."""
    plant = _question(given).plant
    return plant[0] / plant[1] if given.system.discrete else None


@ragazzini.consequence("controller", of=("T",))
def controller_of_another_target(given: Given[InputOutput, RagazziniOptions], found: Mapping[str, Any]) -> Any:
    """(1/G) T/(1 − T)."""
    G, T = _held_or_given(given), found["T"]
    return None if G is None or T == 1 else sp.cancel(T / ((1 - T) * G))
