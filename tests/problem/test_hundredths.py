"""Marks as they are printed: hundredths that add up, over the answers that a question has."""

from fractions import Fraction

import pytest

from solver.problem.asked import marks_shown
from solver.problem.hundredths import dealt
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue

ALL = ("G", "poles", "zeros")


def shown(asked, found):
    text = f'system: {{transfer_function: "2/(s+4)"}}\nfind: {{a: {{task: transfer_function, {asked}}}}}\n'
    part = read_problem(Source("a", text), catalogue()).parts[0]
    return {name: str(marks) for name, marks in marks_shown(part, catalogue()["transfer_function"], found).items()}


def test_shares_add_up():
    assert dealt(Fraction(1), [Fraction(1, 3)] * 3) == [Fraction(34, 100), Fraction(33, 100), Fraction(33, 100)]


@pytest.mark.parametrize(
    ("asked", "found", "marks"),
    [
        ("marks: 10, answers: [G, poles, zeros]", ALL, {"G": "167/50", "poles": "333/100", "zeros": "333/100"}),
        ("marks: {poles: 1, zeros: 1/3}", ALL, {"poles": "1", "zeros": "1/3"}),
        ("marks: 6, answers: [G, poles, zeros]", ("G",), {"G": "6"}),  # nobody could earn the others
    ],
)
def test_marks_of_answers_are_hundredths_where_they_can_be(asked, found, marks):
    assert shown(asked, found) == marks
