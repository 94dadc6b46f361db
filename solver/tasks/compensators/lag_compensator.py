"""Lag compensators: a crossover that is lower, where the phase is enough."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from solver.derivation import Answers, Derivation, Given, Refusal, Task, Unsolved
from solver.tasks.compensators import compensator_mistakes
from solver.tasks.compensators.compensating import answers_of, judged_by
from solver.tasks.compensators.compensator import checked
from solver.tasks.compensators.lag import lag_for_a_crossover, lag_in_attempts
from solver.tasks.compensators.locus import lag_for_a_pole
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

lag_compensator: Task[OpenLoop, CompensatorOptions] = Task(
    "lag_compensator",
    title="Lag compensator",
    doc="K (T s + 1)/(α T s + 1) with α > 1 that gives a loop with unity feedback the margin asked for.",
    needs=("open_loop",),
    options=CompensatorOptions,
    answers=answers_of(several=False),
    example={"transfer_function": '"1/(s (s + 1) (0.5 s + 1))"', "velocity_constant": "5", "phase_margin": "40"},
)
judged_by(lag_compensator, "lag")
compensator_mistakes.register(lag_compensator)


@lag_compensator.refusal
def specifications_that_no_loop_meets(_system: System, options: CompensatorOptions) -> Iterable[Refusal]:
    """What contradicts itself, or means nothing."""
    yield from compensator_faults(options)


@lag_compensator.method(
    "frequency_response",
    title="Bode diagram",
    source="Ogata, Modern Control Engineering, §7–12",
    time="continuous",
)
def by_the_bode_diagram(given: Given[OpenLoop, CompensatorOptions]) -> Derivation[Answers]:
    """The gain from the error, the crossover where the phase is enough, α and T of it; checked by computation."""
    options = given.options
    G = plant_of(given.system, options)
    K = yield from gain_for_the_error(G, options)
    before = yield from margins_of_the_gain(G, K, options.phase_margin)
    if options.crossover is not None:
        loop = yield from lag_for_a_crossover(G, K, options)
    else:
        if before.stable and before.margins.phase_margin >= options.phase_margin:
            raise Unsolved("compensators/not_needed", margin=before.margins.phase_margin, wanted=options.phase_margin)
        loop = yield from lag_in_attempts(G, K, options)
    return (yield from checked(G, loop, before, options))


@lag_compensator.method(
    "root_locus",
    title="Root locus",
    source="Ogata, Modern Control Engineering, §6–7",
    time="continuous",
)
def by_the_root_locus(given: Given[OpenLoop, CompensatorOptions]) -> Derivation[Answers]:
    """The gain at the pole, the constant with it, and a zero and a pole near the origin that raise it."""
    options = given.options
    G = rational_plant_of(given.system, options)
    found = yield from lag_for_a_pole(G, options)
    return (yield from checked(G, found.loop, None, options))
