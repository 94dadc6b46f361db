"""A wrong value that is right with the student's own earlier answers is right, and said to be so."""

import pytest

from tests.helpers.marked import marked

pytestmark = pytest.mark.xdist_group("follow_through")  # its problem is solved once

CHAIN = """
system: {A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}
find:
  a: {task: pole_placement, method: ackermann, poles: [-4, -5], marks: {K: 2, polynomial: 1}}
  b: {task: eigenstructure, gain: {from: a}, marks: 2}
  c: {task: reference_tracking, gain: {from: a}, marks: 2}
  d: {task: observer, poles: [-6, -7], method: ackermann, marks: 1}
  e: {task: observer_feedback, gain: {from: a}, observer_gain: {from: d}, marks: 2}
  f: {task: lqr, Q: [[4, 0], [0, 1]], R: 1, marks: 1}
  g: {task: optimal_tracking, gain: {from: f}, marks: 1}
"""
# right: a K = [18, 6]; d L = [10, 10]. A student's K = [16, 6]: A − BK = [[0, 1], [-18, -9]], eigenvalues −3, −6.


def test_every_later_part_is_followed():
    found = marked(CHAIN, "answers: {a: {K: [16, 6]}, b: {eigenvalues: [-3, -6]}, c: {K_o: 18}}")
    assert found["a"].answers["K"].verdict == "wrong"
    for part, name in (("b", "eigenvalues"), ("c", "K_o")):
        answer = found[part].answers[name]
        assert (answer.verdict, answer.follows, answer.note) == (
            "correct",
            True,
            "right with your own K of part a",
        )
    assert [found[part].marks for part in "bc"] == [
        0.5,
        2,
    ]  # the eigenvectors and the Jordan form of b were not submitted


def test_two_own_answers_are_followed_together():
    # L = [9, 9]: A − LC = [[-9, 1], [-11, -3]], s² + 12 s + 38
    answers = "answers: {a: {K: [16, 6]}, d: {L: [9, 9]}, e: {eigenvalues: [-3, -6, '-6 ± sqrt(2) j']}}"
    found = marked(CHAIN, answers)["e"].answers["eigenvalues"]
    assert (found.verdict, found.note) == ("correct", "right with your own K of part a and L of part d")
    found = marked(CHAIN, answers.replace("sqrt(2) j", "sqrt(2)"))["e"].answers["eigenvalues"]
    assert found.verdict == "wrong"


def test_a_wrong_earlier_answer_beside_a_right_later_one_changes_nothing():
    found = marked(CHAIN, "answers: {a: {K: [16, 6]}, b: {eigenvalues: [-4, -5]}}")["b"].answers["eigenvalues"]
    assert (found.verdict, found.follows) == ("correct", False)


def test_a_right_earlier_answer_leaves_nothing_to_follow():
    found = marked(CHAIN, "answers: {a: {K: [18, 6]}, b: {eigenvalues: [-3, -6]}}")["b"].answers["eigenvalues"]
    assert (found.verdict, found.follows) == ("wrong", False)


@pytest.mark.parametrize(
    ("K", "eigenvalues"), [("[0, 0]", "[-1, -2]"), ("[[0], [0]]", "[-1, -2]"), ("[1, 2, 3]", "[-1, -2]")]
)
def test_an_own_answer_that_trivialises_or_does_not_fit_is_not_followed(K, eigenvalues):
    found = marked(CHAIN, f"answers: {{a: {{K: {K}}}, b: {{eigenvalues: {eigenvalues}}}}}")
    assert found["b"].answers["eigenvalues"].verdict == "wrong"


def test_an_earlier_answer_that_was_not_submitted_is_not_followed():
    found = marked(CHAIN, "answers: {b: {eigenvalues: [-3, -6]}}")["b"].answers["eigenvalues"]
    assert found.verdict == "wrong"


def test_rounded_own_answers_are_followed_with_the_digits_they_have():
    found = marked(CHAIN, "answers: {f: {K: [0.9, 0.4]}, g: {K_o: 2.9}}")["g"].answers["K_o"]
    assert (found.verdict, found.follows) == ("correct", True)  # 2 + 0.9


def test_marks_of_each_answer_count_and_what_is_missing_earns_nothing():
    found = marked(CHAIN, "answers: {a: {K: [18, 5], polynomial: s^2 + 9s + 20}}")["a"]
    assert (found.marks, found.out_of) == (2, 3)
    found = marked(CHAIN, "answers: {a: {K: [18, 6]}}")["a"]
    assert (found.marks, found.out_of) == (2, 3)
    found = marked(CHAIN, "answers: {a: {closed_loop_A: [[0, 1], [-20, -9]], polynomial: s^2 + 9s + 20}}")["a"]
    assert (found.marks, found.out_of) == (1, 3)
