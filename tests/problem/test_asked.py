"""Which answers earn the marks of a part where the problem names none: those that its system has."""

import pytest

from solver.problem.asked import asked_of, marks_of
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue

RESPONSE = "task: response, kind: zero_state, input: '1'"
PLANT = "{A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}"
SHORT = "{A: [[0, 1], [-2, -3]], B: [0, 1]}"


@pytest.mark.parametrize(
    ("question", "asked"),
    [
        (f"{RESPONSE}, system: {PLANT}", ("x", "y")),
        (f"{RESPONSE}, system: {SHORT}", ("x",)),
        (f"{RESPONSE}, system: {{transfer_function: 1/(s+1)}}", ("y",)),
        (f"{RESPONSE}, system: {{transfer_function: exp(-s)/(s+1)}}", ("y",)),
        (f"{RESPONSE}, controller: '2', system: {{transfer_function: 1/(s+1)}}", ("y",)),
        (f"{RESPONSE}, answers: [y], system: {PLANT}", ("y",)),
        (f"task: similarity_transformation, T: [[1, 1], [0, 1]], system: {PLANT}", ("A", "B", "C")),
        (f"task: similarity_transformation, T: [[1, 1], [0, 1]], system: {SHORT}", ("A", "B")),
        (f"task: transfer_function, system: {PLANT}", ("G",)),
    ],
)
def test_what_is_asked_depends_on_the_system(question, asked):
    part = read_problem(Source("problem.yaml", f"find:\n  a: {{{question}, marks: 6}}\n"), catalogue()).parts[0]
    task = catalogue()[part.task]
    assert asked_of(part, task) == asked
    assert marks_of(part, task) == dict.fromkeys(asked, 6 // len(asked))
