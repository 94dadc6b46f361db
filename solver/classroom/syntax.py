"""How the values of an answer file are read, for who writes it: no verdicts, no marks, nothing of our own answers."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from solver.classroom.kinds import kind_of, like
from solver.classroom.marking import Marker, read_value
from solver.classroom.reading.answer_file import Submission
from solver.classroom.reading.spelling import typed
from solver.classroom.submitted import Submitted
from solver.engine import Solution
from solver.problem.model import Part
from solver.problem.nodes import Node
from solver.problem.source import Fault
from solver.render.wording import Wording
from solver.words import Reason


@dataclass(frozen=True, slots=True)
class Reading:
    """How a value is read: what was typed, the `kind` that it is read as, and its formulas (LaTeX).

    Several of them are several readings. None: it cannot be read, and `reason` says why (Markdown).
    """

    part: str
    name: str
    typed: str
    kind: str
    formulas: tuple[str, ...] = ()
    reason: str = ""


@dataclass(frozen=True, slots=True)
class Readings:
    """The readings of all values of a file, and remarks on what is left out."""

    student: str
    values: tuple[Reading, ...]
    remarks: tuple[str, ...]

    @property
    def all_clear(self) -> bool:
        """Whether everything in the file is read, in one way."""
        return not self.remarks and all(len(each.formulas) == 1 for each in self.values)


def readings(solution: Solution, submission: Submission, templates: Path | None = None) -> Readings:
    """Return how the values of a submission are read."""
    reader = _Readings(solution, submission, templates)
    values = [
        reader.reading(part, name, node)
        for part in solution.problem.parts
        for name, node in submission.answers.get(part.id, {}).items()
    ]
    return Readings(submission.student, tuple(values), reader.marker.remarks())


class _Readings:
    def __init__(self, solution: Solution, submission: Submission, templates: Path | None) -> None:
        self.marker = Marker(solution, submission, templates)
        self.wording = Wording.of(solution.problem.display, templates=templates)

    def reading(self, part: Part, name: str, node: Node) -> Reading:
        """Return how a value is read; one that our solution has not, by what it looks like."""
        ours = self.marker.ours(part.id).get(name)
        kind = kind_of(like(node) if ours is None else ours)
        unread, found = self.marker.unread[part.id].get(name), self.marker.values[part.id].get(name)
        if found is None and unread is None:
            found, unread = self._by_looks(part, node)
        reason = self.marker.messages.reason(unread) if unread is not None else ""
        formulas = tuple(self._formula(each) for each in (found, *found.others)) if found is not None else ()
        return Reading(part.id, name, typed(node), self.wording.say(kind), formulas, reason)

    def _by_looks(self, part: Part, node: Node) -> tuple[Submitted | None, Reason | None]:
        for kind in (like(node), ""):
            try:
                return read_value(self.marker.reader(part, {}), node, kind), None
            except Fault as fault:
                unread = fault
        return None, Reason("marking/not_read", {**_place(unread)})

    def _formula(self, read: Submitted) -> str:
        """Return the value as it is read; decimals as they were written."""
        return self.wording.answer(read.value)


def _place(fault: Fault) -> dict[str, Any]:
    what = fault.diagnostics[0]
    return {"line": what.line, "column": what.column, "message": what.message, "suggestion": "", "note": what.note}
