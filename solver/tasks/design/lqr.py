"""The linear quadratic regulator: the state feedback that minimizes ∫ xᵀQx + 2xᵀNu + uᵀRu dt, or the sum over k."""

from __future__ import annotations

from collections.abc import Iterable
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
    Refusal,
    Task,
    option,
)
from solver.lazy import numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import optimal as judges
from solver.options.matrix import MatrixOf
from solver.tasks import consequences, meanings, mistakes
from solver.tasks.design import regulator_formulas as formulas
from solver.tasks.design.dearer import dearer
from solver.tasks.design.minimal_solution import MINIMAL, minimal_checks, minimal_solution_of
from solver.tasks.design.optimal_control import control_of
from solver.tasks.design.regulator import REGULATING, faulty_weights
from solver.tasks.design.regulator_formulas import initial_state_of, states_of
from solver.tasks.design.riccati import solution_by_hamiltonian
from solver.tasks.design.riccati_checks import (
    FLOATS,
    are_of,
    cost_oracle,
    equations_check,
    gain_check,
    gain_formula,
    listed_checks,
    loop_check,
    spectrum_check,
    stabilizing_checks,
)
from solver.tasks.design.riccati_solutions import (
    LISTED,
    listed_answers,
    other_solutions,
    solutions_by_equations,
)
from solver.tasks.design.weights import (
    WeightOptions,
    cost_factor,
    faulty_cross_weight,
    faulty_state_weight,
    regulator_of,
    state_weight,
    weights_as_stated,
)
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.numeric.judges.optimal import Weights
    from solver.systems import System
    from solver.tasks.needed import WithInput


@dataclass(frozen=True, kw_only=True)
class LqrOptions(WeightOptions):
    """The weights, and where the motion starts."""

    initial_state: ImmutableMatrix | None = option(
        MatrixOf("n", 1, flat="column"), "x(0), for the least cost (numbers or symbols)"
    )


lqr: Task[WithInput, LqrOptions] = Task(
    "lqr",
    title="Linear quadratic regulator",
    doc="The feedback u = −K x that minimizes ∫ xᵀQx + uᵀRu dt, or its sum, by the algebraic Riccati equation.",
    needs=("A", "B"),
    options=LqrOptions,
    answers=[
        AnswerName("P", "P", "the stabilizing solution of the Riccati equation"),
        AnswerName("K", r"\sym{K}", "the gain of the feedback", principal=True, earned=REGULATING),
        AnswerName("u", "u", "the control law"),
        AnswerName("Q", "Q", "the weight of the state"),
        AnswerName("R", "R", "the weight of the input"),
        AnswerName("closed_loop_A", r"A - B\sym{K}", "the matrix of the closed loop"),
        AnswerName(
            "eigenvalues", r"\lambda_i", "the eigenvalues of the closed loop", numbered=True, told=("closed_loop",)
        ),
        AnswerName("cost", r"J^{*}", "the least cost from the initial state", optional=True),
        *LISTED,
        MINIMAL,
    ],
    example={"Q": "[[1, 0], [0, 1]]", "R": "1"},
)


@lqr.refusal
def wrong_weights(system: Any, options: LqrOptions) -> Iterable[Refusal]:
    """Weights given twice, of the wrong size, or not definite as they must be."""
    yield from faulty_weights(options.Q, options.R, discrete=system.discrete and options.N is None)
    yield from faulty_state_weight(system, options)
    yield from faulty_cross_weight(system, options)
    factor = options.cost_factor
    if factor is not None and factor.is_positive is False:
        yield "cost_factor", Reason("regulators/not_positive", {"name": "cost_factor"})


@lqr.method("riccati", title="Riccati equation", source="Lecture note, section 5.3")
def by_the_riccati_equation(given: Given[WithInput, LqrOptions]) -> Derivation[Answers]:
    """Solve AᵀP + PA − P B R⁻¹ Bᵀ P + Q = 0 entry by entry and choose the stabilizing solution.

    In discrete time the equation is P = Q + AᵀPA − AᵀPB (R + BᵀPB)⁻¹ BᵀPA.
    """
    asked, problem = yield from regulator_of(given)
    equation, listed = yield from solutions_by_equations(problem)
    minimal = yield from minimal_solution_of(problem, listed.solutions)
    answers = yield from control_of(given, asked, equation)
    answers |= listed_answers(problem, listed)
    if minimal is not None:
        answers["minimal_solution"] = minimal
    return answers


