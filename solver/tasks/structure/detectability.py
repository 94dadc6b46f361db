"""Detectability: whether an observer can make its error vanish."""

from __future__ import annotations

from collections.abc import Iterable

from solver.derivation import AnswerName, Answers, Check, Derivation, Given, Task
from solver.tasks.structure.pairs import observability_pair
from solver.tasks.structure.weak_conditions import decay_of_hidden_modes, weak_checks

detectability = Task(
    "detectability",
    group="Representation and analysis",
    title="Detectability",
    doc="Whether every mode that the output does not show is stable.",
    needs=("A", "C"),
    answers=[
        AnswerName("detectable", r"\text{detectable}", "whether every unobservable mode is stable"),
        AnswerName("hidden_modes", r"\lambda_{\text{hidden}}", "the unobservable eigenvalues"),
    ],
)


@detectability.method(source="Lecture note, chapter 2")
def by_hidden_modes(given: Given) -> Derivation[Answers]:
    """The unobservable modes, and whether all of them decay by themselves."""
    return (yield from decay_of_hidden_modes(observability_pair(given.system)))


@detectability.verification("detectable", "hidden_modes")
def hidden_modes_and_their_decay(given: Given, answers: Answers) -> Iterable[Check]:
    """The polynomial of what is hidden, and where its roots lie."""
    yield from weak_checks(observability_pair(given.system), answers)
