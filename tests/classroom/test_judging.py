"""Verdicts by property: right answers in unusual forms pass, wrong ones do not, and the words fit."""

import pytest

from solver.classroom.report.words import wrong_places
from solver.derivation import Task
from solver.problem.source import InputError
from tests.helpers.marked import marked, solved, verdict

pytestmark = pytest.mark.xdist_group("judging")  # its problem is solved once

PLANT = """
title: A plant
system: {A: [[1, 2], [3, 1]], B: [0, 1], C: [1, 3], initial_state: [1, 0]}
find:
  a: eigenstructure
  b: {task: pole_placement, method: ackermann, poles: ["-3 ± 2j"], marks: 3}
  c: {task: eigenstructure, gain: {from: b}, marks: 2}
  d: characteristic_polynomial
  e: controllability
  f: {task: state_transition_matrix, system: {A: [[-1, 1], [0, -1]]}}
  g: {task: state_transition_matrix, system: {A: [[0, 1], [-5, -2]]}}
  h: {task: eigenstructure, system: {A: [[3, 1, 0], [0, 3, 0], [0, 0, 2]]}}
"""

RIGHT = [
    ("a", "eigenvalues", "[1 - sqrt(6), 1 + sqrt(6)]"),
    ("a", "eigenvalues", "1 ± sqrt(6)"),
    ("a", "eigenvalues", "[3.449, -1.449]"),
    ("a", "eigenvalues", "[3.4, -1.4]"),
    ("a", "right_eigenvectors", "[[2, 2], [sqrt(6), -sqrt(6)]]"),
    ("a", "right_eigenvectors", "[[2, -14], [sqrt(6), 7sqrt(6)]]"),
    ("a", "right_eigenvectors", "[[0.632, 0.632], [0.775, -0.775]]"),
    ("a", "right_eigenvectors", "[[0.8165, 1], [1, -1.2247]]"),
    ("a", "left_eigenvectors", "[[sqrt(6), 2], [-sqrt(6), 2]]"),
    ("a", "jordan_form", "[[1 + sqrt(6), 0], [0, 1 - sqrt(6)]]"),
    ("a", "diagonalizable", "yes"),
    ("a", "diagonalizable", "true"),
    ("b", "K", "[13, 8]"),
    ("b", "K", "[[26/2, 8.0]]"),
    ("b", "polynomial", "(s + 3)^2 + 4"),
    ("b", "polynomial", "s^2 + 6.0s + 13"),
    ("d", "polynomial", "(lambda - 1)^2 - 6"),
    ("d", "polynomial", "λ² - 2λ - 5"),
    ("e", "controllable", "yes"),
    ("e", "determinant", "-2"),
    ("e", "uncontrollable_modes", "[]"),
    ("f", "Phi", "[[exp(-t), t exp(-t)], [0, exp(-t)]]"),
    ("f", "Phi", "[[e^(-t), t/e^t], [0, 1/e^t]]"),
    ("f", "Phi", "[[exp(-1.00t), 1.0 t exp(-t)], [0, exp(-t)]]"),
    ("g", "Phi", "[[exp(-t)(cos(2t) + sin(2t)/2), exp(-t) sin(2t)/2],"
                 " [-5 exp(-t) sin(2t)/2, exp(-t)(cos(2t) - 0.5sin(2t))]]"),
    ("h", "eigenvalues", "[2, 3, 3]"),
    ("h", "right_eigenvectors", "[[0, 1, 0], [0, 0, 1], [1, 0, 0]]"),
    ("h", "jordan_form", "[[2, 0, 0], [0, 3, 1], [0, 0, 3]]"),
]  # fmt: skip

