"""The steady-state Kalman filter: the observer gain that minimizes the variance of the estimation error.

In discrete time x̂(k+1) = A x̂(k) + B u(k) + L (y(k) − C x̂(k)) predicts, and x̂(k) + M (y(k) − C x̂(k)) is current.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from solver.derivation import (
    AnswerName,
    Answers,
    Attempt,
    Check,
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
from solver.tasks.design.kalman_gain import duality, filter_of, intensities
from solver.tasks.design.regulator import REGULATING, faulty_weights
from solver.tasks.design.regulator_formulas import gain_of
from solver.tasks.design.riccati import solution_by_hamiltonian
from solver.tasks.design.riccati_checks import (
    FLOATS,
    are_of,
    equations_check,
    gain_check,
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
from solver.tasks.plant_options import PlantOptions
from solver.words import Reason

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.numeric.judges.optimal import Weights
    from solver.tasks.needed import WithOutput


@dataclass(frozen=True, kw_only=True)
class KalmanFilterOptions(PlantOptions):
    """The intensities of the noise."""

    Q: ImmutableMatrix | None = option(
        MatrixOf("n", "n"), "intensity of the noise on x' (discrete: on x(k+1)), n×n, positive semidefinite (default I)"
    )
    R: ImmutableMatrix | None = option(
        MatrixOf("p", "p"), "intensity of the noise on y, p×p, positive definite (default I)"
    )


kalman_filter: Task[WithOutput, KalmanFilterOptions] = Task(
    "kalman_filter",
    title="Kalman filter",
    doc="The gain L of the steady-state Kalman filter x̂' = A x̂ + B u + L (y − C x̂), by the algebraic Riccati equation.",
    needs=("A", "C"),
    options=KalmanFilterOptions,
    answers=[
        AnswerName(
            "P", "P", "the covariance of the estimation error: the stabilizing solution of the Riccati equation"
        ),
        AnswerName(
            "L",
            r"\sym{L}",
            "the gain of the filter",
            principal=True,
            earned=REGULATING,
        ),
        AnswerName(
            "L_current",
            r"L_{\text{cur}}",
            "the gain by which a measurement corrects the estimate of the same time (discrete)",
            optional=True,
            told=("current",),
        ),
        AnswerName("error_A", r"A - \sym{L}C", "the matrix of the estimation error"),
        AnswerName(
            "eigenvalues", r"\lambda_i", "the eigenvalues of the estimation error", numbered=True, told=("error",)
        ),
        *LISTED,
    ],
    example={"Q": "[[1, 0], [0, 1]]", "R": "1"},
)


@kalman_filter.refusal
def wrong_intensities(system: Any, options: KalmanFilterOptions) -> Iterable[Refusal]:
    """Intensities that are not symmetric and definite as they must be."""
    if not options.has("Q") and not options.has("R"):
        yield "", Reason("regulators/no_noise")
    yield from faulty_weights(options.Q, options.R, discrete=system.discrete)


@kalman_filter.method("riccati", title="Riccati equation", source="Lecture note, sections 4.3 and 5.5")
def by_the_riccati_equation(given: Given[WithOutput, KalmanFilterOptions]) -> Derivation[Answers]:
    """Solve AP + PAᵀ − P Cᵀ R⁻¹ C P + Q = 0 entry by entry and choose the stabilizing solution.

    In discrete time the equation is P = Q + APAᵀ − APCᵀ (R + CPCᵀ)⁻¹ CPAᵀ.
    """
    problem = yield from duality(given)
    equation, listed = yield from solutions_by_equations(problem)
    answers = yield from filter_of(given.system, problem, equation)
    answers |= listed_answers(problem, listed)
    return answers


@kalman_filter.method(
    "hamiltonian",
    title="Hamiltonian matrix (discrete: symplectic pencil)",
    source="Lancaster and Rodman, Algebraic Riccati Equations",
)
def by_the_hamiltonian_matrix(given: Given[WithOutput, KalmanFilterOptions]) -> Derivation[Answers]:
    """Take the stable half of the spectrum of the Hamiltonian matrix or pencil of (Aᵀ, Cᵀ); its subspace gives P."""
    problem = yield from duality(given)
    equation = yield from solution_by_hamiltonian(problem)
    return (yield from filter_of(given.system, problem, equation))


def _problem(given: Given[WithOutput, KalmanFilterOptions]) -> Weights:
    """The dual regulator problem, for the judges."""
    A, C = (sp.ImmutableMatrix(M.T) for M in (given.system.A, given.system.C))
    kind = judges.DiscreteWeights if given.system.discrete else judges.Weights
    return kind(A, C, *intensities(given))


def _transposed(M: Any) -> Any:
    return sp.ImmutableMatrix(M.T) if hasattr(M, "T") else M


@kalman_filter.verification("P")
def is_the_stabilizing_solution(given: Given[WithOutput, KalmanFilterOptions], answers: Answers) -> Iterable[Check]:
    """P is symmetric, solves the Riccati equation, and A − PCᵀR⁻¹C is stable; there is only one such P."""
    gain = "APC^{T}(R + CPC^{T})^{-1}" if given.system.discrete else "PC^{T}R^{-1}"
    yield from stabilizing_checks(_problem(given), answers["P"], f"A - {gain}C")


@kalman_filter.verification("L")
def is_optimal(given: Given[WithOutput, KalmanFilterOptions], answers: Answers) -> Iterable[Check]:
    """L stabilizes the error and is PCᵀR⁻¹ for the covariance P that it leads to; discrete APCᵀ(R + CPCᵀ)⁻¹."""
    label = (
        "$A - LC$ is stable, and $L = APC^{T}(R + CPC^{T})^{-1}$ for the covariance $P$ that $L$ leads to"
        if given.system.discrete
        else "$A - LC$ is stable, and $L = PC^{T}R^{-1}$ for the covariance $P$ that $L$ leads to"
    )
    yield gain_check(_problem(given), _transposed(answers["L"]), "L", label)


@kalman_filter.verification("L_current")
def corrects_at_best(given: Given[WithOutput, KalmanFilterOptions], answers: Answers) -> Iterable[Check]:
    """PCᵀ(R + CPCᵀ)⁻¹ with scipy's P."""
    yield numeric.check_residual(
        "$PC^{T}(R + CPC^{T})^{-1}$ with the optimal $P$",
        are_of(given.system.discrete),
        lambda: judges.current_gain_residual(_problem(given), _transposed(answers["L_current"])),
        FLOATS,
    )


