"""Pole-zero forms: roots of numpy, what cancels, decimals, parameters, dead times, corruptions, marking."""

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

TASK = "pole_zero_form"
R = sp.Rational


def solved(G, more="", outside=""):
    text = f'system: {{transfer_function: "{G}"}}\nfind: {{a: {{task: {TASK}{more}}}}}\n{outside}'
    return solve_problem(read_problem(Source("file.yaml", text), catalogue())).parts[0]


def test_real_factors_and_a_pair():
    result = solved("(2s^2 + 6s + 4)/(4s^3 + 8s^2 + 20s)")
    assert result.status is Status.VERIFIED
    assert [step.kind for step in result.steps] == ["gain", "numerator", "denominator", "form"]
    answers = result.answers
    assert answers["gain"] == R(1, 2)
    assert answers["zeros"] == [-2, -1]
    assert answers["poles"] == [0, -1 + 2 * sp.I, -1 - 2 * sp.I]
    assert answers["G"] == (s + 1) * (s + 2) / (2 * s * (s**2 + 2 * s + 5))
    assert result.steps[-1].figures


def test_multiple_poles_and_what_cancels():
    result = solved("(s^2 - 1)/(s^4 + 5s^3 + 9s^2 + 7s + 2)")
    assert result.steps[0].kind == "cancelled"
    assert result.answers["poles"] == [-2, -1, -1]
    assert result.answers["zeros"] == [1]


def test_surds_are_taken_apart_and_a_cubic_is_in_decimals():
    answers = solved("(3 - s)/(s^2 + 2s - 1)").answers
    assert answers["gain"] == -1
    assert set(answers["poles"]) == {-1 + sp.sqrt(2), -1 - sp.sqrt(2)}
    answers = solved("10/(3s^3 + 3s^2 + 6s + 3)").answers
    assert answers["gain"] == R(10, 3)
    ours = np.sort_complex(np.array([complex(p) for p in answers["poles"]]))
    assert np.allclose(ours, np.sort_complex(np.roots([3, 3, 6, 3])))


def test_a_constant_and_zero():
    answers = solved("7").answers
    assert (answers["G"], answers["zeros"], answers["poles"], answers["gain"]) == (7, [], [], 7)
    assert solved("0").status is Status.UNSOLVED


def test_parameters_where_the_roots_have_a_form():
    result = solved("K exp(-T s)/(s(a s + 1))", outside="assume: {K: positive, T: positive, a: positive}")
    assert result.status is Status.VERIFIED
    assert result.answers["G"].has(sp.exp)
    open_roots = solved("1/(s^3 + a s + 1)")
    assert open_roots.status is Status.UNSOLVED
    assert "s^{3}" in str(open_roots.reason) or "s³" in str(open_roots.reason) or "a s" in str(open_roots.reason)


ROOTS = st.lists(st.integers(-4, 4), max_size=3)


@tried(25)
@given(ROOTS, ROOTS.filter(bool), st.integers(1, 5), st.booleans())
def test_built_from_roots(zeros, poles, gain, turned):
    zeros = zeros[: len(poles)]
    quadratic = s**2 + 2 * s + 10 if turned else sp.Integer(1)
    top, bottom = (sp.Mul(*(s - r for r in each)) for each in (zeros, poles))
    result = ask(TASK, plant(gain * top, bottom * quadratic))
    assert result.status is Status.VERIFIED, result.reason
    for root in set(zeros) & set(poles):
        for _ in range(min(zeros.count(root), poles.count(root))):
            zeros.remove(root)
            poles.remove(root)
    assert sorted(result.answers["zeros"]) == sorted(zeros)
    assert len(result.answers["poles"]) == len(poles) + 2 * turned
    assert result.answers["gain"] == gain


G = plant(2 * s**2 + 6 * s + 4, 4 * s**3 + 8 * s**2 + 20 * s)
CORRUPTIONS = {
    "G": [lambda v: 2 * v, lambda v: v.subs(s, -s), lambda v: v + 1],
    "zeros": [lambda v: v[:1], lambda v: [*v, v[0]], lambda v: [-r for r in v], lambda v: [v[0] + R(1, 1000), v[1]]],
    "poles": [lambda v: v[1:], lambda v: [*v, 0], lambda v: [-r for r in v], lambda v: [v[0] + R(1, 1000), *v[1:]]],
    "gain": [lambda v: -v, lambda v: 2 * v, lambda v: v * R(1001, 1000), lambda v: v * 0],
}


@pytest.mark.parametrize("name", CORRUPTIONS)
def test_each_answer_alone_is_accepted_and_each_corruption_rejected(name):
    answer = ask(TASK, G).answers[name]
    assert not rejected(TASK, G, {name: answer})
    for corrupt in CORRUPTIONS[name]:
        assert rejected(TASK, G, {name: corrupt(answer)})


PROBLEM = 'system: {transfer_function: "(2s + 4)/(s^2 + 7s + 12)"}\nfind: {a: pole_zero_form}\n'


@pytest.mark.parametrize(
    ("name", "value", "says"),
    [
        ("gain", "2", ""),
        ("gain", "1/3", "DC gain"),
        ("zeros", "[-2]", ""),
        ("zeros", "[2]", "signs"),
        ("zeros", "[-3, -4]", "exchanged"),
        ("poles", "-4; -3", ""),
        ("poles", "[3, 4]", "signs"),
        ("G", "2(s + 2)/((s + 3)(s + 4))", ""),
        ("G", "(s + 2)/((s + 3)(s + 4))", "factor 2"),
        ("G", "(s + 2)/((s + 3)(s + 5))", "not"),
    ],
)
def test_marking(name, value, says):
    found = verdict(PROBLEM, "a", name, f'"{value}"')
    assert (found.verdict.value == "correct") is not says, found.reason
    assert says in str(found.reason)
