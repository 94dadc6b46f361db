"""Differential equations by both methods: steps, answers against solve_ivp, corruptions, refusals, marking."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from solver.derivation import Answers, CheckStatus, Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.helpers.marked import verdict

T = sp.Symbol("t")
step, delta = sp.Heaviside, sp.DiracDelta
METHODS = ("laplace", "characteristic_equation")
e = sp.exp(-T)


def text(equations, u="", initial="", method="laplace", more=""):
    listed = ", ".join(f'"{each}"' for each in ([equations] if isinstance(equations, str) else equations))
    system = (
        f"equations: [{listed}]" + (", inputs: [u]" if u else "") + (f", initial: {{{initial}}}" if initial else "")
    )
    asks = f'input: {{u: "{u}"}}' if u else ""
    options = ", ".join(filter(None, [f"method: {method}", asks, more]))
    return f"system: {{{system}}}\nfind:\n  a: {{task: differential_equation, {options}}}\n"


def asked(*args, **named):
    return solve_problem(read_problem(Source("file.yaml", text(*args, **named)), catalogue())).parts[0]


def solution(*args, **named):
    result = asked(*args, **named)
    assert result.status is Status.VERIFIED, result.reason
    assert not [check for check in result.checks if check.status is CheckStatus.SKIPPED]
    return {str(name): f for name, f in result.answers["solution"].items()}


def rejected(question, found):
    task = catalogue()["differential_equation"]
    part = read_problem(Source("file.yaml", question), catalogue()).parts[0]
    named = {sp.Symbol(name, real=True): f for name, f in found.items()}
    checks = list(task.verify(task.given(part.system, part.options), Answers(solution=named)))
    return any(check.status is CheckStatus.FAILED for check in checks)


def same(f, g):
    points = (sp.Rational(3, 10), sp.Rational(17, 10), sp.Rational(5, 2))
    return all(abs(sp.N((f - g).subs(T, point), 30)) < 1e-25 for point in points)


@pytest.mark.parametrize(
    ("equation", "u", "orders"),
    [("x'' + 3x' + 2x = u", "sin(t)", [1, 2]), ("x'' + 4x = u", "t", [2]), ("x''' + x' = u", "cos(2t)", [1, 3])],
)
def test_a_trial_function_is_differentiated_as_often_as_the_equation_says(equation, u, orders):
    result = asked(equation, u, method="characteristic_equation")
    (trial,) = (each for step in result.steps for each in step.walk() if each.kind == "trial")
    assert [order for order, _ in trial.values["derivatives"]] == orders
    for order, found in trial.values["derivatives"]:
        assert sp.expand(found - sp.diff(trial.values["trial"].function, T, order)) == 0


TEXTBOOK = [
    ("x'' + 3x' + 2x = 0", "", 'x: 1, "x\'": 3', 5 * e - 4 * e**2),
    ("x'' + 2x' + 5x = u", "3", "", sp.Rational(3, 5) * (1 - e * (sp.cos(2 * T) + sp.sin(2 * T) / 2))),
    ("x'' + 4x = u", "sin(2t)", "", sp.sin(2 * T) / 8 - T * sp.cos(2 * T) / 4),
    ("x'' + 2x' + x = u", "exp(-t)", "x: 1", e * (1 + T + T**2 / 2)),
    ("x' + x = u", "t", "x: 1", T - 1 + 2 * e),
    ("x'' + x = u", "delta(t)", "", sp.sin(T)),
    ("x' + x = u", "step(t - 1)", "", (1 - sp.exp(1 - T)) * step(T - 1)),
    ("x' + x = u'", "1", "", e),
    ("x'' + 3x' + 2x = u' + 3u", "step(t)", "x: 1", sp.Rational(3, 2) - e**2 / 2),
    ("x' + 2x = 4", "", "x: 1", 2 - e**2),
]


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(("equation", "u", "initial", "wanted"), TEXTBOOK)
def test_equations_of_the_textbooks(equation, u, initial, wanted, method):
    assert same(solution(equation, u, initial, method)["x"], wanted)


@pytest.mark.parametrize("method", METHODS)
def test_systems_of_equations(method):
    found = solution(["x' = -2x + y", "y' = x - 2y + u"], "exp(-t)", "x: 1", method)
    assert same(found["x"], T * e / 2 + e / 4 + 3 * e**3 / 4)
    assert same(found["y"], T * e / 2 + 3 * e / 4 - 3 * e**3 / 4)
    masses = solution(["x'' = -2x + y", "y'' = x - 2y"], "", "x: 1", method)
    assert same(masses["x"], (sp.cos(T) + sp.cos(sp.sqrt(3) * T)) / 2)


def test_algebraic_equations_among_them():
    question = text(["x' = -y", "y = 2x + u"], "1", "x: 1").replace("initial:", "algebraic: [y], initial:")
    result = solve_problem(read_problem(Source("file.yaml", question), catalogue())).parts[0]
    assert result.status is Status.VERIFIED
    found = {str(name): f for name, f in result.answers["solution"].items()}
    assert same(found["x"], -sp.Rational(1, 2) + sp.Rational(3, 2) * e**2)
    assert same(found["y"], 3 * e**2)


def test_the_transform_is_set_up_with_the_values_at_the_start():
    result = asked("x'' + 3x' + 2x = u", "exp(-4t)", 'x: 1, "x\'": 2')
    s, X = sp.symbols("s X")
    equations = next(each for each in result.steps if each.kind == "equations")
    ((left, right),) = equations.values["lines"]
    assert left.operands[0].operands == (s**2 + 3 * s + 2, X)
    assert sp.cancel(sum(map(sp.sympify, right.operands)) - (1 / (s + 4) + s + 5)) == 0


def test_resonance_is_seen():
    kinds = {each.kind: each for each in asked("x'' + 4x = u", "sin(2t)", method="characteristic_equation").steps}
    assert kinds["trial"].values["trial"].resonance == 1


def test_a_jump_of_the_input_makes_a_derivative_jump():
    result = asked("x'' + 3x' + 2x = u' + 3u", "step(t)", "x: 1", "characteristic_equation")
    start = next(each for each in result.steps if each.kind == "start")
    assert start.values["before"] == [1, 0]
    assert start.values["after"] == [1, 1]
    assert result.steps[-1].kind == "solution"
    assert len(result.steps[-1].values["jumps"]) == 1


def test_parameters():
    K, late = sp.Symbol("K", real=True), sp.Symbol("T", positive=True)
    found = solution("T x' + x = K u", "1", more="assume: {T: positive}")["x"]
    assert sp.simplify(found - K * (1 - sp.exp(-T / late))) == 0


def test_a_solution_with_an_impulse_is_left_to_the_transform():
    result = asked("x' + x = u''", "1", method="characteristic_equation")
    assert result.status is Status.UNSOLVED
    assert "impulse" in str(result.reason)
    assert solution("x' + x = u''", "1")["x"] == delta(T) - sp.exp(-T)


numbers = st.integers(-3, 3)
inputs = st.sampled_from(["1", "t", "exp(-t)", "sin(2t)", "t*exp(-2t)", "cos(t)*exp(-t)"])


@settings(max_examples=10, deadline=None)
@given(st.lists(numbers, min_size=4, max_size=4), st.tuples(numbers, numbers), inputs, st.sampled_from(METHODS))
def test_generated_systems_against_solve_ivp(entries, start, u, method):
    a, b, c, d = entries
    equations = [f"x' = ({a})x + ({b})y + u", f"y' = ({c})x + ({d})y"]
    found = solution(equations, u, f"x: {start[0]}, y: {start[1]}", method)
    f = sp.lambdify(T, sp.sympify(u.replace("2t", "2*t")), "numpy")
    A = np.array([[a, b], [c, d]], dtype=float)
    run = solve_ivp(
        lambda t, v: A @ v + np.array([f(t), 0.0]), (0, 2), np.array(start, dtype=float), rtol=1e-11, atol=1e-12
    )
    for name, value in zip("xy", run.y[:, -1], strict=True):
        own = complex(sp.N(found[name].subs(T, 2), 20))
        assert abs(own - value) < 1e-6 * (1 + abs(value))


@settings(max_examples=10, deadline=None)
@given(
    st.lists(numbers, min_size=3, max_size=3), st.tuples(numbers, numbers, numbers), inputs, st.sampled_from(METHODS)
)
def test_generated_equations_of_third_order_against_solve_ivp(c, start, u, method):
    equation = f"x''' + ({c[2]})x'' + ({c[1]})x' + ({c[0]})x = u"
    found = solution(equation, u, f'x: {start[0]}, "x\'": {start[1]}, "x\'\'": {start[2]}', method)["x"]
    f = sp.lambdify(T, sp.sympify(u.replace("2t", "2*t")), "numpy")

    def slope(t, v):
        return [v[1], v[2], f(t) - c[0] * v[0] - c[1] * v[1] - c[2] * v[2]]

    run = solve_ivp(slope, (0, 2), np.array(start, dtype=float), rtol=1e-11, atol=1e-12)
    value = run.y[0, -1]
    assert abs(complex(sp.N(found.subs(T, 2), 20)) - value) < 1e-6 * (1 + abs(value))


@pytest.mark.parametrize(
    ("question", "wrong"),
    [
        (text("x'' + 3x' + 2x = 0", "", 'x: 1, "x\'": 3'), e),
        (text("x'' + 3x' + 2x = 0", "", 'x: 1, "x\'": 3'), 5 * e - 4 * sp.exp(-3 * T)),
        (text("x'' + 3x' + 2x = u' + 3u", "1", "x: 1"), sp.Rational(3, 2) - e / 2),
        (text("x' + x = u", "step(t - 1)"), 1 - e),
        (text("x' + x = u", "delta(t)"), sp.S.Zero),
        (text("x' + x = u'", "1"), sp.S.Zero),
    ],
)
def test_corrupted_solutions_are_rejected(question, wrong):
    assert rejected(question, {"x": wrong})
    part = solve_problem(read_problem(Source("file.yaml", question), catalogue())).parts[0]
    assert not rejected(question, {str(name): f for name, f in part.answers["solution"].items()})


def test_a_solution_without_one_of_the_unknowns_is_rejected():
    question = text(["x' = y", "y' = -x"], "", "x: 1")
    assert rejected(question, {"x": sp.cos(T)})
    assert not rejected(question, {"x": sp.cos(T), "y": -sp.sin(T)})


@pytest.mark.parametrize(
    ("question", "says"),
    [
        (text("x' + x = u", "1").replace('input: {u: "1"}', 'input: {w: "1"}'), "no input of the system"),
        (text("x' + x = u", "1").replace(', input: {u: "1"}', ""), "not given"),
        (text("x' + x = u", "exp(t^2)"), "not rational"),
        (text("x' + x^2 = u", "1"), "not linear"),
        (text("x' + x = u", "1", '"x\'": 1'), "no initial value"),
        (text("x' + x = u", "1", "u: 1"), "is an input"),
        (text("x' + x = 0", "", more="initial: {y: 1}"), "neither an unknown"),
    ],
)
def test_what_is_wrong_with_a_question_is_said(question, says):
    with pytest.raises(InputError) as raised:
        solve_problem(read_problem(Source("file.yaml", question), catalogue()))
    assert says in str(raised.value)


QUESTION = text("x'' + 3x' + 2x = u' + 3u", "step(t)", "x: 1")


@pytest.mark.parametrize("form", ["3/2 - e^(-2t)/2", "(3 - exp(-2t))/2"])
def test_equivalent_forms_are_right(form):
    assert verdict(QUESTION, "a", "solution", f'{{x: "{form}"}}').verdict == "correct"


@pytest.mark.parametrize(
    ("question", "wrong", "says"),
    [
        (text("x' + 2x = 0", "", "x: 3"), "0", "forgotten"),
        (text("x' + 2x = 0", "", "x: 3"), "-3exp(-2t)", "wrong sign"),
        (QUESTION, "3/2 + exp(-t)*0 - exp(-t) + exp(-2t)/2", "before the input acts"),
    ],
)
def test_usual_mistakes_are_named(question, wrong, says):
    found = verdict(question, "a", "solution", f'{{x: "{wrong}"}}')
    assert found.verdict == "wrong"
    assert says in str(found.reason)
