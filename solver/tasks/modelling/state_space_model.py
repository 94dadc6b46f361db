"""From the equations of a system to its state space."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.derivation import AnswerName, Answers, Check, Derivation, Given, Options, Refusal, Task, state_equations
from solver.lazy import numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import modelling as judges
from solver.tasks.modelling.linear_model import is_linear, state_space_of
from solver.words import Phrase, Reason, formula

if TYPE_CHECKING:
    from solver.systems import Equations, System

EXACT = 1e-10
"""What doubles leave of the equations where all values are exact."""


@dataclass(frozen=True, kw_only=True)
class StateSpaceModelOptions(Options):
    """There are none."""


def with_derivatives(given: Given[Equations, StateSpaceModelOptions]) -> bool:
    """Whether derivatives of inputs occur: then no states are named, and any realization is right."""
    model = given.system
    return any(name in model.inputs and k > 0 for name, k in model.jets.values()) or any(
        k < 0 for _, k in model.jets.values()
    )


state_space_model: Task[Equations, StateSpaceModelOptions] = Task(
    "state_space_model",
    title="State-space model",
    doc="The state equations of a system that is given by its differential (difference) equations.",
    needs=("equations",),
    options=StateSpaceModelOptions,
    answers=[
        AnswerName(
            "A", "A", "the system matrix", free=with_derivatives, earned=("highest", "matrices", "input_derivatives")
        ),
        AnswerName("B", "B", "the input matrix", optional=True, free=with_derivatives),
        AnswerName("C", "C", "the output matrix", free=with_derivatives),
        AnswerName("D", "D", "the feedthrough", optional=True),
        AnswerName("eliminated", r"\text{eliminated}", "what was eliminated, by the states and inputs", optional=True),
    ],
)
state_space_model.together(state_equations())


@state_space_model.refusal
def is_not_linear(system: System, options: StateSpaceModelOptions) -> Iterable[Refusal]:  # noqa: ARG001 - no options
    """A, B, C, D are those of linear equations."""
    if system.kind == "equations" and not is_linear(system):  # type: ignore[arg-type]  # of that kind
        yield "", Reason("equations/linearize_first")


@state_space_model.method(source="Ogata, Modern Control Engineering, §§2–4 and 2–5")
def by_highest_derivatives(given: Given[Equations, StateSpaceModelOptions]) -> Derivation[Answers]:
    """Solve for the highest derivatives, choose the lower ones as states, read off the rows."""
    found = yield from state_space_of(given.system)
    plant = found.plant
    named = {"A": plant.A, "B": plant.B, "C": plant.C, "D": plant.D}
    answers = Answers(**{name: M for name, M in named.items() if M is not None})
    if found.eliminated:
        answers["eliminated"] = dict(found.eliminated)
    return answers


@state_space_model.verification("A", "B", "C", "D")
def moves_as_the_equations_say(given: Given[Equations, StateSpaceModelOptions], answers: Answers) -> Iterable[Check]:
    """For random states and inputs the equations, transformed at a random s, have the solution of the model."""
    model = given.system
    sides = [left - right for left, right in model.sides]
    question = judges.Question(
        sides, list(model.outputs), dict(model.jets), model.unknowns, model.inputs, model.states, model.algebraic
    )
    found = {name: answers[name] for name in "ABCD" if name in answers}
    for name, label, residual in judges.model_residuals(question, found, free=with_derivatives(given)):
        near = 1e-6 if numeric.holds_decimals([sides, found]) else EXACT
        yield Check.within(label, "numpy.linalg.lstsq, transformed equations", residual, near, answer=name)


@state_space_model.verification("eliminated")
def hold_along_the_equations(given: Given[Equations, StateSpaceModelOptions], answers: Answers) -> Iterable[Check]:
    """Each eliminated unknown has the value that the equations give it."""
    model = given.system
    sides = [left - right for left, right in model.sides]
    for symbol, value in dict(answers["eliminated"]).items():
        residual = judges.eliminated_residual(sides, dict(model.jets), sp.Symbol(str(symbol), real=True), value)
        label = Phrase("${symbol}$ put into the equations", symbol=formula(symbol))
        yield Check.within(label, "numpy.linalg.lstsq", residual, 1e-8 if numeric.holds_decimals(value) else EXACT)
