"""The solutions of a class: found by processes, the same for every number of them, and none is solved by the parent."""

import os
import sys

import pytest

from solver.executors import Processes
from solver.limits import Limits, child, solve_within
from solver.papers.exam.solved import solve_each
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.helpers.difficult_task import difficult, problem_text
from tests.helpers.small_problems import GOOD

pytestmark = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the task is known to forked children")
SINGULAR = "system: {A: [[0, 1], [-2, -3]]}\nfind: {a: {task: similarity_transformation, T: [[1, 1], [1, 1]]}}\n"


@pytest.fixture
def read(monkeypatch):
    monkeypatch.setitem(catalogue(), "difficult", difficult)
    return lambda text: read_problem(Source("q.yaml", text), catalogue())


def told(solution):
    parts = solution.parts
    return [(part.id, part.method, part.status, dict(part.answers.items()), str(part.reason)) for part in parts]


def test_only_the_part_that_is_stuck_or_dead_or_too_large_is_lost(read, monkeypatch, loaded):
    asked = [("easy", "endless", "easy"), ("deadly", "easy"), ("greedy", "buggy")]
    problems = [read(text) for text in (GOOD, *(problem_text(*each) for each in asked), GOOD.replace("-3", "-4"))]
    limits, here = Limits(2.0, 64), os.getpid()
    expected = [told(solve_within(each, limits).solution()) for each in problems]
    begin = child.Child.__init__

    def elsewhere(self):
        assert os.getpid() != here
        begin(self)

    monkeypatch.setattr(child.Child, "__init__", elsewhere)
    for jobs in (1, 3):
        with Processes(jobs, "fork") as executor:
            found = solve_each(problems, limits, executor)
        assert [each.problem for each in found] == problems
        assert list(map(told, found)) == expected


def test_a_question_that_is_wrong_as_it_is_asked_is_told_in_its_place(read, loaded):
    problems = [read(GOOD), read(SINGULAR)]
    with pytest.raises(InputError) as expected:
        solve_within(problems[1])
    with Processes(2, "fork") as executor, pytest.raises(InputError) as found:
        solve_each(problems, Limits(), executor)
    assert str(found.value) == str(expected.value)
