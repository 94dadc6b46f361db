"""Natural frequency and damping: numpy's roots, the four cases with symbols, critical values, corruptions, marking."""

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
from solver.systems import Polynomial
from solver.tasks import catalogue
from tests.helpers.asking import ask, rejected
from tests.helpers.marked import verdict
from tests.helpers.tried import tried

TASK = "second_order_parameters"
R = sp.Rational
s = sp.Symbol("s")
SPRING = "{equations: [\"m x'' + d x' + k x = u\"], inputs: [u]}"


def solved(system, more="", outside=""):
    text = f"system: {system}\nfind: {{a: {{task: {TASK}{more}}}}}\n{outside}"
    return solve_problem(read_problem(Source("file.yaml", text), catalogue())).parts[0]


def polynomial(*coefficients):
    return Polynomial(tuple(map(sp.sympify, coefficients)), s)


def test_a_spring_with_a_damper_by_its_symbols():
    result = solved(SPRING, outside="assume: {m: positive, k: positive}")
    assert result.status is Status.VERIFIED
    assert [step.kind for step in result.steps][-3:] == ["compare", "discriminant", "cases"]
    answers = result.answers
    m, k, d = (next(x for x in answers["damping_ratio"].free_symbols if x.name == name) for name in "mkd")
    assert answers["natural_frequency"] == sp.sqrt(k / m)
    assert sp.cancel(answers["damping_ratio"] ** 2 - d**2 / (4 * k * m)) == 0
    assert answers["critical_value"] == 2 * sp.sqrt(k * m)
    assert list(answers["cases"]) == ["undamped", "underdamped", "critically_damped", "overdamped"]
    assert answers["cases"]["undamped"] == sp.Eq(d, 0)
    assert answers["cases"]["underdamped"] == sp.And(d > 0, d < 2 * sp.sqrt(k * m))


def test_what_is_assumed_excludes_cases():
    result = solved(SPRING, ", parameter: k", "assume: {m: positive, d: positive, k: positive}")
    assert list(result.answers["cases"]) == ["underdamped", "critically_damped", "overdamped"]
    assert str(result.answers["critical_value"]) == "d**2/(4*m)"


@pytest.mark.parametrize(
    ("coefficients", "frequency", "ratio", "word"),
    [
        ((2, 4, 10), sp.sqrt(5), sp.sqrt(5) / 5, "underdamped"),
        ((1, 0, 9), 3, 0, "undamped"),
        ((1, 6, 9), 3, 1, "critically damped"),
        ((-1, -5, -4), 2, R(5, 4), "overdamped"),
    ],
)
def test_numbers(coefficients, frequency, ratio, word):
    result = ask(TASK, polynomial(*coefficients))
    assert result.status is Status.VERIFIED
    answers = result.answers
    assert (answers["natural_frequency"], answers["damping_ratio"], answers["damping"]) == (frequency, ratio, word)
    assert "cases" not in answers


def test_negative_damping_is_no_case():
    result = ask(TASK, polynomial(1, -2, 5))
    assert result.status is Status.VERIFIED
    assert "damping" not in result.answers
    assert result.answers["damping_ratio"] == -sp.sqrt(5) / 5


@pytest.mark.parametrize(
    ("coefficients", "says"),
    [((1, 2, 0), "not positive"), ((1, 0, -4), "not positive"), ((1, 2, 3, 4), "degree 3"), ((1, 2), "time constant")],
)
def test_without_natural_frequency(coefficients, says):
    result = ask(TASK, polynomial(*coefficients))
    assert result.status is Status.UNSOLVED
    assert says in str(result.reason)


def test_a_gain_of_a_loop():
    result = solved('{transfer_function: "1/(s(s + 2))"}', ", controller: K, feedback: unity", "assume: {K: positive}")
    assert result.status is Status.VERIFIED
    (K,) = result.answers["damping_ratio"].free_symbols
    assert result.answers["critical_value"] == 1
    assert result.answers["cases"] == {"underdamped": K > 1, "critically_damped": sp.Eq(K, 1), "overdamped": K < 1}


