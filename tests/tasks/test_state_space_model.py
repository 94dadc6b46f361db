"""Equations in state space against scipy: algebraic unknowns, derivatives of inputs, samples, what is refused."""

from __future__ import annotations

import re

import numpy as np
import pytest
import scipy.signal
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import CheckStatus, Status
from solver.engine import refusals_of, solve_problem
from solver.messages import Messages
from solver.problem.model import Display
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.render.wording import Wording
from solver.tasks import catalogue
from solver.tasks.modelling.state_space_model import with_derivatives


def read(system, find="state_space_model"):
    return read_problem(Source("file.yaml", f"system: {{{system}}}\nfind: {{a: {find}}}\n"), catalogue())


def solved(system, find="state_space_model"):
    return solve_problem(read(system, find)).parts[0]


def numbers(M):
    return np.array(M.tolist(), dtype=float)


def complaint(system):
    with pytest.raises(InputError) as caught:
        read(system)
    return [f"{each.column} {each.message}" for each in caught.value.diagnostics]


def rejected(system, **answers):
    task, part = catalogue()["state_space_model"], read(system).parts[0]
    checks = task.verify(task.given(part.system, {}), {name: sp.ImmutableMatrix(M) for name, M in answers.items()})
    return any(check.status is CheckStatus.FAILED for check in checks)


MASS = """equations: ["m x'' + d x' + k x = u"], inputs: [u]"""


def test_coefficients_of_very_different_sizes_are_judged_by_their_own():
    """The companion matrix of (s + 1)(s + 2)…(s + 10), whose entries go from 1 to 3·10⁷."""
    low = [-round(c) for c in np.poly(-np.arange(1, 11))[:0:-1]]
    rows = [f"x{i}' = x{i + 1}" for i in range(1, 10)]
    rows.append("x10' = u" + "".join(f" {c:+d} x{i}" for i, c in enumerate(low, start=1)))
    system = f"equations: {rows}, inputs: [u]".replace("'x", '"x').replace("',", '",').replace("']", '"]')
    A = sp.Matrix(np.eye(10, k=1, dtype=int))
    A[9, :] = [low]
    result = solved(system)
    assert result.status is Status.VERIFIED
    assert result.answers["A"] == A
    for i, j in [(9, 0), (9, 9), (0, 1), (4, 9)]:
        wrong = A.copy()
        wrong[i, j] += 1
        assert rejected(system, A=wrong)


def test_a_mass_with_spring_and_damper():
    result = solved(MASS)
    m, d, k = sp.symbols("m d k", real=True)
    assert result.status is Status.VERIFIED
    assert [step.kind for step in result.steps] == ["highest", "states", "matrices"]
    assert result.answers["A"] == sp.Matrix([[0, 1], [-k / m, -d / m]])
    assert result.answers["B"] == sp.Matrix([0, 1 / m])
    assert result.answers["C"] == sp.Matrix([[1, 0]])


coefficients = st.lists(st.integers(-5, 5), min_size=1, max_size=3)


@settings(max_examples=15)
@given(coefficients, coefficients, st.booleans())
def test_derivatives_of_the_input_are_realized(low, above, discrete):
    n = len(low)
    above = above[: n + 1]

    def term(name, order):
        return f"{name}(k+{order})" if discrete else f"{name}^({order})" if order else name

    left = " + ".join([term("y", n), *(f"({c})*{term('y', i)}" for i, c in enumerate(low))])
    right = " + ".join(f"({c})*{term('u', i)}" for i, c in enumerate(above))
    result = solved(f"equations: ['{left} = {right}'], inputs: [u]" + (", time: discrete" if discrete else ""))
    assert result.status is Status.VERIFIED
    A, B, C, D = (numbers(result.answers[name]) for name in "ABCD")
    numerator, denominator = scipy.signal.ss2tf(A, B, C, D)
    expected = np.zeros(n + 1)
    expected[n + 1 - len(above) :] = above[::-1]
    assert np.allclose(denominator, [1, *low[::-1]], atol=1e-6)
    assert np.allclose(numerator[0], expected, atol=1e-6)


