"""Lead compensators: more phase where the loop crosses one."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from solver.derivation import Answers, Derivation, Given, Refusal, Task, Unsolved
from solver.lazy import exact
from solver.tasks.compensators import compensator_mistakes
from solver.tasks.compensators.compensating import answers_of, judged_by
from solver.tasks.compensators.compensator import checked, constant_of, error_of
from solver.tasks.compensators.lead import lead_for_a_crossover, lead_in_attempts
from solver.tasks.compensators.locus import lead_for_a_pole
from solver.tasks.compensators.specifications import (
    CompensatorOptions,
    accuracy,
    compensator_faults,
    gain_for_the_error,
    margins_of_the_gain,
    plant_of,
    rational_plant_of,
)

if TYPE_CHECKING:
    from solver.systems import OpenLoop, System

lead_compensator: Task[OpenLoop, CompensatorOptions] = Task(
    "lead_compensator",
    title="Lead compensator",
    doc="K (T s + 1)/(α T s + 1) with α < 1 that gives a loop with unity feedback the margin asked for.",
    needs=("open_loop",),
    options=CompensatorOptions,
    answers=answers_of(several=False),
    example={"transfer_function": '"4/(s (s + 2))"', "velocity_constant": "20", "phase_margin": "50"},
)
judged_by(lead_compensator, "lead")
compensator_mistakes.register(lead_compensator)


@lead_compensator.refusal
def specifications_that_no_loop_meets(_system: System, options: CompensatorOptions) -> Iterable[Refusal]:
    """What contradicts itself, or means nothing."""
    yield from compensator_faults(options)


@lead_compensator.method(
    "frequency_response",
    title="Bode diagram",
    source="Ogata, Modern Control Engineering, §7–11",
    time="continuous",
)
def by_the_bode_diagram(given: Given[OpenLoop, CompensatorOptions]) -> Derivation[Answers]:
    """The gain from the error, the phase that is missing, α and T of it; checked by computation, and again."""
    options = given.options
    G = plant_of(given.system, options)
    if options.crossover is not None and accuracy(options) is None:
        loop = yield from lead_for_a_crossover(G, None, options)
        return (yield from checked(G, loop, exact.compensated(G, loop.K), options))
    K = yield from gain_for_the_error(G, options)
    before = yield from margins_of_the_gain(G, K, options.phase_margin)
    if options.crossover is not None:
        loop = yield from lead_for_a_crossover(G, K, options)
    else:
        if before.stable and before.margins.phase_margin >= options.phase_margin:
            raise Unsolved("compensators/not_needed", margin=before.margins.phase_margin, wanted=options.phase_margin)
        loop = yield from lead_in_attempts(G, K, options)
    return (yield from checked(G, loop, before, options))


@lead_compensator.method(
    "root_locus",
    title="Root locus",
    source="Ogata, Modern Control Engineering, §6–6",
    time="continuous",
)
def by_the_root_locus(given: Given[OpenLoop, CompensatorOptions]) -> Derivation[Answers]:
    """The angle that is missing at the pole, zero and pole by the bisector, the gain by the magnitude."""
    options = given.options
    G = rational_plant_of(given.system, options)
    found = yield from lead_for_a_pole(G, options)
    constant = constant_of(G, found.loop, options)
    error = error_of(G, found.loop, options)
    if constant is not None and constant[2] < constant[1]:
        raise Unsolved("compensators/constant_not_met", name=constant[0], wanted=constant[1], found=constant[2])
    if error is not None and options.error is not None and abs(error) > options.error:
        raise Unsolved("compensators/constant_not_met", name="error", wanted=options.error, found=error)
    return (yield from checked(G, found.loop, None, options))