@lqr.method(
    "hamiltonian",
    title="Hamiltonian matrix (discrete: symplectic pencil)",
    source="Lancaster and Rodman, Algebraic Riccati Equations",
)
def by_the_hamiltonian_matrix(given: Given[WithInput, LqrOptions]) -> Derivation[Answers]:
    """Take the stable half of the spectrum of the Hamiltonian matrix or of the pencil; its subspace gives P."""
    asked, problem = yield from regulator_of(given)
    equation = yield from solution_by_hamiltonian(problem)
    return (yield from control_of(given, asked, equation))


def _problem(given: Given[WithInput, LqrOptions]) -> Weights:
    """The plant and the weights, for the judges."""
    Q, R = state_weight(given), weights_as_stated(given)[1]
    kind = judges.DiscreteWeights if given.system.discrete else judges.Weights
    return kind(given.system.A, given.system.B, Q, R, given.options.N)


@lqr.verification("P")
def is_the_stabilizing_solution(given: Given[WithInput, LqrOptions], answers: Answers) -> Iterable[Check]:
    """P is symmetric, solves the Riccati equation, and A − BR⁻¹(BᵀP + Nᵀ) is stable; there is only one such P."""
    gain = gain_formula(discrete=given.system.discrete, cross=given.options.N is not None)
    yield from stabilizing_checks(_problem(given), answers["P"], f"A - B{gain}")


@lqr.verification("K")
def is_optimal(given: Given[WithInput, LqrOptions], answers: Answers) -> Iterable[Check]:
    """K stabilizes and is R⁻¹(BᵀP + Nᵀ) for the matrix P of its own cost; discrete (R + BᵀPB)⁻¹(BᵀPA + Nᵀ)."""
    gain = gain_formula(discrete=given.system.discrete, cross=given.options.N is not None)
    label = Phrase("$K$ stabilizes, and $K = {gain}$ for the $P$ of its own cost", gain=gain)
    yield gain_check(_problem(given), answers["K"], "K", label)


@lqr.verification("u")
def is_the_optimal_control(given: Given[WithInput, LqrOptions], answers: Answers) -> Iterable[Check]:
    """u = −K x at random states, K from scipy."""
    yield numeric.check_residual(
        "$u = -Kx$ at random states",
        are_of(given.system.discrete),
        lambda: judges.control_residual(_problem(given), answers["u"], states_of(given)),
        FLOATS,
    )


@lqr.verification("Q", "R")
def are_the_weights_asked_for(given: Given[WithInput, LqrOptions], answers: Answers) -> Iterable[Check]:
    """Q and R as the question says."""
    Q, R = weights_as_stated(given)
    for name, stated in (("Q", Q), ("R", R)):
        if name in answers:
            yield numeric.check_claim(
                Claim(stated, answers[name]), Phrase("${name}$ as the question says", name=name), answer=name
            )


@lqr.verification("closed_loop_A")
def is_the_optimal_loop(given: Given[WithInput, LqrOptions], answers: Answers) -> Iterable[Check]:
    """A − BK with scipy's K."""
    yield loop_check(_problem(given), answers["closed_loop_A"], "closed_loop_A", "$A - BK$ with the optimal $K$")


@lqr.verification("eigenvalues")
def are_the_stable_eigenvalues(given: Given[WithInput, LqrOptions], answers: Answers) -> Iterable[Check]:
    """The stable half of the spectrum of the Hamiltonian matrix, or of the pencil."""
    yield spectrum_check(_problem(given), answers["eigenvalues"])


@lqr.verification("cost")
def is_the_least_cost(given: Given[WithInput, LqrOptions], answers: Answers) -> Iterable[Check]:
    """The cost of the optimal loop by its Lyapunov equation, or summed up along the motion."""
    x0 = initial_state_of(given)
    yield numeric.check_residual(
        "the cost of the optimal loop from $x(0)$",
        cost_oracle(given.system.discrete),
        lambda: judges.cost_residual(_problem(given), answers["cost"], x0, cost_factor(given.options)),
        FLOATS,
    )


