"""The questions of the table of growth: every task is asked by each of its methods, and solved."""

import pytest

from benchmarks.growth import part
from benchmarks.questions import LARGEST, asked
from solver.derivation import Status
from solver.engine import solve_part
from solver.tasks import catalogue
from tests.helpers.shares import turn

QUESTIONS = list(asked())
SIZED = [pytest.param(*each, n, marks=turn(f"{each} {n}", 2 * n)) for n in (2, 8) for each in QUESTIONS]
"""Small ones in four turns, large ones in sixteen."""
FEW = [("response", "z_transform", "dense"), ("observer", "unity_rank", "companion"), ("lqr", "hamiltonian", "random")]


def is_verified(task, method, kind, n=2):
    return solve_part(part(task, method, n, kind), {})[0].status is Status.VERIFIED


def test_every_method_of_every_task_is_asked():
    methods = {
        (name, each.name) for name, task in catalogue().items() for each in task.methods.values() if not each.system
    }
    assert {(task, method) for task, method, _ in QUESTIONS} == methods
    for task, method, kind in QUESTIONS:
        read = part(task, method, 2, kind)
        assert (read.task, read.methods) == (task, (method,))


@pytest.mark.parametrize(("task", "method", "kind"), FEW)
def test_some_questions_are_verified(task, method, kind):
    assert is_verified(task, method, kind)


@pytest.mark.parametrize(("task", "method", "kind", "n"), SIZED)
def test_every_question_is_verified(task, method, kind, n):
    assert is_verified(task, method, kind, min(n, LARGEST.get(task, n)))
