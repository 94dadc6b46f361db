"""Stabilizability: whether feedback can make the system stable."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from solver.derivation import AnswerName, Answers, Check, Derivation, Given, Task
from solver.tasks import consequences, meanings
from solver.tasks.plant_options import PlantOptions
from solver.tasks.structure.pairs import controllability_pair
from solver.tasks.structure.weak_conditions import decay_of_hidden_modes, weak_checks

if TYPE_CHECKING:
    from solver.tasks.needed import WithInput

stabilizability: Task[WithInput, PlantOptions] = Task(
    "stabilizability",
    title="Stabilizability",
    doc="Whether every mode that the input does not reach is stable.",
    needs=("A", "B"),
    options=PlantOptions,
    answers=[
        AnswerName(
            "stabilizable",
            r"\text{stabilizable}",
            "whether every uncontrollable mode is stable",
            optional=True,
            principal=True,
            earned=("verdict", "decay"),
        ),
        AnswerName("hidden_modes", r"\lambda_{\text{hidden}}", "the uncontrollable eigenvalues"),
        AnswerName(
            "condition",
            r"\text{condition}",
            "for which parameters the system is stabilizable, where it depends on them",
            optional=True,
            principal=True,
        ),
    ],
)


@stabilizability.method(source="Lecture note, chapter 2")
def by_hidden_modes(given: Given[WithInput, PlantOptions]) -> Derivation[Answers]:
    """The uncontrollable modes, and whether all of them decay by themselves."""
    return (yield from decay_of_hidden_modes(controllability_pair(given.system)))


@stabilizability.verification("stabilizable", "hidden_modes", "condition")
def hidden_modes_and_their_decay(given: Given[WithInput, PlantOptions], answers: Answers) -> Iterable[Check]:
    """The polynomial of what is hidden, where its roots lie, and for which parameters."""
    yield from weak_checks(controllability_pair(given.system), answers)


stabilizability.consequence("stabilizable", of=("hidden_modes",), symbolic=False)(consequences.modes_decay)


stabilizability.meaning("hidden_modes")(meanings.hidden)
