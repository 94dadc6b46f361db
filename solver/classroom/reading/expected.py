"""What is known of an answer before its value is read: its labels, its words, its unit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from solver.classroom.reading.labels import Labels
from solver.derivation import AnswerName


@dataclass(frozen=True)
class Expected:
    """The answer that a value is submitted for; by default nothing is known of it."""

    name: str = ""
    labels: Labels = field(default_factory=Labels)
    words: tuple[str, ...] = ()
    unit: str = ""

    @classmethod
    def of(cls, name: str, answers: Mapping[str, AnswerName]) -> Expected:
        """Return what is expected of one of the answers of a task."""
        answer = answers[name]
        others = [other for other in answers.values() if other.name != name]
        return cls(name, Labels(answer, others), answer.words, answer.unit)
