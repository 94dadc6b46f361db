"""Equations of motion with all symbols: ours with every step and claim, and sympy's LagrangesMethod."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator
from typing import Any

import sympy as sp
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

from benchmarks.timing import Failure, Row, side_by_side
from solver.conversions.lagrangian_to_equations import by_euler_lagrange
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.systems import Lagrangian
from solver.tasks import catalogue

CART = """lagrangian: {coordinates: [x, theta], bodies: [{mass: m_c, position: [x, 0]}, {mass: m_p,
 position: ["x + l sin(theta)", "l cos(theta)"], inertia: J, angle: theta}], gravity: g, forces: {x: u}}, inputs: [u]"""
ACROBOT = """lagrangian: {coordinates: [q1, q2], bodies: [{mass: m1, position: [c1 sin(q1), -c1 cos(q1)],
 inertia: I1, angle: q1}, {mass: m2, position: ["l1 sin(q1) + c2 sin(q1 + q2)", "-l1 cos(q1) - c2 cos(q1 + q2)"],
 inertia: I2, angle: q1 + q2}], gravity: g, forces: {q2: tau}}, inputs: [tau]"""


def read(system: str) -> Lagrangian:
    """The system of a problem."""
    text = f"system: {{{system}}}\nfind: {{a: equations_of_motion}}\n"
    found: Lagrangian = read_problem(Source("file.yaml", text), catalogue()).parts[0].system
    return found


def ours(system: Lagrangian) -> Any:
    """The equations, with the steps that lead to them."""
    steps: Generator[Any, None, Any] = by_euler_lagrange(system)
    while True:
        try:
            next(steps)
        except StopIteration as end:
            return end.value


def peer(system: Lagrangian) -> Callable[[], Any]:
    """The same by sympy: T and V formed of the positions, the equations simplified."""
    functions = [dynamicsymbols(name) for name in system.coordinates]
    put = dict(zip(system.symbols(), functions, strict=True))
    t = dynamicsymbols._t

    def form() -> Any:
        T, V = sp.S.Zero, sp.S.Zero
        for body in system.bodies:
            x, y = (each.xreplace(put) for each in body.position)
            T += body.mass * (x.diff(t) ** 2 + y.diff(t) ** 2) / 2
            V += body.mass * system.gravity * y
            if body.angle is not None:
                T += body.inertia * body.angle.xreplace(put).diff(t) ** 2 / 2
        return sp.trigsimp(LagrangesMethod(T - V, functions).form_lagranges_equations())

    return form


def rows() -> Iterator[Row | Failure]:
    """Return the lines of the table."""
    for name, text, at_most in (("pendulum on a cart", CART, 50), ("acrobot", ACROBOT, 250)):
        system = read(text)
        mine, theirs = side_by_side(lambda system=system: ours(system), peer(system))
        yield Row(f"equations of motion, {name}", mine, "sympy LagrangesMethod", theirs, 10, at_most)
