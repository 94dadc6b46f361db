"""Equilibria against textbooks and against systems that were made of them; corrupted answers; what is refused."""

from __future__ import annotations

from pathlib import Path

import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from solver.derivation import Answers, CheckStatus, Status
from solver.engine import solve_problem
from solver.problem.reader import read_problem
from solver.problem.source import InputError, Source
from solver.render.plain import sympy_text
from solver.tasks import catalogue

n, m = sp.symbols("n m", integer=True)


def read(system, options="", task="equilibrium_points", more=""):
    text = f"system: {{{system}}}\nfind:\n  a: {{task: {task}{', ' if options else ''}{options}}}\n{more}"
    return read_problem(Source("file.yaml", text), catalogue())


def solved(system, options="", more=""):
    return solve_problem(read(system, options, more=more)).parts[0]


def points(system, options="", more=""):
    result = solved(system, options, more)
    assert result.status is Status.VERIFIED, result.reason
    return [{str(name): value for name, value in point.items()} for point in result.answers["points"]]


def rejected(system, found, options=""):
    task, part = catalogue()["equilibrium_points"], read(system, options).parts[0]
    symbols = [{sp.Symbol(name, real=True): sp.S(value) for name, value in point.items()} for point in found]
    checks = task.verify(task.given(part.system, part.options), Answers(points=symbols))
    return any(check.status is CheckStatus.FAILED for check in checks)


CART = (
    "equations: [\"(m_c + m_p) x'' + b x' + m_p l theta'' cos(theta) - m_p l theta'^2 sin(theta) = u\", "
    "\"(J + m_p l^2) theta'' - m_p l g sin(theta) + m_p l x'' cos(theta) = 0\"], inputs: [u]"
)
PENDULUM = "equations: [\"m l^2 theta'' + b theta' + m g l sin(theta) = 0\"]"
PARABOLA = 'equations: ["x1\' = -x1 + x2", "x2\' = -x1 - x2 - x1^2"]'
NOTE = 'equations: ["x1\' = 7x1 + 2sin(x2) - x2^4 + u^3", "x2\' = exp(x1) - 3x2 - 1 + 5x1^2 + sin(u)"], inputs: [u]'
x = sp.Symbol("x", real=True)


def test_a_pendulum_on_a_cart_is_at_rest_anywhere_upright_or_hanging():
    result = solved(CART, "inputs: {u: 0}")
    assert [step.kind for step in result.steps] == ["rest", "inverse", "list"]
    assert points(CART, "inputs: {u: 0}") == [{"x": x, "x_dot": 0, "theta": n * sp.pi, "theta_dot": 0}]


def test_an_input_that_is_not_named_keeps_its_symbol_and_none_may_be_an_equilibrium():
    result = solved(CART)
    assert result.status is Status.VERIFIED
    assert result.answers["points"] == []
    assert [step.kind for step in result.steps] == ["rest", "contradiction", "list"]


def test_points_ascend_and_stand_before_families():
    assert points(PARABOLA) == [{"x1": -2, "x2": -2}, {"x1": 0, "x2": 0}]
    assert points('equations: ["x\' = x (x - 1)", "y\' = x y"]') == [
        {"x": 1, "y": 0},
        {"x": 0, "y": sp.Symbol("y", real=True)},
    ]


def test_the_second_equilibrium_that_the_note_misses():
    origin, second = points(NOTE, "inputs: {u: 0}")
    assert origin == {"x1": 0, "x2": 0}
    assert abs(second["x1"] - sp.Float("0.858521413839465")) < 1e-13
    assert abs(second["x2"] - sp.Float("1.68165474301064")) < 1e-13
    a, b = second["x1"], second["x2"]
    assert abs(7 * a + 2 * sp.sin(b) - b**4) < 1e-12


def test_both_links_of_an_acrobot_hang_or_stand_each_by_itself():
    system = (
        "equations: [\"M q1'' + c q2'' + (m1 l_c1 + m2 l_1) g sin(q1) + m2 g l_c2 sin(q1 + q2) = 0\", "
        "\"c q1'' + I q2'' + m2 g l_c2 sin(q1 + q2) = tau\"], inputs: [tau]"
    )
    (family,) = points(system, "inputs: {tau: 0}")
    assert family == {"q1": n * sp.pi, "q1_dot": 0, "q2": m * sp.pi, "q2_dot": 0}


def test_integers_are_never_names_of_the_question():
    (family,) = points("equations: [\"n theta'' + m sin(theta) = 0\"]")
    assert family["theta"] == sp.Symbol("n1", integer=True) * sp.pi


