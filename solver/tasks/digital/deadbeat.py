"""Deadbeat control: the state feedback that brings every state to zero in the fewest steps."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Check,
    Claim,
    Derivation,
    Given,
    Task,
    control_law,
)
from solver.lazy import numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import design
from solver.numeric.judges import digital as judges
from solver.stated.algebra import difference, product
from solver.tasks import consequences, meanings, mistakes
from solver.tasks.design.loop_figures import block_diagram
from solver.tasks.design.pole_options import PLACING
from solver.tasks.digital.dead_in_steps import dead_after, deadbeat_gain_of
from solver.tasks.freedom import gain_is_free
from solver.tasks.plant_options import PlantOptions
from solver.words import Reason

if TYPE_CHECKING:
    from solver.tasks.needed import WithInput

deadbeat: Task[WithInput, PlantOptions] = Task(
    "deadbeat",
    title="Deadbeat control",
    doc="The gain K of u = −K x for which A − BK is nilpotent: every state is zero after the fewest steps possible.",
    needs=("A", "B"),
    options=PlantOptions,
    answers=[
        AnswerName(
            "K",
            r"\sym{K}",
            "the gain of the feedback",
            free=gain_is_free,
            principal=True,
            earned=(*PLACING, "ends_gain", "stages_gain"),
        ),
        AnswerName("closed_loop_A", r"A - B\sym{K}", "the matrix of the closed loop", free=gain_is_free),
        AnswerName(
            "steps",
            r"\nu",
            "the number of steps after which the state is zero",
            principal=True,
            count=True,
            earned=("powers",),
        ),
    ],
    example={"time": "discrete"},
)
deadbeat.together(control_law(("-K", "x")))


@deadbeat.method(source="Åström and Wittenmark, Computer-Controlled Systems, section 4.3", time="discrete")
def by_nilpotency(given: Given[WithInput, PlantOptions]) -> Derivation[Answers]:
    """All poles at z = 0: Ackermann's formula with p̂(z) = zⁿ; several inputs by their chains."""
    yield from block_diagram("state_feedback", r"State feedback $u = -\sym{K} x$", discrete=True)
    K, steps = yield from deadbeat_gain_of(given.system)
    loop = yield from dead_after(given.system, K, steps)
    return Answers(K=K, closed_loop_A=loop, steps=sp.Integer(steps))


@deadbeat.verification("K", "closed_loop_A", "steps")
def is_dead_in_the_fewest_steps(given: Given[WithInput, PlantOptions], answers: Answers) -> Iterable[Check]:
    """(A − BK)^ν = 0 for the least ν with im A^ν in the range of [B, AB, …, A^{ν−1}B]."""
    A, B = given.system.A, given.system.B
    fewest = judges.fewest_steps(A, B)
    K, loop = answers.get("K"), answers.get("closed_loop_A")
    if "steps" in answers:
        yield Check.that(
            "it is the least number of steps in which the input brings every state to zero",
            "numpy.linalg.svd",
            bool(fewest is not None and answers["steps"] == fewest),
            answer="steps",
        )
    if fewest is None:
        yield Check.that("every state can be brought to zero", "numpy.linalg.svd", False)
        return
    if K is not None:
        fits = K.shape == (B.cols, A.rows)
        yield Check.that("the gain has a row an input and a column a state", "inspection", fits, answer="K")
        if fits:
            yield _is_dead(sp.ImmutableMatrix(A - B * K), fewest, "K")
    if loop is not None:
        yield Check.that(
            "the closed loop has the size of $A$", "inspection", loop.shape == A.shape, answer="closed_loop_A"
        )
        if loop.shape == A.shape:
            yield _is_dead(loop, fewest, "closed_loop_A")
            yield numeric.check_residual(
                "$A$ less the closed loop is $B$ times a gain",
                "numpy.linalg.lstsq",
                lambda: design.range_residual(A, B, loop),
                answer="closed_loop_A",
            )
    if loop is not None and K is not None and K.shape == (B.cols, A.rows):
        yield numeric.check_claim(Claim(difference(A, product(B, K)), loop), "$A - BK$", answer="closed_loop_A")


def _is_dead(loop: Any, steps: int, name: str) -> Check:
    """The power of the loop is zero."""
    return numeric.check_residual(
        r"$(A - B\sym{K})^{\nu} = 0$ with the least possible $\nu$",
        "mpmath, 60 digits",
        lambda: judges.remaining(loop, steps),
        answer=name,
    )


deadbeat.consequence("closed_loop_A", of=("K",))(consequences.closed_loop)


@deadbeat.consequence("steps", of=("closed_loop_A",), symbolic=False)
def index_of_the_loop(_given: Given[WithInput, PlantOptions], found: Mapping[str, Any]) -> Any:
    """The least power of the loop that is zero; None where none is."""
    loop = found["closed_loop_A"]
    M = loop
    for steps in range(1, loop.rows + 1):
        if M.is_zero_matrix:
            return sp.Integer(steps)
        M = sp.ImmutableMatrix((M * loop).applyfunc(sp.expand))
    return None


deadbeat.mistaken_question(mistakes.EXCHANGED)(mistakes.inputs_for_outputs)
deadbeat.mistake(mistakes.ADDED, "closed_loop_A")(mistakes.plus_for_minus)
deadbeat.mistake(mistakes.GAIN_ADDED, "K")(mistakes.negative)


@deadbeat.meaning("steps")
def too_many_or_too_few(wrong: Attempt[WithInput, PlantOptions]) -> Reason | None:
    """What can be brought to rest in so many steps: all states in fewer, or not all of them."""
    plant, steps = wrong.given.system, wrong.value
    if not steps.is_Integer or not 0 <= steps <= plant.order:
        return None
    dimension = judges.states_at_rest(plant.A, plant.B, int(steps))
    if dimension == plant.order:
        return Reason("deadbeat/too_many", {"steps": steps, "all": steps == plant.order})
    return Reason("deadbeat/too_few", {"steps": steps, "dimension": dimension, "n": plant.order})


@deadbeat.meaning("K", "closed_loop_A")
def poles_of_the_loop(wrong: Attempt[WithInput, PlantOptions]) -> Reason | None:
    """The poles that the gain or the loop has, where they are not all zero."""
    plant = wrong.given.system
    loop = wrong.value if wrong.name == "closed_loop_A" else plant.A - plant.B * wrong.value
    return meanings.poles_given(loop, [sp.Integer(0)] * plant.order)