def test_assumptions_that_decide_the_case():
    system = '{polynomial: "s^2 + 2 zeta omega s + omega^2"}'
    result = solved(system, outside='assume: {omega: positive}\nconditions: ["0 < zeta < 1"]')
    assert result.status is Status.VERIFIED
    assert result.answers["damping"] == "underdamped"
    assert str(result.answers["natural_frequency"]) == "omega"


@tried(30)
@given(st.integers(1, 6), st.integers(0, 12), st.integers(1, 20))
def test_the_poles_of_numpy(b2, b1, b0):
    result = ask(TASK, polynomial(b2, b1, b0))
    assert result.status is Status.VERIFIED, result.reason
    roots = np.roots([b2, b1, b0])
    assert float(result.answers["natural_frequency"]) == pytest.approx(abs(np.sqrt(np.prod(roots))), rel=1e-9)
    assert float(result.answers["damping_ratio"]) == pytest.approx(-roots.sum().real / 2 / np.sqrt(b0 / b2), abs=1e-9)
    complex_pair = b1**2 < 4 * b2 * b0
    words = {"undamped"} if b1 == 0 else {"underdamped"} if complex_pair else {"critically damped", "overdamped"}
    assert result.answers["damping"] in words


def test_corruptions_are_rejected():
    P = polynomial(2, 4, 10)
    right = ask(TASK, P).answers
    wrong = {
        "natural_frequency": [sp.sqrt(10), sp.Integer(5), -sp.sqrt(5), R(2237, 1000)],
        "damping_ratio": [2 * sp.sqrt(5) / 5, sp.Integer(1), -sp.sqrt(5) / 5],
        "damping": ["overdamped", "undamped", "critically damped"],
    }
    for name, values in wrong.items():
        assert not rejected(TASK, P, {name: right[name]})
        for value in values:
            assert rejected(TASK, P, {name: value})


def test_corrupted_cases_and_critical_values_are_rejected():
    m, k = sp.symbols("m k", positive=True)
    d = sp.Symbol("d", real=True)
    P = polynomial(m, d, k)
    answers = ask(TASK, P).answers
    cases, critical = answers["cases"], answers["critical_value"]
    assert not rejected(TASK, P, {"cases": cases, "critical_value": critical})
    for value in (critical / 2, -critical, critical + R(1, 100), sp.sqrt(k * m)):
        assert rejected(TASK, P, {"critical_value": value})
    for name in cases:
        assert rejected(TASK, P, {"cases": {key: value for key, value in cases.items() if key != name}}), name
    changed = [
        {**cases, "underdamped": d < critical},
        {**cases, "overdamped": d > critical / 2},
        {**cases, "critically_damped": sp.Eq(d, critical / 2)},
        {**cases, "undamped": sp.Eq(d, 1)},
        {**cases, "underdamped": cases["overdamped"], "overdamped": cases["underdamped"]},
    ]
    for value in changed:
        assert rejected(TASK, P, {"cases": value})


PROBLEM = """
system: {polynomial: "2s^2 + 6s + 23"}
find: {a: second_order_parameters, b: {task: second_order_parameters, system: {polynomial: "s^2 + d s + 4"}}}
"""


@pytest.mark.parametrize(
    ("part", "name", "value", "says"),
    [
        ("a", "natural_frequency", "sqrt(23/2)", ""),
        ("a", "natural_frequency", "3.391 rad/s", ""),
        ("a", "natural_frequency", "11.5", "root is not taken"),
        ("a", "natural_frequency", "0.5397", "hertz"),
        ("a", "natural_frequency", "3.0414", "damped frequency"),
        ("a", "damping_ratio", "0.4423", ""),
        ("a", "damping_ratio", "0.8847", "2 is forgotten"),
        ("a", "damping_ratio", "1.5", "divided by"),
        ("a", "damping", "underdamped", ""),
        ("a", "damping", "overdamped", " "),
        ("b", "critical_value", "4", ""),
        ("b", "critical_value", "2", "meet"),
    ],
)
def test_marking(part, name, value, says):
    found = verdict(PROBLEM, part, name, value)
    assert (found.verdict.value == "correct") is not says, found.reason
    assert says.strip() in str(found.reason)


