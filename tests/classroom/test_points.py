"""Equilibria and solutions as students write them: sets in any order, families by any name, mistakes by theirs."""

from __future__ import annotations

import pytest

from tests.helpers.marked import verdict

PENDULUM = """
system: {equations: ["m l^2 theta'' + b theta' + m g l sin(theta) = 0"]}
find: {a: equilibrium_points}
"""
PARABOLA = """
system: {equations: ["x1' = -x1 + x2", "x2' = -x1 - x2 - x1^2"]}
find: {a: equilibrium_points}
"""
NOTE = """
system: {equations: ["x1' = 7 x1 + 2 sin(x2) - x2^4", "x2' = exp(x1) - 3 x2 - 1 + 5 x1^2"]}
find: {a: equilibrium_points}
"""
CART = """
system:
  equations:
    - (M + m) x'' + b x' + m l theta'' cos(theta) - m l theta'^2 sin(theta) = u
    - (J + m l^2) theta'' - m l g sin(theta) + m l x'' cos(theta) = 0
  inputs: [u]
find: {a: {task: equilibrium_points, inputs: {u: 0}}}
"""
SPRING = """
system: {equations: ["m x'' + k x = m g"]}
find: {a: equilibrium_points}
"""
CURVES = """
find: {a: {task: solve_equations, equations: ["x^2 + y^2 = 25", "x y = 12"], unknowns: [x, y]}}
"""

RIGHT = [
    (PENDULUM, "[{theta: n*pi, theta_dot: 0}]"),
    (PENDULUM, "[{theta: k*pi, theta_dot: 0}]"),
    (PENDULUM, "{theta: n pi, theta': 0}"),
    (PENDULUM, '"theta = nπ, theta\' = 0"'),
    (PENDULUM, '"θ = nπ, n ∈ Z"'),
    (PENDULUM, '"(n pi, 0)"'),
    (PENDULUM, "[{theta: 2 n pi, theta_dot: 0}, {theta: pi + 2 n pi, theta_dot: 0}]"),
    (PENDULUM, "[{theta: 2 k pi, theta_dot: 0}, {theta: (2 k + 1) pi, theta_dot: 0}]"),
    (PARABOLA, "[{x1: 0, x2: 0}, {x1: -2, x2: -2}]"),
    (PARABOLA, "[[0, 0], [-2, -2]]"),
    (PARABOLA, '"(0, 0), (-2, -2)"'),
    (PARABOLA, '"x1 = 0, x2 = 0; x1 = -2, x2 = -2"'),
    (PARABOLA, '"x1 = x2 = 0 and x1 = x2 = -2"'),
    (PARABOLA, '"[(0, 0), (-2, -2)]"'),
    (PARABOLA, '"[[0, 0], [-2, -2]]"'),
    (PARABOLA, "{E1: {x1: 0, x2: 0}, E2: {x1: -4/2, x2: -sqrt(4)}}"),
    (PARABOLA, '"(x1, x2) = (0, 0), (x1, x2) = (-2, -2)"'),
    (NOTE, "[[0, 0], [0.8585, 1.682]]"),
    (NOTE, "[{x1: 0.858521, x2: 1.681655}, {x1: 0, x2: 0}]"),
    (CART, "[{x: x, x_dot: 0, theta: n*pi, theta_dot: 0}]"),
    (CART, '"(x, 0, nπ, 0)"'),
    (CART, '"(x1, 0, n pi, 0)"'),
    (CART, "{x: arbitrary, theta: k pi}"),
    (SPRING, '"x = mg/k"'),
]
WRONG = [
    (PENDULUM, "[[0, 0], [pi, 0]]", "one_turn", ["correct", "correct", "wrong"]),
    (PENDULUM, "[{theta: 0, theta_dot: 0}]", "one_turn", ["correct", "wrong"]),
    (PENDULUM, "[{theta: 2*k*pi, theta_dot: 0}]", "turns", ["correct", "wrong"]),
    (PENDULUM, "[{theta: n*pi/2, theta_dot: 0}]", "turns", ["wrong"]),
    (PENDULUM, "[{theta: n*pi, theta_dot: any}]", "moving", ["wrong"]),
    (PENDULUM, "none", "", ["wrong"]),
    (PARABOLA, "[[0, 0]]", "one_of_several", ["correct", "wrong"]),
    (PARABOLA, "[0, 0]", "one_of_several", ["correct", "wrong"]),
    (PARABOLA, "[[0, 0], [-2, 2]]", "", ["correct", "wrong"]),
    (PARABOLA, "[[0, 0], [-2, -2], [1, 1]]", "", ["correct", "correct", "wrong"]),
    (NOTE, "[[0, 0]]", "one_of_several", ["correct", "wrong"]),
    (NOTE, "[[0, 0], [0.86, 1.69]]", "", ["correct", "wrong"]),
    (CART, "{x: 0, theta: n pi}", "", ["correct", "wrong"]),
    (SPRING, '"x = -m g/k"', "gravity_sign", ["wrong"]),
]


@pytest.mark.parametrize(("problem", "value"), RIGHT)
def test_points_are_right_however_they_are_written(problem, value):
    found = verdict(problem, "a", "points", value)
    assert found.verdict == "correct", found.reason


@pytest.mark.parametrize(("problem", "value", "mistake", "entries"), WRONG)
def test_wrong_points_are_told_apart_and_their_mistake_is_named(problem, value, mistake, entries):
    found = verdict(problem, "a", "points", value)
    assert found.verdict == "wrong"
    assert (found.mistake, found.entries) == (mistake, entries)


def test_that_others_are_missing_is_told():
    found = verdict(CART, "a", "points", "{x: 0, theta: n pi}")
    assert "there are other points" in str(found.reason)


def test_a_name_that_is_no_unknown_is_not_read():
    found = verdict(PENDULUM, "a", "points", "[{phi: 0}]")
    assert found.verdict == "not judged"
    assert "none of the unknowns" in str(found.reason)


def test_solutions_in_any_order():
    right = "[{x: 3, y: 4}, {x: -3, y: -4}, {y: 3, x: 4}, [-4, -3]]"
    assert verdict(CURVES, "a", "solutions", right).verdict == "correct"
    half = verdict(CURVES, "a", "solutions", '"x = 3, y = 4 or x = 4, y = 3"')
    assert (half.verdict, half.mistake) == ("wrong", "one_of_several")