@settings(max_examples=10)
@given(st.lists(st.integers(-4, 4), min_size=8, max_size=8))
def test_two_coupled_unknowns_move_as_scipy_integrates_them(c):
    system = (
        f"equations: [\"2x'' + x' + ({c[0]})*x + ({c[1]})*z' = ({c[2]})*u\", "
        f"\"z' + x' + ({c[3]})*z + ({c[4]})*x = ({c[5]})*u\"], "
        f"inputs: [u], outputs: [x, ({c[6]})*z + ({c[7]})*u], states: [z, x, x']"
    )
    result = solved(system)
    assert result.status is Status.VERIFIED
    A, B, C, D = (numbers(result.answers[name]) for name in "ABCD")
    state, u = np.array([0.7, -1.1, 0.4]), 1.3
    z, x, dx = state
    dz = -dx - c[3] * z - c[4] * x + c[5] * u
    ddx = (-dx - c[0] * x - c[1] * dz + c[2] * u) / 2
    assert np.allclose(A @ state + B[:, 0] * u, [dz, dx, ddx])
    assert np.allclose(C @ state + D[:, 0] * u, [x, c[6] * z + c[7] * u])


GEAR = (
    "equations: [\"J_m omega_m' = tau - tau_g\", \"J_L omega_L' + d omega_L = r tau_g\", 'omega_m = r omega_L'], "
    "algebraic: [omega_m, tau_g], inputs: [tau], outputs: [omega_L]"
)


def test_algebraic_unknowns_are_eliminated():
    result = solved(GEAR)
    J_m, J_L, r, d = sp.symbols("J_m J_L r d", real=True)
    assert result.status is Status.VERIFIED
    assert sp.cancel(result.answers["A"][0, 0] + d / (J_L + r**2 * J_m)) == 0
    assert sp.cancel(result.answers["B"][0, 0] - r / (J_L + r**2 * J_m)) == 0
    assert {str(name) for name in result.answers["eliminated"]} == {"omega_m", "tau_g"}
    assert result.steps[0].kind == "eliminated"


def test_samples_of_the_past_are_written_later():
    result = solved("time: discrete, equations: ['y(k) = 1.5y(k-1) - 0.5y(k-2) + u(k-1)'], inputs: [u]")
    assert result.status is Status.VERIFIED
    numerator, denominator = scipy.signal.ss2tf(*(numbers(result.answers[name]) for name in "ABCD"))
    assert np.allclose(denominator, [1, -1.5, 0.5])
    assert np.allclose(numerator[0], [0, 1, 0])


def test_every_task_about_a_plant_takes_linear_equations():
    start = solved(MASS + ", initial: {x: 1}", "{task: response, kind: zero_input, parameters: {m: 1, d: 3, k: 2}}")
    assert start.status is Status.VERIFIED
    assert start.answers["y"].subs(sp.Symbol("t"), 0) == 1
    G = solved(MASS, "transfer_function").answers["G"]
    s, m, d, k = sp.Symbol("s"), *sp.symbols("m d k", real=True)
    assert sp.cancel(G - 1 / (m * s**2 + d * s + k)) == 0
    free = solved('equations: ["x1\' = -x1 + x2", "x2\' = -3x2"]', "stability")
    assert sorted(free.answers["eigenvalues"]) == [-3, -1]


@pytest.mark.parametrize(
    ("system", "says"),
    [
        ('equations: ["x\' = y"], states: [x, y]', "1 equation for 2 unknowns (x, y)"),
        ('equations: ["x\' = u", "x\'\' = u"], inputs: u', "2 equations for 1 unknown (x)"),
        ("equations: [\"x' = u\", 'z = 1'], inputs: u, algebraic: [w]", "there is no equation for w"),
        ("equations: [\"x' = -x\"], states: [x']", "x' is no state: the highest derivative of x is of order 1"),
        ('equations: ["x\' = -x"], states: [2x]', "a function of time or a derivative of one is expected here"),
        ("equations: ['x = 3']", "no unknown is found"),
        ('equations: ["x^(9) = u"], inputs: u', "derivatives are read up to order 8"),
        ('equations: ["x\' = -t x"]', "the time t cannot stand"),
        ('equations: ["x\' = -x ="]', "one sign"),
        ("time: discrete, equations: ['y(2k) = y(k)']", "a function of time is written at the time k"),
        ('equations: ["x\' = -x"], initial: {z: 1}', "'z' is no unknown of the equations"),
    ],
)
def test_what_is_wrong_with_equations_is_said_at_its_place(system, says):
    found = complaint(system)
    assert any(says in message for message in found), found
    assert all(int(message.split()[0]) > 1 for message in found)


