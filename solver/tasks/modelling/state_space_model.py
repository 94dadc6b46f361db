"""From the equations of a system to its state space."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.derivation import AnswerName, Answers, Check, Derivation, Given, Options, Task, state_equations
from solver.derivation.answer_equations import state_functions
from solver.lazy import numeric, systems
from solver.lazy import sympy as sp
from solver.numeric.judges import modelling as judges
from solver.tasks.modelling import circuit_mistakes, equation_mistakes
from solver.tasks.modelling.first_order import first_order_of, functions_of, is_linear
from solver.tasks.modelling.linear_model import matrices_of
from solver.tasks.modelling.questions import is_driven, question_of
from solver.words import Phrase, formula

if TYPE_CHECKING:
    from solver.systems import Circuit, Equations, Lagrangian

EXACT = 1e-10
"""What doubles leave of the equations where all values are exact."""
NEAR = 1e-8
"""What they leave where derivatives are taken along a motion."""
NEWTON = "Newton's method with numpy.linalg.lstsq"


@dataclass(frozen=True, kw_only=True)
class StateSpaceModelOptions(Options):
    """There are none."""


def with_derivatives(given: Given[Equations, StateSpaceModelOptions]) -> bool:
    """Whether derivatives of inputs occur: then no states are named, and any realization is right."""
    model = given.system
    return any(name in model.inputs and k > 0 for name, k in model.jets.values()) or any(
        k < 0 for _, k in model.jets.values()
    )


def may_have_matrices(system: Equations | Circuit | Lagrangian) -> bool:
    """Whether A, B, C and D are asked for: the equations are linear."""
    return is_linear(system) if isinstance(system, systems.Equations) else system.is_linear


def has_driven_matrices(system: Equations | Circuit | Lagrangian) -> bool:
    """Whether B and D are asked for: the equations are linear and have inputs."""
    return may_have_matrices(system) and is_driven(system)


def has_functions(system: Equations | Circuit | Lagrangian) -> bool:
    """Whether f and h are asked for: the equations are not linear."""
    return not may_have_matrices(system)


state_space_model: Task[Equations, StateSpaceModelOptions] = Task(
    "state_space_model",
    title="State-space model",
    doc="The state equations of a system that is given by its differential (difference) equations.",
    needs=("equations",),
    options=StateSpaceModelOptions,
    answers=[
        AnswerName("A", "A", "the system matrix", free=with_derivatives, optional=True, principal=may_have_matrices,
                   earned=("highest", "matrices", "input_derivatives")),
        AnswerName("B", "B", "the input matrix", optional=True, free=with_derivatives, principal=has_driven_matrices),
        AnswerName("C", "C", "the output matrix", optional=True, free=with_derivatives, principal=may_have_matrices),
        AnswerName("D", "D", "the feedthrough", optional=True, principal=has_driven_matrices),
        AnswerName("f", "f(x, u)", "nonlinear: the derivatives of the states (discrete: their next values), n×1",
                   optional=True, principal=has_functions, earned=("highest",)),
        AnswerName("h", "h(x, u)", "nonlinear: the outputs, p×1", optional=True, principal=has_functions),
        AnswerName("eliminated", r"\text{eliminated}", "what was eliminated, by the states and inputs", optional=True),
    ],
)  # fmt: skip
state_space_model.together(state_equations())
state_space_model.together(state_functions())
circuit_mistakes.name_mistakes(state_space_model)
equation_mistakes.name_mistakes(state_space_model)
state_space_model.mistake(equation_mistakes.TERM_REVERSED, "f")(equation_mistakes.term_reversed)


@state_space_model.method(
    "kirchhoff",
    title="Kirchhoff's laws",
    source="Balabanian and Bickart, Electrical Network Theory, §4.5",
    system="circuit",
)
def by_kirchhoff(given: Given[Equations, StateSpaceModelOptions]) -> Derivation[Answers]:
    """The state equations that Kirchhoff's laws give, solved for the derivatives."""
    return (yield from by_highest_derivatives(given))


@state_space_model.method(title="Highest derivatives", source="Ogata, Modern Control Engineering, §§2–4 and 2–5")
def by_highest_derivatives(given: Given[Equations, StateSpaceModelOptions]) -> Derivation[Answers]:
    """Solve for the highest derivatives and choose the lower ones as states; of linear equations read off the rows."""
    found = yield from first_order_of(given.system)
    if found.is_linear:
        plant = yield from matrices_of(found)
        named = {"A": plant.A, "B": plant.B, "C": plant.C, "D": plant.D}
        answers = Answers(**{name: M for name, M in named.items() if M is not None})
    else:
        yield from functions_of(found)
        answers = Answers(**{name: sp.ImmutableMatrix(list(rows)) for name, rows in (("f", found.f), ("h", found.h))})
    if found.eliminated:
        answers["eliminated"] = dict(found.eliminated)
    return answers


@state_space_model.verification("A", "B", "C", "D")
def moves_as_the_equations_say(given: Given[Equations, StateSpaceModelOptions], answers: Answers) -> Iterable[Check]:
    """For random states and inputs the equations, transformed at a random s, have the solution of the model."""
    question = question_of(given.system)
    found = {name: answers[name] for name in "ABCD" if name in answers}
    if not is_linear(given.system):
        for name in found:
            yield Check.that("the equations are linear", "their terms", holds=False, answer=name)
        return
    for name, label, residual in judges.model_residuals(question, found, free=with_derivatives(given)):
        near = 1e-6 if numeric.holds_decimals([question.equations, found]) else EXACT
        yield Check.within(label, "numpy.linalg.lstsq, transformed equations", residual, near, answer=name)


@state_space_model.verification("f", "h")
def are_what_the_equations_say(given: Given[Equations, StateSpaceModelOptions], answers: Answers) -> Iterable[Check]:
    """At random states and inputs the equations, solved by Newton's method, have these derivatives and outputs."""
    question = question_of(given.system)
    found = {name: list(answers[name]) for name in "fh" if name in answers}
    for name, label, residual in judges.function_residuals(question, found, discrete=given.system.discrete):
        near = 1e-6 if numeric.holds_decimals([question.equations, found]) else NEAR
        yield Check.within(label, NEWTON, residual, near, answer=name)


@state_space_model.verification("eliminated")
def hold_along_the_equations(given: Given[Equations, StateSpaceModelOptions], answers: Answers) -> Iterable[Check]:
    """Each eliminated unknown has the value that the equations give it."""
    question, linear = question_of(given.system), is_linear(given.system)
    for name, value in dict(answers["eliminated"]).items():
        symbol = next((x for x in question.jets if str(x) == str(name)), sp.Symbol(str(name), real=True))
        if linear:
            residual = judges.eliminated_residual(question.equations, question.jets, symbol, value)
        else:
            residual = judges.value_residual(question, symbol, value, discrete=given.system.discrete)
        label = Phrase("${symbol}$ put into the equations", symbol=formula(symbol))
        near = 1e-8 if numeric.holds_decimals(value) else EXACT if linear else NEAR
        yield Check.within(label, "numpy.linalg.lstsq" if linear else NEWTON, residual, near)
