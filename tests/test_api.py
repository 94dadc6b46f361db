"""The Python interface: from a path or from text, and what a notebook shows."""

import json
from fractions import Fraction
from html.parser import HTMLParser

import numpy as np
import pytest
import sympy as sp

import solver
from solver.derivation import Status
from solver.problem.source import InputError
from solver.resources import root

TEXT = """\
title: A < B
system:
  A: [[0, 1], [-2, -3]]
find:
  a: {task: state_transition_matrix, method: [modal, laplace]}
  b: eigenstructure
"""
t = sp.Symbol("t")


@pytest.fixture(scope="module")
def solution():
    return solver.solve(TEXT)


def test_text_is_solved(solution):
    assert solution.status is Status.VERIFIED
    assert [part.method for part in solution.parts] == ["modal", "laplace", "eigenstructure"]
    assert solution.answers["a"]["Phi"][0, 1] == sp.exp(-t) - sp.exp(-2 * t)
    assert solution.answers["b"]["eigenvalues"] == [-2, -1]


def test_a_mapping_is_solved():
    system = {"A": np.array([[0, 1], [-2, -3]]), "B": sp.Matrix([0, 1])}
    poles = [complex(-3, 2), -3 - 2 * sp.I]
    asked = {"system": system, "find": {"a": {"task": "pole_placement", "poles": poles, "marks": Fraction(7, 2)}}}
    solution = solver.solve(asked)
    assert solution.status is Status.VERIFIED
    assert solution.answers["a"]["K"].tolist() == [[11, 3]]
    marked = solver.check(asked, {"a": {"K": np.array([11, 3])}})
    assert marked.marks == Fraction(7, 2)


def test_answers_as_a_mapping_may_have_the_keys_of_a_file():
    asked = {"system": {"A": [[0, 1], [0, 0]], "B": [0, 1]}, "find": {"a": "controllability"}}
    marked = solver.check(asked, {"student": "Ada", "answers": {"a": {"rank": 2}, "a.controllable": True}})
    assert {name: str(each.verdict) for name, each in marked.parts["a"].answers.items()} == {
        "rank": "correct",
        "controllable": "correct",
    }


@pytest.mark.parametrize("answers", [{}, {"a": {"rank": "9" * 30000}}])
def test_what_cannot_be_read_of_a_mapping_is_told(answers):
    asked = {"system": {"A": [[0, 1], [0, 0]], "B": [0, 1]}, "find": {"a": "controllability"}}
    with pytest.raises(InputError, match=r"no part of the problem is answered|longer than"):
        solver.check(asked, answers)


@pytest.mark.parametrize(
    ("problem", "told"),
    [
        ({"system": {"A": [[0, 1], [2, "3 +"]]}, "find": {"a": "stability"}}, "<problem>: at system.A[1][1]: error: "),
        (
            {"system": {"A": [[0, 1], [2, 3]]}, "find": {"a": {"task": "stabilty"}}},
            "<problem>: at find.a.task: error: ",
        ),
        ({"sistem": {"A": [[0]]}, "find": {"a": "stability"}}, "<problem>: at sistem: error: "),
        ({}, "<problem>: error: "),
    ],
)
def test_what_is_wrong_with_a_mapping_is_told_by_its_keys(problem, told):
    with pytest.raises(InputError) as error:
        solver.solve(problem)
    assert any(line.startswith(told) for line in str(error.value).splitlines()), str(error.value)
    assert " | " not in str(error.value)


def test_a_mapping_in_itself_is_refused():
    problem = {"find": {"a": "stability"}}
    problem["system"] = problem
    with pytest.raises(InputError, match="nested too deeply"):
        solver.solve(problem)


def test_a_path_is_solved():
    path = root("problems") / "course" / "ch1" / "ch1-ex05.yaml"
    assert (
        solver.solve(path).answers["a"]["eigenvalues"] == solver.solve(str(path)).answers["a"]["eigenvalues"] == [-2, 3]
    )


def test_limits_run_in_a_child_and_give_the_same_answers(solution):
    limited = solver.solve(TEXT, seconds=60)
    assert limited.answers == solution.answers


def test_every_format(solution):
    assert "<!DOCTYPE html>" in solution.html()
    assert solution.latex(detail="tutor").rstrip().endswith(r"\end{document}")
    assert solution.markdown(detail="brief").startswith("# A")
    assert json.loads(solution.json())["status"] == "verified"


def test_the_notebook_shows_the_page_in_a_frame_of_its_own(solution):
    seen = []

    class Frames(HTMLParser):
        def handle_starttag(self, tag, attrs):
            seen.append((tag, dict(attrs)))

    Frames().feed(solution._repr_html_())
    assert [tag for tag, _ in seen] == ["iframe"]
    assert seen[0][1]["srcdoc"] == solution.html()
    assert seen[0][1]["sandbox"] == ""


def test_the_other_representations(solution):
    assert solution._repr_markdown_() == solution.markdown()
    assert solution._repr_latex_().count("$$") == 2 * 7
    assert repr(solution) == "<worked solution of 'A < B': verified>"


def test_input_at_fault_is_raised_with_its_place():
    with pytest.raises(InputError) as caught:
        solver.solve("system:\n  A: [[1, 2]]\nfind:\n  a: eigenstructure\n")
    assert "<text>:2:" in caught.value.render()


def test_an_unknown_name_of_the_package_is_an_attribute_error():
    with pytest.raises(AttributeError, match="no attribute 'resolve'"):
        _ = solver.resolve


@pytest.mark.parametrize(
    "answers",
    [{"a": {"Phi": "[[1, 0], [0, t]]"}, "b": {"eigenvalues": [-1, -2]}}, "answers:\n  b: {eigenvalues: [-1, -2]}"],
)
@pytest.mark.parametrize("limits", [{}, {"seconds": 60}])
def test_answers_are_marked(answers, limits):
    marked = solver.check(TEXT, answers, **limits)
    assert marked.parts["b"].answers["eigenvalues"].verdict == "correct"
    assert (marked.marks, marked.out_of) == (sp.Rational(1, 4), 2)
    assert marked.data() == json.loads(marked.json())
    assert repr(marked) == "<marked answers: 0.25 of 2>"


def test_a_marking_has_the_sheet_with_answers_and_solution_on_request(tmp_path):
    file = tmp_path / "ada.yaml"
    file.write_text("student: Ada\nanswers: {b: {eigenvalues: [1, -2]}}", encoding="utf-8")
    marked = solver.check(TEXT, file, language="de")
    assert "Bewertete Antworten von Ada" in marked.html()
    assert "Musterlösung" not in marked.html()
    assert "Musterlösung" in marked.html(solution=True)
    assert "richtige Wert" in marked.html(answers=True)
    assert marked._repr_html_().startswith("<iframe ")


def test_an_answer_file_at_fault_is_raised():
    with pytest.raises(InputError, match="has no part 'c'"):
        solver.check(TEXT, {"c": {"K": 1}})