WRONG = [
    ("a", "eigenvalues", "[3.45, -1.44]", ""),
    ("a", "eigenvalues", "[3.449]", ""),
    ("a", "eigenvalues", "[1 + sqrt(6), 1 + sqrt(6)]", ""),
    ("a", "right_eigenvectors", "[[2, 4], [sqrt(6), 2sqrt(6)]]", ""),
    ("a", "right_eigenvectors", "[[0.64, 0.632], [0.775, -0.775]]", ""),
    ("a", "right_eigenvectors", "[[sqrt(6), -sqrt(6)], [2, 2]]", "left and right eigenvectors are exchanged"),
    ("a", "diagonalizable", "no", "the opposite is true"),
    ("b", "K", "[-13, -8]", "it is the gain of $A + BK_f$; the feedback is subtracted, $A - BK_f$"),
    ("b", "K", "[8, 13]", "the entries stand in reverse order"),
    ("b", "K", "[13, 8.1]", ""),
    ("b", "K", "[-3, -4]", ""),
    ("b", "K", "[7, -4]", "the poles have the wrong sign"),
    ("b", "closed_loop_A", "[[1, 2], [16, 9]]", "$+$ stands where $-$ belongs: the feedback is subtracted"),
    ("d", "polynomial", "lambda^2 - 2 lambda + 5", ""),
    ("d", "polynomial", "-lambda^2 + 2lambda + 5", "the sign is reversed"),
    ("e", "controllability_matrix", "[[0, 1], [2, 1]]", "it is transposed: rows and columns are exchanged"),
    ("e", "controllable", "no", "the opposite is true"),
    ("e", "rank", "1", ""),
    ("f", "Phi", "[[exp(-t), exp(-t)], [0, exp(-t)]]",
     "the factor $t$ (or $k$) of a repeated eigenvalue is missing"),
    ("f", "Phi", "[[exp(t), -t exp(t)], [0, exp(t)]]", "the sign of the exponents is reversed"),
    ("f", "Phi", "[[exp(-t), 0], [t exp(-t), exp(-t)]]", "it is transposed: rows and columns are exchanged"),
    ("h", "eigenvalues", "[2, 3]", "each value counts as often as its multiplicity"),
    ("h", "jordan_form", "[[3, 0, 0], [0, 3, 0], [0, 0, 2]]", ""),
]  # fmt: skip


@pytest.mark.parametrize(("part", "name", "value"), RIGHT)
def test_a_right_answer_is_right_in_any_form(part, name, value):
    found = verdict(PLANT, part, name, f'"{value}"' if not value.startswith("[") else value)
    assert found.verdict == "correct", found.reason


@pytest.mark.parametrize(("part", "name", "value", "words"), WRONG)
def test_a_wrong_answer_is_wrong_and_a_usual_mistake_is_named(part, name, value, words):
    found = verdict(PLANT, part, name, f'"{value}"' if not value.startswith("[") else value)
    assert found.verdict == "wrong"
    assert found.reason == words or not words


def test_decimals_must_be_right_to_the_last_digit_written():
    assert verdict(PLANT, "a", "eigenvalues", "[3.4495, -1.4495]").verdict == "correct"
    assert verdict(PLANT, "a", "eigenvalues", "[3.4494, -1.4495]").verdict == "wrong"  # cut off, not rounded
    assert verdict(PLANT, "a", "eigenvalues", "[3.4495, -1.4496]").verdict == "wrong"


DECIMALS = """\
system: {A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}
find:
  a: {task: pole_placement, poles: [-3, -4]}
  b: {task: response, input: 1}
  c: {task: eigenstructure, system: {matrix: [[1, 0.1], [0.5, 3]]}}
  d: {task: pole_placement, poles: [-3, -4], digits: 4, system: {A: [[0, 1], [-3, -1]], B: [0, 3]}}
  e: {task: eigenstructure, system: {matrix: [[0, 1], [-2, 0]]}}
  f: {task: pole_placement, poles: [-1, -2], system: {A: [[0, 1], [0, 0]], B: [0, 3]}}
"""
"""K is [10, 4], y = 1/2 − e^(−t) + e^(−2t)/2, the eigenvectors of c are (1, −0.24695) and (0.04939, 1); K of d is
[3, 2]; the eigenvalues of e are ±1.41421j; K of f is [2/3, 1]."""


