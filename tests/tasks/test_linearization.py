"""Linear models about a point: textbook values, numeric Jacobians, conditions, points that are none, rejections."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Answers, CheckStatus, Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.tasks import catalogue
from tests.helpers.marked import verdict
from tests.helpers.solved import document_of_problem

CART = """
  equations:
    - "(m_c + m_p) x'' + b x' + m_p l cos(theta) theta'' - m_p l sin(theta) theta'^2 = u"
    - "(J + m_p l^2) theta'' + m_p l cos(theta) x'' - m_p g l sin(theta) = 0"
  inputs: [u]
  outputs: [x, theta]
"""


def read(system, at="{}", more=""):
    text = f"system:\n{system}\n{more}\nfind: {{a: {{task: linearization, at: {at}}}}}\n"
    return read_problem(Source("file.yaml", text), catalogue())


def solved(system, at="{}", more=""):
    return solve_problem(read(system, at, more)).parts[0]


def accepted(system, at, **answers):
    task, part = catalogue()["linearization"], read(system, at).parts[0]
    found = {name: sp.ImmutableMatrix(M) for name, M in answers.items()}
    checks = list(task.verify(task.given(part.system, part.options), found))
    return bool(checks) and all(check.status is CheckStatus.PASSED for check in checks)


@pytest.mark.parametrize(("at", "sign"), [("{theta: 0, u: 0}", 1), ("{theta: pi, u: 0}", -1)])
def test_the_pendulum_on_a_cart_as_the_note_has_it(at, sign):
    result = solved(CART, at)
    assert result.status is Status.VERIFIED
    assert [step.kind for step in result.steps] == ["highest", "states", "functions", "point", "entries", "matrices"]
    m_c, m_p, b, J, el, g = sp.symbols("m_c m_p b J l g", real=True)
    q = J * (m_c + m_p) + m_c * m_p * el**2
    A = sp.Matrix([
        [0, 1, 0, 0],
        [0, -(J + m_p * el**2) * b / q, -(m_p**2) * g * el**2 / q, 0],
        [0, 0, 0, 1],
        [0, sign * b * m_p * el / q, sign * m_p * g * el * (m_c + m_p) / q, 0],
    ])  # fmt: skip
    B = sp.Matrix([0, (J + m_p * el**2) / q, 0, -sign * m_p * el / q])
    assert sp.simplify(result.answers["A"] - A) == sp.zeros(4)
    assert sp.simplify(result.answers["B"] - B) == sp.zeros(4, 1)
    assert result.answers["C"] == sp.Matrix([[1, 0, 0, 0], [0, 0, 1, 0]])
    assert result.answers["D"] == sp.zeros(2, 1)
    assert "conditions" not in result.answers
    assert accepted(CART, at, A=A, B=B)
    for i, j in [(1, 1), (1, 2), (3, 1), (3, 2), (0, 1), (1, 3)]:
        wrong = A.copy()
        wrong[i, j] = -wrong[i, j] if wrong[i, j] != 0 and i else wrong[i, j] + sp.Rational(1, 1000)
        assert not accepted(CART, at, A=wrong), (i, j)
    assert not accepted(CART, at, A=sp.eye(3))
    assert not accepted(CART, at, B=-B)
    assert not accepted(CART, at, C=sp.eye(4))
    assert not accepted(CART, at, D=sp.ones(2, 1))


TANK = '  equations: ["A h\' = q - c sqrt(h)"]\n  inputs: [q]\n'
POSITIVE = "assume: {A: positive, c: positive}"


def test_what_is_not_given_must_satisfy_conditions():
    h, q, A, c = sp.Symbol("h", real=True), sp.Symbol("q", real=True), *sp.symbols("A c", positive=True)
    result = solved(TANK, "{}", POSITIVE)
    assert result.status is Status.VERIFIED
    assert result.answers["conditions"] == [sp.Eq(q, c * sp.sqrt(h))]
    assert sp.simplify(result.answers["A"][0] + c / (2 * A * sp.sqrt(h))) == 0
    at_four = solved(TANK, "{h: 4}", POSITIVE)
    assert at_four.answers["conditions"] == [sp.Eq(q, 2 * c)]
    assert at_four.answers["A"][0] == -c / (4 * A)
    both = solved(TANK, '{h: 4, q: "c sqrt(h)"}', POSITIVE)
    assert both.status is Status.VERIFIED
    assert "conditions" not in both.answers


def test_names_that_a_condition_gives_a_number_are_put_in():
    system = '  equations: ["x1\' = x2", "x2\' = -sin(x1) - d x2 + x2^2 cos(x1) + u"]\n  inputs: [u]\n'
    result = solved(system, "{x1: pi}")
    assert result.status is Status.VERIFIED
    assert [str(each) for each in result.answers["conditions"]] == ["Eq(x2, 0)", "Eq(u, 0)"]
    assert result.answers["A"] == sp.Matrix([[0, 1], [1, -sp.Symbol("d", real=True)]])


@pytest.mark.parametrize(
    ("system", "at", "says"),
    [
        ("  equations: [\"x'' = -sin(x) + u\"]\n  inputs: [u]\n", "{x: 1, u: 0}", "no equilibrium"),
        ("  equations: [\"x'' = -sin(x) + u\"]\n  inputs: [u]\n", "{x: 0, x': 2, u: 0}", "no equilibrium"),
        (TANK, "{h: 0}", "no derivative"),
        (TANK, "{h: -1}", "no derivative"),
        ('  equations: ["v\' = -v abs(v) - abs(v) + u"]\n  inputs: [u]\n', "{v: 0}", "no derivative"),
        ('  equations: ["x\' = 1/x - 1/x", "z\' = (x - z)/x"]\n', "{x: 0}", "no derivative"),
        ("  time: discrete\n  equations: ['y(k+1) = y(k)^2 + 1']\n", "{y: 1}", "no equilibrium"),
    ],
)
def test_a_point_at_which_there_is_no_model_is_unsolved(system, at, says):
    result = solved(system, at, POSITIVE if system == TANK else "")
    assert result.status is Status.UNSOLVED
    assert says in str(result.reason) or result.reason.kind.split("/")[1] in ("no_equilibrium", "undefined")


@pytest.mark.parametrize(
    ("at", "says"),
    [
        ("{phi: 0}", "'phi' is neither an unknown nor an input of the system"),
        ("{thet: 0}", "did you mean 'theta'?"),
        ("[0, 1]", "has values of states and inputs"),
        ("{from: b, point: 1}", "'b' is not an earlier part"),
        ("{theta: 1/0}", "division by zero"),
    ],
)
def test_a_point_at_fault_is_told_at_its_place(at, says):
    with pytest.raises(InputError) as caught:
        read(CART, at)
    found = [f"{each.message} did you mean '{each.suggestion}'?" for each in caught.value.diagnostics]
    assert any(says in message for message in found), found
    assert all(each.column > 30 for each in caught.value.diagnostics)


def test_fixed_points_in_discrete_time():
    result = solved(
        "  time: discrete\n  equations: ['y(k+2) = r y(k+1)(1 - y(k)) + u(k)']\n  inputs: [u]\n", "{y: 1/2}"
    )
    r = sp.Symbol("r", real=True)
    assert result.status is Status.VERIFIED
    assert result.answers["A"] == sp.Matrix([[0, 1], [-r / 2, r / 2]])
    assert result.answers["conditions"] == [sp.Eq(sp.Symbol("u(k)", real=True), sp.Rational(1, 2) - r / 4)]


def test_a_linear_model_is_a_system_for_later_parts():
    numbers = "parameters: {m_c: 0.5, m_p: 0.2, b: 0.1, l: 0.3, J: 0.009, g: 9.81}"
    asked = "  a: {task: linearization, at: {theta: 0, u: 0}}\n  b: {task: controllability, system: {from: a}}\n"
    text = f"system:\n{CART}\n{numbers}\nfind:\n{asked}"
    result = solve_problem(read_problem(Source("file.yaml", text), catalogue()))
    assert result.status is Status.VERIFIED
    assert result.parts[1].answers["controllable"] is True


terms = st.sampled_from(["sin(x)", "cos(z)", "x^2", "x z'", "exp(z)", "z'^2", "x' z", "u cos(x)", "u^2", "1/(2 + x^2)"])


@settings(max_examples=5, deadline=None)
@given(st.lists(st.tuples(st.integers(-3, 3), terms), min_size=3, max_size=5), st.integers(1, 3), st.booleans())
def test_generated_equations_have_the_jacobian_of_differences(chosen, inertia, coupled):
    right = " + ".join(f"({c})*{term}" for c, term in chosen)
    mass = f"({inertia} + cos(x)^2)*x'' + {'sin(z) z' + chr(39) * 2 if coupled else 0}"
    system = f"  equations: [\"{mass} + r = {right}\", \"z'' + x'' = -z + u\"]\n  inputs: [u]\n  outputs: [x z + u]\n"

    def rate(x, dx, z, dz, u, r):
        value = {
            "sin(x)": np.sin(x), "cos(z)": np.cos(z), "x^2": x**2, "x z'": x * dz, "exp(z)": np.exp(z), "z'^2": dz**2,
            "x' z": dx * z, "u cos(x)": u * np.cos(x), "u^2": u**2, "1/(2 + x^2)": 1 / (2 + x**2),
        }  # fmt: skip
        M = np.array([[inertia + np.cos(x) ** 2, np.sin(z) if coupled else 0.0], [1.0, 1.0]])
        ddx, ddz = np.linalg.solve(M, [sum(c * value[term] for c, term in chosen) - r, -z + u])
        return np.array([dx, ddx, dz, ddz])

    at, step = (0.5, 0.0, 0.25, 0.0, 0.25), 1e-6
    balance = float(rate(*at, 0.0)[1])  # r makes the point one of rest
    offset = balance * (inertia + np.cos(0.5) ** 2 - (np.sin(0.25) if coupled else 0.0))
    result = solved(system, "{x: 1/2, z: 1/4, u: 1/4}")
    assert result.status is Status.VERIFIED, result.reason
    moves = np.eye(5) * step
    J = np.array([(rate(*(at + d), offset) - rate(*(at - d), offset)) / (2 * step) for d in moves]).T
    numbers = {sp.Symbol("r", real=True): offset}
    for name, wanted in (("A", J[:, :4]), ("B", J[:, 4:])):
        found = np.array(result.answers[name].subs(numbers).evalf().tolist(), dtype=float)
        assert np.allclose(found, wanted, atol=1e-5), name


PENDULUM = """
system:
  equations: ["m l theta'' = -m g sin(theta) - d l theta' + u cos(theta)"]
  inputs: [u]
