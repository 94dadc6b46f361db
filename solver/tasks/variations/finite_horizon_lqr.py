"""The regulator over a finite horizon: the feedback u = −K(t) x that minimizes c (x(T)ᵀS x(T) + ∫ xᵀQx + uᵀRu dt)."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Check, Claim, Derivation, Given, Refusal, Task
from solver.lazy import exact, numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import variations as judges
from solver.stated.algebra import product, total
from solver.stated.calculus import derivative, value_at
from solver.tasks.variations import horizon_mistakes
from solver.tasks.variations.horizon_control import control_of
from solver.tasks.variations.horizon_equation import differential_equations_of, scalar_solution, weights_of
from solver.tasks.variations.horizon_hamiltonian import solution_by_hamiltonian
from solver.tasks.variations.horizon_question import HorizonOptions, HorizonQuestion, faulty_horizon
from solver.tasks.variations.horizon_recursion import recursion_of

if TYPE_CHECKING:
    from solver.systems import System
    from solver.tasks.needed import WithInput

FLOATS = 1e-6
"""Tolerance of comparisons with what is integrated in floats."""
IVP, BATCH = "scipy.integrate.solve_ivp", "least squares over all inputs at once"

finite_horizon_lqr: Task[WithInput, HorizonOptions] = Task(
    "finite_horizon_lqr",
    title="Regulator over a finite horizon",
    doc="The feedback u = −K(t) x of least cost from 0 to T, by the Riccati differential equation.",
    needs=("A", "B"),
    options=HorizonOptions,
    answers=[
        AnswerName(
            "riccati_equations",
            r"\text{equations}",
            "the entries of the Riccati differential equation, each of which is zero (in `p11`, `p11_dot`, …)",
            optional=True,
            zero=True,
            told=("equations",),
        ),
        AnswerName(
            "P",
            "P",
            r"the solution of the Riccati equation, in $t$ (discrete: $P_0, \ldots, P_N$)",
            ordered=True,
            principal=True,
            earned=("equations", "integrated", "quotient", "step"),
        ),
        AnswerName(
            "K", r"\sym{K}", r"the gain, in $t$ (discrete: $K_0, \ldots, K_{N-1}$)", ordered=True, principal=True
        ),
        AnswerName(
            "x", "x", r"the optimal motion from $x(0)$ (discrete: $x_0, \ldots, x_N$)", optional=True, ordered=True
        ),
        AnswerName("u", "u", r"the optimal control (discrete: $u_0, \ldots, u_{N-1}$)", optional=True, ordered=True),
        AnswerName("cost", r"J^{*}", "the least cost from x(0)", optional=True),
        AnswerName("P_infinite", r"P_{\infty}", "the limit of $P(0)$ as the horizon grows", optional=True),
    ],
    example={"Q": "[[1, 0], [0, 1]]", "R": "1", "final_time": "1"},
)


@finite_horizon_lqr.refusal
def wrong_question(system: System, options: HorizonOptions) -> Iterable[Refusal]:
    """Weights that are not definite as they must be, or no horizon."""
    yield from faulty_horizon(system, options)


@finite_horizon_lqr.method("riccati", title="Riccati equation", source="Lecture note, section 5.3")
def by_the_riccati_equation(given: Given[WithInput, HorizonOptions]) -> Derivation[Answers]:
    """−P' = AᵀP + PA − P B R⁻¹ Bᵀ P + Q with P(T) = S; in discrete time the recursion from P_N = S."""
    asked = HorizonQuestion.of(given)
    if given.options.steps is not None:
        answers = yield from recursion_of(asked, given.options.steps)
        return _restored(asked, answers)
    yield from weights_of(asked)
    equations = yield from differential_equations_of(asked)
    found = exact.finite_horizon(asked.A, asked.B, asked.Q, asked.R, asked.S)
    if asked.order == 1:
        yield from scalar_solution(asked, found)
    else:
        yield from solution_by_hamiltonian(asked, found, canonical=False)
    answers = yield from control_of(asked, found)
    return _restored(asked, Answers(riccati_equations=equations, **answers))


@finite_horizon_lqr.method(
    "hamiltonian",
    title="Hamiltonian matrix",
    source="Anderson and Moore, Optimal Control, section 2.3",
    time="continuous",
)
def by_the_hamiltonian_matrix(given: Given[WithInput, HorizonOptions]) -> Derivation[Answers]:
    """State and costate by e^{−Hτ}, backwards from λ(T) = S x(T); P is what makes λ of x."""
    asked = HorizonQuestion.of(given)
    yield from weights_of(asked)
    found = exact.finite_horizon(asked.A, asked.B, asked.Q, asked.R, asked.S)
    yield from solution_by_hamiltonian(asked, found, canonical=True)
    equations = yield from differential_equations_of(asked)
    answers = yield from control_of(asked, found)
    return _restored(asked, Answers(riccati_equations=equations, **answers))


