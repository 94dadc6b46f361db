"""What makes the answers of `stability` right: eigenvalues found by numbers, equations put to the test."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Check, Claim, Given, Task
from solver.lazy import numeric
from solver.lazy import sympy as sp
from solver.numeric.judges import linear_algebra, stability
from solver.tasks.stability.lyapunov_equation import left_side

if TYPE_CHECKING:
    from solver.systems import StateSpace
    from solver.tasks.stability.stability import StabilityOptions

BY_EIGENVALUES = "numpy.linalg.eigvals; on the boundary ranks with 100 digits"


def is_where_the_eigenvalues_are(given: Given[StateSpace, StabilityOptions], answers: Answers) -> Iterable[Check]:
    """Inside, on the boundary without chains, or else: at several values of the parameters."""
    found = {each.verdict for each in stability.locations(given.system.A, discrete=given.system.discrete)}
    yield Check.that("the verdict is that of the eigenvalues", BY_EIGENVALUES, found == {str(answers["verdict"])})


def is_bounded_near_the_eigenvalues(given: Given[StateSpace, StabilityOptions], answers: Answers) -> Iterable[Check]:
    """C (sI − A)⁻¹ B has no pole at an eigenvalue that is not inside; B or C that is not given is I."""
    plant = given.system
    identity = sp.ImmutableMatrix(sp.eye(plant.order))
    B, C = (identity if M is None else M for M in (plant.B, plant.C))
    points = stability.spread_points([plant.A, B, C], 4)
    found = {stability.externally_stable(plant.A, B, C, point, discrete=plant.discrete) for point in points}
    yield Check.that(
        r"$C(sI - A)^{-1}B$ near the eigenvalues that are not inside",
        "mpmath.inverse",
        found == {bool(answers["bibo_stable"])},
    )


def are_the_roots(given: Given[StateSpace, StabilityOptions], answers: Answers) -> Iterable[Check]:
    """det(xI − A) = Π(x − λᵢ) at random x."""
    yield numeric.check_residual(
        r"$\det(xI - A) = \prod_i (x - \lambda_i)$",
        "numpy.linalg.det",
        lambda: linear_algebra.spectrum_residual(given.system.A, answers["eigenvalues"]),
    )


def solves_the_equation(given: Given[StateSpace, StabilityOptions], answers: Answers) -> Iterable[Check]:
    """The equation itself, entry by entry."""
    A, P = given.system.A, answers["P"]
    Q = given.options.Q if given.options.Q is not None else sp.ImmutableMatrix(sp.eye(A.rows))
    left = left_side(A, P, dual=bool(given.options.dual), discrete=given.system.discrete)
    yield numeric.check_claim(Claim(left, sp.ImmutableMatrix(-Q)), "$P$ put into Lyapunov's equation")


def follows_row_by_row(given: Given[StateSpace, StabilityOptions], answers: Answers) -> Iterable[Check]:
    """The first rows from the coefficients, each further row from the two above it."""
    fault = stability.routh_fault(given.system.A, answers["array"], discrete=given.system.discrete)
    yield replace(Check.that("each row follows from the two above it", "mpmath", not fault), reason=fault)


def counts_the_eigenvalues_outside(given: Given[StateSpace, StabilityOptions], answers: Answers) -> Iterable[Check]:
    """The number of eigenvalues with positive real part (discrete: outside the unit circle)."""
    found = {each.outside for each in stability.locations(given.system.A, discrete=given.system.discrete)}
    holds = len(found) == 1 and answers["right_half_plane_roots"] == next(iter(found))
    yield Check.that("the number of eigenvalues outside", BY_EIGENVALUES, bool(holds))


def register(task: Task[Any, Any]) -> None:
    """Register the judges of the task's answers, one for each."""
    judges = {
        "verdict": is_where_the_eigenvalues_are,
        "bibo_stable": is_bounded_near_the_eigenvalues,
        "eigenvalues": are_the_roots,
        "P": solves_the_equation,
        "array": follows_row_by_row,
        "right_half_plane_roots": counts_the_eigenvalues_outside,
    }
    for name, judge in judges.items():
        task.verification(name)(judge)
