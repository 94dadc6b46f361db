"""Reduction in z: poles of largest size, the DC gain kept, scipy's step responses, corruptions."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from scipy import signal

from solver.derivation import Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue
from tests.helpers.asking import rejected
from tests.helpers.fractions_of_polynomials import plant, z
from tests.helpers.marked import verdict

TASK = "dominant_pole_reduction"
R = sp.Rational
GAIN = 'system: {{time: discrete, transfer_function: "{}"}}\nfind: {{a: dc_gain}}\n'


def solved(G, more=""):
    text = f'system: {{time: discrete, transfer_function: "{G}"}}\nfind: {{a: {{task: {TASK}{more}}}}}\n'
    return solve_problem(read_problem(Source("file.yaml", text), catalogue())).parts[0]


def coefficients(G):
    return [[float(c) for c in sp.Poly(each, z).all_coeffs()] for each in sp.fraction(sp.together(G))]


def step(G, count=200):
    return np.ravel(signal.dstep((*coefficients(G), 1), n=count)[1][0])


@pytest.mark.parametrize(
    ("G", "order", "kept", "wanted"),
    [
        ("1/((10z - 9)(5z - 1)z)", 1, [R(9, 10)], 1 / (4 * (10 * z - 9))),
        ("1/((2z^2 - 2z + 1)(10z + 1))", 2, None, R(1, 11) / (2 * z**2 - 2 * z + 1)),
        ("1/((10z + 9)(2z - 1))", 1, [-R(9, 10)], 1 / (10 * z + 9)),
        ("(10z - 7)/((10z - 9)(5z - 4)(5z + 1))", 2, [R(9, 10), R(4, 5)], (3 / R(6)) / ((10 * z - 9) * (5 * z - 4))),
    ],
)
def test_the_largest_poles_and_the_gain_are_kept(G, order, kept, wanted):
    result = solved(G, f", order: {order}")
    assert result.status is Status.VERIFIED, result.reason
    gain = solve_problem(read_problem(Source("file.yaml", GAIN.format(G)), catalogue())).parts[0].answers["dc_gain"]
    assert result.answers["G"].subs(z, 1) == gain
    if kept is not None:
        assert result.answers["kept"] == kept
    if order == 1 or kept is None:
        assert sp.cancel(result.answers["G"] - wanted) == 0


def test_the_largest_difference_is_scipys():
    G = (z + 1) / ((10 * z - 9) * (5 * z - 4) * (10 * z - 1) * (5 * z - 1))
    result = solved("(z + 1)/((10z - 9)(5z - 4)(10z - 1)(5z - 1))")
    error = next(each for each in result.steps if each.kind == "compared").values["error"]
    difference = step(sp.expand(sp.numer(G)) / sp.expand(sp.denom(G))) - step(
        sp.expand(sp.numer(sp.together(result.answers["G"]))) / sp.expand(sp.denom(sp.together(result.answers["G"])))
    )
    assert error.time == int(np.argmax(abs(difference)))
    assert float(error.value) == pytest.approx(difference[error.time], rel=1e-9)


def test_what_lasts_is_kept_and_may_be_too_much():
    result = solved("1/((z - 1)(10z - 9)(5z - 1))")
    assert result.answers["kept"] == [1, R(9, 10)]
    too_many = solved("1/((z - 1)(z - 2)(5z - 1))", ", order: 1")
    assert too_many.status is Status.UNSOLVED
    assert "inside the unit circle" in str(too_many.reason)


def test_corrupted_answers_are_rejected():
    G = plant(1, sp.expand((10 * z - 9) * (5 * z - 1) * (2 * z + 1)), discrete=True)
    right = {"G": R(1, 12) / (10 * z - 9), "kept": [R(9, 10)], "dropped": [-R(1, 2), R(1, 5)]}
    assert not rejected(TASK, G, right, order=1)
    for name, value in (
        ("G", R(1, 10) / (10 * z - 9)),
        ("G", R(1, 12) / (10 * z + 9)),
        ("G", R(1, 12) * z / (10 * z - 9)),
        ("kept", [-R(1, 2)]),
        ("dropped", [R(9, 10), R(1, 5)]),
    ):
        assert rejected(TASK, G, {name: value}, order=1), (name, value)


PAPER = """\
system: {time: discrete, transfer_function: "1/((10z - 9)(5z - 1))"}
find: {a: {task: dominant_pole_reduction, order: 1}}
"""


@pytest.mark.parametrize(
    ("name", "value", "verdict_", "named"),
    [
        ("G", "1/(4(10z - 9))", "correct", ""),
        ("G", "1/(5(10z - 9))", "wrong", "DC gain is not kept"),
        ("kept", "[1/5]", "wrong", "fastest"),
        ("dropped", "[0.2]", "correct", ""),
    ],
)
def test_marking(name, value, verdict_, named):
    found = verdict(PAPER, "a", name, value)
    assert found.verdict == verdict_, found.reason
    assert named in str(found.reason)