def sampled(coefficients, period="1/10"):
    return Polynomial(
        tuple(map(sp.sympify, coefficients)), sp.Symbol("z"), discrete=True, sample_time=sp.sympify(period)
    )


@tried(20)
@given(st.integers(1, 5), st.integers(-6, 6), st.integers(1, 9), st.sampled_from([R(1, 10), R(1, 2), sp.Integer(2)]))
def test_in_discrete_time_the_logarithms_of_the_poles_of_numpy(b2, b1, b0, period):
    result = ask(TASK, sampled((b2, b1, b0), period))
    z = np.roots([b2, b1, b0]).astype(complex)
    if b1**2 >= 4 * b2 * b0 and (b1 >= 0 or np.prod(np.log(abs(z))) <= 1e-12):
        assert result.status is Status.UNSOLVED
        assert "no natural frequency" in str(result.reason)
        return
    assert result.status is Status.VERIFIED, result.reason
    poles = np.log(z) / float(period)
    frequency = np.sqrt(np.prod(poles)).real
    assert float(result.answers["natural_frequency"]) == pytest.approx(frequency, rel=1e-9)
    assert float(result.answers["damping_ratio"]) == pytest.approx(-poles.sum().real / 2 / frequency, abs=1e-9)
    inside = b0 <= b2
    assert ("damping" in result.answers) is inside


def test_in_discrete_time_corruptions_are_rejected():
    P = sampled(("1", "-8/5", "17/25"))
    right = ask(TASK, P).answers
    assert float(right["natural_frequency"]) == pytest.approx(3.1177, abs=1e-4)
    assert not rejected(TASK, P, right)
    wrong = {
        "natural_frequency": [right["natural_frequency"] / 10, sp.sqrt(R(17, 25)), -right["natural_frequency"]],
        "damping_ratio": [-right["damping_ratio"], R(4, 5), right["damping_ratio"] * R(1001, 1000)],
        "damping": ["overdamped", "undamped", "critically damped"],
    }
    for name, values in wrong.items():
        for value in values:
            assert rejected(TASK, P, {name: value}), (name, value)


@pytest.mark.parametrize(
    ("name", "value", "says"),
    [
        ("natural_frequency", "3.118", ""),
        ("natural_frequency", "0.3118", "sampling period"),
        ("natural_frequency", "0.8246", "standard form in"),
        ("natural_frequency", "2.45", "damped frequency"),
        ("damping_ratio", "0.6185", ""),
        ("damping_ratio", "-0.9701", "standard form in"),
        ("damping", "overdamped", " "),
    ],
)
def test_marking_in_discrete_time(name, value, says):
    problem = """
system: {time: discrete, sample_time: 0.1, polynomial: "z^2 - 1.6z + 0.68"}
find: {a: second_order_parameters}
"""
    found = verdict(problem, "a", name, value)
    assert (found.verdict.value == "correct") is not says, found.reason
    assert says.strip() in str(found.reason)


@pytest.mark.parametrize(
    ("system", "says"),
    [
        ('{time: discrete, sample_time: 1, polynomial: "z^2 + K z + 1"}', "Give values"),
        ('{time: discrete, sample_time: 1, polynomial: "(2z - 1)(2z + 1)"}', "changes its sign"),
        ('{time: discrete, sample_time: 1, polynomial: "(2z - 1)z"}', "over at once"),
        ('{time: discrete, sample_time: 1, polynomial: "(z - 2)(2z - 1)"}', "either side"),
    ],
)
def test_what_has_no_natural_frequency_in_discrete_time_says_why(system, says):
    result = solved(system)
    assert result.status is Status.UNSOLVED
    assert says in str(result.reason)


def test_in_discrete_time_a_sampling_period_is_needed():
    with pytest.raises(InputError, match="sampling period is not given"):
        solved('{time: discrete, polynomial: "z^2 + 1"}')


def test_a_parameter_that_is_not_there_is_refused():
    text = f"system: {SPRING}\nfind: {{a: {{task: {TASK}, parameter: q}}}}\n"
    with pytest.raises(InputError, match="q"):
        solve_problem(read_problem(Source("file.yaml", text), catalogue()))