@pytest.mark.parametrize(
    ("part", "name", "value", "expected"),
    [
        # an interval as wide as one likes tells nothing; nor does one digit, but where it is the number itself
        ("a", "K", "[0e5, 0e5]", "not judged"),
        ("a", "K", "[1.0e1, 4.0]", "correct"),
        ("a", "K", "[1e1, 4.0]", "correct"),
        ("a", "K", "[2e1, 4.0]", "wrong"),
        ("f", "K", "[0.7, 1]", "not judged"),
        ("f", "K", "[0.67, 1]", "correct"),
        ("f", "K", "[0.6, 1]", "wrong"),
        ("f", "K", "[0.0, 1]", "wrong"),
        ("e", "eigenvalues", "[0e9, 0e9]", "not judged"),
        ("e", "eigenvalues", "[1.4j, -1.4j]", "correct"),
        ("d", "K", "[3.0, 2.00]", "correct"),
        ("d", "K", "[3.001, 2]", "wrong"),
        # one choice of all decimals, for all times
        ("b", "y", "0.6 - 1.1 exp(-1.0 t) + 0.5 exp(-2.0 t)", "wrong"),
        ("b", "y", "0.5 - 1.0 exp(-1.0 t) + 0.5 exp(-2.0 t)", "correct"),
        ("b", "y", "0.50 - 1.05 exp(-1.0 t) + 0.55 exp(-2.0 t)", "wrong"),
        ("b", "y", "0.50 (1.0 - exp(-1.0 t))^2", "correct"),
        ("b", "y", "0.50 - 1.0 exp(-1.1 t) + 0.50 exp(-2.0 t)", "wrong"),
        # each vector explains what is left in it by its own rounding
        ("c", "right_eigenvectors", "[[1, 0.049], [-0.25, 1]]", "correct"),
        ("c", "right_eigenvectors", "[[1, 0.040], [-0.25, 1]]", "wrong"),
        ("c", "right_eigenvectors", "[[1, 0.05], [-0.25, 1]]", "not judged"),
        ("c", "right_eigenvectors", "[[1, 0.049], [-0.24, 1]]", "wrong"),
    ],
)
def test_decimals_stand_for_one_number_each_within_half_a_unit_of_their_last_digit(part, name, value, expected):
    found = verdict(DECIMALS, part, name, value if value.startswith("[") else f'"{value}"')
    assert found.verdict == expected, found.reason
    if expected == "not judged":
        assert "too few digits to tell; 2 significant ones" in found.reason


@pytest.mark.parametrize(
    ("value", "cut"), [("[0.66, 1]", True), ("[0.666, 1]", True), ("[0.68, 1]", False), ("[0.665, 1]", False)]
)
def test_the_last_digit_is_said_to_be_cut_off_only_where_it_is(value, cut):
    assert ("cut off" in verdict(DECIMALS, "f", "K", value).reason) is cut


@pytest.mark.parametrize(("digits", "words"), [("0", "of at least 1 and at most 12"), ("two", "a whole number")])
def test_the_digits_asked_for_are_a_whole_number(digits, words):
    for text in (f"digits: {digits}\n{DECIMALS}", DECIMALS.replace("digits: 4", f"digits: {digits}")):
        with pytest.raises(InputError, match=words):
            solved(text)


def test_the_problem_asks_for_digits_and_a_part_for_others():
    problem = solved(f"digits: 3\n{DECIMALS}").problem
    assert [part.digits for part in problem.parts] == [3, 3, 3, 4, 3, 3]
    assert verdict(f"digits: 3\n{DECIMALS}", "f", "K", "[0.67, 1]").verdict == "not judged"


FREE = """\
system: {A: [[1, 1, 0], [0, 1, 0], [0, 1, 1]], B: [0, 1, 0], C: [1, 1, 1]}
find:
  a: {task: kalman_decomposition, part: controllable}
  b: {task: eigenstructure, system: {matrix: [[0, 1], [-2, -3]]}}
  c: {task: stability_range, system: {A: [[0, 1, 0], [0, 0, 1], [-K, -2, -3]]}, parameters: [K]}
"""


@pytest.mark.parametrize(
    ("part", "values", "expected"),
    [
        ("a", {"B_c": "[7, 9]"}, ["not judged"]),
        ("a", {"C_c": "[[1, 2]]"}, ["not judged"]),
        ("a", {"B_c": '["1/s", 2]'}, ["wrong"]),
        ("a", {"B_c": "[0, 0]"}, ["wrong"]),
        ("b", {"right_eigenvectors": "[[1, 1], [-2, -1]]"}, ["correct"]),
        ("b", {"right_eigenvectors": "[[q, 1], [-2q, -1]]"}, ["correct"]),
        ("b", {"right_eigenvectors": "[[t, 1], [-2t, -1]]"}, ["wrong"]),
        ("b", {"right_eigenvectors": '[["exp(s)", 1], ["-2exp(s)", -1]]'}, ["wrong"]),
        ("b", {"eigenvalues": "[-2, -1]", "right_eigenvectors": "[[1, 1], [-2, -1]]"}, ["correct", "correct"]),
        ("b", {"eigenvalues": "[-1, -2]", "right_eigenvectors": "[[1, 1], [-2, -1]]"}, ["correct", "wrong"]),
        ("b", {"eigenvalues": "[-1, -2]", "left_eigenvectors": "[[2, 1], [1, 1]]"}, ["correct", "correct"]),
        ("b", {"eigenvalues": "[-2, -1]", "left_eigenvectors": "[[2, 1], [1, 1]]"}, ["correct", "wrong"]),
        ("b", {"eigenvalues": "[-2.0, -1.0]", "right_eigenvectors": "[[1, 1], [-2, -1]]"}, ["correct", "correct"]),
        ("c", {"condition": "K > 0 und K < 6"}, ["correct"]),
        ("c", {"condition": "K > 0 AND K < 6"}, ["correct"]),
        ("c", {"condition": "K < 6 oder K > 0"}, ["wrong"]),
    ],
)
def test_what_is_free_is_judged_with_what_fixes_it(part, values, expected):
    given = ", ".join(f"{name}: {value}" for name, value in values.items())
    found = marked(FREE, f"answers: {{{part}: {{{given}}}}}")[part].answers
    assert [found[name].verdict for name in values] == expected, found
    if expected == ["not judged"]:
        (only,) = found.values()
        assert only.reason == "the coordinates are free: it is judged together with A_c"