def test_the_order_of_a_derivative_stands_in_parentheses():
    model = read("equations: ['x^(4) + 2x = u'], inputs: u").system
    assert max(k for _, k in model.jets.values()) == 4


@pytest.mark.parametrize(
    ("system", "found"),
    [
        ("equations: [\"x' = u\", '3a = u'], inputs: u", ["32 no unknown occurs in this equation"]),
        ("equations: [\"x' = u\", \"x' = u\"], inputs: u", ["32 this equation stands above already"]),
        ("equations: [\"x' = u\"], inputs: u, algebraic: [z, w]",
         ["56 there is no equation for z", "59 there is no equation for w"]),
        ("equations: [\"x' = u\"], inputs: u, states: [x, v]", ["56 there is no equation for v"]),
        ("equations: [\"x' = u\", \"x'' = u\"], inputs: u", ["21 2 equations for 1 unknown (x)"]),
    ],
)  # fmt: skip
def test_an_equation_or_unknown_at_fault_is_named_by_its_place(system, found):
    assert complaint(system) == found


@pytest.mark.parametrize(
    ("typed", "shown"),
    [
        ("m x'' + d x' + k x = u", r"m\ddot{x} + d\dot{x} + kx = u"),
        ("-z' + 3 z/4 = -x^-1 + u/2 + x'", r"-\dot{z} + \frac{3}{4}z = -\frac{1}{x} + \frac{1}{2}u + \dot{x}"),
        ("a(x - z) - x' = 0", r"a(x - z) - \dot{x} = 0"),
        ("x' = x + u - x", r"\dot{x} = x + u - x"),
        ("u - x'", r"u - \dot{x} = 0"),
    ],
)
def test_equations_are_shown_in_the_order_in_which_they_are_typed(typed, shown):
    def plain(text):
        return re.sub(r"[\s{}]|\\left|\\right", "", text)

    problem = read(f'equations: ["{typed}", "z\' = x\'"], inputs: u, states: [x, z]')
    given = Wording.of(Display()).given(problem.system)
    assert plain(shown) in plain(given)


@pytest.mark.parametrize("task", ["stability", "routh_hurwitz"])
def test_nonlinear_equations_are_refused_by_the_file(task):
    (part,) = read("equations: [\"x'' = sin(x) + u\"], inputs: u", task).parts
    ((option, message),) = refusals_of(part, Messages())
    assert option == ""
    assert "linearization first" in message
    (part,) = read('equations: ["x\' = x + 1"]', task).parts
    assert refusals_of(part, Messages(language="de"))


@pytest.mark.parametrize(
    ("system", "says"),
    [
        ("equations: [\"x' + z' = u\", \"x' + z' = 2x\"], inputs: u", "cannot be solved for the highest derivatives"),
        ("equations: [\"x'' = u\"], inputs: u, states: [x]", "no states of the equations"),
        ('equations: ["x\' = u"], inputs: u, outputs: ["u\'"]', "improper"),
        ("time: discrete, equations: ['y(k+1) = y(k)'], outputs: ['y(k-1)']", "past samples"),
        ("equations: ['y = 2u'], inputs: u, states: [], algebraic: [y]", "no derivative"),
    ],
)
def test_what_has_no_state_space_is_unsolved(system, says):
    result = solved(system)
    assert result.status is Status.UNSOLVED
    assert says in str(result.reason)


def test_what_is_not_named_starts_at_zero():
    start = solved(MASS + ", initial: {x: 3}", "{task: response, kind: zero_input, parameters: {m: 1, d: 3, k: 2}}")
    assert start.status is Status.VERIFIED
    x, t = start.answers["y"], sp.Symbol("t")
    assert (x.subs(t, 0), sp.diff(x, t).subs(t, 0)) == (3, 0)


