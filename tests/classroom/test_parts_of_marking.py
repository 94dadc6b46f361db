"""The parts of marking, each by itself: entries compared, places told, marks split, what earlier answers do."""

from fractions import Fraction

import pytest
import sympy as sp

from solver.classroom.following.trivial import trivial
from solver.classroom.judging.entries import all_right, entrywise, shaped
from solver.classroom.report.words import number, wrong_places
from solver.classroom.submitted import Submitted
from solver.classroom.verdicts import AnswerVerdict, Marking, PartVerdict, Verdict
from solver.document.model import Presentation
from solver.document.works import document_of
from solver.problem.nodes import ScalarNode
from tests.helpers.marked import marked, marker, solved, verdict

M = sp.ImmutableMatrix
x, y = sp.symbols("x y")
C, W = "correct", "wrong"


def submitted(value):
    return Submitted(value, value)


@pytest.mark.parametrize(
    ("value", "ours", "ordered", "entries"),
    [
        (M([[1, 2], [3, 5]]), M([[1, 2], [3, 4]]), False, [[C, C], [C, W]]),
        (M([[1, 2, 3]]), M([[3, 2, 1]]), False, [[W, C, W]]),
        (M([[1, 2]]), M([1, 2]), False, None),
        (M([[1]]), sp.Integer(1), False, None),
        (sp.Integer(1), M([[1]]), False, None),
        ([1 + x, y], [y, x + 1], False, [C, C]),
        ([x, x], [x, y], False, [C, W]),
        ([x], [x, x, y], False, [C, W, W]),
        ([x, y, y], [x, y], False, [C, C, W]),
        ([], [x], False, [W]),
        ([y, x], [x, y], True, [W, W]),
        ([x], [x, y, y], True, [C, W, W]),
        ([x, y, y], [x, y], True, [C, C, W]),
        ([M([1, 0]), M([0, 1])], [M([0, 1]), M([1, 0])], False, [C, C]),
        ([M([1, 0])], [M([[1, 0]])], False, [W]),
        (["a", "b"], ["a", "c"], True, [C, W]),
        ([M([[1]])], [x], False, [W]),
        (x + x, 2 * x, False, C),
        (x, y, False, W),
        (True, True, False, C),
        (False, True, False, W),
        ("stable", "unstable", False, W),
        ([x], x, False, None),
        (x, [x], False, None),
    ],
    ids=str,
)
def test_entries_are_compared_in_their_shape(value, ours, ordered, entries):
    found = entrywise(submitted(value), ours, ordered=ordered)
    assert found == entries
    flat = [word for row in found or [] for word in (row if isinstance(row, list) else [row])]
    assert isinstance(found, str | None) or all_right(found) == (W not in flat)


@pytest.mark.parametrize(
    ("value", "keep", "result"),
    [
        (M([[x, 1]]), False, [["x", "1"]]),
        (M([[x, 1]]), True, M([[2 * x, 2]])),
        ([x, M([1])], False, ["x", [["1"]]]),
        ([x, M([1])], True, [2 * x, M([2])]),
        ({x: y}, False, {"x": "y"}),
        ({x: y}, True, {x: 2 * y}),
        (x, False, "x"),
        (x, True, 2 * x),
        (True, True, True),
        (True, False, "True"),
    ],
    ids=str,
)
def test_a_function_is_applied_to_every_entry(value, keep, result):
    assert shaped(value, (lambda entry: 2 * entry) if keep else str, keep=keep) == result


@pytest.mark.parametrize(
    ("entries", "places"),
    [
        ([[C, W], [C, W]], ["column 2"]),
        ([[W, W], [C, C]], ["row 1"]),
        ([[C, W], [W, C]], ["row 1, column 2", "row 2, column 1"]),
        ([[W, W], [C, W]], ["row 1, column 1", "row 1, column 2", "row 2, column 2"]),
        ([[C, W, C]], ["row 1, column 2"]),
        ([[C], [W]], ["row 2, column 1"]),
        ([[W, C, W], [W, C, W]], ["column 1", "column 3"]),
        ([C, W, W], ["item 2", "item 3"]),
        ([W, W], []),
        ([[W]], []),
        (W, []),
        (None, []),
        ([], []),
    ],
    ids=str,
)
def test_the_places_of_what_is_wrong_are_told_where_something_is_right(entries, places):
    found = AnswerVerdict("K", Verdict.WRONG, entries=entries)
    assert list(map(str, wrong_places(found))) == places
    assert wrong_places(AnswerVerdict("K", Verdict.NOT_JUDGED, entries=entries)) == []


