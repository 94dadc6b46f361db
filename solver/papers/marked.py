"""What was solved and marked before, by all it depends on: of a class marked again only what changed is marked.

What a limit had a part in is not kept: another time it may be found.
"""

from __future__ import annotations

from contextlib import suppress
from typing import Any

from solver.classroom import Marking, Submission
from solver.classroom.alike import Remembered, facts_of, places_of, values_of
from solver.document.model import Document, Presentation
from solver.engine import Solution
from solver.limits import Solved
from solver.limits.child import Reply, Unit
from solver.limits.results import Sent
from solver.papers.kept import Kept
from solver.papers.plain import NotPlain, as_plain, of_plain
from solver.problem.model import Problem

BY_LIMITS = "limits/ended"


def solved_before(kept: Kept, problem: Problem, told: Presentation | None = None) -> Solved | None:
    """Return what a problem was solved to, in words if it is told how; None where that is not known."""
    units = [Unit(part, method) for part in problem.parts for method in part.methods]
    try:
        found = of_plain(kept.get(*_facts_of_solving(problem, told)))
    except NotPlain:
        return None
    if not isinstance(found, list) or not all(isinstance(each, Sent) for each in found) or len(found) != len(units):
        return None
    return Solved(problem, [(unit, Reply(sent=each)) for unit, each in zip(units, found, strict=True)], told)


def keep_solved(kept: Kept, solved: Solved, told: Presentation | None = None) -> None:
    """Keep what a problem was solved to, if all of it lasts."""
    found = [reply.sent for _, reply in solved.replies]
    if any(each is None or (each.reason is not None and each.reason[0] == BY_LIMITS) for each in found):
        return
    with suppress(NotPlain):  # it is solved again
        kept.put(as_plain(found), *_facts_of_solving(solved.problem, told))


def _facts_of_solving(problem: Problem, told: Presentation | None) -> tuple[Any, ...]:
    return "solved", *_text_of(problem), _pictures(problem), repr(told)


def _pictures(problem: Problem) -> dict[str, str]:
    return {address: image.file_name for address, image in sorted(problem.images.items())}


def _text_of(problem: Problem) -> tuple[Any, ...]:
    return problem.file.text if problem.file is not None else repr(problem), repr(problem.display)


def worked_before(kept: Kept, solution: Solution, *told: Any) -> Document | None:
    """Return the worked solution as it was told so; None where that is not known."""
    try:
        found = of_plain(kept.get("worked", *_text_of(solution.problem), _pictures(solution.problem), repr(told)))
    except NotPlain:
        return None
    return found if isinstance(found, Document) else None


def keep_worked(kept: Kept, solution: Solution, document: Document, *told: Any) -> None:
    """Keep a worked solution."""
    with suppress(NotPlain):  # it is worded again
        kept.put(as_plain(document), "worked", *_text_of(solution.problem), _pictures(solution.problem), repr(told))


class MarkedBefore(Remembered):
    """Knows the markings of this run, and those that were kept."""

    def __init__(self, kept: Kept) -> None:
        super().__init__()
        self.kept = kept

    def get(self, solution: Solution, submission: Submission) -> Marking | None:
        """Return the marking of an equal submission."""
        if (found := super().get(solution, submission)) is not None:
            return found
        for facts in (values_of(submission), places_of(submission)):
            marking = _marking(self.kept.get(*_facts_of_marking(solution), facts))
            if marking is not None and facts_of(submission, marking) == facts:
                super().put(solution, submission, marking, lasts=True)
                return marking
        return None

    def put(self, solution: Solution, submission: Submission, marking: Marking, *, lasts: bool) -> None:
        """Keep a marking."""
        super().put(solution, submission, marking, lasts=lasts)
        if not lasts or any(each.reason is not None and each.reason.kind == BY_LIMITS for each in solution.parts):
            return
        with suppress(NotPlain):  # it is marked again
            self.kept.put(as_plain(marking.of("")), *_facts_of_marking(solution), facts_of(submission, marking))


def _marking(data: Any) -> Marking | None:
    try:
        found = of_plain(data)
    except NotPlain:
        return None
    return found if isinstance(found, Marking) else None


def _facts_of_marking(solution: Solution) -> tuple[Any, ...]:
    rules = [
        (part.id, str(part.marks), {name: str(each) for name, each in part.answer_marks.items()}, repr(part.partial))
        for part in solution.problem.parts
    ]
    return "marked", *_text_of(solution.problem), rules
