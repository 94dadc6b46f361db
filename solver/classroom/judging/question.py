"""A part as it is judged, and the verification of its task made on what was submitted."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from solver.classroom.submitted import Submitted
from solver.derivation import Answers, Check, Given, Task
from solver.lazy import numeric
from solver.problem.model import DIGITS

STRANGE = (ValueError, TypeError, LookupError, ArithmeticError, AttributeError, NotImplementedError)
"""What a verification may raise on a value of a form it was never meant for."""


@dataclass(frozen=True)
class Question:
    """A part as it is judged: the task, what is given, and our own verified answers (kind and shape of values).

    A decimal must have `digits` significant ones, or be right as the exact number that it is.
    """

    task: Task[Any, Any]
    given: Given[Any, Any]
    ours: Mapping[str, Any]
    digits: int = DIGITS


def checks_of(question: Question, values: Mapping[str, Submitted]) -> list[Check] | None:
    """Return the checks of some values, None where the verification can't work on them."""
    answers = Answers(**{name: each.value for name, each in values.items()})
    try:
        with numeric.typed_decimals(any(each.decimals for each in values.values())):
            return list(question.task.verify(question.given, answers))
    except STRANGE:
        return None