@pytest.mark.parametrize(
    ("verdict", "entries", "share"),
    [
        (Verdict.CORRECT, [[W]], 1),
        (Verdict.WRONG, [[C, W], [C, C]], Fraction(3, 4)),
        (Verdict.WRONG, [C, [C, W]], Fraction(2, 3)),
        (Verdict.WRONG, None, 0),
        (Verdict.WRONG, W, 0),
        (Verdict.NOT_JUDGED, [C, W], 0),
    ],
)
def test_what_share_of_an_answer_is_right(verdict, entries, share):
    assert AnswerVerdict("K", verdict, entries=entries).share == share


def test_marks_are_numbers_of_two_decimals_and_add_up():
    assert [number(Fraction(*each)) for each in ((4, 2), (1, 3), (5, 8))] == [2, 0.33, 0.63]
    wrong = {"K": AnswerVerdict("K", Verdict.WRONG)}
    parts = (
        PartVerdict("a", "", {}, Fraction(1, 2), Fraction(2)),
        PartVerdict("b", "", wrong, Fraction(0), Fraction(3)),
    )
    assert (Marking("", parts).marks, Marking("", parts).out_of, Marking("", parts).all_right) == (
        Fraction(1, 2),
        5,
        False,
    )
    assert Marking("", parts[:1]).all_right


PARTS = """
system: {{A: [[0, 1], [-2, -3]], B: [0, 1]}}
find:
  a: {{task: eigenstructure{}}}
  b: {{task: controllability{}}}
"""


@pytest.mark.parametrize(
    ("marks", "out_of"), [(("", ""), [1, 1]), ((", marks: 3", ""), [3, 0]), (("", ", marks: 1/2"), [0, Fraction(1, 2)])]
)
def test_parts_count_alike_where_none_has_marks(marks, out_of):
    found = marked(PARTS.format(*marks), "answers: {a: {eigenvalues: [-1, -2]}}")
    assert [each.out_of for each in found.values()] == out_of


def test_each_answer_earns_its_own_marks_and_one_that_is_not_asked_for_none():
    split = PARTS.format(", marks: {eigenvalues: 2, diagonalizable: 1}", ", answers: rank, marks: 2")
    found = marked(split, "answers: {a: {eigenvalues: [-1, -3], diagonalizable: yes}, b: {controllable: yes, rank: 2}}")
    assert (found["a"].marks, found["a"].out_of) == (2, 3)
    assert (found["b"].marks, found["b"].out_of) == (2, 2)
    assert marked(split, "answers: {b: {controllable: yes, rank: 1}}")["b"].marks == 0


@pytest.mark.parametrize(
    ("own", "ours", "is_trivial"),
    [
        (M([[0, 0]]), M([[1, 2]]), True),
        (M([[0, 0], [1, 1]]), M([[1, 2], [3, 4]]), True),
        (M([[0, 0], [1, 1]]), M([[0, 0], [3, 4]]), False),
        (M([[0, 1]]), M([[1, 2]]), False),
        (M([[1, 0], [0, 1]]), M([[1, 2], [3, 4]]), True),
        (M([[1, 0], [0, 1]]), M([[1, 0], [0, 1]]), False),
        (M([[1, 2]]), M([1, 2]), True),
        (M([[1, 2]]), x, True),
        ([x], [x, y], True),
        ([x, x], [x, y], False),
        (sp.Integer(0), x, True),
        (sp.Integer(2), x, False),
    ],
    ids=str,
)
def test_what_would_make_a_later_question_trivial(own, ours, is_trivial):
    assert trivial(own, ours) is is_trivial


REGULATOR = "system: {A: 0, B: 1}\nfind: {a: {task: lqr, Q: 1, R: 1}}\n"


