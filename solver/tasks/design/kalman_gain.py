"""The gains of a Kalman filter as lemmas: the regulator that is dual to it, and what follows from its solution."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.derivation import Answers, Claim, Derivation, Given, Step, lemma
from solver.derivation.figures import Diagram
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product
from solver.stated.matrices import inverse
from solver.tasks import figures
from solver.tasks.design.regulator import Regulator, given_or_identity
from solver.tasks.design.regulator_products import products_of_the_gain
from solver.words import formula

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.tasks.design.kalman_filter import KalmanFilterOptions
    from solver.tasks.needed import WithOutput

LARGEST = 3
"""Matrices with more rows are not written into boxes."""


def intensities(given: Given[WithOutput, KalmanFilterOptions]) -> tuple[ImmutableMatrix, ImmutableMatrix]:
    """Q and R, identity matrices where they are not given."""
    return given_or_identity(given.options.Q, given.system.order), given_or_identity(
        given.options.R, given.system.C.rows
    )


@lemma("kalman_gain")
def duality(given: Given[WithOutput, KalmanFilterOptions]) -> Derivation[Regulator]:
    """Show the intensities, and the regulator problem that is solved in place of the filter's."""
    Q, R = intensities(given)
    A, C = (sp.ImmutableMatrix(M.T) for M in (given.system.A, given.system.C))
    yield Step(
        "intensities",
        unclaimed="the intensities are given, and transposing is no calculation",
        Q=Q,
        R=R,
        At=A,
        Ct=C,
        chosen=given.options.Q is None or given.options.R is None,
        rounded=exact.negative_by_rounding(Q),
        discrete=given.system.discrete,
    )
    return Regulator.of(A, C, Q, R, dual=True, discrete=given.system.discrete)


@lemma("kalman_gain")
def filter_of(plant: WithOutput, problem: Regulator, equation: exact.Riccati) -> Derivation[Answers]:
    """Find L = P Cᵀ R⁻¹, or the two gains of discrete time, and the matrix of the error."""
    P, C, discrete = equation.stabilizing.P, problem.Bt, problem.discrete
    L = sp.ImmutableMatrix(equation.gain(problem.B, problem.R).T)
    current = (yield from _current_gain(problem, equation)) if isinstance(equation, exact.DiscreteRiccati) else None
    if current is None:
        claims = {"L": Claim(product(P, problem.B, inverse(problem.R)), L, "the gain of the filter")}
        yield Step("gain", claims=claims, L=L, steps=products_of_the_gain(problem, P))
    else:
        claims = {"L": Claim(product(sp.ImmutableMatrix(problem.A.T), current), L, "the gain of the filter")}
        yield Step("prediction", claims=claims, L=L)
    A = sp.ImmutableMatrix(problem.A.T)
    expand = exact.expanded_around_roots if discrete else sp.expand
    error = sp.ImmutableMatrix((A - L * C).applyfunc(expand))
    yield Step(
        "error",
        claims={"error": Claim(difference(A, product(L, C)), error, "matrix of the error $A - LC$")},
        eigenvalues=equation.eigenvalues,
        discrete=discrete,
        figures=(
            *_loop(plant, problem.restored(L)),
            *figures.plane(
                "Poles of the error, without correction and with it",
                figures.eigenvalues_of("without correction", A),
                figures.roots("with correction", equation.eigenvalues, "square"),
                discrete=discrete,
            ),
            *figures.error_of_estimate(error, r"\tilde{x}" if discrete else "e", discrete=discrete),
        ),
    )
    answers = Answers(P=P, L=L, error_A=error, eigenvalues=equation.eigenvalues)
    if current is not None:
        answers["L_current"] = current
    return Answers(**{name: problem.restored(value) for name, value in answers.items()})


@lemma("kalman_gain")
def _current_gain(problem: Regulator, equation: exact.DiscreteRiccati) -> Derivation[ImmutableMatrix]:
    """Find P Cᵀ (R + C P Cᵀ)⁻¹, and the covariance that a measurement leaves."""
    P, C = equation.stabilizing.P, problem.Bt
    L = sp.ImmutableMatrix(equation.current_gain(equation.stabilizing).T)
    weight = exact.riccati_weight(problem.B, problem.R, P)
    left = sp.ImmutableMatrix((P - L * C * P).applyfunc(exact.expanded_around_roots))
    yield Step(
        "current",
        claims={
            "weight": Claim(problem.weight_of(P), weight, "the covariance of what is measured"),
            "L": Claim(product(P, problem.B, inverse(weight)), L, "the current gain"),
            "left": Claim(difference(P, product(L, C, P)), left, "the covariance after the measurement"),
        },
        L=L,
        steps=products_of_the_gain(problem, P),
    )
    return L


def _loop(plant: WithOutput, L: ImmutableMatrix) -> tuple[Diagram, ...]:
    """The filter beside its plant, with its numbers; none for a plant too large to be written into boxes."""
    if max(plant.A.rows, plant.C.rows) > LARGEST:
        return ()
    matrices = {"A": plant.A, "C": plant.C, "L": L} | ({} if plant.B is None else {"B": plant.B})
    labels = {name: formula(M[0, 0] if M.shape == (1, 1) else M) for name, M in matrices.items()}
    caption = "The Kalman filter beside its plant, which the noises $w$ and $v$ disturb"
    return (Diagram(caption, "kalman_filter" if plant.B is None else "driven_kalman_filter", labels),)