assume: {m: positive, l: positive, g: positive}
find:
  a: state_space_model
  b: {task: linearization, at: {theta: pi, u: 0}}
"""


@pytest.mark.parametrize(
    ("part", "name", "value", "says"),
    [
        ("a", "f", """["theta_dot", "-(g/l) sin(theta) - (d/m) theta_dot + u cos(theta)/(m l)"]""", ""),
        ("a", "f", """["theta'", "(u cos(theta) - m g sin(theta) - d l theta')/(m l)"]""", ""),
        ("a", "f", """["theta'", "-(g/l) sin(theta) + (d/m) theta' + u cos(theta)/(m l)"]""", "a term"),
        ("a", "f", """["theta'", "-(g/l) cos(theta) - (d/m) theta' + u sin(theta)/(m l)"]""", "sine and cosine"),
        ("b", "A", "[[0, 1], [g/l, -d/m]]", ""),
        ("b", "A", "[[0, 1], [-g/l, -d/m]]", "about the origin"),
        ("b", "B", "[0, -1/(m l)]", ""),
        ("b", "B", "[0, 1/(m l)]", "about the origin"),
        ("b", "A", "[[0, 1], [0, -d/m]]", "gravity is missing"),
    ],
)
def test_right_and_wrong_models_are_told_apart(part, name, value, says):
    found = verdict(PENDULUM, part, name, value)
    assert (found.verdict == "correct") == (not says)
    assert says in str(found.reason)


def test_a_point_of_an_earlier_part_has_the_inputs_that_this_part_keeps_constant():
    text = """