def test_blocks_in_our_coordinates_are_right_together():
    ours = solved(FREE).parts[0].answers
    A, B = (str(ours[name].tolist()) for name in ("A_c", "B_c"))
    found = marked(FREE, f"answers: {{a: {{A_c: {A}, B_c: {B}}}}}")["a"].answers
    assert [each.verdict for each in found.values()] == ["correct", "correct"]


def test_a_gain_of_almost_nothing_is_not_followed():
    problem = """\
system: {A: [[0, 1], [1, 1]], B: [0, 1]}
find:
  a: {task: pole_placement, poles: [-1, -2]}
  b: {task: stability, gain: {from: a}}
"""
    answers = "answers: {a: {K: [1e-9, x]}, b: {verdict: unstable}}"
    assert marked(problem, answers.replace("x", "1e-9"))["b"].answers["verdict"].verdict == "wrong"
    follows = marked(problem, answers.replace("x", "0.50"))["b"].answers["verdict"]
    assert (follows.verdict, follows.follows) == ("correct", True)


def test_marks_are_split_over_the_principal_answers_in_proportion_to_what_is_right():
    found = marked(PLANT, "answers: {b: {K: [13, 9], polynomial: s^2+6s+13}}")["b"]
    assert found.answers["K"].entries == [["correct", "wrong"]]
    assert (found.marks, found.out_of) == (3 / 2, 3)  # the gain is what the task is after; the rest earns nothing
    assert marked(PLANT, "answers: {a: {diagonalizable: yes}}")["b"].note == "not answered"


def test_a_later_part_is_followed_through_with_the_students_own_gain():
    found = marked(PLANT, "answers: {b: {K: [10, 5]}, c: {eigenvalues: ['(-3 ± sqrt(33) j)/2 - 0', 0]}}")
    assert found["c"].answers["eigenvalues"].verdict == "wrong"
    # with K = [10, 5]: A - BK = [[1, 2], [-7, -4]], eigenvalues (-3 ± j sqrt(31))/2
    found = marked(PLANT, "answers: {b: {K: [10, 5]}, c: {eigenvalues: ['-3/2 ± j sqrt(31)/2']}}")
    right = found["c"].answers["eigenvalues"]
    assert (right.verdict, right.follows, right.note) == ("correct", True, "right with your own K of part b")
    assert found["c"].marks == 0.5  # the eigenvectors and the Jordan form, asked for too, were not submitted


def test_an_earlier_answer_that_makes_the_later_question_trivial_is_not_followed():
    found = marked(PLANT, "answers: {b: {K: [0, 0]}, c: {eigenvalues: [1 + sqrt(6), 1 - sqrt(6)]}}")
    assert found["c"].answers["eigenvalues"].verdict == "wrong"


def test_answers_that_relate_to_each_other_are_judged_together():
    wrong = "answers: {a: {right_eigenvectors: [[2, 2], [sqrt(6), -sqrt(6)]], jordan_form: [[1, 0], [0, 1]]}}"
    found = marked(PLANT, wrong)["a"].answers
    assert (found["right_eigenvectors"].verdict, found["jordan_form"].verdict) == ("correct", "wrong")