def _restored(asked: HorizonQuestion, answers: Answers) -> Answers:
    """The answers in the symbols of the problem."""
    return Answers(**{name: asked.restored(value) for name, value in answers.items()})


def _judged(
    given: Given[WithInput, HorizonOptions],
    value: Any,
    label: str,
    continuous: Callable[[Any, Any], float],
    discrete: Callable[[Any, Any], float],
) -> Check:
    """The check of a value by the judge for its kind of time."""
    horizon = HorizonQuestion.of(given).judged
    if given.options.steps is None:
        return numeric.check_residual(label, IVP, lambda: continuous(horizon, value), FLOATS)
    steps = judges.Steps(*horizon[:5], given.options.steps, *horizon[6:])
    return numeric.check_residual(label, BATCH, lambda: discrete(steps, value), FLOATS)


@finite_horizon_lqr.verification("P")
def solves_the_riccati_equation(given: Given[WithInput, HorizonOptions], answers: Answers) -> Iterable[Check]:
    """P(T) = S, the equation at random times, and the solution integrated from the end; discrete: the least costs."""
    asked, P, t = HorizonQuestion.of(given), answers["P"], sp.Symbol("t")
    if given.options.steps is None and getattr(P, "shape", None) == asked.A.shape:
        Q, S, T = (asked.restored(value) for value in (asked.Q, asked.S, asked.T))
        A, G = asked.A, asked.restored(asked.G)
        left = total(derivative(P, t), product(sp.ImmutableMatrix(A.T), P), product(P, A), Q)
        yield numeric.check_claim(Claim(left, product(P, G, P)), "the Riccati differential equation at random times")
        yield numeric.check_claim(Claim(value_at(P, t, T), S), "$P(T)$ is the terminal weight")
    label = "$P$ integrated back from the end" if given.options.steps is None else "the least costs of the steps left"
    yield _judged(given, P, label, judges.path_residual, judges.cost_matrices_residual)


@finite_horizon_lqr.verification("K")
def is_the_optimal_gain(given: Given[WithInput, HorizonOptions], answers: Answers) -> Iterable[Check]:
    """R⁻¹BᵀP with the integrated P; gains a tenth larger or smaller cost more."""
    K = answers["K"]
    label = "$R^{-1}B^{T}P$ with the integrated $P$" if given.options.steps is None else "the gains of the first input"
    check = _judged(given, K, label, judges.gain_path_residual, judges.step_gains_residual)
    yield check
    if given.options.steps is None and check.status == "passed":
        horizon = HorizonQuestion.of(given).judged
        yield Check.that(
            "simulated, gains a tenth larger or smaller cost more",
            "Runge and Kutta",
            judges.others_cost_more(horizon, K),
        )


@finite_horizon_lqr.verification("x")
def is_the_optimal_motion(given: Given[WithInput, HorizonOptions], answers: Answers) -> Iterable[Check]:
    """The motion simulated under the integrated gain; discrete: under the best inputs."""
    yield _judged(
        given, answers["x"], "the simulated motion", judges.optimal_motion_residual, judges.step_states_residual
    )


@finite_horizon_lqr.verification("u")
def is_the_optimal_control(given: Given[WithInput, HorizonOptions], answers: Answers) -> Iterable[Check]:
    """The feedback of the simulated motion; discrete: the best inputs."""
    yield _judged(
        given,
        answers["u"],
        "$u = -Kx$ along the simulated motion",
        judges.optimal_input_residual,
        judges.step_inputs_residual,
    )


@finite_horizon_lqr.verification("cost")
def is_the_least_cost(given: Given[WithInput, HorizonOptions], answers: Answers) -> Iterable[Check]:
    """x(0)ᵀP(0)x(0) with the integrated P, times the factor."""
    yield _judged(
        given, answers["cost"], "the cost from $x(0)$", judges.horizon_cost_residual, judges.steps_cost_residual
    )


@finite_horizon_lqr.verification("P_infinite")
def is_the_limit(given: Given[WithInput, HorizonOptions], answers: Answers) -> Iterable[Check]:
    """P(0) of longer and longer horizons."""
    discrete = given.options.steps is not None
    label = "$P_{0}$ of ever more steps" if discrete else "$P$ integrated over longer and longer horizons"
    yield _judged(given, answers["P_infinite"], label, judges.long_horizon_residual, judges.long_steps_residual)


@finite_horizon_lqr.verification("riccati_equations")
def are_the_entries_of_the_equation(given: Given[WithInput, HorizonOptions], answers: Answers) -> Iterable[Check]:
    """The entries of P' + AᵀP + PA − PBR⁻¹BᵀP + Q, in any order and scale."""
    asked = HorizonQuestion.of(given)
    yield numeric.check_residual(
        "the entries of the Riccati differential equation at random $P$ and $\\dot{P}$",
        "random points",
        lambda: judges.differential_equations_residual(asked.judged, answers["riccati_equations"], asked.pairs),
        FLOATS,
    )


horizon_mistakes.register(finite_horizon_lqr)
