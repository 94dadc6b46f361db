"""What one part takes from another, in which words a question is refused, and what becomes of decimals on the way."""

import time

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import solve_continuous_are

from solver.derivation import Status
from solver.engine import given_of, solve_part, solve_problem, steps_of
from solver.messages import Messages
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue

PLANT = "system: {A: [[0, 1], [-2, -3]], B: [0, 1], C: [1, 0]}\n"


def read(text):
    return read_problem(Source("p.yaml", text), catalogue())


def solve(text):
    return {part.id: part for part in solve_problem(read(text)).parts}


def test_a_part_goes_on_with_the_first_method_of_another():
    text = PLANT + "find:\n  a: {task: pole_placement, method: [ackermann, bass_gura], poles: [-4, -5]}\n"
    text += "  b: {task: characteristic_polynomial, gain: {from: a, answer: K}}\n"
    first, second, closed = solve_problem(read(text)).parts
    assert (first.method, second.method) == ("ackermann", "bass_gura")
    x = sp.Symbol("lamda")
    assert sp.expand(closed.answers["polynomial"] - (x + 4) * (x + 5)) == 0


def test_a_part_tells_how_long_it_took():
    start = time.perf_counter()
    parts = solve_problem(read(PLANT + "find: {a: eigenstructure, b: controllability}\n")).parts
    assert 0 < sum(part.seconds for part in parts) < time.perf_counter() - start


ENGLISH, GERMAN = "the closed loop has 2 poles", "der geschlossene Kreis hat 2 Pole"


@pytest.mark.parametrize(
    ("language", "asked", "said"),
    [("en", None, ENGLISH), ("de", None, GERMAN), ("de", "en", ENGLISH), ("en", "de", GERMAN)],
)
def test_a_question_is_refused_in_the_language_asked_for_or_that_of_the_problem(language, asked, said):
    problem = read(f"language: {language}\n{PLANT}find: {{a: {{task: pole_placement, poles: [-4, -5, -6]}}}}\n")
    with pytest.raises(InputError) as caught:
        solve_problem(problem, messages=asked and Messages(language=asked))
    assert said in caught.value.render()


def test_an_answer_that_was_not_found_is_named_by_who_needs_it():
    text = "system: {A: [[1, 0], [0, 2]], B: [1, 0]}\nfind:\n  a: {task: pole_placement, poles: [-1, -2]}\n"
    text += "  b: {task: characteristic_polynomial, gain: {from: a, answer: K}}\n"
    found = solve(text)["b"]
    assert found.status is Status.UNSOLVED
    assert str(found.reason) == "it needs the answer K of part a (for gain), which was not found"
    (result,) = solve_part(read(text).parts[1], {})
    assert str(result.reason) == str(found.reason)


def test_a_system_of_a_part_that_was_not_solved_is_unknown():
    part = read(PLANT + "find:\n  a: minimal_realization\n  b: {task: stability, system: {from: a}}\n").parts[1]
    (result,) = solve_part(part, {})
    assert result.status is Status.UNSOLVED
    assert "part a" in str(result.reason)


def test_the_steps_of_a_part_end_where_it_has_no_answer():
    text = PLANT + "find: {a: {task: pole_placement, poles: [-4, -5]}}\n"
    (part,) = read(text).parts
    assert [step.kind for step in steps_of(part, part.methods[0], {})] == [step.kind for step in solve(text)["a"].steps]
    assert sp.ImmutableMatrix([[0, 1], [-2, -3]]) == given_of(part, part.methods[0], {}).system.A


def test_what_comes_of_decimals_of_an_earlier_part_has_fifteen_digits():
    text = "system: {A: [[0, 1, 0], [0, 0, 1], [-1, -1, -2]], B: [0, 0, 1]}\nfind:\n"
    text += "  a: {task: lqr, Q: [[1, 0, 0], [0, 0, 0], [0, 0, 0]], R: 1}\n"
    text += "  b: {task: characteristic_polynomial, gain: {from: a, answer: K}}\n"
    x, polynomial = sp.Symbol("lamda"), solve(text)["b"].answers["polynomial"]
    A, B, Q = np.array([[0, 1, 0], [0, 0, 1], [-1, -1, -2.0]]), np.array([[0], [0], [1.0]]), np.diag([1.0, 0, 0])
    K = B.T @ solve_continuous_are(A, B, Q, np.eye(1))
    coefficients = [polynomial.coeff(x, i) for i in (3, 2, 1, 0)]
    assert np.allclose([float(each) for each in coefficients], np.poly(A - B @ K), rtol=1e-12)
    assert [len(str(each)) for each in coefficients] == [1, *[len("1.41421356237309")] * 3]


@pytest.mark.parametrize("system", ["polynomial: s^2 + 3s + 2", "transfer_function: exp(-s)/(s + 1)"])
def test_what_an_option_gives_is_not_needed_of_the_system(system):
    asked = "find:\n  a: {task: fundamental_subspaces, matrix: [[1, 2], [2, 4]]}\n"
    own, beside = (solve(f"{each}\n{asked}")["a"] for each in (f"system: {{{system}}}", "system: {A: [[1]]}"))
    assert own.status is Status.VERIFIED
    assert [step.kind for step in own.steps] == [step.kind for step in beside.steps]
