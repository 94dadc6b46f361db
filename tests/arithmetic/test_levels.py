"""Arithmetic is carried out only where it is told; it may be told later."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import solver.arithmetic
from solver import solve
from solver.document.model import Presentation
from solver.document.works import solve_as_told
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue

QUESTION = """\
system: {A: [[0, 1], [-6, -5]], B: [[0], [1]], C: [[1, 0]]}
find:
  a: {task: state_transition_matrix, method: laplace}
  b: {task: pole_placement, method: ackermann, poles: [-1, -2]}
"""


def details(level: str) -> set[str]:
    problem = read_problem(Source("question.yaml", QUESTION), catalogue())
    solution = solve_as_told(problem, Presentation(level))
    return {each.detail for part in solution.parts for step in part.steps for each in step.walk()}


@pytest.mark.parametrize("level", ["key", "brief", "full"])
def test_arithmetic_that_is_not_told_is_not_carried_out(level):
    assert "tutor" not in details(level)
    assert "tutor" in details("tutor")


def test_a_solution_is_told_with_its_arithmetic_afterwards():
    before, anew = solve(QUESTION).told(detail="tutor"), solve(QUESTION, detail="tutor")
    assert before.rendered("html") == anew.rendered("html")
    assert anew.told(detail="full").rendered("latex") == solve(QUESTION).rendered("latex")


def test_the_checks_of_a_page_are_those_of_what_it_carries_out():
    short, long = solve(QUESTION), solve(QUESTION, detail="tutor")
    assert all(len(few.checks) < len(many.checks) for few, many in zip(short.parts, long.parts, strict=True))


def substeps() -> list[ast.FunctionDef]:
    """The functions of the room that return substeps."""
    folder = Path(solver.arithmetic.__file__).parent
    trees = [ast.parse(path.read_text(encoding="utf-8")) for path in sorted(folder.glob("*.py"))]
    found = [each for tree in trees for each in tree.body if isinstance(each, ast.FunctionDef) and each.returns]
    return [each for each in found if ast.unparse(each.returns) == "tuple[Step, ...]" and each.name[0] != "_"]


@pytest.mark.parametrize("function", substeps(), ids=lambda each: each.name)
def test_all_arithmetic_waits_until_it_is_told(function):
    assert function.name == "at_full" or ast.unparse(function.decorator_list[0]) == "where_exact"