@kalman_filter.verification("error_A")
def is_the_optimal_error_matrix(given: Given[WithOutput, KalmanFilterOptions], answers: Answers) -> Iterable[Check]:
    """A − LC with scipy's L."""
    yield loop_check(_problem(given), _transposed(answers["error_A"]), "error_A", "$A - LC$ with the optimal $L$")


@kalman_filter.verification("eigenvalues")
def are_the_stable_eigenvalues(given: Given[WithOutput, KalmanFilterOptions], answers: Answers) -> Iterable[Check]:
    """The stable half of the spectrum of the Hamiltonian matrix."""
    yield spectrum_check(_problem(given), answers["eigenvalues"])


@kalman_filter.verification("equations")
def are_the_entries_of_the_equation(given: Given[WithOutput, KalmanFilterOptions], answers: Answers) -> Iterable[Check]:
    """The entries of AP + PAᵀ − P Cᵀ R⁻¹ C P + Q, in any order and scale."""
    yield equations_check(_problem(given), answers["equations"])


@kalman_filter.verification("solutions", "definiteness")
def are_all_solutions(given: Given[WithOutput, KalmanFilterOptions], answers: Answers) -> Iterable[Check]:
    """Every one solves the equation, none is missing or listed twice, and the words fit."""
    yield from listed_checks(_problem(given), answers)


kalman_filter.consequence("error_A", of=("L",))(consequences.error_matrix)
kalman_filter.consequence("eigenvalues", of=("error_A",), symbolic=False)(consequences.eigenvalues_of("error_A"))
kalman_filter.consequence("definiteness", of=("solutions",), symbolic=False)(consequences.words_of_definiteness)


@kalman_filter.consequence("L", of=("P",))
def gain_of_the_covariance(given: Given[WithOutput, KalmanFilterOptions], found: Mapping[str, Any]) -> Any:
    """L = P Cᵀ R⁻¹, in discrete time A P Cᵀ (R + C P Cᵀ)⁻¹."""
    A, C = (sp.ImmutableMatrix(M.T) for M in (given.system.A, given.system.C))
    R = intensities(given)[1]
    return sp.ImmutableMatrix(gain_of(A, C, R, found["P"], discrete=given.system.discrete).T)


kalman_filter.mistake(mistakes.ADDED, "error_A")(mistakes.plus_for_minus)
kalman_filter.mistake(mistakes.OBSERVER_ADDED, "L")(mistakes.negative)


@kalman_filter.mistake(mistakes.OF_ANOTHER_SOLUTION, "L")
def gain_of_another_solution(wrong: Attempt[WithOutput, KalmanFilterOptions]) -> Iterable[Any]:
    """L of a P that is not the stabilizing one."""
    for P in wrong.answers.get("solutions", ()):
        yield gain_of_the_covariance(wrong.given, {"P": P})


kalman_filter.mistake(mistakes.OTHER_SOLUTION, "P")(other_solutions)
kalman_filter.mistaken_question(mistakes.CONTINUOUS_RICCATI)(mistakes.in_continuous_time)


@kalman_filter.mistake(mistakes.CURRENT_FOR_PREDICTION, "L")
def current_gain(wrong: Attempt[WithOutput, KalmanFilterOptions]) -> Iterable[Any]:
    """The gain of the current estimate."""
    if (L := wrong.answers.get("L_current")) is not None:
        yield L


@kalman_filter.mistake(mistakes.PREDICTION_FOR_CURRENT, "L_current")
def prediction_gain(wrong: Attempt[WithOutput, KalmanFilterOptions]) -> Iterable[Any]:
    """The gain of the prediction."""
    if (L := wrong.answers.get("L")) is not None:
        yield L


@kalman_filter.consequence("L_current", of=("P",))
def current_gain_of_the_covariance(given: Given[WithOutput, KalmanFilterOptions], found: Mapping[str, Any]) -> Any:
    """M = P Cᵀ (R + C P Cᵀ)⁻¹, in discrete time."""
    if not given.system.discrete:
        return None
    C, one = sp.ImmutableMatrix(given.system.C.T), sp.ImmutableMatrix(sp.eye(given.system.order))
    return sp.ImmutableMatrix(gain_of(one, C, intensities(given)[1], found["P"], discrete=True).T)


@kalman_filter.consequence("L", of=("L_current",))
def gain_of_the_current_one(given: Given[WithOutput, KalmanFilterOptions], found: Mapping[str, Any]) -> Any:
    """L = A M."""
    return sp.ImmutableMatrix(given.system.A * found["L_current"])


@kalman_filter.meaning("L", "error_A")
def instability(wrong: Attempt[WithOutput, KalmanFilterOptions]) -> Reason | None:
    """The poles, where they are not asymptotically stable."""
    plant = wrong.given.system
    loop = wrong.value if wrong.name == "error_A" else plant.A - wrong.value * plant.C
    return meanings.unstable(loop, discrete=plant.discrete)
