"""Controllability: whether the input reaches every state."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Attempt, Check, Derivation, Given, Refusal, Task
from solver.lazy import sympy as sp
from solver.tasks import meanings, mistakes
from solver.tasks.structure.pair_checks import checks_of
from solver.tasks.structure.pair_formulas import register
from solver.tasks.structure.pair_methods import PairOptions, by_gramian, by_pbh, by_rank, horizon_refusals
from solver.tasks.structure.pairs import controllability_pair

if TYPE_CHECKING:
    from solver.systems import System
    from solver.tasks.needed import WithInput


controllability: Task[WithInput, PairOptions] = Task(
    "controllability",
    title="Controllability",
    doc="Whether the input can take the state anywhere: rank of [B, AB, …], test of Hautus, or Gramian.",
    needs=("A", "B"),
    options=PairOptions,
    answers=[
        AnswerName(
            "controllability_matrix",
            r"\sym{controllability_matrix}",
            r"the controllability matrix $[B, AB, \ldots, A^{n-1}B]$",
        ),
        AnswerName(
            "determinant",
            r"\det \sym{controllability_matrix}",
            "the determinant of the controllability matrix",
            optional=True,
        ),
        AnswerName(
            "rank",
            r"\operatorname{rank} \sym{controllability_matrix}",
            "the rank of the controllability matrix (with parameters: the rank in general)",
            count=True,
            most=lambda given: given.system.order,
        ),
        AnswerName(
            "controllable",
            r"\text{controllable}",
            "whether the rank is $n$",
            principal=True,
            earned=(
                "matrix",
                "determinant",
                "verdict",
                "motion",
                "eigenvalue",
                "solution",
                "definite",
                "integral",
                "independence",
                "sum",
            ),
        ),
        AnswerName(
            "uncontrollable_modes",
            r"\lambda_{\text{uncontrollable}}",
            "the eigenvalues that the input does not reach",
            optional=True,
        ),
        AnswerName("exceptions", r"\text{exceptions}", "where the parameters lower the rank", optional=True),
        AnswerName("gramian", "W_c", "the Gramian", ("gramian",)),
    ],
)


@controllability.refusal
def horizon_is_a_time(system: System, options: PairOptions) -> Iterable[Refusal]:
    """The horizon is positive; in discrete time a number of steps."""
    yield from horizon_refusals(system, options)


@controllability.method("rank", title="Rank of the controllability matrix", source="Lecture note, section 2.1")
def rank_of_the_matrix(given: Given[WithInput, PairOptions]) -> Derivation[Answers]:
    """The pair is controllable if and only if [B, AB, …, Aⁿ⁻¹B] has rank n."""
    return (yield from by_rank(controllability_pair(given.system)))


@controllability.method("pbh", title="Test of Popov, Belevitch and Hautus", source="Lecture note, section 2.3")
def rank_at_each_eigenvalue(given: Given[WithInput, PairOptions]) -> Derivation[Answers]:
    """The pair is controllable if and only if [λI − A, B] has rank n at every eigenvalue λ."""
    return (yield from by_pbh(controllability_pair(given.system)))


@controllability.method("gramian", title="Gramian", source="Lecture note, section 2.1")
def definite_gramian(given: Given[WithInput, PairOptions]) -> Derivation[Answers]:
    """The pair is controllable if and only if its Gramian is positive definite."""
    return (yield from by_gramian(controllability_pair(given.system), given.options.horizon))


@controllability.verification(*controllability.answers)
def by_ranks_and_defining_equations(given: Given[WithInput, PairOptions], answers: Answers) -> Iterable[Check]:
    """The matrix by blocks, ranks by singular values, hidden modes by their polynomial, the Gramian by its equation."""
    yield from checks_of(controllability_pair(given.system), given, answers)


register(controllability, "controllability_matrix", "controllable")


controllability.mistaken_question(mistakes.EXCHANGED)(mistakes.inputs_for_outputs)


@controllability.mistake(mistakes.STACKED, "controllability_matrix")
def stacked_the_other_way(wrong: Attempt[WithInput, PairOptions]) -> Iterable[Any]:
    """B, AB, … one below the other."""
    plant = wrong.given.system
    yield sp.ImmutableMatrix.vstack(*(plant.A**i * plant.B for i in range(plant.order)))


controllability.meaning("uncontrollable_modes")(meanings.hidden)