def test_values_that_the_verification_cannot_work_on_together_are_judged_alone(monkeypatch):
    solution, together = solved(PLANT), Task.verify

    def stubborn(self, given, answers):
        if len(answers) > 1:
            raise ZeroDivisionError
        return together(self, given, answers)

    monkeypatch.setattr(Task, "verify", stubborn)
    found = marked(solution, "answers: {b: {K: [13, 9], polynomial: s^2+6s+13}}")["b"].answers
    assert (found["K"].verdict, found["polynomial"].verdict) == ("wrong", "correct")


def test_what_no_check_judges_is_right_where_it_is_ours(monkeypatch):
    solution = solved(PLANT)
    monkeypatch.setattr(Task, "verify", lambda *_: [])
    verdicts = [verdict(solution, "b", "K", value).verdict for value in ("[13, 8]", "[26/2, 8.0]", "[13, 9]")]
    assert verdicts == ["correct", "correct", "not judged"]


def test_an_unsolved_part_is_not_judged_and_earns_nothing():
    solution = solved("system: {transfer_function: '2'}\nfind: {a: {task: eigenstructure, marks: 2}}\n")
    found = marked(solution, "answers: {a: {diagonalizable: yes}}")["a"]
    assert found.answers["diagonalizable"].verdict == "not judged"
    assert "constant" in found.answers["diagonalizable"].reason
    assert (found.marks, found.out_of) == (0, 2)
    assert "could not be judged" in found.note


def test_yes_or_no_and_ranks_are_not_explained_by_chance():
    """λ = 0 is stable in discrete time; whoever says "stabilizable" need not have thought of that."""
    solution = solved("system: {A: [[0, 0], [0, 1]], B: [0, 1]}\nfind: {a: stabilizability, b: controllability}\n")
    assert verdict(solution, "a", "stabilizable", "yes").reason == "the opposite is true"
    assert "factor" not in verdict(solution, "b", "rank", "2").reason


def test_a_singular_transformation_is_said_to_be_singular():
    plant = "system: {A: [[-2, 0, -3], [0, 0, 0], [3/2, 0, 5/2]], B: [-1, 0, -2]}\nfind: {a: kalman_decomposition}\n"
    found = verdict(solved(plant), "a", "T", "[[-1, 8, 0], [0, 0, 0], [-2, -6.5, 1]]")
    assert (found.verdict, found.reason) == ("wrong", "it fails the check “$T$ is invertible”")
    assert wrong_places(found) == ["column 3"]


def test_a_wrong_column_is_named_once():
    found = verdict(PLANT, "a", "right_eigenvectors", "[[2, 2], [sqrt(6), 1]]")
    assert wrong_places(found) == ["column 2"]
    found = verdict(PLANT, "e", "controllability_matrix", "[[0, 2], [1, 2]]")
    assert wrong_places(found) == ["row 2, column 2"]


def test_a_free_matrix_is_judged_vector_by_vector():
    found = verdict(PLANT, "a", "right_eigenvectors", "[[2, 1], [-sqrt(6), 1]]")
    assert found.entries == [["correct", "wrong"], ["correct", "wrong"]]
    found = verdict(PLANT, "a", "left_eigenvectors", "[[sqrt(6), 2], [1, 1]]")
    assert found.entries == [["correct", "correct"], ["wrong", "wrong"]]
    found = verdict(PLANT, "a", "right_eigenvectors", "[[1, 1], [1, 2]]")
    assert found.share == 0


@pytest.mark.parametrize(
    ("part", "name", "value"),
    [
        ("b", "K", '"Matrix([[13, 8]])"'),
        ("a", "right_eigenvectors", '"Matrix([[2, 2], [sqrt(6), -sqrt(6)]])"'),
        ("b", "closed_loop_A", '"[[1, 2], [-10, -7]]"'),
        ("e", "controllable", '"True"'),
        ("c", "eigenvalues", "[-3 + 2i, -3 - 2i]"),
        ("c", "eigenvalues", '"[-3 + 2*I, -3 - 2*I]"'),
        ("d", "polynomial", '[["lamda**2 - 2*lamda - 5"]]'),
    ],
)
def test_values_may_be_written_as_results_are(part, name, value):
    found = verdict(PLANT, part, name, value)
    assert found.verdict == "correct", found.reason


@pytest.mark.parametrize("value", ['"[oo, 1]"', "[inf, inf]", "[[x_9, 1]]", "[0, 0]", "[]"])
def test_an_odd_value_is_wrong(value):
    assert verdict(PLANT, "b", "K", value).verdict == "wrong"
