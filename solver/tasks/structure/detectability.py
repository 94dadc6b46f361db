"""Detectability: whether an observer can make its error vanish."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from solver.derivation import AnswerName, Answers, Check, Derivation, Given, Task
from solver.tasks import consequences, meanings
from solver.tasks.plant_options import PlantOptions
from solver.tasks.structure.pairs import observability_pair
from solver.tasks.structure.weak_conditions import decay_of_hidden_modes, weak_checks

if TYPE_CHECKING:
    from solver.tasks.needed import WithOutput

detectability: Task[WithOutput, PlantOptions] = Task(
    "detectability",
    title="Detectability",
    doc="Whether every mode that the output does not show is stable.",
    needs=("A", "C"),
    options=PlantOptions,
    answers=[
        AnswerName(
            "detectable",
            r"\text{detectable}",
            "whether every unobservable mode is stable",
            optional=True,
            principal=True,
            earned=("verdict", "decay"),
        ),
        AnswerName("hidden_modes", r"\lambda_{\text{hidden}}", "the unobservable eigenvalues"),
        AnswerName(
            "condition",
            r"\text{condition}",
            "for which parameters the system is detectable, where it depends on them",
            optional=True,
            principal=True,
        ),
    ],
)


@detectability.method(source="Lecture note, chapter 2")
def by_hidden_modes(given: Given[WithOutput, PlantOptions]) -> Derivation[Answers]:
    """The unobservable modes, and whether all of them decay by themselves."""
    return (yield from decay_of_hidden_modes(observability_pair(given.system)))


@detectability.verification("detectable", "hidden_modes", "condition")
def hidden_modes_and_their_decay(given: Given[WithOutput, PlantOptions], answers: Answers) -> Iterable[Check]:
    """The polynomial of what is hidden, where its roots lie, and for which parameters."""
    yield from weak_checks(observability_pair(given.system), answers)


detectability.consequence("detectable", of=("hidden_modes",), symbolic=False)(consequences.modes_decay)


detectability.meaning("hidden_modes")(meanings.hidden)