system:
  equations: ["x1' = 7x1 + 2 sin(x2) - x2^4 + u^3", "x2' = exp(x1) - 3x2 - 1 + 5x1^2 + sin(u)"]
  inputs: [u]
  outputs: ["exp(x1)"]
find:
  a: {task: equilibrium_points, inputs: {u: 0}, between: {x1: [-3, 3], x2: [-3, 3]}}
  b: {task: linearization, at: {from: a, point: 2}}
"""
    found, linear = solve_problem(read_problem(Source("file.yaml", text), catalogue())).parts
    assert linear.status is Status.VERIFIED
    assert "conditions" not in linear.answers
    assert linear.answers["B"] == sp.Matrix([0, 1])
    value = sp.exp(next(v for x, v in found.answers["points"][1].items() if str(x) == "x1"))
    assert linear.answers["C"][0].is_Float  # not e^0.858...
    assert abs(linear.answers["C"][0] - value) < 1e-12


def test_a_point_in_few_decimals_that_is_none_is_still_refused():
    result = solved('  equations: ["x\' = 1 - x^2"]', "{x: 1.000001}")
    assert result.status is Status.UNSOLVED


def test_partial_derivatives_by_samples_are_judged():
    """A sample y(k+1) is a variable like any other: what the page says of ∂f/∂y(k+1) is evaluated."""
    path = Path("problems/examples/delayed-logistic.yaml")
    document = document_of_problem(path)
    reasons = [check.reason for part in document.parts for check in part.checks if check.reason]
    assert not reasons


CSTR = """
  equations: ["V c' = q (c_i - c) - V r", "V T' = q (T_i - T) - h V r", "r = k c exp(-E/T)"]
  algebraic: [r]
  inputs: [c_i, T_i]
"""
TANKS = """
  equations: ["h1' = a sqrt(h2) - b sqrt(h1) + u", "h2' = v - d sqrt(h2)", "h3' = u - h3"]
  inputs: [u, v]
"""


@pytest.mark.parametrize("system", [CSTR, TANKS])
def test_too_few_conditions_are_rejected(system):
    """All of them make a point of rest, also with unknowns that are eliminated; each is needed."""
    result = solve_problem(read(system)).parts[0]
    assert result.status is Status.VERIFIED
    part, ours = read(system).parts[0], result.answers["conditions"]
    task = catalogue()["linearization"]
    assert len(ours) > 1
    for i in range(len(ours)):
        rest = Answers(conditions=[each for j, each in enumerate(ours) if j != i])
        checks = task.verify(task.given(part.system, part.options), rest)
        assert any(check.status is CheckStatus.FAILED for check in checks)
