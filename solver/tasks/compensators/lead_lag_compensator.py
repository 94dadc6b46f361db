"""Lead-lag compensators: the lead gives phase, the lag accuracy."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from solver.derivation import Answers, Derivation, Given, Refusal, Task, Unsolved
from solver.tasks.compensators import compensator_mistakes
from solver.tasks.compensators.compensating import answers_of, judged_by
from solver.tasks.compensators.compensator import checked
from solver.tasks.compensators.lead_lag import both_in_attempts
from solver.tasks.compensators.locus import lag_for_a_pole, lead_for_a_pole
from solver.tasks.compensators.specifications import (
    CompensatorOptions,
    compensator_faults,
    gain_for_the_error,
    margins_of_the_gain,
    plant_of,
    rational_plant_of,
)

if TYPE_CHECKING:
    from solver.systems import OpenLoop, System

lead_lag_compensator: Task[OpenLoop, CompensatorOptions] = Task(
    "lead_lag_compensator",
    title="Lead-lag compensator",
    doc="A lead and a lag section with a gain that give a loop with unity feedback what is asked of it.",
    needs=("open_loop",),
    options=CompensatorOptions,
    answers=answers_of(several=True),
    example={"transfer_function": '"1/(s (s + 1) (s + 2))"', "velocity_constant": "10", "phase_margin": "50"},
)
judged_by(lead_lag_compensator, "lead_lag")
compensator_mistakes.register(lead_lag_compensator)


@lead_lag_compensator.refusal
def specifications_that_no_loop_meets(_system: System, options: CompensatorOptions) -> Iterable[Refusal]:
    """What contradicts itself, or means nothing."""
    yield from compensator_faults(options)


@lead_lag_compensator.method(
    "frequency_response",
    title="Bode diagram",
    source="Ogata, Modern Control Engineering, §7–13",
    time="continuous",
)
def by_the_bode_diagram(given: Given[OpenLoop, CompensatorOptions]) -> Derivation[Answers]:
    """The gain from the error, the lead from the phase at the crossover, the lag from the magnitude left there."""
    options = given.options
    G = plant_of(given.system, options)
    K = yield from gain_for_the_error(G, options)
    before = yield from margins_of_the_gain(G, K, options.phase_margin)
    if options.crossover is None and before.stable and before.margins.phase_margin >= options.phase_margin:
        raise Unsolved("compensators/not_needed", margin=before.margins.phase_margin, wanted=options.phase_margin)
    loop = yield from both_in_attempts(G, K, options)
    return (yield from checked(G, loop, before, options))


@lead_lag_compensator.method(
    "root_locus",
    title="Root locus",
    source="Ogata, Modern Control Engineering, §6–8",
    time="continuous",
)
def by_the_root_locus(given: Given[OpenLoop, CompensatorOptions]) -> Derivation[Answers]:
    """The lead makes the pole a point of the locus, the lag raises the constant and leaves it nearly there."""
    options = given.options
    G = rational_plant_of(given.system, options)
    lead = yield from lead_for_a_pole(G, options)
    found = yield from lag_for_a_pole(G, options, (lead.section,))
    return (yield from checked(G, found.loop, None, options))
