"""Stabilizability and detectability: hidden modes that decay, stay or grow; corruptions; parameters."""

from dataclasses import replace

import pytest
import sympy as sp

from solver import solve
from solver.derivation import Status
from tests.helpers.asking import ask, rejected, system
from tests.helpers.marked import solved, verdict

NOTE = system([[1, 0, 0], [1, -1, 1], [0, 0, -2]], B=[1, 1, 0], C=[[1, 0, 0]])  # lecture note, 2.6 example 3


def test_the_notes_example():
    result = ask("stabilizability", NOTE)
    assert result.status is Status.VERIFIED
    assert result.answers == {"stabilizable": True, "hidden_modes": [-2]}
    result = ask("detectability", NOTE)
    assert result.answers == {"detectable": True, "hidden_modes": [-2, -1]}
    assert result.steps[-1].kind == "decay"


@pytest.mark.parametrize(("value", "stabilizable"), [(-1, True), (0, False), (1, False), (sp.Rational(-1, 100), True)])
def test_zero_is_not_a_stable_hidden_mode(value, stabilizable):
    result = ask("stabilizability", system([[value, 0], [0, 3]], B=[0, 1], C=[[1, 1]]))
    assert result.status is Status.VERIFIED
    assert result.answers == {"stabilizable": stabilizable, "hidden_modes": [value]}


@pytest.mark.parametrize(("value", "detectable"), [(sp.Rational(1, 2), True), (-2, False), (-1, False), (0, True)])
def test_in_discrete_time_the_unit_circle_decides(value, detectable):
    result = ask("detectability", system([[value, 1], [0, 3]], B=[0, 1], C=[[0, 1]], discrete=True))
    assert result.status is Status.VERIFIED
    assert result.answers == {"detectable": detectable, "hidden_modes": [value]}


def test_hidden_pairs_on_and_beside_the_imaginary_axis():
    for sigma, holds in ((-1, True), (0, False)):
        A = sp.diag(sp.Matrix([[sigma, 2], [-2, sigma]]), 1)
        result = ask("stabilizability", system(A, B=[0, 0, 1], C=[[1, 0, 1]]))
        assert result.status is Status.VERIFIED
        assert result.answers["stabilizable"] is holds


def test_parameters_decide_or_are_asked_for():
    for assumption, holds in (("positive", True), ("negative", False)):
        a = sp.Symbol("a", **{assumption: True})
        result = ask("stabilizability", system([[-a, 0], [0, 1]], B=[0, 1], C=[[1, 1]]))
        assert result.status is Status.VERIFIED
        assert result.answers["stabilizable"] is holds
    a = sp.Symbol("a", real=True)
    result = ask("stabilizability", system([[-a, 0], [0, 1]], B=[0, 1], C=[[1, 1]]))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers == {"hidden_modes": [-a], "condition": a > 0}


a, b, c, d = sp.symbols("a b c d", real=True)
PAIR = [[0, 1, 0], [-c, -d, 0], [0, 0, 1]]
CONDITIONS = [
    ([[a, 0], [0, 1]], False, a < 0),
    ([[a, 0], [0, 1]], True, (a > -1) & (a < 1)),
    ([[0, 0, 0], [0, a, 0], [0, 0, 1]], True, (a > -1) & (a < 1)),
    ([[a, 1, 0], [0, a, 0], [0, 0, 1]], False, a < 0),
    ([[a, 0, 0], [0, b - 2, 0], [0, 0, 1]], False, (a < 0) & (b < 2)),
    ([[a**2 - 1, 0], [0, 1]], False, (a > -1) & (a < 1)),
    ([[a - sp.sqrt(2), 0], [0, 1]], False, a < sp.sqrt(2)),
    ([[a, b, 0], [-b, a, 0], [0, 0, 1]], False, a < 0),
    (PAIR, False, (c > 0) & (d > 0)),
    (PAIR, True, (c < 1) & (d > -c - 1) & (d < c + 1)),
]


@pytest.mark.parametrize(
    ("task", "rows", "discrete", "condition"),
    [("stabilizability", *each) for each in CONDITIONS] + [("detectability", *each) for each in CONDITIONS[1::4]],
)
def test_hidden_modes_with_parameters_name_the_condition(task, rows, discrete, condition):
    reached = [0] * (len(rows) - 1) + [1]
    plant = system(sp.Matrix(rows) if task == "stabilizability" else sp.Matrix(rows).T, B=reached, C=[reached])
    plant = replace(plant, discrete=discrete)
    result = ask(task, plant)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["condition"] == condition
    assert set(result.answers) == {"hidden_modes", "condition"}
    assert [step.kind for step in result.steps][-2:] == ["decay", "condition"]


