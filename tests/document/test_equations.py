"""Answers are told as equations: state equations, observers, control laws; JSON keeps each answer by itself."""

import json
import re

import numpy as np
import pytest
from scipy import signal

from solver.document.model import Presentation
from solver.document.works import document_of
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue

STATE_SPACE = "{A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}"
MATRIX = re.compile(r"\\begin\{bmatrix\}(.+?)\\end\{bmatrix\}")


def told(find, system=STATE_SPACE, detail="full"):
    text = f"title: Equations\nsystem: {system}\nfind:\n  a: {find}\n"
    return document_of(solve_problem(read_problem(Source("file.yaml", text), catalogue())), Presentation(detail))


def shown(*arguments, **given):
    return [each.shown for each in told(*arguments, **given).parts[0].found]


def matrices(latex):
    return [
        np.array([[float(x) for x in row.split("&")] for row in body.split(r"\\")]) for body in MATRIX.findall(latex)
    ]


@pytest.mark.parametrize("form", ["controllable", "observable", "diagonal"])
def test_the_state_equations_of_a_realization_have_its_transfer_function(form):
    document = told(f"{{task: realization, form: {form}}}", "{transfer_function: (3s + 7)/(s^2 + 5s + 6)}")
    [equation] = [each.shown for each in document.parts[0].found]
    assert re.fullmatch(r"\\dot\{x\} = .*x \+ .*u,\\qquad y = .*x", equation)
    numerator, denominator = signal.ss2tf(*matrices(equation), np.zeros((1, 1)))
    assert np.allclose(numerator, [[0, 3, 7]])
    assert np.allclose(denominator, [1, 5, 6])


def test_a_direct_path_stands_in_the_output_equation_and_one_state_has_no_brackets():
    equations = shown("{task: realization, form: controllable}", "{transfer_function: (2s + 5)/(s + 2)}")
    assert equations == [r"\dot{x} = -2x + u,\qquad y = x + 2u"]
    equations = shown("{task: realization, form: controllable}", "{transfer_function: (a - s)/(s + a - b)}")
    assert equations == [r"\dot{x} = -(a - b)x + u,\qquad y = (2a - b)x - u"] or "(b - a)x" in equations[0]


def test_in_discrete_time_the_next_state_follows():
    find, system = "{task: realization, form: observable}", "{time: discrete, transfer_function: 1/(z - 1/2)}"
    assert shown(find, system) == [r"x(k + 1) = \frac{1}{2}x(k) + u(k),\qquad y(k) = x(k)"]


def test_coordinates_have_their_own_name_and_what_has_no_input_none():
    [equation] = shown("{task: similarity_transformation, T: [[1, 1], [-1, -2]]}", "{A: [[0, 1], [-2, -3]]}")
    assert equation.startswith(r"\dot{\xi} = ")
    assert "u" not in equation


def test_a_reduced_observer_is_its_equation_and_its_gain():
    found = told("{task: reduced_observer, poles: [-5]}").parts[0].found
    assert [each.shown for each in found][:2] == [
        "L_c = 2",
        r"\dot{\omega} = -5\omega - 12y + u,\qquad \hat{\eta}_{2} = \omega + 2y",
    ]


def test_a_gain_is_told_by_itself_and_in_its_control_law():
    laws = shown("{task: pole_placement, poles: [-4, -5]}")
    assert r"K_f = \begin{bmatrix}18 & 6\end{bmatrix}" in laws
    assert laws[-1] == r"u = -\begin{bmatrix}18 & 6\end{bmatrix}x"
    one = shown("{task: pole_placement, poles: [-4]}", "{A: [[1]], B: [1]}")
    assert "K_f = 5" in one
    assert one[-1] == "u = -5x"
    servo = shown("{task: servo, poles: [-1, -2, -3]}")
    assert servo[-1] == r"u = -\begin{bmatrix}9 & 3\end{bmatrix}x + 6\xi"


def test_what_is_too_wide_stays_single():
    factors = "".join(f"(s^2 + {n}.0123s + {n}7.0145)" for n in (1, 2, 3, 4))
    document = told("{task: realization, form: diagonal}", f'{{transfer_function: "1/({factors})"}}')
    assert [each.name for each in document.parts[0].found] == ["A", "B", "C", "D"]


@pytest.mark.parametrize("format_", ["html", "latex", "md", "text"])
def test_equations_stand_in_every_format_and_the_matrices_are_not_told_again(format_):
    document = told("{task: realization, form: controllable}", "{transfer_function: 1/((s+1)(s+2))}", "key")
    text = document.rendered(format_).decode()
    assert len(re.findall(r"Answer\b(?!s)", text.split("</style>")[-1])) == 1
    if format_ in {"md", "latex"}:
        assert text.count(r"\dot{x} = ") == 1
        assert "A = " not in text


def test_single_answers_stay_in_json_and_their_marks_are_those_of_the_equations():
    document = told("{task: realization, form: controllable, marks: 6}", "{transfer_function: 1/((s+1)(s+2))}", "key")
    assert [each.marks for each in document.parts[0].found] == ["6"]
    parts = json.loads(document.json())["parts"]
    assert set(parts[0]["answers"]) == {"A", "B", "C", "D"}


def test_equations_wait_for_all_their_answers():
    found = told("{task: realization, answers: [A]}", "{transfer_function: 1/((s+1)(s+2))}", "key").parts[0].found
    assert [each.name for each in found] == ["A"]


def _answers(system, task):
    text = f"title: T\nsystem: {{{system}}}\nfind: {{a: {task}}}\n"
    solved = solve_problem(read_problem(Source("file.yaml", text), catalogue()))
    return [each.equation for each in document_of(solved, Presentation("full")).parts[0].found]


def test_equations_of_motion_are_told_as_equations():
    system = 'lagrangian: {coordinates: [x], kinetic: "m x\'^2/2", potential: "k x^2/2"}'
    assert any(each.endswith("= 0") for each in _answers(system, "equations_of_motion"))


def test_nonlinear_state_equations_name_the_derivatives():
    first, *others = _answers("equations: [\"x'' = sin(x) + u\"], inputs: [u]", "state_space_model")
    assert r"\begin{bmatrix}\dot{x} \\ \ddot{x}\end{bmatrix} = " in first
    assert not any("f(x, u)" in each for each in (first, *others))
