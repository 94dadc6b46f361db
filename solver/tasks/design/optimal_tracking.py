"""Optimal tracking of a constant reference: the regulator around a set point."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
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
    control_law,
    option,
)
from solver.derivation.figures import Diagram
from solver.lazy import exact, numeric
from solver.numeric.judges import design, optimal
from solver.options.matrix import MatrixOf
from solver.tasks import consequences, meanings, mistakes
from solver.tasks.design.optimal_control import gain_claims
from solver.tasks.design.regulator import REGULATING, Regulator, faulty_weights, given_or_identity
from solver.tasks.design.regulator_products import products_of_the_gain
from solver.tasks.design.riccati import solution_by_hamiltonian
from solver.tasks.design.riccati_checks import FLOATS, are_of, gain_check, gain_formula
from solver.tasks.design.set_point import equations_of_rest, reference_gain, set_point_checks, set_point_of
from solver.tasks.freedom import more_inputs_than_outputs
from solver.tasks.plant_options import PlantOptions
from solver.words import Phrase, Reason

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.tasks.needed import WithBoth


@dataclass(frozen=True, kw_only=True)
class OptimalTrackingOptions(PlantOptions):
    """The weights, or the gain."""

    Q: ImmutableMatrix | None = option(
        MatrixOf("n", "n"), "weight of x − x_d, n×n, symmetric and positive semidefinite (default I)"
    )
    R: ImmutableMatrix | None = option(
        MatrixOf("m", "m"), "weight of u − u_d, m×m, symmetric and positive definite (default I)"
    )
    gain: ImmutableMatrix | None = option(MatrixOf("m", "n", flat="row"), "K itself, instead of weights", answer="K")


optimal_tracking: Task[WithBoth, OptimalTrackingOptions] = Task(
    "optimal_tracking",
    title="Optimal tracking",
    doc="The control u = −K x + K_o r that brings the output to a constant r, optimal around the set point.",
    needs=("A", "B", "C"),
    options=OptimalTrackingOptions,
    answers=[
        AnswerName(
            "K",
            r"\sym{K}",
            "the gain of the feedback",
            principal=True,
            earned=REGULATING,
        ),
        AnswerName("F", "F", "the state of the set point, $x_{d} = Fr$", free=more_inputs_than_outputs),
        AnswerName("N", "N", "the input of the set point, $u_{d} = Nr$", free=more_inputs_than_outputs),
        AnswerName(
            "K_o",
            "K_o",
            "the gain of the reference",
            free=more_inputs_than_outputs,
            principal=True,
            earned=("set_point",),
        ),
    ],
    example={"Q": "[[1, 0], [0, 1]]", "R": "1"},
)
optimal_tracking.together(control_law(("-K", "x"), ("K_o", "r")))


@optimal_tracking.refusal
def wrong_weights(system: Any, options: OptimalTrackingOptions) -> Iterable[Refusal]:
    """Weights and gain together, neither, or weights that are not definite or not for this kind of time."""
    weights = [name for name in ("Q", "R") if options.has(name)]
    if options.has("gain") and weights:
        yield "gain", Reason("regulators/gain_and_weight", {"weight": weights[0]})
    if not options.has("gain") and not weights:
        yield "", Reason("regulators/no_gain")
    yield from faulty_weights(options.Q, options.R, discrete=system.discrete)


def _weights(given: Given[WithBoth, OptimalTrackingOptions]) -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """Q and R, identity matrices where they are not given."""
    return given_or_identity(given.options.Q, given.system.order), given_or_identity(
        given.options.R, given.system.B.cols
    )


@optimal_tracking.method(source="Lecture note, section 5.4")
def around_a_set_point(given: Given[WithBoth, OptimalTrackingOptions]) -> Derivation[Answers]:
    """Solve for the set point (x_d, u_d) and feed back the deviations from it."""
    plant, K = given.system, given.options.gain
    found = yield from set_point_of(plant)
    if K is None:
        K = yield from _optimal_gain(given)
    yield Step(
        "deviations",
        unclaimed="a definition: the coordinates are moved to the set point",
        figures=(Diagram("The loop with a reference.", "state_feedback_reference", {"K": r"\sym{K}", "N": "K_o"}),),
        K=K,
        given=given.options.gain is not None,
        discrete=plant.discrete,
    )
    K_o = yield from reference_gain(K, found, plant)
    return Answers(K=K, F=found.F, N=found.N, K_o=K_o)


def _optimal_gain(given: Given[WithBoth, OptimalTrackingOptions]) -> Derivation[ImmutableMatrix]:
    """Find K of the regulator of the deviations."""
    Q, R = _weights(given)
    yield Step(
        "weights",
        unclaimed="the weights are given",
        Q=Q,
        R=R,
        chosen=given.options.Q is None or given.options.R is None,
        rounded=exact.negative_by_rounding(Q),
        discrete=given.system.discrete,
    )
    problem = Regulator.of(given.system.A, given.system.B, Q, R, discrete=given.system.discrete)
    equation = yield from solution_by_hamiltonian(problem)
    P = equation.stabilizing.P
    K = equation.gain(problem.B, problem.R)
    yield Step(
        "gain", claims=gain_claims(problem, P, K), discrete=problem.discrete, steps=products_of_the_gain(problem, P)
    )
    restored: ImmutableMatrix = problem.restored(K)
    return restored


def _problem(given: Given[WithBoth, OptimalTrackingOptions]) -> optimal.Weights:
    """The plant and the weights, for the judges."""
    kind = optimal.DiscreteWeights if given.system.discrete else optimal.Weights
    return kind(given.system.A, given.system.B, *_weights(given))


@optimal_tracking.verification("K")
def is_optimal_or_given(given: Given[WithBoth, OptimalTrackingOptions], answers: Answers) -> Iterable[Check]:
    """The gain given; else K stabilizes and is optimal for the P of its own cost."""
    K = answers["K"]
    if given.options.gain is not None:
        yield numeric.check_claim(Claim(given.options.gain, K), "the gain given", answer="K")
        return
    gain = gain_formula(discrete=given.system.discrete, cross=False)
    label = Phrase("$K$ stabilizes, and $K = {gain}$ for the $P$ of its own cost", gain=gain)
    yield gain_check(_problem(given), K, "K", label)


@optimal_tracking.verification("F", "N", "K_o")
def belong_to_a_set_point(given: Given[WithBoth, OptimalTrackingOptions], answers: Answers) -> Iterable[Check]:
    """A F + B N = 0, C F + D N = I and K_o = N + K F; alone, each must go with some set point."""
    K = answers.get("K", given.options.gain)
    yield from set_point_checks(given.system, answers, K)
    if "K_o" in answers and K is None:
        weights = _problem(given)
        M, p = equations_of_rest(given.system), given.system.C.rows
        yield numeric.check_residual(
            "$K_o = N + KF$ for a set point, with the optimal $K$",
            are_of(given.system.discrete),
            lambda: design.reference_residual_at_optimum(weights, M, p, answers["K_o"]),
            FLOATS,
            answer="K_o",
        )


optimal_tracking.mistaken_question(mistakes.CONTINUOUS_RICCATI)(mistakes.in_continuous_time)


optimal_tracking.consequence("F", of=("N",))(consequences.state_of_rest)
optimal_tracking.consequence("K_o", of=("F", "N"))(consequences.reference_gain)
optimal_tracking.consequence("K_o", of=("F", "N", "K"))(consequences.reference_gain)


@optimal_tracking.meaning("K")
def instability(wrong: Attempt[WithBoth, OptimalTrackingOptions]) -> Reason | None:
    """The poles, where they are not asymptotically stable."""
    plant = wrong.given.system
    return meanings.unstable(plant.A - plant.B * wrong.value, discrete=plant.discrete)