@pytest.mark.parametrize(
    ("name", "value", "reason"),
    [
        ("P", "-1", "it solves the Riccati equation, but it is not the stabilising solution"),
        ("P", "1/2", "a factor 2 is missing"),
        ("definiteness", "[positive definite, positive definite]", "it fails the check"),
    ],
)
def test_a_mistake_is_named_where_it_leads_to_the_very_value(name, value, reason):
    found = verdict(REGULATOR, "a", name, value)
    assert found.verdict == "wrong"
    assert found.reason.startswith(reason)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("[[1, 2], [3, 4]]", M([[1, 2], [3, 4]])),
        ("Matrix([[1, 2], [3, 4]])", M([[1, 2], [3, 4]])),
        ("ImmutableDenseMatrix([[1], [2]])", M([1, 2])),
    ],
)
def test_a_matrix_may_be_written_in_one_text(text, value):
    desk = marker(solved(REGULATOR))
    read = desk.reader(desk.solution.problem.parts[0], {}).read(ScalarNode(None, text), value)
    assert read.value == value


@pytest.mark.parametrize(("b", "value", "named"), [("1/2", "1/4", True), ("1", "1", False)])
def test_a_whole_number_is_not_explained_by_a_mistake(b, value, named):
    plant = f"system: {{A: [[0, 1], [-2, -3]], B: [0, {b}]}}\nfind: {{a: controllability}}\n"
    found = verdict(plant, "a", "determinant", value)  # of the other sign
    assert found.verdict == "wrong"
    assert ("sign" in found.reason) is named


def test_an_answer_that_the_question_has_not_carries_no_marks():
    """A discretization without an output equation to y has no G: its marks are those of the others, on keys as well."""
    text = (
        "title: T\nfind:\n"
        "  a: {task: discretization, system: {A: [[0]], B: [1]}, sample_time: 1, answers: [A, B, G], marks: 3}\n"
    )
    part = marked(text, "answers: {a: {A: [[1]], B: [[1]]}}")["a"]
    assert (part.marks, part.out_of) == (3, 3)
    (shown,) = document_of(solved(text), Presentation("key")).parts
    assert [answer.marks for answer in shown.boxed] == ["1.5", "1.5"]


@pytest.mark.parametrize(
    ("part", "name", "value", "right"),
    [
        ("a", "K", "u = -tanh(1 - t) x", True), ("a", "K", "u = tanh(1 - t) x", False),
        ("b", "nature", "weak minimum", True), ("b", "nature", "weak maximum", False),
    ],
)  # fmt: skip
def test_a_law_of_one_state_and_a_weak_extremum_are_read(part, name, value, right):
    functional = '{integrand: "x\'^2 + x^2", from: 0, to: 1, ends: {x: [0, 1]}}'
    text = (
        "title: T\nfind:\n"
        "  a: {task: finite_horizon_lqr, system: {A: [[0]], B: [1]}, Q: [[1]], R: [[1]], final_time: 1}\n"
        f"  b: {{task: extremal, system: {{functional: {functional}}}}}\n"
    )
    assert (verdict(text, part, name, value).verdict == "correct") is right


MOTION = """
title: T
find:
  l:
    task: extremal
    system: {functional: {integrand: "x'^2 + 4x^2", from: 0, to: 1, ends: {x: [0, 1]}}}
    answers: [equations]
  m:
    task: equations_of_motion
    system: {lagrangian: {coordinates: [x_1, x_2], kinetic: "x_1'^2/2 + x_2'^2/2", potential: "x_1^2/2 + x_1 x_2"}}
    answers: [equations]
  r:
    task: routh_hurwitz
    system: {A: [[0, 1, 0], [0, 0, 1], [-6, -11, -6]]}
    answers: [right_half_plane_roots]
"""


@pytest.mark.parametrize(
    ("part", "name", "value", "said"),
    [
        ("l", "equations", "x'' = 4x", "correct"), ("l", "equations", "2x'' = 8x", "correct"),
        ("l", "equations", "x'' = 5x", "wrong"), ("m", "equations", "x1'' = -x1 - x2, x2'' = -x1", "correct"),
        ("m", "equations", "d²x1/dt² + x1 + x2 = 0, d²x2/dt² + x1 = 0", "correct"),
        ("m", "equations", "x1'' = -x1 - x2, x2'' = x1", "wrong"),
        ("r", "right_half_plane_roots", "none, all are stable", "correct"),
        ("r", "right_half_plane_roots", "none, one is unstable", "not judged"),
    ],
)  # fmt: skip
def test_a_factor_is_no_multiplicity_and_an_index_needs_no_sign(part, name, value, said):
    assert verdict(MOTION, part, name, f'"{value}"').verdict == said
