"""The minimal solution of a Riccati equation, where it is not the stabilizing one: a lemma, and how it is judged."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Check, CheckStatus, Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.numeric.judges import optimal as judges
from solver.stated.algebra import product
from solver.tasks.design.regulator import Regulator
from solver.tasks.design.riccati_checks import holds, solution_checks
from solver.tasks.design.riccati_claims import residual_claim

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.numeric.judges.optimal import Weights

MINIMAL = AnswerName(
    "minimal_solution",
    r"P_{\min}",
    "the smallest positive semidefinite solution, where it is not the stabilizing one",
    ("riccati",),
    optional=True,
)


@lemma("minimal_solution")
def minimal_solution_of(problem: Regulator, listed: list[ImmutableMatrix] | None) -> Derivation[ImmutableMatrix | None]:
    """Show the cost of leaving alone what Q does not see; returns None where that is stabilizing, or has no form."""
    try:
        found = exact.minimal_solution(problem.A, problem.B, problem.Q, problem.R, discrete=problem.discrete)
    except exact.NotExact:
        return None
    if found is None:
        return None
    V = found.unseen
    zero = sp.ImmutableMatrix(sp.zeros(*V.shape))
    yield Step(
        "minimal",
        claims={
            "residual": residual_claim(problem, found.P),
            "unseen": Claim(product(problem.Q, V), zero, "what the weight does not see"),
            "free": Claim(product(found.P, V), zero, "what costs nothing"),
        },
        P=found.P,
        unseen=V,
        modes=found.modes,
        number=listed.index(found.P) + 1 if listed is not None and found.P in listed else None,
        **problem.names,
    )
    restored: ImmutableMatrix = problem.restored(found.P)
    return restored


def minimal_checks(weights: Weights, P: Any) -> Iterable[Check]:
    """P solves the equation, is positive semidefinite, and vanishes where the weight of the state sees nothing."""
    checks = list(solution_checks(weights, P, r"$P_{\min}$", "minimal_solution"))
    yield from checks
    if all(check.status is not CheckStatus.FAILED for check in checks):
        label = r"$P_{\min}$ is positive semidefinite, and zero on the states that $Q$ does not see"
        yield holds(label, "numpy.linalg.svd", lambda: judges.is_minimal(weights, P), "minimal_solution")
