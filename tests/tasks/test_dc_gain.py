"""DC gains: values at zero, integrators, parameters, dead times, loops, corruptions, marking, bad questions."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st

from solver.derivation import Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected, system
from tests.helpers.fractions_of_polynomials import plant, s
from tests.helpers.marked import verdict
from tests.helpers.tried import tried

TASK = "dc_gain"
R = sp.Rational


def solved(G, more="", outside=""):
    text = f'system: {{transfer_function: "{G}"}}\nfind: {{a: {{task: {TASK}{more}}}}}\n{outside}'
    return solve_problem(read_problem(Source("file.yaml", text), catalogue())).parts[0]


def test_the_value_at_zero_with_what_cancels_named():
    result = solved("(2s + 6)/(s^2 + 4s + 3)")
    assert result.status is Status.VERIFIED
    assert [step.kind for step in result.steps] == ["cancelled", "value", "meaning"]
    assert result.answers["dc_gain"] == 2
    assert result.steps[-1].values["stable"] is True


def test_what_cancels_at_the_origin_is_no_integrator():
    result = solved("s(s + 4)/(s(s + 2))")
    assert result.status is Status.VERIFIED
    assert result.answers["dc_gain"] == 2


@pytest.mark.parametrize(("G", "gain", "order"), [("3/(s(s + 4))", sp.oo, 1), ("(s - 2)/(s^2(s + 1))", -sp.oo, 2)])
def test_an_integrator_makes_it_infinite(G, gain, order):
    result = solved(G)
    assert result.status is Status.VERIFIED
    assert result.answers["dc_gain"] == gain
    assert result.steps[-1].values["order"] == order


def test_an_integrator_whose_sign_is_open_is_said_to_be():
    result = solved("K/s")
    assert result.status is Status.UNSOLVED
    assert "sign" in str(result.reason)
    assert solved("K/s", outside="assume: {K: negative}").answers["dc_gain"] == -sp.oo


def test_a_loop_and_its_parameter():
    K = sp.Symbol("K", positive=True)
    result = solved("1/((s + 1)(s + 2))", ", controller: K, feedback: unity", "assume: {K: positive}")
    assert result.status is Status.VERIFIED
    assert sp.cancel(result.answers["dc_gain"].subs(result.answers["dc_gain"].free_symbols.pop(), K) - K / (K + 2)) == 0


def test_a_dead_time_changes_nothing():
    result = solved("5exp(-2s)/(3s + 1)")
    assert result.status is Status.VERIFIED
    assert result.answers["dc_gain"] == 5


def test_the_value_where_the_system_is_unstable_is_told_apart():
    result = solved("2/(s - 1)")
    assert result.answers["dc_gain"] == -2
    assert result.steps[-1].values["stable"] is False


@tried(20)
@given(st.lists(st.integers(-6, 6), min_size=9, max_size=9))
def test_states_have_the_gain_of_numpy(entries):
    A = np.array(entries[:4]).reshape(2, 2)
    B, C, D = np.array(entries[4:6]).reshape(2, 1), np.array(entries[6:8]).reshape(1, 2), entries[8]
    if abs(np.linalg.det(A)) < 0.5:
        return
    plant = system(A.tolist(), B=B.tolist(), C=C.tolist(), D=[[D]])
    result = ask(TASK, plant)
    assert result.status is Status.VERIFIED, result.reason
    expected = (C @ np.linalg.solve(-A, B)).item() + D
    assert float(result.answers["dc_gain"]) == pytest.approx(expected, abs=1e-9)


def test_corrupted_gains_are_rejected():
    G = plant(2 * s + 6, s**2 + 5 * s + 4)
    assert not rejected(TASK, G, {"dc_gain": R(3, 2)})
    for wrong in (R(2), R(-3, 2), R(3001, 2000), sp.oo, sp.zoo, R(2, 3)):
        assert rejected(TASK, G, {"dc_gain": wrong})
    integrating = plant(3, s**2 + 4 * s)
    assert not rejected(TASK, integrating, {"dc_gain": sp.oo})
    for wrong in (-sp.oo, R(3, 4), sp.zoo, sp.nan):
        assert rejected(TASK, integrating, {"dc_gain": wrong})


PROBLEM = """
system: {transfer_function: "(2s + 6)/(4s^2 + 5s + 8)"}
find: {a: dc_gain, b: {task: dc_gain, system: {transfer_function: 1/s}}}
"""


@pytest.mark.parametrize(
    ("part", "value", "right"),
    [
        ("a", "3/4", True),
        ("a", "0.75", True),
        ("a", "1/2", False),
        ("a", "4/3", False),
        ("b", "inf", True),
        ("b", "1", False),
    ],
)
def test_marking(part, value, right):
    found = verdict(PROBLEM, part, "dc_gain", value)
    assert (found.verdict.value == "correct") is right, found.reason


def test_usual_mistakes_are_named():
    assert "constant terms" in str(verdict(PROBLEM, "a", "dc_gain", "0.5").reason)
    assert "exchanged" in str(verdict(PROBLEM, "a", "dc_gain", "4/3").reason)


def test_several_channels_and_free_motions_are_refused():
    text = 'system: {transfer_matrix: [["1/(s + 1)", "1/s"]]}\nfind: {a: dc_gain}\n'
    result = solve_problem(read_problem(Source("file.yaml", text), catalogue())).parts[0]
    assert result.status is Status.UNSOLVED
    assert "one transfer function" in str(result.reason)
    with pytest.raises(InputError, match="transfer function"):
        read_problem(Source("file.yaml", "system: {A: [[1]]}\nfind: {a: dc_gain}\n"), catalogue())
    with pytest.raises(InputError, match="feedback"):
        read_problem(
            Source("f", "system: {transfer_function: 1/s}\nfind: {a: {task: dc_gain, feedbak: 1}}\n"), catalogue()
        )
