"""Marking within limits of time and memory: one answer file in a child process, or those of a class by an executor."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING
from uuid import uuid4

from solver.classroom.alike import Memory, Remembered, values_of
from solver.classroom.marking import Marker, mark
from solver.classroom.reading.answer_file import Submission
from solver.classroom.same import Same
from solver.classroom.verdicts import Marking
from solver.engine import Solution
from solver.executors import Executor
from solver.limits import Exceeded, Limits, call_within
from solver.problem.model import Problem

if TYPE_CHECKING:
    from solver.limits.results import Sent

Paper = tuple[Solution, Submission]
"""A solved problem and what was submitted to it."""

KEPT = 64
"""So many solutions are kept by a process that marks: an exam asks for each question in a few variants."""


def mark_within(solution: Solution, submission: Submission, limits: Limits, templates: Path | None = None) -> Marking:
    """Return the marking, judged in a child process; a part that meets a limit is not judged, the others are."""
    return next(_judged([(solution, submission)], limits, templates, None))[0]


def mark_each(
    papers: Sequence[Paper],
    limits: Limits,
    templates: Path | None = None,
    executor: Executor | None = None,
    memory: Memory | None = None,
) -> Iterator[Marking]:
    """Yield the marking of each submission, in their order, judged by the executor if there is one.

    Equal answers are judged once, and not at all where the memory knows them. A file that meets a limit is judged
    again, part by part: what met the limit in it is not judged.
    """
    known = memory or Remembered()
    first: dict[tuple[Same[Solution], str], int] = {}
    for place, paper in enumerate(papers):
        if known.get(*paper) is None:
            first.setdefault((Same(paper[0]), values_of(paper[1])), place)
    called = set(first.values())
    judged = _judged([papers[place] for place in sorted(called)], limits, templates, executor)
    for place, paper in enumerate(papers):
        marking = None if place in called else known.get(*paper)
        if marking is None:  # beside those called: the same answers at places that the other marking names
            new = judged if place in called else _judged([paper], limits, templates, executor)
            marking, lasts = next(new)
            known.put(*paper, marking, lasts=lasts)
        yield marking.of(paper[1].student)


def _judged(
    papers: Sequence[Paper], limits: Limits, templates: Path | None, executor: Executor | None
) -> Iterator[tuple[Marking, bool]]:
    """Yield the marking of each submission, and whether it lasts: no limit had a part in it."""
    if executor is None:
        found: Iterator[Marking | Exceeded] = (_whole(*paper, limits, templates) for paper in papers)
    else:
        packed = {id(solution): _packed(solution) for solution, _ in papers}
        calls = ((packed[id(solution)], submission, templates) for solution, submission in papers)
        found = executor.in_order(limits, mark_packed, calls)
    for paper, marking in zip(papers, found, strict=True):
        if isinstance(marking, Exceeded):
            yield _part_by_part(*paper, limits, templates), False
        else:
            yield marking, True


def _whole(solution: Solution, submission: Submission, limits: Limits, templates: Path | None) -> Marking | Exceeded:
    """Return the marking, judged in a child process, or the limit that it met."""
    try:
        marking: Marking = call_within(limits, mark, solution, submission, templates)
    except Exceeded as limit:
        return limit
    return marking


@dataclass(frozen=True, slots=True)
class _Packed:
    """A solution as it is sent: its answers as plain data. It is known by its key."""

    key: str
    problem: Problem = field(compare=False)
    parts: tuple[Sent, ...] = field(compare=False)


def mark_packed(solution: _Packed, submission: Submission, templates: Path | None) -> Marking:
    """Return the marking of a submission to a solved problem that was sent here."""
    return mark(_unpacked(solution), submission, templates)


def _packed(solution: Solution) -> _Packed:
    from solver.limits.results import sent  # noqa: PLC0415 - who marks one file sends none

    return _Packed(uuid4().hex, replace(solution.problem, images={}), tuple(map(sent, solution.parts)))


@lru_cache(KEPT)
def _unpacked(packed: _Packed) -> Solution:
    return Solution(packed.problem, tuple(each.result() for each in packed.parts))


def _part_by_part(solution: Solution, submission: Submission, limits: Limits, templates: Path | None) -> Marking:
    """Return the marking with the limits for each part."""
    marker = Marker(solution, submission, templates)
    parts = tuple(marker.within(part, limits) for part in solution.problem.parts)
    return Marking(submission.student, parts, marker.remarks())
