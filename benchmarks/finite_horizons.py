"""Regulators over a finite horizon: ours in closed form with steps and checks, and the same integrated by scipy."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from benchmarks.timing import Failure, Row, side_by_side
from solver.engine import solve_part
from solver.problem.model import Part
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue

PLANTS = (
    ("double integrator", "[[0, 1], [0, 0]]", 300),
    ("real modes, √5", "[[0, 1], [-2, -3]]", 300),
)


def read(A: str) -> Part:
    """The part that asks for P(t) and K(t), by the Hamiltonian matrix."""
    asked = "task: finite_horizon_lqr, method: hamiltonian, Q: [[1, 0], [0, 1]], R: 1, final_time: 2"
    text = f"system: {{A: {A}, B: [0, 1]}}\nfind: {{a: {{{asked}}}}}\n"
    return read_problem(Source("file.yaml", text), catalogue()).parts[0]


def ours(part: Part) -> Callable[[], Any]:
    """P(t), K(t) and the limit with their steps, checked."""
    return lambda: solve_part(part, {})


def by_scipy() -> Any:
    """P at the beginning of the horizon, one number an entry."""
    A, B = np.array([[0.0, 1.0], [0.0, 0.0]]), np.array([[0.0], [1.0]])

    def slope(_: float, flat: Any) -> Any:
        P = flat.reshape(2, 2)
        return (A.T @ P + P @ A - P @ B @ B.T @ P + np.eye(2)).ravel()

    return solve_ivp(slope, (0, 2), np.zeros(4), rtol=1e-10, atol=1e-12)


def rows() -> Iterator[Row | Failure]:
    """Return the lines of the table."""
    for name, A, at_most in PLANTS:
        mine, theirs = side_by_side(ours(read(A)), by_scipy)
        yield Row(f"finite horizon, {name}", mine, "scipy solve_ivp, numbers only", theirs, None, at_most)
