"""Titles tell the parts of a page apart, by what their questions say and nothing else."""

from collections import Counter

import pytest

from solver import solve
from solver.document.model import Presentation
from solver.document.works import Writer
from solver.problem.files import load
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.resources import root
from solver.tasks import catalogue

CATALOGUE = catalogue()
FILES = sorted(
    path
    for path in root("problems").rglob("*.yaml")
    if not path.name.endswith(".answers.yaml") and path.parent != root("problems") / "exams"
)
PLANT = "{A: [[0, 1], [2, 3]], B: [0, 1], C: [1, 0]}"
MASS = "{equations: [\"m x'' + k x = u\"]}"


def titles(find, system=PLANT, rest="", **presentation):
    text = f"title: A page\nsystem: {system}\n{rest}find:\n" + "".join(f"  {each}\n" for each in find)
    problem = read_problem(Source("file.yaml", text), CATALOGUE)
    return list(Writer(Presentation(**presentation).of(problem), Presentation(**presentation)).titles.values())


def test_no_two_parts_of_a_problem_have_one_title():
    """All problems are read, none is solved."""
    alike = {}
    for path in FILES:
        problem = read_problem(load(path), CATALOGUE)
        counted = Counter(Writer(problem, Presentation("question")).titles.values())
        alike |= {(path.stem, title): number for title, number in counted.items() if number > 1}
    assert alike == {}


def test_titles_of_the_course_say_what_differs():
    expected = {
        "ch6/ch6-ex03": ["Linearization: x₁ = 0, x₂ = 0, u = 0", "Linearization: point 2 of part (a)"],
        "ch6/ch6-q02": ["Transfer function: input 1", "Transfer function: input 2"],
        "ch2/ch2-ex01": ["Controllability: Rank of the controllability matrix", "Controllability: Gramian"],
        "ch1/ch1-ex09": ["Stability: dual", "Stability: Lyapunov's equation", "Stability: Eigenvalues"],
    }  # fmt: skip
    for name, wanted in expected.items():
        problem = read_problem(load(root("problems") / f"course/{name}.yaml"), CATALOGUE)
        found = Writer(problem, Presentation("question")).titles.values()
        assert set(wanted) <= set(found), found


@pytest.mark.parametrize(
    ("find", "words"),
    [
        (["a: {task: pole_placement, poles: [-1, -2]}", "b: {task: pole_placement, poles: [-3, -3]}"],
         ["poles −1, −2", "poles −3, −3"]),
        (["a: {task: lqr, Q: [[1, 0], [0, 1]], R: 1}", "b: {task: lqr, Q: [[1, 0], [0, 1]], R: 4}"],
         ["R = 1", "R = 4"]),
        (["a: {task: response, kind: zero_state, input: 1}", "b: {task: response, kind: zero_state, input: exp(-2t)}"],
         ["u = 1", "u = e⁻²ᵗ"]),
        (["a: stability", "b: {task: stability, system: {A: [[1]]}}"], ["", "A = 1"]),
        (["a: stability", "b: {task: stability, system: {A: [[a, b, c], [b, c, a], [c, b, a + 1]]}}"],
         ["system 1", "system 2"]),
        (["a: {task: pole_placement, poles: [-1, -2]}", "b: {task: stability, gain: {from: a}}", "c: stability"],
         ["", "", ""]),
        (["a: {task: stability, method: eigenvalues}", "b: {task: stability, method: lyapunov}"],
         ["Eigenvalues", "Lyapunov's equation"]),
    ],
)  # fmt: skip
def test_what_differs_is_said_and_no_more(find, words):
    found = titles(find, rest="assume: {a: real, b: real, c: real}\n")
    assert [title.partition(": ")[2] for title in found] == words
    assert len(set(found)) == len(found)


def test_values_of_parameters_are_told():
    find = ["a: state_space_model", "b: {task: state_space_model, parameters: {m: 2, k: 3}}"]
    assert titles(find, MASS, "assume: {m: positive, k: positive}\n")[1] == "State-space model: m = 2, k = 3"


def test_a_title_gives_away_neither_what_a_prompt_leaves_out_nor_a_hidden_system():
    behind = ["a: {task: pole_placement, poles: [-1, -2], prompt: Make it quick.}",
              "b: {task: pole_placement, poles: [-7, -8], prompt: Make it quicker.}"]  # fmt: skip
    assert titles(behind) == [f"Pole placement by state feedback: question {number}" for number in (1, 2)]
    said = [each.replace("Make it", "'Poles at $-1$, $-2$, $-7$ or $-8$:").replace(".}", ".'}") for each in behind]
    assert titles(said)[0].endswith("poles −1, −2")
    hidden = ["a: stability", "b: {task: stability, system: {A: [[1]]}, show: {system: false}}"]
    assert titles(hidden) == ["Stability: state-space model", "Stability"]
    method = ["a: {task: stability, method: lyapunov, show: {method: false}}", "b: stability"]
    assert not any("Lyapunov" in title for title in titles(method))


def test_titles_are_told_in_the_language_of_the_page():
    find = ["a: stability", "b: {task: stability, system: {A: [[a, b, c], [b, c, a], [c, b, a + 1]]}}"]
    found = titles(find, rest="assume: {a: real, b: real, c: real}\n", language="de")
    assert [title.partition(": ")[2] for title in found] == ["System 1", "System 2"]


def test_a_method_in_the_title_is_not_told_again():
    text = f"""system: {PLANT}
find:
  a: {{task: stability, method: eigenvalues}}
  b: {{task: stability, method: lyapunov}}
"""
    first, second = solve(text).parts
    assert (first.title, first.named_method) == ("Stability: Eigenvalues", "")
    assert (second.title, second.named_method) == ("Stability: Lyapunov's equation", "")
    (alone,) = solve(f"system: {PLANT}\nfind: {{a: {{task: stability, method: lyapunov}}}}\n").parts
    assert (alone.title, alone.named_method) == ("Stability", "Lyapunov's equation")
