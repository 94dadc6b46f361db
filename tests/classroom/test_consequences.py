"""The formulas by which answers follow from others: they lead from our own answers to our own answers."""

import pytest
import sympy as sp

from solver.classroom.judging.entries import all_right, entrywise
from solver.classroom.submitted import Submitted
from solver.decimals import exactly
from solver.derivation import Status
from solver.engine import given_of
from solver.tasks import catalogue
from tests.helpers.solved import EXAMPLES, by_problem, solution_of

QUICK = EXAMPLES[::10]
"""See `test_mutations`."""


@pytest.mark.parametrize(**by_problem(EXAMPLES, QUICK))
def test_the_formulas_lead_from_our_answers_to_ours(path):
    solution = solution_of(path)
    parts = {part.id: part for part in solution.problem.parts}
    earlier = {}
    for result in solution.parts:
        earlier.setdefault(result.id, result)
    for result in solution.parts:
        if result.status is not Status.VERIFIED:
            continue
        task = catalogue()[result.task]
        given = given_of(parts[result.id], result.method, earlier)
        for each in task.consequences:
            if not {each.name, *each.of} <= result.answers.keys():
                continue
            found = each.formula(given, {name: exactly(value) for name, value in result.answers.items()})
            if found is None:
                continue
            ours = result.answers[each.name]
            if each.completing and any(result.answers[name].has(sp.Float) for name in each.of):
                assert all(abs(sp.N(a - b)) < 1e-9 for a, b in zip(ours, found, strict=True)), (result.id, each.name)
                continue
            words = entrywise(Submitted(ours, ours), found, ordered=task.answers[each.name].ordered)
            assert words is not None, (result.id, each.name, each.of)
            assert all_right(words), (result.id, each.name, each.of, ours, found)


def test_no_answer_follows_from_itself():
    for task in catalogue().values():
        formulas = [each for each in task.consequences if not each.completing]
        below = {name: {of for each in formulas if each.name == name for of in each.of} for name in task.answers}
        for name in task.answers:
            reached = set(below[name])
            while new := set().union(*(below[each] for each in reached)) - reached:
                reached |= new
            assert name not in reached, (task.name, name)