def test_the_input_that_hovers_is_asked_for():
    forces = "\"m x'' = -F sin(theta)\", \"m y'' = F cos(theta) - m g\""
    system = f"equations: [{forces}, \"J theta'' = r tau\"], inputs: [F, tau]"
    (family,) = points(system, "unknowns: [theta, F, tau]")
    M, g = sp.symbols("m g", real=True)
    named = sp.Symbol("n", integer=True)
    assert family == {"theta": named * sp.pi, "F": (-1) ** named * M * g, "tau": 0}


def test_levels_of_tanks_are_found_through_roots():
    level, g, V, k, a = sp.symbols("h g V k a", real=True)
    (point,) = points('equations: ["A h\' = k V - a sqrt(2 g h)"], inputs: [V]')
    assert sp.expand(point["h"] - (k * V / a) ** 2 / (2 * g)) == 0
    assert level not in point["h"].free_symbols


def test_fixed_points_of_a_map():
    assert points('equations: ["x(k+1) = 2.5 x(k) (1 - x(k))"], time: discrete') == [
        {"x(k)": 0},
        {"x(k)": sp.Rational(3, 5)},
    ]
    (still,) = points('equations: ["y(k+2) = y(k+1)/2 - y(k) + 3"], time: discrete')
    assert still == {"y(k)": 2, "y(k+1)": 2}


def test_an_algebraic_unknown_is_solved_for_and_not_told():
    (point,) = points(
        'equations: ["J w\' = tau - b w", "tau = K i", "R i = V - K w"], algebraic: [tau, i], inputs: [V]'
    )
    K, V, b, R = sp.symbols("K V b R", real=True)
    assert sp.cancel(point["w"] - K * V / (b * R + K**2)) == 0
    assert list(point) == ["w"]


def test_where_roots_are_searched_is_said():
    step = next(s for s in solved(NOTE, "inputs: {u: 0}, between: {x2: [-1, 3/2]}").steps if s.kind == "search")
    assert step.values["certain"]
    assert dict(step.values["box"])[sp.Symbol("x2", real=True)] == (-1, sp.Rational(3, 2))
    assert step.values["found"] == [[(sp.Symbol("x2", real=True), 0)]]


CORRUPTED = [
    (PENDULUM, [{"theta": sp.pi, "theta_dot": 0}]),
    (PENDULUM, [{"theta": 2 * n * sp.pi, "theta_dot": 0}]),
    (PENDULUM, [{"theta": n * sp.pi / 2, "theta_dot": 0}]),
    (PENDULUM, [{"theta": 0, "theta_dot": 0}, {"theta": sp.pi, "theta_dot": 0}]),
    (PENDULUM, [{"theta": n * sp.pi, "theta_dot": 1}]),
    (PENDULUM, [{"theta": n * sp.pi}]),
    (PENDULUM, []),
    (PARABOLA, [{"x1": 0, "x2": 0}]),
    (PARABOLA, [{"x1": -2, "x2": -2}, {"x1": 0, "x2": 0}, {"x1": 1, "x2": 1}]),
    (PARABOLA, [{"x1": -2, "x2": -2 + sp.Rational(1, 10**6)}, {"x1": 0, "x2": 0}]),
    (PARABOLA, [{"x1": sp.Float("-2.000001", 15), "x2": sp.Float(-2, 15)}, {"x1": 0, "x2": 0}]),
]


@pytest.mark.parametrize(("system", "found"), CORRUPTED)
def test_corrupted_points_are_rejected(system, found):
    assert rejected(system, found)


@pytest.mark.parametrize(
    "found",
    [
        [{"theta": n * sp.pi, "theta_dot": 0}],
        [{"theta": 2 * n * sp.pi, "theta_dot": 0}, {"theta": (2 * m + 1) * sp.pi, "theta_dot": 0}],
        [{"theta": sp.pi - n * sp.pi, "theta_dot": 0}],
    ],
)
def test_a_family_may_be_written_in_several_ways(found):
    assert not rejected(PENDULUM, found)


roots = st.lists(st.fractions(-4, 4, max_denominator=3), min_size=1, max_size=3, unique=True)


@settings(max_examples=15)
@given(roots, st.integers(-3, 3), st.integers(1, 3))
def test_a_system_made_of_its_equilibria_has_them(found, a, b):
    """x' = Π (x − rᵢ), y' = a x + b y."""
    product = " ".join(f"(x - ({r}))" for r in found)
    expected = [{"x": sp.Rational(r), "y": -a * sp.Rational(r) / b} for r in sorted(map(sp.Rational, map(str, found)))]
    assert points(f'equations: ["x\' = {product}", "y\' = ({a}) x + {b} y"]') == expected


