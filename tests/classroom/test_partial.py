"""What wrong answers earn: in proportion to what is right, nothing, or what the named mistakes leave."""

from dataclasses import replace
from fractions import Fraction

import pytest

from solver.classroom import mark, read_submission
from solver.problem.partial import ruled, slips_of
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.helpers.marked import marked, solved

PROBLEM = """
title: Partial marks
system: {{A: [[0, 1, 0], [0, 0, 1], [1, 2, 3]], B: [0, 0, 1]}}
{problem}
find:
  a: {{task: pole_placement, poles: [-1, -2, -3], marks: {{K: 10, closed_loop_A: 9}}{part}}}
"""
BACKWARDS = "answers: {a: {K: [9, 13, 7], closed_loop_A: [[0, 1, 0], [0, 0, 1], [6, 11, 6]]}}"
"""K is [7, 13, 9]; of the closed loop the last row has the wrong sign."""


def earned(problem="", part="", answers=BACKWARDS):
    """The marks of K and of the closed loop."""
    found = marked(PROBLEM.format(problem=problem, part=part), answers)["a"].answers
    return tuple(found[name].marks for name in ("K", "closed_loop_A"))


ENTRIES = (Fraction(10, 3), Fraction(6))


@pytest.mark.parametrize(
    ("problem", "part", "marks"),
    [
        ("", "", ENTRIES),
        ("partial: entries", "", ENTRIES),
        ("partial: none", "", (0, 0)),
        ("partial: named", "", (5, Fraction(9, 2))),
        ("partial: {K: none}", "", (0, ENTRIES[1])),
        ("partial: none", ", partial: entries", ENTRIES),
        ("partial: none", ", partial: {K: entries}", (ENTRIES[0], 0)),
        ("partial: {reversed: 2}", "", (8, ENTRIES[1])),
        ("partial: {reversed: 2, sign: 1}", "", (8, 8)),
        ("partial: {reversed: 12}", "", (0, ENTRIES[1])),
        ("partial: {K: {reversed: 1/2}}", "", (Fraction(19, 2), ENTRIES[1])),
        ("partial: {K: none, sign: 1}", "", (0, 8)),
        ("partial: {sign: 1}", ", partial: {closed_loop_A: {feedback_sign: 1}, reversed: 3}", (7, ENTRIES[1])),
    ],
)
def test_the_problem_says_what_wrong_answers_earn(problem, part, marks):
    assert earned(problem, part) == marks


def test_what_is_wrong_without_a_name_earns_by_its_entries():
    assert earned("partial: named", answers="answers: {a: {K: [7, 13, 8], closed_loop_A: [[0]]}}") == (
        Fraction(20, 3),
        0,
    )


def test_a_right_answer_and_one_that_is_not_judged_are_the_same_by_every_rule():
    answers = "answers: {a: {K: [7, 13, 9], closed_loop_A: [[0, 1, what?]]}}"
    assert earned("partial: none", answers=answers) == earned("partial: named", answers=answers) == (10, 0)


def test_the_rule_of_the_command_line_wins():
    solution = solved(PROBLEM.format(problem="partial: {K: entries}", part=", partial: named"))
    strict = replace(solution, problem=ruled(solution.problem, "none", catalogue()))
    submission = read_submission(Source("answers.yaml", BACKWARDS), solution.problem)
    assert mark(strict, submission).marks == 0
    assert mark(solution, submission).marks == Fraction(19, 2)


@pytest.mark.parametrize(
    ("problem", "part", "words"),
    [
        ("partial: named_", "", "named"),
        ("partial: {K: non}", "", "did you mean 'none'"),
        ("partial: {sgn: 1}", "", "no answer and no mistake 'sgn'"),
        ("partial: {sgn: 1}", "", "did you mean 'sign'"),
        ("partial: {Q: none}", "", "no answer and no mistake 'Q'"),
        ("partial: {K: {transpose: 1}}", "", "no mistake 'transpose'"),
        ("partial: {K: {transpose: 1}}", "", "did you mean 'transposed'"),
        ("", ", partial: {eigenvalues: none}", "no answer and no mistake 'eigenvalues'"),
        ("partial: {sign: -1}", "", "can't be negative"),
        ("partial: {sign: many}", "", "many"),
        ("partial: [none]", "", "entries, none, named"),
    ],
)
def test_what_is_no_rule_no_answer_and_no_mistake_is_refused_at_its_place(problem, part, words):
    with pytest.raises(InputError) as refused:
        read_problem(Source("problem.yaml", PROBLEM.format(problem=problem, part=part)), catalogue())
    assert len(refused.value.diagnostics) == 1
    assert words in str(refused.value)


def test_a_problem_may_name_the_answers_and_mistakes_of_any_of_its_parts():
    text = PROBLEM.format(problem="partial: {eigenvalues: none, left_right: 1}", part="") + "  b: eigenstructure\n"
    a, b = read_problem(Source("problem.yaml", text), catalogue()).parts
    assert a.partial["K"].costs == b.partial["right_eigenvectors"].costs == {"left_right": 1}
    assert b.partial["eigenvalues"].rule == "none"


def test_no_answer_has_the_name_of_a_mistake():
    tasks = [catalogue()[name] for name in catalogue()]
    assert not {name for task in tasks for name in task.answers} & set(slips_of(tasks))