def test_an_input_that_moves_nothing_has_a_column_of_zeros_and_needs_no_more_steps():
    result = solved('equations: ["x\' = -2x"], inputs: [u]')
    assert [result.answers[name][0, 0] for name in "ABCD"] == [-2, 0, 1, 0]
    assert [step.kind for step in result.steps] == ["highest", "states", "matrices"]


def test_corrupted_answers_are_rejected():
    system = "equations: [\"2x'' + 3x' + 4x = 5u\"], inputs: [u], outputs: [\"x' + 6u\"]"
    right = {"A": [[0, 1], [-2, sp.Rational(-3, 2)]], "B": [[0], [sp.Rational(5, 2)]], "C": [[0, 1]], "D": [[6]]}
    assert not rejected(system, **right)
    for name, M in right.items():
        assert not rejected(system, **{name: M})
        for i in range(len(M)):
            for j in range(len(M[0])):
                wrong = [list(row) for row in M]
                wrong[i][j] += sp.Rational(1, 100)
                assert rejected(system, **{name: wrong}), (name, i, j)
    assert rejected(system, A=[[1]])
    shifted = "equations: [\"y'' + 3y' + 2y = u' + 5u\"], inputs: [u]"
    assert with_derivatives(catalogue()["state_space_model"].given(read(shifted).system, {}))
    assert not rejected(shifted, A=[[0, 1], [-2, -3]], B=[[0], [1]], C=[[5, 1]], D=[[0]])
    assert rejected(shifted, A=[[0, 1], [-2, -3]], B=[[0], [1]], C=[[5, 2]], D=[[0]])
    assert rejected(shifted, A=[[0, 1], [-2, -4]])
    assert rejected(shifted, A=[[0, 1, 0], [-2, -3, 0]])


CART = """
  equations:
    - "(m_c + m_p) x'' + b x' + m_p l cos(theta) theta'' - m_p l sin(theta) theta'^2 = u"
    - "(J + m_p l^2) theta'' + m_p l cos(theta) x'' - m_p g l sin(theta) = 0"
  inputs: [u]
  outputs: [x, theta]
"""


def nonlinear(system):
    return read_problem(Source("file.yaml", f"system:\n{system}\nfind: {{a: state_space_model}}\n"), catalogue())


def judged(system, **answers):
    """Whether none of the checks of these answers fails."""
    task, part = catalogue()["state_space_model"], nonlinear(system).parts[0]
    checks = task.verify(task.given(part.system, {}), {name: sp.ImmutableMatrix(M) for name, M in answers.items()})
    return all(check.status is CheckStatus.PASSED for check in checks)


def test_the_pendulum_on_a_cart_has_functions_for_its_model():
    result = solve_problem(nonlinear(CART)).parts[0]
    assert result.status is Status.VERIFIED
    assert [step.kind for step in result.steps] == ["highest", "states", "functions"]
    x, dx, theta, dtheta, u = sp.symbols("x x_dot theta theta_dot u", real=True)
    m_c, m_p, b, J, el, g = sp.symbols("m_c m_p b J l g", real=True)
    mass = sp.Matrix([[m_c + m_p, m_p * el * sp.cos(theta)], [m_p * el * sp.cos(theta), J + m_p * el**2]])
    force = sp.Matrix([u - b * dx + m_p * el * sp.sin(theta) * dtheta**2, m_p * g * el * sp.sin(theta)])
    ddx, ddtheta = mass.LUsolve(force)
    right = sp.Matrix([dx, ddx, dtheta, ddtheta])
    assert judged(CART, f=right)
    assert judged(CART, f=result.answers["f"], h=[x, theta])
    for i in range(4):
        for wrong in (right[i] + sp.Rational(1, 1000), -right[i], right[i].subs(b, -b) if i % 2 else right[i] + x):
            spoiled = right.copy()
            spoiled[i] = wrong
            assert not judged(CART, f=spoiled), (i, wrong)
    assert not judged(CART, f=[dx, dtheta, right[1], right[3]])
    assert not judged(CART, f=right[:3])
    assert not judged(CART, h=[x, theta + u])
    assert not judged(CART, h=[x, sp.Symbol("theta_ddot", real=True)])
    assert not judged(CART, A=sp.eye(4))


