"""Marking within limits of time and memory, in child processes: one answer file, or those of a class."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from solver.classroom.marking import Marker, mark
from solver.classroom.reading.answer_file import Submission
from solver.classroom.verdicts import Marking
from solver.engine import Solution
from solver.limits import Exceeded, Limits, calls_within

Paper = tuple[Solution, Submission]
"""A solved problem and what was submitted to it."""


def mark_within(solution: Solution, submission: Submission, limits: Limits, templates: Path | None = None) -> Marking:
    """Return the marking, judged in a child process; a part that meets a limit is not judged, the others are."""
    return next(mark_each([(solution, submission)], limits, templates))


def mark_each(
    papers: Sequence[Paper], limits: Limits, templates: Path | None = None, jobs: int = 1
) -> Iterator[Marking]:
    """Yield the marking of each submission, in their order, judged by so many processes.

    A file that meets a limit is judged again, part by part: what met the limit in it is not judged.
    """
    found: dict[int, Marking | Exceeded] = {}
    given = 0
    for place, result in calls_within(limits, mark, [(*paper, templates) for paper in papers], jobs):
        found[place] = result
        while given in found:
            marking = found.pop(given)
            yield _part_by_part(*papers[given], limits, templates) if isinstance(marking, Exceeded) else marking
            given += 1


def _part_by_part(solution: Solution, submission: Submission, limits: Limits, templates: Path | None) -> Marking:
    """Return the marking with the limits for each part."""
    marker = Marker(solution, submission, templates)
    parts = tuple(marker.within(part, limits) for part in solution.problem.parts)
    return Marking(submission.student, parts, marker.remarks())
