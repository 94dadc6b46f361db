"""Equilibria of x' = Ax + Bu as it is given: points, lines, planes, none; names; inputs that are none."""

from __future__ import annotations

import pytest
import sympy as sp

from solver.derivation import Status
from solver.derivation.conversion import chain_to
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.systems import Equations, StateSpace
from solver.tasks import catalogue
from tests.helpers.marked import verdict


def problem(system, options=""):
    text = f"system: {{{system}}}\nfind:\n  a: {{task: equilibrium_points{options}}}\n"
    return read_problem(Source("file.yaml", text), catalogue())


def solved(system, options=""):
    return solve_problem(problem(system, options)).parts[0]


def points(system, options=""):
    found = solved(system, options)
    assert found.status is Status.VERIFIED, found.reason
    return [{str(x): str(value) for x, value in point.items()} for point in found.answers["points"]]


DAMPED = "A: [[0, 1], [-2, -3]], B: [0, 1]"


def test_a_regular_matrix_has_one_point():
    assert points(DAMPED, ", inputs: {u: 4}") == [{"x1": "2", "x2": "0"}]
    assert points(DAMPED) == [{"x1": "u/2", "x2": "0"}]
    assert points(DAMPED, ", unknowns: [x2, u], inputs: {}") == [{"x2": "0", "u": "2*x1"}]
    assert [step.kind for step in solved(DAMPED).steps][:2] == ["rows", "rest"]


@pytest.mark.parametrize(
    ("system", "options", "found"),
    [
        ("A: [[0, 1], [0, -3]], B: [0, 1]", ", inputs: {u: 0}", [{"x1": "x1", "x2": "0"}]),
        ("A: [[0, 1], [0, -3]], B: [1, 1]", ", inputs: {u: 2}", []),
        ("matrix: [[0, 0], [0, 0]]", "", [{"x1": "x1", "x2": "x2"}]),
        ("A: [[1, -1], [2, -2]], B: [1, 2]", ", inputs: {u: 3}", [{"x1": "x2 - 3", "x2": "x2"}]),
        ("time: discrete, A: [[1/2, 1], [0, 1/3]], B: [0, 1]", ", inputs: {u: 2}", [{"x1(k)": "6", "x2(k)": "3"}]),
        ("A: [[-x1, 0], [1, -2]], B: [1, 0]", ", inputs: {u: 4}", [{"xi1": "4/x1", "xi2": "2/x1"}]),
        ("A: [[0, 1], [-k, -1]], B: [0, 1], states: [p, v], inputs: [f]", ", inputs: {f: 1}",
         [{"p": "1/k", "v": "0"}]),
    ],
)  # fmt: skip
def test_lines_planes_and_names(system, options, found):
    assert points(system, options) == found


def test_no_derivative_at_all_is_rest_everywhere():
    found = solved('equations: ["x\' = 0"]')
    assert found.status is Status.VERIFIED
    x = sp.Symbol("x", real=True)
    assert found.answers["points"] == [{x: x}]


def test_a_constant_input_of_discrete_equations_that_is_given_does_not_keep_its_symbol():
    rest = next(each for each in solved("time: discrete, A: [[1/2]], B: [1]", ", inputs: {u: 2}").steps
                if each.kind == "rest")  # fmt: skip
    assert not rest.values["kept"]


@pytest.mark.parametrize(
    ("options", "says"),
    [
        (", inputs: {v: 4}", "'v' is no input of the system; its input is u"),
        (", unknowns: [x3]", "'x3' is none of the unknowns, which are: u, x1, x2"),
        (", between: {y: [0, 1]}", "'y' is none of the unknowns"),
    ],
)
def test_names_at_fault_are_told_at_their_place(options, says):
    with pytest.raises(InputError) as caught:
        solve_problem(problem(DAMPED, options))
    assert says in caught.value.diagnostics[0].message
    assert caught.value.diagnostics[0].line == 3
    assert caught.value.diagnostics[0].column > 30


def test_marking_knows_a_line_from_a_point():
    text = "system: {A: [[0, 1], [0, -3]], B: [0, 1]}\nfind: {a: {task: equilibrium_points, inputs: {u: 0}}}\n"
    assert verdict(text, "a", "points", "[{x1: x1, x2: 0}]").verdict == "correct"
    assert verdict(text, "a", "points", "[{x1: 0, x2: 0}]").verdict == "wrong"
    assert verdict(text, "a", "points", "[{x1: x1, x2: 1}]").verdict == "wrong"


def test_only_what_is_given_in_state_space_is_written_out():
    plant = StateSpace(sp.ImmutableMatrix([[1]]), sp.ImmutableMatrix([[1]]), sp.ImmutableMatrix([[1]]))
    assert [each.target for each in chain_to(plant, ("rest",))] == [Equations]
    assert chain_to(plant, ("equations",)) is None
    with pytest.raises(InputError, match=r"needs equations \(or A\)"):
        solved('transfer_function: "1/(s + 1)"')
