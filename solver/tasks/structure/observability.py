"""Observability: whether the output shows every state."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from solver.derivation import AnswerName, Answers, Attempt, Check, Derivation, Given, Refusal, Task
from solver.lazy import sympy as sp
from solver.tasks import meanings, mistakes
from solver.tasks.structure.pair_checks import checks_of
from solver.tasks.structure.pair_formulas import register
from solver.tasks.structure.pair_methods import PairOptions, by_gramian, by_pbh, by_rank, horizon_refusals
from solver.tasks.structure.pairs import observability_pair

if TYPE_CHECKING:
    from solver.systems import System
    from solver.tasks.needed import WithOutput


observability: Task[WithOutput, PairOptions] = Task(
    "observability",
    title="Observability",
    doc="Whether the output shows the state: rank of [C; CA; …], test of Hautus, or Gramian.",
    needs=("A", "C"),
    options=PairOptions,
    answers=[
        AnswerName(
            "observability_matrix",
            r"\sym{observability_matrix}",
            "the observability matrix: $C$, $CA$, …, $CA^{n-1}$ under each other",
        ),
        AnswerName(
            "determinant",
            r"\det \sym{observability_matrix}",
            "the determinant of the observability matrix",
            optional=True,
        ),
        AnswerName(
            "rank",
            r"\operatorname{rank} \sym{observability_matrix}",
            "the rank of the observability matrix (with parameters: the rank in general)",
            count=True,
            most=lambda given: given.system.order,
        ),
        AnswerName(
            "observable",
            r"\text{observable}",
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
            "unobservable_modes",
            r"\lambda_{\text{unobservable}}",
            "the eigenvalues that the output does not show",
            optional=True,
        ),
        AnswerName("exceptions", r"\text{exceptions}", "where the parameters lower the rank", optional=True),
        AnswerName("gramian", "W_o", "the Gramian", ("gramian",)),
    ],
)


@observability.refusal
def horizon_is_a_time(system: System, options: PairOptions) -> Iterable[Refusal]:
    """The horizon is positive; in discrete time a number of steps."""
    yield from horizon_refusals(system, options)


@observability.method("rank", title="Rank of the observability matrix", source="Lecture note, section 2.2")
def rank_of_the_matrix(given: Given[WithOutput, PairOptions]) -> Derivation[Answers]:
    """The pair is observable if and only if [C; CA; …; CAⁿ⁻¹] has rank n."""
    return (yield from by_rank(observability_pair(given.system)))


@observability.method("pbh", title="Test of Popov, Belevitch and Hautus", source="Lecture note, section 2.3")
def rank_at_each_eigenvalue(given: Given[WithOutput, PairOptions]) -> Derivation[Answers]:
    """The pair is observable if and only if λI − A over C has rank n at every eigenvalue λ."""
    return (yield from by_pbh(observability_pair(given.system)))


@observability.method("gramian", title="Gramian", source="Lecture note, section 2.2")
def definite_gramian(given: Given[WithOutput, PairOptions]) -> Derivation[Answers]:
    """The pair is observable if and only if its Gramian is positive definite."""
    return (yield from by_gramian(observability_pair(given.system), given.options.horizon))


@observability.verification(*observability.answers)
def by_ranks_and_defining_equations(given: Given[WithOutput, PairOptions], answers: Answers) -> Iterable[Check]:
    """The matrix by blocks, ranks by singular values, hidden modes by their polynomial, the Gramian by its equation."""
    yield from checks_of(observability_pair(given.system), given, answers)


register(observability, "observability_matrix", "observable")


observability.mistaken_question(mistakes.EXCHANGED)(mistakes.inputs_for_outputs)


@observability.mistake(mistakes.STACKED, "observability_matrix")
def stacked_the_other_way(wrong: Attempt[WithOutput, PairOptions]) -> Iterable[Any]:
    """C, CA, … beside each other."""
    plant = wrong.given.system
    yield sp.ImmutableMatrix.hstack(*(plant.C * plant.A**i for i in range(plant.order)))


observability.meaning("unobservable_modes")(meanings.hidden)