def test_conditions_that_cannot_hold_together_decide():
    result = ask("stabilizability", system([[a, 0, 0], [0, -a, 0], [0, 0, 1]], B=[0, 0, 1]))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers == {"stabilizable": False, "hidden_modes": [-a, a]}


def test_a_mode_of_parameters_beside_one_that_grows_needs_no_condition():
    result = ask("stabilizability", system([[a, 0, 0], [0, 2, 0], [0, 0, 1]], B=[0, 0, 1]))
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers == {"stabilizable": False, "hidden_modes": [2, a]}


@pytest.mark.parametrize(("rows", "discrete", "right"), CONDITIONS[1::4] + CONDITIONS[4:9:4])
def test_wrong_conditions_are_rejected(rows, discrete, right):
    reached = [0] * (len(rows) - 1) + [1]
    plant = system(rows, B=reached, C=[reached], discrete=discrete)
    assert not rejected("stabilizability", plant, {"condition": right})
    parts = right.args if isinstance(right, sp.And) else (right,)
    unstrict = {sp.StrictLessThan: sp.LessThan, sp.StrictGreaterThan: sp.GreaterThan}
    first, *others = parts
    beside = first.func(first.lhs, first.rhs + sp.Rational(1, 97))
    for wrong in (sp.true, sp.false, ~right, sp.And(beside, *others), *([sp.And(*others)] if others else [])):
        assert rejected("stabilizability", plant, {"condition": wrong}), wrong
    closed = sp.And(*(unstrict[each.func](*each.args) for each in parts))
    assert rejected("stabilizability", plant, {"condition": closed})


def test_where_the_input_reaches_less_the_condition_does_not_count():
    plant = system([[a, 1], [0, b]], B=[b, b * (b - a)])
    result = ask("stabilizability", plant)
    assert result.status is Status.VERIFIED, result.reason
    assert result.answers["condition"] == (a < 0)


HALF = sp.Rational(1, 2)


@pytest.mark.parametrize(
    ("modes", "says"),
    [
        ([[0, 1], [0, 0]], "Here every hidden mode is zero"),
        ([[0, 0], [0, HALF]], "Here not every hidden mode is zero"),
        ([[HALF]], "Here the hidden mode is not zero"),
        ([[2]], "Here the hidden mode is not zero"),
    ],
)
@pytest.mark.parametrize(("task", "word"), [("stabilizability", "to the origin"), ("detectability", "econstructib")])
def test_in_discrete_time_it_is_told_from_control_to_the_origin(modes, says, task, word):
    A = sp.diag(sp.Matrix(modes), 3)
    rows = (A if task == "stabilizability" else A.T).tolist()
    reached = [0] * (A.rows - 1) + [1]
    text = f"title: T\nsystem: {{time: discrete, A: {_yaml(rows)}, B: {reached}, C: {reached}}}\nfind: {{a: {task}}}\n"
    said = solve(text).markdown()
    assert says in said
    assert word in said
    assert word not in solve(text.replace("time: discrete, ", "")).markdown()
    assert word not in solve(text).markdown(detail="brief")


def _yaml(rows):
    return "[" + ", ".join("[" + ", ".join(f'"{entry}"' for entry in row) + "]" for row in rows) + "]"


def test_a_system_without_hidden_modes_is_not_told_so():
    plant = system([[0, 1], [0, 0]], B=[0, 1], C=[[1, 0]], discrete=True)
    assert [step.kind for step in ask("stabilizability", plant).steps][-1] == "decay"


def test_a_students_condition_is_judged_by_the_hidden_modes():
    problem = solved("title: T\nsystem: {A: [[a, 0], [0, 1]], B: [0, 1]}\nfind: {a: stabilizability}\n")
    assert verdict(problem, "a", "condition", "a < 0").verdict == "correct"
    for wrong in ("a > 0", "a <= 0", "a < 1"):
        assert verdict(problem, "a", "condition", wrong).verdict == "wrong"


def test_corrupted_answers_are_rejected_one_by_one():
    assert not rejected("stabilizability", NOTE, {"stabilizable": True})
    assert rejected("stabilizability", NOTE, {"stabilizable": False})
    for wrong in ([], [sp.Integer(2)], [sp.Integer(-2)] * 2):
        assert rejected("stabilizability", NOTE, {"hidden_modes": wrong})
    assert not rejected("detectability", NOTE, {"hidden_modes": [sp.Integer(-1), sp.Integer(-2)]})
    assert rejected("detectability", NOTE, {"detectable": False})
