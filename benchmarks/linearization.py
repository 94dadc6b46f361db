"""Linear models with all symbols: ours with every step and claim, and sympy's Matrix.jacobian and simplify."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import sympy as sp

from benchmarks.mechanics import ACROBOT, CART
from benchmarks.timing import Failure, Row, side_by_side
from solver.engine import found_by
from solver.problem.model import Part
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue

EQUATIONS = """equations: ["(m_c + m_p) x'' + b x' + m_p l cos(theta) theta'' - m_p l sin(theta) theta'^2 = u",
 "(J + m_p l^2) theta'' + m_p l cos(theta) x'' - m_p g l sin(theta) = 0"], inputs: [u]"""


def read(system: str, at: str) -> Part:
    """The part that asks for the linear model."""
    text = f"system: {{{system}}}\nfind: {{a: {{task: linearization, at: {at}}}}}\n"
    return read_problem(Source("file.yaml", text), catalogue()).parts[0]


def ours(part: Part) -> Callable[[], Any]:
    """A, B, C and D, with the steps that lead to them."""
    return lambda: found_by(part.methods[0], part, {})


def by_sympy() -> Any:
    """The same for the pendulum on a cart: solved for the accelerations, then Jacobians, simplified, at the point."""
    x, dx, theta, dtheta, u = sp.symbols("x x_dot theta theta_dot u", real=True)
    m_c, m_p, b, J, arm, g = sp.symbols("m_c m_p b J l g", real=True)
    mass = sp.Matrix([[m_c + m_p, m_p * arm * sp.cos(theta)], [m_p * arm * sp.cos(theta), J + m_p * arm**2]])
    force = sp.Matrix([u - b * dx + m_p * arm * sp.sin(theta) * dtheta**2, m_p * g * arm * sp.sin(theta)])
    acceleration = mass.LUsolve(force)
    f = sp.Matrix([dx, acceleration[0], dtheta, acceleration[1]])
    put = {theta: 0, dtheta: 0, dx: 0, u: 0}
    return [sp.simplify(f.jacobian(by)).subs(put) for by in ([x, dx, theta, dtheta], [u])]


def rows() -> Iterator[Row | Failure]:
    """Return the lines of the table."""
    part = read(EQUATIONS, "{theta: 0, u: 0}")
    mine, theirs = side_by_side(ours(part), by_sympy)
    yield Row("linearization, pendulum on a cart", mine, "sympy jacobian, simplify", theirs, 10, 60)
    for name, system, at, at_most in (
        ("pendulum on a cart", CART, "{theta: 0, u: 0}", 60),
        ("acrobot", ACROBOT, "{q1: 0, q2: 0, tau: 0}", 250),
    ):
        mine, _ = side_by_side(ours(read(system, at)), lambda: None)
        yield Row(f"motion and linearization, {name}", mine, at_most=at_most)
