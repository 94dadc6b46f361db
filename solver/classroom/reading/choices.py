"""The readings of a value, gone through one by one: each question is answered in one way throughout a reading."""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from dataclasses import dataclass
from typing import TypeVar

T = TypeVar("T")

MOST_READINGS = 24
"""A value of more readings tells nothing."""


@dataclass
class _Question:
    """A question that came up, how it is answered now, and how many answers it has."""

    about: Hashable
    answer: int
    answers: int


class Choices:
    """The answers of one reading; a question that was not asked before gets its first answer."""

    def __init__(self, path: list[_Question] | None = None) -> None:
        self.path = path or []

    def choose(self, about: Hashable, options: Sequence[T]) -> T:
        """Return the option of this reading; the same question has the same options each time."""
        for question in self.path:
            if question.about == about:
                return options[question.answer]
        self.path.append(_Question(about, 0, len(options)))
        return options[0]

    def next(self) -> Choices | None:
        """Return the choices of the next reading, None after the last."""
        path = list(self.path)
        while path and path[-1].answer + 1 == path[-1].answers:
            path.pop()
        if not path:
            return None
        last = path.pop()
        return Choices([*path, _Question(last.about, last.answer + 1, last.answers)])


def readings() -> Iterator[Choices]:
    """Yield the choices of every reading, up to one more than can be told; what is read asks them its questions."""
    choices: Choices | None = Choices()
    for _ in range(MOST_READINGS + 1):
        if choices is None:
            return
        yield choices
        choices = choices.next()