@lqr.verification("equations")
def are_the_entries_of_the_equation(given: Given[WithInput, LqrOptions], answers: Answers) -> Iterable[Check]:
    """The entries of the left side of the Riccati equation, in any order and scale."""
    yield equations_check(_problem(given), answers["equations"])


@lqr.verification("solutions", "definiteness")
def are_all_solutions(given: Given[WithInput, LqrOptions], answers: Answers) -> Iterable[Check]:
    """Every one solves the equation, none is missing or listed twice, and the words fit."""
    yield from listed_checks(_problem(given), answers)


@lqr.verification("minimal_solution")
def is_the_smallest_solution(given: Given[WithInput, LqrOptions], answers: Answers) -> Iterable[Check]:
    """It solves the equation, is positive semidefinite, and leaves alone what Q does not see."""
    yield from minimal_checks(_problem(given), answers["minimal_solution"])


lqr.consequence("closed_loop_A", of=("K",))(consequences.closed_loop)
lqr.consequence("eigenvalues", of=("closed_loop_A",), symbolic=False)(consequences.eigenvalues_of("closed_loop_A"))
lqr.consequence("K", of=("P",))(formulas.gain_of_the_solution)
lqr.consequence("u", of=("K",))(formulas.law_of_the_gain)
lqr.consequence("cost", of=("P",))(formulas.cost_of_the_solution)
lqr.consequence("definiteness", of=("solutions",), symbolic=False)(consequences.words_of_definiteness)


lqr.mistake(mistakes.ADDED, "closed_loop_A")(mistakes.plus_for_minus)
lqr.mistake(mistakes.GAIN_ADDED, "K")(mistakes.negative)


@lqr.mistake(mistakes.OF_ANOTHER_SOLUTION, "K")
def gain_of_another_solution(wrong: Attempt[WithInput, LqrOptions]) -> Iterable[Any]:
    """K of a P that is not the stabilizing one."""
    for P in wrong.answers.get("solutions", ()):
        yield formulas.gain_of_the_solution(wrong.given, {"P": P})


lqr.mistake(mistakes.OTHER_SOLUTION, "P")(other_solutions)
lqr.mistaken_question(mistakes.CONTINUOUS_RICCATI)(mistakes.in_continuous_time)


@lqr.mistake(mistakes.WEIGHT_ALONE, "K")
def gain_by_the_weight_alone(wrong: Attempt[WithInput, LqrOptions]) -> Iterable[Any]:
    """R⁻¹(BᵀPA + Nᵀ) in discrete time."""
    yield from formulas.gains_by_the_weight_alone(wrong.given, wrong.answers.get("P"))


@lqr.mistake(mistakes.WITHOUT_A, "K")
def gain_without_the_plant(wrong: Attempt[WithInput, LqrOptions]) -> Iterable[Any]:
    """(R + BᵀPB)⁻¹BᵀP in discrete time."""
    yield from formulas.gains_without_the_plant(wrong.given, wrong.answers.get("P"))


@lqr.mistaken_question(mistakes.WITHOUT_INITIAL_STATE)
def without_initial_state(system: System, options: LqrOptions) -> tuple[System, LqrOptions] | None:
    """The cost from rest."""
    x0 = options.initial_state
    return None if x0 is None else (system, replace(options, initial_state=sp.ImmutableMatrix(sp.zeros(*x0.shape))))


@lqr.mistaken_question(mistakes.WITHOUT_CROSS_WEIGHT)
def without_cross_weight(system: System, options: LqrOptions) -> tuple[System, LqrOptions] | None:
    """The regulator without N."""
    return None if options.N is None else (system, replace(options, N=None))


@lqr.meaning("K", "closed_loop_A")
def instability(wrong: Attempt[WithInput, LqrOptions]) -> Reason | None:
    """The poles, where they are not asymptotically stable; else what the gain costs."""
    plant, options = wrong.given.system, wrong.given.options
    loop = wrong.value if wrong.name == "closed_loop_A" else plant.A - plant.B * wrong.value
    told = meanings.unstable(loop, discrete=plant.discrete)
    if told is not None or wrong.name != "K":
        return told
    return dearer(_problem(wrong.given), wrong.value, options.initial_state, cost_factor(options))
