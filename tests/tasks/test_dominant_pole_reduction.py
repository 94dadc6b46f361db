"""Reduction to the dominant poles: which are kept, the gain, zeros, the error by simulation, corruptions, marking."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given
from hypothesis import strategies as st
from scipy import signal

from solver.derivation import Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected
from tests.helpers.fractions_of_polynomials import plant, s
from tests.helpers.marked import verdict
from tests.helpers.tried import tried

TASK = "dominant_pole_reduction"
R = sp.Rational


def solved(G, more="", outside=""):
    text = f'system: {{transfer_function: "{G}"}}\nfind: {{a: {{task: {TASK}{more}}}}}\n{outside}'
    return solve_problem(read_problem(Source("file.yaml", text), catalogue())).parts[0]


def test_the_two_slowest_of_real_poles():
    result = solved("300(s + 12)/((s + 1)(s + 3)(s + 10)(s + 15))")
    assert result.status is Status.VERIFIED
    assert [step.kind for step in result.steps] == ["poles", "chosen", "zeros", "constant", "reduced", "compared"]
    assert result.answers["kept"] == [-1, -3]
    assert result.answers["dropped"] == [-10, -15]
    assert sp.cancel(result.answers["G"] - 24 / ((s + 1) * (s + 3))) == 0
    assert result.steps[-1].figures


def test_a_pair_is_not_split():
    result = solved("20(s + 2)/((s + 1)(s^2 + 6s + 25))")
    assert result.status is Status.VERIFIED
    assert result.answers["kept"] == [-1]
    whole = solved("1/((s^2 + 2s + 5)(s + 20))", ", order: 1")
    assert len(whole.answers["kept"]) == 2
    assert solved("20(s + 2)/((s + 1)(s^2 + 6s + 25))", ", order: 3").status is Status.UNSOLVED


def test_an_integrator_keeps_its_velocity_constant():
    result = solved("50/(s(s + 2)(s + 25))")
    assert result.status is Status.VERIFIED
    assert sp.cancel(result.answers["G"] - 2 / (s * (s + 2))) == 0
    error = result.steps[-1].values["error"]
    assert error.time is sp.oo
    assert float(error.value) == pytest.approx(-0.04)


def test_an_unstable_pole_is_kept():
    result = solved("10/((s - 1)(s + 2)(s + 30))")
    assert result.status is Status.VERIFIED
    assert result.answers["kept"] == [1, -2]
    assert result.steps[-1].values["error"] is None
    assert "do not decay" in str(solved("10/((s - 1)(s - 2)(s + 30))", ", order: 1").reason)


def test_slow_zeros_stay_and_a_dead_time_too():
    result = solved("exp(-s)(s + 2)/((s + 1)(s + 3)(s + 30))")
    assert result.status is Status.VERIFIED
    G = result.answers["G"]
    assert sp.cancel(sp.expand(G * sp.exp(s), power_exp=True) - (s + 2) / (30 * (s + 1) * (s + 3))) == 0


def test_decimal_poles():
    result = solved("20/(s^3 + 15s^2 + 38s + 44)")
    assert result.status is Status.VERIFIED
    roots = sorted(np.roots([1, 15, 38, 44]), key=lambda p: -p.real)
    assert np.allclose(
        sorted(map(complex, result.answers["kept"]), key=lambda p: p.imag), sorted(roots[:2], key=lambda p: p.imag)
    )
    assert float(abs(result.steps[-1].values["error"].value)) == pytest.approx(0.0310, abs=1e-4)


def test_what_says_nothing_new_or_is_open():
    assert "nothing to drop" in str(solved("1/((s + 1)(s + 2))").reason)
    assert "parameters" in str(solved("1/((s + a)(s + b)(s + 1))", outside="assume: {a: positive, b: positive}").reason)
    symbolic = solved("1/((s + a)(s + 3a)(s + 20a))", outside="assume: {a: positive}")
    assert symbolic.status is Status.VERIFIED
    with pytest.raises(InputError, match="1"):
        read_problem(
            Source("f", f"system: {{transfer_function: 1/s}}\nfind: {{a: {{task: {TASK}, order: 0}}}}\n"), catalogue()
        )


@tried(10)
@given(st.lists(st.integers(1, 30), min_size=3, max_size=4, unique=True), st.integers(1, 2), st.booleans())
def test_the_error_is_that_of_a_simulation(rates, order, paired):
    factors = [s + a for a in rates]
    if paired:
        factors[0] = (s + rates[0]) ** 2 + 4
    bottom = sp.Poly(sp.expand(sp.Mul(*factors)), s)
    result = ask(TASK, plant(100, bottom.as_expr()), order=order)
    if result.status is Status.UNSOLVED:
        return
    assert result.status is Status.VERIFIED, result.reason
    error = result.steps[-1].values["error"]
    t = np.linspace(0, 12 / min(rates), 40001)
    top, below = (sp.Poly(each, s) for each in sp.fraction(sp.cancel(result.answers["G"])))
    pairs = [([100.0], [float(c) for c in bottom.all_coeffs()])]
    pairs.append(([float(c) for c in top.all_coeffs()], [float(c) for c in below.all_coeffs()]))
    y, y_r = (signal.step(pair, T=t)[1] for pair in pairs)
    assert np.max(abs(y - y_r)) == pytest.approx(abs(float(error.value)), rel=1e-3, abs=1e-9)


G = plant(300 * s + 3600, (s + 1) * (s + 3) * (s + 10) * (s + 15))


def test_corruptions_are_rejected():
    right = ask(TASK, G, order=2).answers
    wrong = {
        "G": [
            2 * right["G"],
            24 / ((s + 1) * (s + 10)),
            8 / (s + 1),
            right["G"] * (s + 2) / 2,
            right["G"] * R(1001, 1000),
        ],
        "kept": [[-1], [-1, -10], [-1, -3, -10], [1, 3], [-1, R(-3001, 1000)]],
        "dropped": [[-10], [-1, -3], [-10, -15, -15]],
    }
    for name, values in wrong.items():
        assert not rejected(TASK, G, {name: right[name]}, order=2)
        for value in values:
            assert rejected(TASK, G, {name: value}, order=2), (name, value)
    assert not rejected(TASK, G, {"G": right["G"] * (s + 12) / 12}, order=2)  # a fast zero may stay
    slow = plant(s + 2, (s + 1) * (s + 3) * (s + 30))
    assert rejected(TASK, slow, {"G": 2 / (30 * (s + 1) * (s + 3))}, order=2)  # a slow one must


PROBLEM = 'system: {transfer_function: "300/((s + 1)(s + 3)(s + 25))"}\nfind: {a: dominant_pole_reduction}\n'


@pytest.mark.parametrize(
    ("name", "value", "says"),
    [
        ("G", "12/((s + 1)(s + 3))", ""),
        ("G", "12/(s^2 + 4s + 3)", ""),
        ("G", "300/((s + 1)(s + 3))", "DC gain"),
        ("kept", "[-3, -1]", ""),
        ("kept", "[-25, -3]", "fastest"),
        ("dropped", "[-25]", ""),
    ],
)
def test_marking(name, value, says):
    found = verdict(PROBLEM, "a", name, f'"{value}"')
    assert (found.verdict.value == "correct") is not says, found.reason
    assert says in str(found.reason)
