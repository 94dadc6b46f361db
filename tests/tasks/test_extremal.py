"""Extremals: textbook values, steps, scipy's boundary value problems, corruptions, mistakes, marking."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_bvp

from solver.classroom.verdicts import Verdict
from solver.derivation import CheckStatus, Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue
from tests.helpers.marked import verdict

TASK = "extremal"
t = sp.Symbol("t")


def text(functional):
    return f"system: {{functional: {{{functional}}}}}\nfind: {{a: {TASK}}}\n"


def read(functional):
    return read_problem(Source("file.yaml", text(functional)), catalogue())


def solved(functional):
    return solve_problem(read(functional)).parts[0]


def value(written):
    return sp.sympify(written, locals={"t": t, "a": sp.Symbol("a", real=True), "T": sp.Symbol("T", real=True)})


def equal(found, wanted):
    difference = found - value(wanted)
    points = {symbol: sp.Rational(7 + i, 10) for i, symbol in enumerate(sorted(difference.free_symbols, key=str))}
    return abs(sp.N(difference.subs(points), 30)) < 1e-20


FIXED = "from: 0, to: 1, ends: {x: [0, 1]}"
TEXTBOOK = {
    # Elsgolc, chapter VI, and its problems; Gelfand and Fomin, §4, §12; Kirk, chapter 4; Naidu, chapter 2
    f"integrand: \"x'^2 + 12 x t\", {FIXED}": ("t**3", "21/5", "minimum"),
    "integrand: \"x'^2 - x^2\", from: 0, to: pi/2, ends: {x: [0, 1]}": ("sin(t)", "0", "minimum"),
    "integrand: \"x^2 - x'^2\", from: 0, to: pi/2, ends: {x: [0, 1]}": ("sin(t)", "0", "maximum"),
    "integrand: \"x'^2 - x^2 + 2 x t\", from: 0, to: pi/2, ends: {x: [0, 0]}":
        ("t - pi*sin(t)/2", "pi**3/24 - pi/2", "minimum"),
    f"integrand: \"x'^2 + x^2\", {FIXED}": ("sinh(t)/sinh(1)", "coth(1)", "minimum"),
    "integrand: \"x'^2 + a^2 x^2\", from: 0, to: T, ends: {x: [0, 1]}":
        ("sinh(a*t)/sinh(a*T)", "a*coth(a*T)", "minimum"),
    "integrand: \"x'^2/t^3\", from: 1, to: 2, ends: {x: [0, 15]}": ("t**4 - 1", "60", "minimum"),
    "integrand: \"x'^2/2 + x x' + x' + x\", from: 0, to: 2, ends: {x: [1, free]}":
        ("t**2/2 - 2*t + 1", "-4/3", "minimum"),
    "integrand: \"x'^2\", from: 0, to: 1, ends: {x: [1, free]}, terminal_cost: 3x^2":
        ("1 - 3*t/4", "3/4", "minimum"),
    "integrand: \"x''^2/2 - x\", from: 0, to: 1, ends: {x: [0, 0], \"x'\": [0, 0]}":
        ("t**2*(1 - t)**2/24", "-1/1440", "minimum"),
    "integrand: \"x'^2\", from: 0, to: 1, ends: {x: [0, 0]}, integral_constraints: [{integrand: x, value: 1}]":
        ("6*t - 6*t**2", "12", "minimum"),
    # x² is a parabola that is a square, with the value zero; a part of a circle
    "integrand: \"x^2 (1 - x')^2\", from: 0, to: 2, ends: {x: [1, 3]}": ("t + 1", "0", "minimum"),
    "integrand: \"sqrt(1 + x'^2)/x\", from: 0, to: 1, ends: {x: [1, 1]}":
        ("sqrt(1 + t - t**2)", "log((sqrt(5) + 1)/(sqrt(5) - 1))", "minimum"),
}  # fmt: skip


@pytest.mark.parametrize("functional", TEXTBOOK)
def test_textbook_extremals(functional):
    x, J, nature = TEXTBOOK[functional]
    result = solved(functional)
    assert result.status is Status.VERIFIED, result.reason
    assert equal(result.answers["x"], x)
    assert equal(result.answers["value"], J)
    assert result.answers["nature"] == nature


def test_conditions_with_fractional_powers_are_solved_exactly():
    written = "assume: {x: positive}\n" + text('integrand: "x x\'^2", from: 0, to: 1, ends: {x: [1, 4]}')
    result = solve_problem(read_problem(Source("file.yaml", written), catalogue())).parts[0]
    assert result.status is Status.VERIFIED, result.reason
    assert "powers" in [step.kind for step in result.steps]
    assert equal(result.answers["x"], "(1 + 7*t)**(2/3)")
    assert result.answers["value"] == sp.Rational(196, 9)


FREE_TIMES = {
    # the shortest way to a line; a given end at a free time; Naidu, example 2.3
    'integrand: "sqrt(1 + x\'^2)", from: 0, to: free, ends: {x: [0, {on: 5 - t}]}': ("t", "5/2"),
    'integrand: "x\'^2 + 4", from: 0, to: free, ends: {x: [0, 4]}': ("2*t", "2"),
    'integrand: "x\'^2/2", from: 0, to: free, ends: {x: [0, {on: 2 - 3t}]}, terminal_cost: t': (
        "(sqrt(11) - 3)*t",
        "2/sqrt(11)",
    ),
}


@pytest.mark.parametrize("functional", FREE_TIMES)
def test_free_times(functional):
    x, t_f = FREE_TIMES[functional]
    result = solved(functional)
    assert result.status is Status.VERIFIED, result.reason
    assert equal(result.answers["t_f"], t_f)
    assert equal(result.answers["x"], x)


def test_the_steps_are_those_of_a_board():
    kinds = [step.kind for step in solved(f'integrand: "x\'^2 + x^2", {FIXED}').steps]
    assert kinds[:6] == ["equation", "characteristic", "homogeneous", "put_in", "linear", "functions"]
    assert "value" in kinds
    free = [step.kind for step in solved("integrand: x'^2, from: 0, to: 1, ends: {x: [1, free]}").steps]
    assert "natural" in free


def test_a_cyclic_function_has_a_first_integral():
    result = solved('integrand: "t x\'^2", from: 1, to: 2, ends: {x: [0, 1]}')
    assert "cyclic" in [step.kind for step in result.steps]
    assert equal(result.answers["x"], "log(t)/log(2)")


def test_state_equations_are_adjoined():
    result = solved(
        "integrand: u^2/2, functions: [x1, x2, u], from: 0, to: 1, ends: {x1: [1, 0], x2: [1, 0]}, "
        'constraints: ["x1\' = x2", "x2\' = u"]'
    )
    assert result.status is Status.VERIFIED
    functions = {str(name): f for name, f in result.answers["x"].items()}
    assert sp.expand(functions["u"] - (18 * t - 10)) == 0
    assert [str(each) for each in result.answers["equations"]] == [
        "lambda1_dot", "lambda1 + lambda2_dot", "lambda2 + u", "-x1_dot + x2", "u - x2_dot"
    ]  # fmt: skip


@settings(max_examples=10, deadline=None)
@given(st.lists(st.integers(-3, 3), min_size=5, max_size=5))
def test_fixed_ends_are_scipys(numbers):
    p, q, r, first, last = numbers
    result = solved(
        f"integrand: \"x'^2 + ({p * p}) x^2 + ({q}) t x + ({r}) x x'\", from: 0, to: 1, ends: {{x: [{first}, {last}]}}"
    )
    assert result.status is Status.VERIFIED, result.reason
    times = np.linspace(0, 1, 41)
    bvp = solve_bvp(
        lambda s, y: np.array([y[1], p * p * y[0] + q * s / 2]),
        lambda a, b: np.array([a[0] - first, b[0] - last]),
        times, np.array([np.linspace(first, last, 41), np.full(41, float(last - first))]), tol=1e-8,
    )  # fmt: skip
    ours = sp.lambdify(t, result.answers["x"], "numpy")(times) * np.ones(41)
    assert np.allclose(ours, bvp.sol(times)[0], atol=1e-6)


BEYOND = [
    ('integrand: "x\'^2/2 + cos(x)", from: 0, to: 1, ends: {x: [0, 1]}', "differential equation"),
    ('integrand: "x\'^2 - x^2", from: 0, to: pi, ends: {x: [0, 1]}', "No extremal satisfies"),
    ('integrand: "x + t x\'", from: 0, to: 1, ends: {x: [0, 1]}', "for every function"),
    ('integrand: "x + x\'", from: 0, to: 1, ends: {x: [0, 1]}', "has no extremals"),
    ('integrand: "x^2 (1 - x\')^2", from: 0, to: 2, ends: {x: [0, 1]}', "is not real and finite"),
    ('integrand: "x\'^2/x^4", from: 0, to: 2, ends: {x: [1, -1]}', "is not real and finite"),
    ('integrand: "sqrt((1 + x\'^2)/x)", from: 0, to: 1, ends: {x: [0, 1]}', r"\dot{x}^{2}"),
]


@pytest.mark.parametrize(("functional", "says"), BEYOND)
def test_what_has_no_extremal_is_said(functional, says):
    result = solved(functional)
    assert result.status is Status.UNSOLVED
    assert says in str(result.reason)
    assert result.steps[0].kind == "equation"


def test_without_ends_the_constants_stay():
    result = solved('integrand: "x\'^2 + 2 x sin(t)", from: 0, to: 1')
    assert result.status is Status.VERIFIED
    assert {str(each) for each in result.answers["x"].free_symbols} == {"C1", "C2", "t"}


def rejected(functional, **answers):
    task, part = catalogue()[TASK], read(functional).parts[0]
    checks = list(task.verify(task.given(part.system, {}), answers))
    return not checks or any(check.status is CheckStatus.FAILED for check in checks)


def test_equations_may_have_factors_and_be_in_any_order():
    x, v, a = (sp.Symbol(name, real=True) for name in ("x", "x_dot", "x_ddot"))
    functional = f'integrand: "x\'^2 + x^2", {FIXED}'
    for right in ([a - x], [3 * x - 3 * a], [(a - x) / (1 + x**2)]):
        assert not rejected(functional, equations=right)
    for wrong in ([a + x], [a - 2 * x], [a - x + v], [x], [a - x, a - x], []):
        assert rejected(functional, equations=wrong)


def test_corrupted_extremals_are_rejected():
    functional = f'integrand: "x\'^2 + x^2", {FIXED}'
    x = sp.sinh(t) / sp.sinh(1)
    assert not rejected(functional, x=x)
    for wrong in (t, sp.sin(t) / sp.sin(1), x * t, sp.sinh(t), -x):
        assert rejected(functional, x=wrong)
    for wrong in (-sp.cosh(1) / sp.sinh(1), sp.cosh(1), sp.Integer(1)):
        assert rejected(functional, x=x, value=wrong)


MISTAKES = [
    ("integrand: \"x^2 - x'^2\", from: 0, to: pi/2, ends: {x: [0, 1]}", "equations", "[x'' - x]", "euler_sign"),
    ("integrand: \"x^2 - x'^2\", from: 0, to: pi/2, ends: {x: [0, 1]}", "x", "sinh(t)/sinh(pi/2)", "euler_sign"),
    ("integrand: \"exp(t)(x'^2 + x^2)\", from: 0, to: 2, ends: {x: [0, 1]}", "equations", "[x'' - x]",
     "total_derivative"),
    ("integrand: \"x'^2 + 4x\", from: 0, to: 1, ends: {x: [1, free]}, terminal_cost: 3x", "x", "(t - 1)^2",
     "terminal_cost"),
    ("integrand: \"x'^2\", from: 0, to: 1, ends: {x: [1, free]}, terminal_cost: 3x^2", "x", "1 - t", "free_end"),
    ("integrand: \"x'^2 + x'\", from: 0, to: free, ends: {x: [1, {on: t/2}]}", "x", "1 - t/2", "transversality"),
]  # fmt: skip


@pytest.mark.parametrize(("functional", "answer", "wrote", "slip"), MISTAKES)
def test_usual_mistakes_are_named(functional, answer, wrote, slip):
    found = verdict(text(functional), "a", answer, wrote if wrote[0] == "[" else f'"{wrote}"')
    assert (found.verdict, found.mistake) == (Verdict.WRONG, slip)


def test_infinitely_many_extremals_keep_a_constant():
    functional = 'integrand: "x^2 - x\'^2", from: 0, to: pi, ends: {x: [0, 0]}'
    result = solved(functional)
    assert result.status is Status.VERIFIED
    assert {str(each) for each in result.answers["x"].free_symbols} == {"C2", "t"}
    assert result.answers["value"] == 0
    assert "nature" not in result.answers
    assert not rejected(functional, x=3 * sp.sin(t))


def test_of_several_extremals_the_one_with_the_least_value_is_told():
    result = solved('integrand: "x sqrt(1 + x\'^2)", from: 0, to: 1, ends: {x: [1, 2]}')
    assert result.status is Status.VERIFIED
    assert "several" in [step.kind for step in result.steps]
    assert float(result.answers["value"]) == pytest.approx(2.0788300900)


def test_a_multiplier_that_turns_the_solution_is_not_guessed():
    result = solved(
        "integrand: x'^2, from: 0, to: pi, ends: {x: [0, 0]}, integral_constraints: [{integrand: x^2, value: 1}]"
    )
    assert result.status is Status.UNSOLVED
    assert "cannot be solved" in str(result.reason)


def test_equations_beyond_are_told_where_no_ends_are_given():
    result = solved('integrand: "m l^2 x\'^2/2 + m g l cos(x)", from: 0, to: T')
    assert result.status is Status.VERIFIED
    assert [str(each) for each in result.answers["equations"]] == ["g*sin(x) + l*x_ddot"]
    assert set(result.answers) == {"equations"}
