"""The judges of regulators and filters: by the defining properties of what was asked, in floats or with many digits."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from solver.derivation import Check, CheckStatus
from solver.lazy import numeric
from solver.numeric.judges import optimal as judges
from solver.words import Phrase

if TYPE_CHECKING:
    from solver.numeric.judges.optimal import Weights

FLOATS = 1e-8
"""Tolerance of comparisons with what scipy finds in floats."""


def are_of(discrete: bool) -> str:
    """The name of scipy's solver of the Riccati equation."""
    return "scipy.linalg.solve_discrete_are" if discrete else "scipy.linalg.solve_continuous_are"


def cost_oracle(discrete: bool) -> str:
    """What finds the cost of a gain."""
    return "the steps simulated, and their costs summed up" if discrete else "scipy.linalg.solve_continuous_lyapunov"


def gain_formula(*, discrete: bool, cross: bool) -> str:
    """The gain by P, as LaTeX."""
    if discrete and cross:
        return "(R + B^{T}PB)^{-1}(B^{T}PA + N^{T})"
    if discrete:
        return "(R + B^{T}PB)^{-1}B^{T}PA"
    return "R^{-1}(B^{T}P + N^{T})" if cross else "R^{-1}B^{T}P"


def solution_checks(weights: Weights, P: Any, name: str = "$P$", answer: str = "P") -> Iterable[Check]:
    """P is real and symmetric and solves the Riccati equation."""
    yield numeric.check_residual(
        Phrase("{name} is real and symmetric", name=name),
        "numpy",
        lambda: judges.symmetry_residual(weights, P),
        answer=answer,
    )
    yield numeric.check_residual(
        Phrase("{name} solves the Riccati equation", name=name),
        "residual",
        lambda: judges.riccati_residual(weights, P),
        answer=answer,
        sides=judges.riccati_sides(weights, P),
    )


def stabilizing_checks(weights: Weights, P: Any, loop: str) -> Iterable[Check]:
    """P is the stabilizing solution."""
    checks = list(solution_checks(weights, P))
    yield from checks
    if all(check.status is not CheckStatus.FAILED for check in checks):
        where = "${loop}$ has all eigenvalues in the open left half plane"
        within = "${loop}$ has all eigenvalues inside of the unit circle"
        label = Phrase(within if weights.discrete else where, loop=loop)
        yield holds(label, "numpy.linalg.eigvals", lambda: judges.stabilizes(weights, P), "P")


def holds(label: str, oracle: str, question: Any, answer: str) -> Check:
    """Return the check of a question of yes or no; skipped with the reason where it cannot be decided."""
    try:
        return Check.that(label, oracle, question(), answer=answer)
    except numeric.ShapeMismatch:
        return Check.that(label, oracle, False, answer=answer)
    except numeric.Undefined:
        return Check.that(label, oracle, False, answer=answer)
    except numeric.NotEvaluable as refusal:
        return Check.skipped(label, oracle, refusal.reason, answer=answer)


def gain_check(weights: Weights, K: Any, answer: str, label: str) -> Check:
    """The gain is optimal: it stabilizes, and is R⁻¹BᵀP for the P of its own cost, or what that is in discrete time."""
    oracle = cost_oracle(weights.discrete)
    return numeric.check_residual(label, oracle, lambda: judges.gain_residual(weights, K), FLOATS, answer=answer)


def loop_check(weights: Weights, loop: Any, answer: str, label: str) -> Check:
    """The closed loop (given as that of the regulator's form) is the optimal one."""
    return numeric.check_residual(
        label, are_of(weights.discrete), lambda: judges.loop_residual(weights, loop), FLOATS, answer=answer
    )


def spectrum_check(weights: Weights, eigenvalues: Sequence[Any]) -> Check:
    """They are the stable eigenvalues of the Hamiltonian matrix, or of the symplectic pencil."""
    return numeric.check_residual(
        "the eigenvalues of the symplectic pencil inside of the unit circle"
        if weights.discrete
        else "the stable eigenvalues of the Hamiltonian matrix",
        "numpy.linalg.det",
        lambda: judges.hamiltonian_spectrum_residual(weights, eigenvalues),
        FLOATS,
        answer="eigenvalues",
    )


def equations_check(weights: Weights, equations: Sequence[Any]) -> Check:
    """They are the entries of the Riccati equation, in any order and scale."""
    return numeric.check_residual(
        "the entries of the Riccati equation at random $P$",
        "random points",
        lambda: judges.equations_residual(weights, equations),
    )


def listed_checks(weights: Weights, answers: Any) -> Iterable[Check]:
    """Each of the solutions solves the equation, none is missing, and each word of definiteness is right."""
    solutions = answers.get("solutions")
    words = answers.get("definiteness")
    if solutions is not None:
        for number, P in enumerate(solutions, 1):
            yield from solution_checks(weights, P, Phrase("solution {number}", number=number), "solutions")
        distinct = holds("no solution is listed twice", "numpy", lambda: judges.all_distinct(weights, solutions),
                         "solutions")  # fmt: skip
        yield distinct
        yield holds("no solution is missing", "invariant subspaces in floats",
                    lambda: judges.none_missing(weights, solutions), "solutions")  # fmt: skip
    if words is not None:
        yield holds(
            "definiteness of each solution",
            "numpy.linalg.eigvalsh",
            lambda: judges.definiteness_holds(weights, words, solutions),
            "definiteness",
        )
