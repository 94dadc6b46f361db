"""Time constants: numpy's roots, pairs and multiple poles, parameters, unstable plants, corruptions, marking."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected
from tests.helpers.fractions_of_polynomials import plant, s
from tests.helpers.marked import verdict
from tests.helpers.tried import tried

TASK = "time_constants"
R = sp.Rational


def solved(G, more="", outside=""):
    text = f'system: {{transfer_function: "{G}"}}\nfind: {{a: {{task: {TASK}{more}}}}}\n{outside}'
    return solve_problem(read_problem(Source("file.yaml", text), catalogue())).parts[0]


def test_the_slowest_comes_first():
    result = solved("3/((2s + 1)(s + 5))")
    assert result.status is Status.VERIFIED
    assert [step.kind for step in result.steps] == ["poles", "constants", "slowest"]
    assert result.answers["time_constants"] == [2, R(1, 5)]


def test_a_pair_and_a_double_pole_count_twice():
    result = solved("(s + 1)/((s^2 + 2s + 5)(s + 4)^2)")
    assert result.answers["time_constants"] == [1, 1, R(1, 4), R(1, 4)]
    assert [mode.count for mode in result.steps[1].values["modes"]] == [2, 2]


def test_what_cancels_has_none():
    assert solved("(s + 3)/((s + 3)(s + 1))").answers["time_constants"] == [1]


def test_parameters_leave_the_order_open():
    result = solved("K/((T_1 s + 1)(T_2 s + 1))", outside="assume: {T_1: positive, T_2: positive}")
    assert result.status is Status.VERIFIED
    assert {str(each) for each in result.answers["time_constants"]} == {"T_1", "T_2"}
    assert result.steps[-2].values["in_order"] is False
    undecided = solved("K/(T s + 1)")
    assert undecided.status is Status.UNSOLVED
    assert "T" in str(undecided.reason)


def test_unstable_poles_have_none():
    result = solved("1/((s - 1)(s + 2))")
    assert result.answers["time_constants"] == [R(1, 2)]
    assert result.steps[-1].values["others"] == [1]
    assert solved("1/(s(s - 1))").status is Status.UNSOLVED
    assert "constant" in str(solved("3").reason)


def test_those_of_a_closed_loop():
    result = solved("1/(s(0.1s + 1))", ", controller: 10, feedback: unity")
    assert result.status is Status.VERIFIED
    assert result.answers["time_constants"] == [R(1, 5), R(1, 5)]


@tried(25)
@given(st.lists(st.integers(-9, 9), min_size=2, max_size=5))
def test_they_are_those_of_numpys_roots(tail):
    roots = np.roots([1, *tail])
    stable = np.sort(1 / -roots.real[roots.real < -1e-6])[::-1]
    near_axis = np.any(abs(roots.real) < 1e-6) or not len(stable) or not tail[-1]
    if near_axis:
        return
    result = ask(TASK, plant(1, sp.Poly([1, *tail], s).as_expr()))
    assert result.status is Status.VERIFIED, result.reason
    assert np.allclose([float(each) for each in result.answers["time_constants"]], stable, rtol=1e-4)


def test_corrupted_lists_are_rejected():
    G = plant(1, (s + 1) * (s**2 + 4 * s + 8) * (s - 3))
    right = ask(TASK, G).answers["time_constants"]
    assert right == [1, R(1, 2), R(1, 2)]
    assert not rejected(TASK, G, {"time_constants": right})
    for wrong in (
        [1, 2, 2],
        [1, R(1, 2)],
        [*right, R(1, 3)],
        [1, R(1, 2), R(501, 1000)],
        [-1, R(1, 2), R(1, 2)],
        [0, 1, 1],
    ):
        assert rejected(TASK, G, {"time_constants": wrong})


PROBLEM = 'system: {transfer_function: "1/((s + 2)(s^2 + 2s + 5))"}\nfind: {a: time_constants}\n'


@pytest.mark.parametrize(
    ("value", "says"),
    [
        ("[1, 1, 0.5]", ""),
        ("[0.5, 1, 1]", ""),
        ("[2, 1, 1]", "reciprocals"),
        ("[1, 0.5]", "counts twice"),
        ("[0.5, 0.4472, 0.4472]", "real part"),
    ],
)
def test_marking(value, says):
    found = verdict(PROBLEM, "a", "time_constants", value)
    assert (found.verdict.value == "correct") is not says, found.reason
    assert says in str(found.reason)
