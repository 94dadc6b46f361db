"""Marking within limits of time and memory: one answer file in a child process, or those of a class by an executor."""

from __future__ import annotations

import pickle
from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

from solver.classroom.marking import Marker, mark
from solver.classroom.reading.answer_file import Submission
from solver.classroom.verdicts import Marking
from solver.engine import Solution
from solver.executors import Executor
from solver.limits import Exceeded, Limits, call_within

Paper = tuple[Solution, Submission]
"""A solved problem and what was submitted to it."""

KEPT = 64
"""So many solutions are kept by a process that marks: an exam asks for each question in a few variants."""


def mark_within(solution: Solution, submission: Submission, limits: Limits, templates: Path | None = None) -> Marking:
    """Return the marking, judged in a child process; a part that meets a limit is not judged, the others are."""
    try:
        marking: Marking = call_within(limits, mark, solution, submission, templates)
    except Exceeded:
        return _part_by_part(solution, submission, limits, templates)
    return marking


def mark_each(
    papers: Sequence[Paper], limits: Limits, templates: Path | None = None, executor: Executor | None = None
) -> Iterator[Marking]:
    """Yield the marking of each submission, in their order, judged by the executor if there is one.

    A file that meets a limit is judged again, part by part: what met the limit in it is not judged.
    """
    if executor is None or len(papers) < 2:
        yield from (mark_within(*paper, limits, templates) for paper in papers)
        return
    packed = {id(solution): _packed(solution) for solution, _ in papers}
    calls = ((packed[id(solution)], submission, templates) for solution, submission in papers)
    for paper, marking in zip(papers, executor.in_order(limits, mark_packed, calls), strict=True):
        yield _part_by_part(*paper, limits, templates) if isinstance(marking, Exceeded) else marking


def mark_packed(solution: bytes, submission: Submission, templates: Path | None) -> Marking:
    """Return the marking of a submission to a solved problem that was sent here."""
    return mark(_unpacked(solution), submission, templates)


def _packed(solution: Solution) -> bytes:
    """Return a solution as it is sent: its answers as plain data."""
    from solver.limits.results import sent  # noqa: PLC0415 - who marks one file sends none

    return pickle.dumps((replace(solution.problem, images={}), tuple(map(sent, solution.parts))))


@lru_cache(KEPT)
def _unpacked(packed: bytes) -> Solution:
    problem, parts = pickle.loads(packed)  # noqa: S301 - of this program, through a pipe of its own
    return Solution(problem, tuple(each.result() for each in parts))


def _part_by_part(solution: Solution, submission: Submission, limits: Limits, templates: Path | None) -> Marking:
    """Return the marking with the limits for each part."""
    marker = Marker(solution, submission, templates)
    parts = tuple(marker.within(part, limits) for part in solution.problem.parts)
    return Marking(submission.student, parts, marker.remarks())
