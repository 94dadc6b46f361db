"""What a marking depends on in an answer file: equal answers, of several students or of two runs, are judged once.

Who wrote them is not part of it, and where they stand is only where the marking names a place: of a value that cannot
be read, and of what nobody asked for.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import Any, Protocol, TypeVar

from solver.classroom.reading.answer_file import Submission
from solver.classroom.same import Same
from solver.classroom.verdicts import Marking, Verdict
from solver.engine import Solution
from solver.problem.nodes import MappingNode, Node, ScalarNode, SequenceNode

SOLUTIONS = 64
"""Solutions of which a process remembers what was judged: an exam asks for each question in a few variants."""
MOST = 128
"""So much is remembered of a solution, what was asked for last."""

Value = TypeVar("Value")


class Known:
    """What was read and judged of a solved problem, by what was written: the same for every student of a class."""

    def __init__(self) -> None:
        self.known: dict[Any, Any] = {}

    def of(self, key: Any, make: Callable[[], Value]) -> Value:
        """Return what was made for the key, or make it."""
        found: Value = self.known.pop(key) if key in self.known else make()
        self.known[key] = found
        if len(self.known) > MOST:
            del self.known[next(iter(self.known))]
        return found


@lru_cache(SOLUTIONS)
def known_of(solution: Same[Solution], templates: Path | None) -> Known:  # noqa: ARG001 - what is kept apart
    """Return what is remembered of a solution, worded by these templates."""
    return Known()


class Memory(Protocol):
    """Knows markings by what was submitted to a solved problem."""

    def get(self, solution: Solution, submission: Submission) -> Marking | None:
        """Return the marking of an equal submission, whosever it is; None where there is none."""

    def put(self, solution: Solution, submission: Submission, marking: Marking, *, lasts: bool) -> None:
        """Keep a marking. One that does not last was made within limits: another time there may be another one."""


@dataclass
class Remembered:
    """Remembers markings as long as it lives."""

    known: dict[tuple[Same[Solution], str], Marking] = field(default_factory=dict)

    def get(self, solution: Solution, submission: Submission) -> Marking | None:
        """Return the marking of an equal submission."""
        facts = (values_of(submission), places_of(submission))
        return next((self.known[key] for each in facts if (key := (Same(solution), each)) in self.known), None)

    def put(self, solution: Solution, submission: Submission, marking: Marking, *, lasts: bool) -> None:  # noqa: ARG002 - as long as this lives
        """Keep a marking."""
        self.known[Same(solution), facts_of(submission, marking)] = marking.of("")


def facts_of(submission: Submission, marking: Marking) -> str:
    """Return on what of a submission its marking depends."""
    verdicts = (answer.verdict for part in marking.parts for answer in part.answers.values())
    names_places = bool(marking.remarks) or Verdict.NOT_JUDGED in verdicts
    return places_of(submission) if names_places else values_of(submission)


def values_of(submission: Submission) -> str:
    """Return all that is submitted, wherever it stands."""
    answers = [[part, [[name, told(node)] for name, node in of.items()]] for part, of in submission.answers.items()]
    return json.dumps([answers, [each.message for each in submission.strange]])


def places_of(submission: Submission) -> str:
    """Return all that is submitted, with the places."""
    return f"{values_of(submission)} {submission.answers!r} {submission.strange!r}"


def told(node: Node) -> Any:
    """Return what is written, wherever it stands, as plain data."""
    match node:
        case ScalarNode():
            return [node.style, node.text]
        case SequenceNode():
            return [node.braces, list(map(told, node.items))]
        case MappingNode():
            return {"of": [[told(each.key), told(each.value)] for each in node]}
    raise AssertionError("there is no other kind of node")
