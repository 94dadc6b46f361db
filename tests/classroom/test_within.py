"""Marking within limits: the files keep their order, and one that is stuck costs only itself."""

import sys
import time

import pytest

from solver.classroom import mark, mark_each, read_submission, within
from solver.classroom.marking import Marker
from solver.executors import Processes
from solver.limits import Limits
from solver.problem.source import Source
from tests.helpers.marked import solved

PROBLEM = """\
system: {A: [[1, 2], [3, 1]], B: [0, 1]}
find: {a: characteristic_polynomial, b: {task: pole_placement, poles: [-1, -2]}}
"""
STUDENTS = ("Ada", "stuck", "Bob", "Eve")

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the patch is known to forked children")


def papers():
    solution = solved(PROBLEM)
    texts = (
        f"student: {name}\nanswers: {{a: lambda^2 - 2lambda - 5, b: {{K: [5, {i} - {i}]}}}}"
        for i, name in enumerate(STUDENTS)
    )
    return [(solution, read_submission(Source("answers.yaml", text), solution.problem)) for text in texts]


def stuck_marking(solution, submission, templates=None):
    """Mark, but never one of the students."""
    if submission.student == "stuck":
        time.sleep(1000)
    return mark(solution, submission, templates)


def stuck_part(marker, part):
    """Judge a part, but never the second of one of the students."""
    if marker.submission.student == "stuck" and part.id == "b":
        time.sleep(1000)
    return JUDGED(marker, part)


JUDGED = Marker.part


def forked(jobs):
    """Return processes that know of patches; one after the other for one."""
    return Processes(jobs, "fork") if jobs > 1 else None


@pytest.mark.parametrize("jobs", [1, 3])
def test_the_markings_are_those_of_one_after_the_other(jobs):
    expected = [mark(*paper) for paper in papers()]
    assert list(mark_each(papers(), Limits(60), executor=forked(jobs))) == expected


@pytest.mark.parametrize("jobs", [1, 2])
def test_a_file_that_meets_the_limit_is_marked_part_by_part(monkeypatch, jobs):
    monkeypatch.setattr(within, "mark", stuck_marking)
    found = list(mark_each(papers(), Limits(3), executor=forked(jobs)))
    assert [marking.student for marking in found] == list(STUDENTS)
    assert {marking.marks for marking in found} == {found[0].marks}


def test_a_part_that_meets_the_limit_is_not_judged_and_the_other_is(monkeypatch):
    monkeypatch.setattr(Marker, "part", stuck_part)
    _, stuck, bob, _ = mark_each(papers(), Limits(3), executor=forked(2))
    assert stuck.parts[0].answers["polynomial"].verdict == "correct"
    assert stuck.parts[1].answers["K"].verdict == "not judged"
    assert "time limit of 3 s" in stuck.parts[1].note
    assert stuck.to_review == ("b.K",)
    assert bob.parts[0].answers["polynomial"].verdict == "correct"
