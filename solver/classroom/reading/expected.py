"""What is known of an answer before its value is read: its labels, its words, its unit, what it counts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from solver.classroom.reading.labels import Labels
from solver.derivation import AnswerName, Given
from solver.derivation.answer_names import SignalNames


@dataclass(frozen=True)
class Expected:
    """The answer that a value is submitted for; by default nothing is known of it.

    Of an answer that is a `count`, a full one is `most`, where that can be told; a matrix may be made of `vectors`,
    "columns" or "rows"; the items of a list may be expressions that are `zero`, or `intervals`. An
    expression may be in `signals`. A list that is `continued` holds the first terms of a sequence. Vectors are `paired`
    with eigenvalues where these are another answer of the task.
    """

    name: str = ""
    labels: Labels = field(default_factory=Labels)
    words: tuple[str, ...] = ()
    unit: str = ""
    count: bool = False
    most: int | None = None
    vectors: str = ""
    zero: bool = False
    intervals: bool = False
    signals: SignalNames | None = None
    continued: bool = False
    paired: bool = False

    @classmethod
    def of(cls, name: str, answers: Mapping[str, AnswerName], given: Given[Any, Any] | None = None) -> Expected:
        """Return what is expected of one of the answers of a task, for what is given."""
        answer = answers[name]
        others = [other for other in answers.values() if other.name != name]
        most = answer.most(given) if answer.most and given else None
        labels = Labels(answer, others)
        kinds = (answer.vectors, answer.zero, answer.intervals)
        signals = answer.signals(given) if answer.signals and given else None
        continued = answer.ordered and answer.numbered
        paired = bool(answer.vectors) and "eigenvalues" in answers
        return cls(name, labels, answer.words, answer.unit, answer.count, most, *kinds, signals, continued, paired)
