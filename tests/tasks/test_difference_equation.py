"""Difference equations by two methods: steps, answers against scipy's filter, corruptions, refusals, marking."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.signal import lfilter, lfiltic

from solver.derivation import Answers, CheckStatus, Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.helpers.marked import verdict

K = sp.Symbol("k")
Y = sp.Symbol("y", real=True)


def text(equations, method="z_transform", inputs="", initial="", more=""):
    listed = ", ".join(f'"{each}"' for each in ([equations] if isinstance(equations, str) else equations))
    of_inputs = f", inputs: [{', '.join(each.split(':')[0] for each in inputs.split(';'))}]" if inputs else ""
    acts = (
        ", input: {" + ", ".join(f'{e.split(":")[0]}: "{e.split(":")[1]}"' for e in inputs.split(";")) + "}"
        if inputs
        else ""
    )
    begins = f", initial: {{{initial}}}" if initial else ""
    system = f"{{time: discrete, equations: [{listed}]{of_inputs}}}"
    return f"find:\n  a: {{task: difference_equation, method: {method}, system: {system}{acts}{begins}{more}}}\n"


def asked(*arguments, **named):
    return solve_problem(read_problem(Source("file.yaml", text(*arguments, **named)), catalogue())).parts[0]


def answers(*arguments, **named):
    result = asked(*arguments, **named)
    assert result.status is Status.VERIFIED, result.reason
    assert not [check for check in result.checks if check.status is CheckStatus.SKIPPED]
    return result.answers


def rejected(question, **given_answers):
    task = catalogue()["difference_equation"]
    part = read_problem(Source("file.yaml", text(**question)), catalogue()).parts[0]
    checks = list(task.verify(task.given(part.system, part.options), Answers(**given_answers)))
    return any(check.status is CheckStatus.FAILED for check in checks)


def numbers(f, count=12):
    return [float(sp.re(sp.N(f.subs(K, i)))) for i in range(count)]


FIBONACCI = {"equations": "y(k) = y(k-1) + y(k-2)", "initial": '"y(0)": 0, "y(1)": 1'}


def test_fibonaccis_numbers():
    found = answers(**FIBONACCI, more=", terms: 10")
    assert found["values"] == [0, 1, 1, 2, 3, 5, 8, 13, 21, 34]
    assert np.allclose(numbers(found["solution"][Y], 10), [float(v) for v in found["values"]])
    assert [each.kind for each in asked(**FIBONACCI).steps][:2] == ["moved", "shifts"]


FORMS = [
    ("y(k+2) - 3y(k+1) + 2y(k) = u(k)", '"y(0)": 0, "y(1)": 1'),
    ("y(k) - 3y(k-1) + 2y(k-2) = u(k-2)", '"y(0)": 0, "y(1)": 1'),
    ("y(k+1) - 3y(k) + 2y(k-1) = u(k-1)", '"y(0)": 0, "y(1)": 1'),
    ("y(k+1) - 3y(k) + 2y(k-1) = u(k-1)", '"y(-1)": -1/2, "y(0)": 0'),
    ("y(k) = 3y(k-1) - 2y(k-2) + u(k-2)", '"y(-1)": -1/2, "y(-2)": -3/4'),
    ("y(k+2) = 3y(k+1) - 2y(k) + u(k)", '"y(-1)": -1/2, "y(-2)": -3/4'),
]


@pytest.mark.parametrize(
    ("number", "method"), [*((i, "z_transform") for i in range(6)), (2, "recursion"), (5, "recursion")]
)
def test_one_equation_in_all_its_forms(number, method):
    """y = (3ᵏ − 1)/2, whichever samples the equation is written in, and whichever values are given."""
    found = answers(FORMS[number][0], method, "u:3^k", FORMS[number][1])
    assert found["values"] == [0, 1, 4, 13, 40, 121]
    if method == "z_transform":
        assert sp.expand(found["solution"][Y] - (3**K - 1) / sp.Integer(2)) == 0


def test_from_rest_it_is_the_response_of_the_filter():
    found = answers("y(k+2) + 5y(k+1) + 6y(k) = u(k+1) + 2u(k)", inputs="u:1")
    assert np.allclose([float(v) for v in found["values"]], lfilter([0, 1, 2], [1, 5, 6], np.ones(6)))
    assert asked("y(k) = u(k+1)", inputs="u:1").status is Status.UNSOLVED


def test_values_not_given_are_zero_where_the_equation_needs_them():
    assert answers("y(k+2) = y(k)", initial='"y(0)": 1')["values"] == [1, 0, 1, 0, 1, 0]


def test_several_equations():
    equations = ["x(k+1) = x(k) + y(k)", "y(k+1) = -x(k) + y(k) + u(k)"]
    found = answers(equations, inputs="u:delta(k)", initial='"x(0)": 1')
    A, x = np.array([[1, 1], [-1, 1]]), np.array([1.0, 0.0])
    wanted = []
    for k in range(6):
        wanted.append(x[0])
        x = A @ x + np.array([0, float(k == 0)])
    assert np.allclose([float(v) for v in found["values"]], wanted)
    assert set(found["solution"]) == {sp.Symbol("x", real=True), Y}


def test_an_algebraic_equation_among_them():
    equations = ["e(k) = u(k) - y(k)", "y(k+1) = y(k) + e(k)/2"]
    found = answers(equations, inputs="u:1", more="")
    e = found["solution"][sp.Symbol("e", real=True)]
    assert np.allclose(numbers(e, 6), [0.5**k for k in range(6)])


def test_sequences_in_the_equation_itself():
    found = answers("y(k+1) - 2y(k) = k", initial='"y(0)": 1')
    assert sp.expand(found["solution"][Y] - (2 * 2**K - K - 1)) == 0
    assert answers("y(k+1) = y(k)/2 + 1")["values"][:3] == [0, 1, sp.Rational(3, 2)]


def test_roots_without_a_formula_are_decimals():
    """y(0) and y(1) are zero: only what is left of 30 digits may be there."""
    initial = '"y(0)": 0, "y(1)": 0, "y(2)": 1'
    found = answers("2y(k) + y(k-1) - 3y(k-2) + 0.3y(k-3) = -u(k-3)", inputs="u:k", initial=initial)
    assert np.allclose(numbers(found["solution"][Y], 6), [float(v) for v in found["values"]])


def test_parameters():
    found = answers("y(k+1) = (1 + r) y(k) - a", initial='"y(0)": y_0')
    r, a, y_0 = sp.symbols("r a y_0", real=True)
    wanted = (y_0 - a / r) * (1 + r) ** K + a / r
    point = {r: 0.1, a: 2, y_0: 5}
    assert np.allclose(numbers(found["solution"][Y].subs(point)), numbers(wanted.subs(point)))


@settings(max_examples=6, deadline=None)
@given(
    st.lists(st.integers(-2, 2), min_size=1, max_size=2),
    st.lists(st.integers(-2, 2), min_size=1, max_size=3),
    st.lists(st.integers(-3, 3), min_size=2, max_size=2),
    st.sampled_from(["1", "(1/2)^k", "k", "delta(k)", "step(k - 2)"]),
    st.booleans(),
)
def test_generated_equations_against_scipys_filter(a, b, before, u, backward):
    """Ay = Bu with values before zero, by lfiltic; forward and backward forms are the same equation."""
    n = len(a)
    b = b[: n + 1]
    if not any(b) or not a[-1]:
        return
    shift = 0 if backward else n
    left = " ".join(f"+ ({c})*y(k{shift - i:+d})" for i, c in enumerate([1, *a])).replace("(k+0)", "(k)")
    right = " ".join(f"+ ({c})*u(k{shift - i:+d})" for i, c in enumerate(b)).replace("(k+0)", "(k)")
    initial = ", ".join(f'"y({-i - 1})": {before[i]}' for i in range(n))
    found = answers(f"{left[1:]} = {right[1:]}", inputs=f"u:{u}", initial=initial)
    samples = {"1": lambda k: 1.0, "(1/2)^k": lambda k: 0.5**k, "k": float, "delta(k)": lambda k: float(k == 0),
               "step(k - 2)": lambda k: float(k >= 2)}[u]  # fmt: skip
    state = lfiltic(b, [1, *a], before[:n])
    wanted, _ = lfilter(b, [1, *a], [samples(k) for k in range(9)], zi=state)
    assert np.allclose([float(v) for v in found["values"]], wanted[:6])
    assert np.allclose(numbers(found["solution"][Y], 9), wanted, atol=1e-7)


QUESTION = {"equations": "y(k+1) - y(k)/2 = u(k)", "inputs": "u:1", "initial": '"y(0)": 4'}


def test_corrupted_answers_are_rejected():
    half = sp.Rational(1, 2)
    right = 2 + 2 * half**K
    assert not rejected(QUESTION, solution={Y: right}, values=[4, 3, half * 5, half**2 * 9, half**3 * 17, half**4 * 33])
    for wrong in (2 + half**K, 2 - 2 * half**K, right + sp.KroneckerDelta(K, 3) / 100, right.subs(K, K + 1)):
        assert rejected(QUESTION, solution={Y: wrong})
    assert rejected(QUESTION, values=[4, 3, half * 5, half**2 * 9, half**3 * 17, 2])
    assert rejected(QUESTION, values=[4, 3])
    assert rejected(QUESTION, solution={})


@pytest.mark.parametrize(
    ("question", "says"),
    [
        ({"equations": "y(k+1) = y(k)^2"}, "not linear"),
        ({"equations": "y(k+1) = k y(k)"}, "not linear"),
        ({"equations": "y(k+1) = y(k)/2", "initial": '"y(2)": 1'}, "cannot begin"),
        ({"equations": "y(k+2) = y(k)", "initial": '"y(-1)": 1'}, "cannot begin"),
        ({"equations": "y(k+1) = y(k)/2", "initial": '"x(0)": 1'}, "neither an unknown nor an input"),
        ({"equations": "y(k+1) = y(k) + u(k)", "inputs": "u:1/(k + 1)"}, "not rational"),
    ],
)
def test_other_questions_are_refused_at_their_place(question, says):
    with pytest.raises(InputError) as raised:
        asked(**question)
    assert says in str(raised.value)
    assert "file.yaml:2" in str(raised.value)


def test_inputs_must_be_given():
    problem = (
        'find:\n  a: {task: difference_equation, system: {time: discrete, equations: ["y(k+1) = u(k)"], inputs: [u]}}\n'
    )
    with pytest.raises(InputError) as raised:
        solve_problem(read_problem(Source("file.yaml", problem), catalogue()))
    assert "not given" in str(raised.value)


@pytest.mark.parametrize(
    "form",
    [
        '{y: "2 + 2*(1/2)^k"}',
        '{y: "2(1 + 2^-k)"}',
        '"y(k) = 2 + 2^(1-k)"',
        '{"y(k)": "2 + 2*2^(-k)"}',
        '"y = 2 + 2*(1/2)^k"',
    ],
)
def test_equivalent_solutions_are_right(form):
    assert verdict(text(**QUESTION), "a", "solution", form).verdict == "correct"


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        ("2 - 2*(1/2)^k", "start are forgotten"),
        ("2 - 6*(1/2)^k", "wrong sign"),
        ("2 + 6*(1/2)^k - 8delta(k)", "derivatives"),
        ("2 + 4*(1/2)^k", "late"),
        ("2 + (1/2)^k", "early"),
    ],
)
def test_usual_mistakes_are_named(wrong, says):
    found = verdict(text(**QUESTION), "a", "solution", f'{{y: "{wrong}"}}')
    assert found.verdict == "wrong"
    assert says in str(found.reason)