@settings(max_examples=15)
@given(st.integers(-4, 4), st.integers(-4, 4), st.integers(-4, 4), st.integers(-4, 4))
def test_circles_through_two_points_meet_there(a, b, c, d):
    """A circle around the origin through (a, b) and a line through (a, b) and (c, d)."""
    if (a, b) == (c, d) or (a, b) == (0, 0):
        return
    system = f'equations: ["x\' = x^2 + y^2 - ({a**2 + b**2})", "y\' = ({d - b})*(x - ({a})) - ({c - a})*(y - ({b}))"]'
    assert {"x": a, "y": b} in points(system)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ("inputs: {v: 0}", "'v' is no input of the system"),
        ("inputs: 3", "values by name"),
        ("unknowns: [thetta]", "'thetta' is neither an unknown nor an input of the system"),
        ("unknowns: [theta, theta]", "given twice"),
        ("between: {theta: 3}", "[a, b]"),
        ("between: {theta: [3, 1]}", "below the second"),
        ("between: {theta: [a, 1]}", "is a number"),
    ],
)
def test_what_the_file_shows_to_be_wrong_is_refused_at_its_place(options, message):
    with pytest.raises(InputError) as caught:
        read(CART, options)
    (fault,) = caught.value.diagnostics
    assert message in fault.message
    assert fault.line == 3


def test_a_mistyped_name_gets_a_suggestion():
    with pytest.raises(InputError) as caught:
        read(CART, "unknowns: [thetta]")
    assert caught.value.diagnostics[0].suggestion == "theta"


def test_what_no_formula_solves_needs_numbers():
    result = solved('equations: ["x\' = a - x - exp(x)*sin(x)"]')
    assert result.status is Status.UNSOLVED
    assert "can be searched" in str(result.reason)


def test_points_as_data():
    result = solved(CART, "inputs: {u: 0}")
    assert sympy_text(result.answers["points"]) == "[{x: x, x_dot: 0, theta: pi*n, theta_dot: 0}]"


def test_the_example_is_verified():
    path = Path(__file__).parents[2] / "problems/examples/equilibrium-points.yaml"
    problem = read_problem(Source(path.name, path.read_text(encoding="utf-8")), catalogue())
    assert {part.status for part in solve_problem(problem).parts} == {Status.VERIFIED}


POLAR = """lagrangian: {coordinates: [r, theta], bodies: [{mass: m, position: [r sin(theta), -r cos(theta)]}],
 gravity: g, springs: [{stiffness: k, length: r, rest: l_0}]}"""


def test_where_the_motion_is_not_determined_there_is_no_equilibrium():
    """At r = 0 the factor of the angle's acceleration is zero: the equations hold there for some angles, no more."""
    (only,) = points(POLAR)
    assert only["theta"] == sp.pi * n
    result = solved('equations: ["(x - 1) x\' = x^2 - 1"]')
    assert result.status is Status.VERIFIED
    assert [list(point.values()) for point in result.answers["points"]] == [[-1]]
    (step,) = [step for step in result.steps if step.kind == "singular"]
    assert step.values["leading"] == [sp.ImmutableMatrix([[0]])]
    assert points('equations: ["y(k) y(k+1) = y(k)^2 - y(k)^3"], time: discrete') == []


def test_points_where_the_motion_is_not_determined_are_rejected():
    """Those that the equations without derivatives allow besides."""
    assert rejected('equations: ["(x - 1) x\' = x^2 - 1"]', [{"x": -1}, {"x": 1}])
    assert rejected('equations: ["1e-12 (x - 1) x\' = x^2 - 1"]', [{"x": -1}, {"x": 1}])
    assert not rejected('equations: ["1e-12 (x + 3) x\' = x^2 - 1"]', [{"x": -1}, {"x": 1}])


def test_points_far_away_are_missed():
    """No list is complete without them: x = 300 and x = −40 of a quadratic; roots that no formula gives within ±100."""
    far = 'equations: ["x\' = (x - 300)(x + 40)"]'
    assert not rejected(far, [{"x": 300}, {"x": -40}])
    assert rejected(far, [{"x": 300}])
    assert rejected(far, [])
    assert rejected('equations: ["x\' = 2000 - x"]', [])
    assert rejected('equations: ["x\' = exp(x/40) - 5"]', [])