@pytest.mark.parametrize(
    ("system", "f", "h"),
    [
        ("  equations: [\"x' = x + 1\"]", ["x + 1"], ["x"]),
        ("  equations: [\"A h' = q - c sqrt(2 g h)\"]\n  inputs: [q]", ["(q - c*sqrt(2*g*h))/A"], ["h"]),
        ("  equations: [\"m v' = F - c v^2\", 'F = k i^2/v', \"L i' + R i = u\"]\n  inputs: [u]\n  algebraic: [F]\n"
         "  states: [v, i]\n  outputs: [F]", ["(k*i**2/v - c*v**2)/m", "(u - R*i)/L"], ["k*i**2/v"]),
        ("  equations: ['y(k+1) = r y(k)(1 - y(k))']", ["r*y*(1 - y)"], ["y"]),
        ("  equations: [\"theta_1'' = -sin(theta_1)\"]\n  outputs: [\"theta_1'''\"]", ["w", "-sin(p)"], ["-w*cos(p)"]),
        ("  equations: ['y(k) = y(k-1)^2 + u(k-2) y(k-2)']\n  inputs: [u]", ["z", "z**2 + u*y"], ["y"]),
        ("  equations: [\"theta_1'' = -g sin(theta_1) + r tau\", 'theta_2 = theta_1^2', \"tau = u - theta_2''\"]\n"
         "  inputs: [u]\n  algebraic: [theta_2, tau]\n  outputs: [theta_2]",
         ["w", "(-g*sin(p) + r*(u - 2*w**2))/(1 + 2*r*p)"], ["p**2"]),
    ],
)  # fmt: skip
def test_nonlinear_equations_of_all_kinds(system, f, h):
    discrete = "(k" in system
    result = solve_problem(nonlinear(system + ("\n  time: discrete" if discrete else ""))).parts[0]
    assert result.status is Status.VERIFIED, result.reason
    names = {"y": "y(k)", "z": "y(k+1)", "u": "u(k)"} if discrete else {"p": "theta_1", "w": "theta_1_dot"}
    real = {
        name: sp.Symbol(names.get(name, name), real=True) for name in "A g h q p c m v F k i L R u r y z w x".split()
    }
    for name, rows in (("f", f), ("h", h)):
        expected = sp.Matrix([sp.sympify(row, real) for row in rows])
        assert sp.simplify(sp.Matrix(result.answers[name]) - expected) == sp.zeros(len(rows), 1)


def test_squares_of_derivatives_need_no_parentheses():
    assert Wording.of(Display()).given(nonlinear(CART).system).count(r"\dot{\theta}^{2}") == 1


def test_a_name_mistyped_among_states_or_initial_values_gets_a_suggestion():
    equations = "equations: [\"theta'' = -sin(theta)\"], "
    for more in ("states: [thta, theta']", "initial: {thet: 1}"):
        with pytest.raises(InputError) as caught:
            read(equations + more)
        assert "theta" in [each.suggestion for each in caught.value.diagnostics]


def test_coupled_equations_show_their_mass_matrix():
    result = solve_problem(nonlinear(CART)).parts[0]
    (shown,) = result.steps[0].steps
    assert (shown.kind, shown.detail) == ("mass_matrix", "tutor")
    assert set(shown.claims) == {"collected", "determinant", "combined0", "combined1"}
    assert not solved(MASS).steps[0].steps


HOIST = """equations: ["m x'' = T - m g", "J omega' = tau - r T", "x' = r omega"], algebraic: [T, omega], inputs: [tau],
 outputs: [x, T]"""


def test_a_relation_of_derivatives_eliminates_what_is_no_state_of_its_own():
    """x' = r ω is differentiated: (m r² + J) x'' = r (τ − m g r)."""
    result = solved(HOIST)
    assert result.status is Status.VERIFIED, result.reason
    named = {str(symbol): symbol for symbol in result.answers["f"].free_symbols}
    m, r, J, g, tau = (named[name] for name in ("m", "r", "J", "g", "tau"))
    assert sp.simplify(result.answers["f"][1] - r * (tau - m * g * r) / (m * r**2 + J)) == 0
    assert str(next(v for k, v in result.answers["eliminated"].items() if str(k) == "omega")) == "x_dot/r"
