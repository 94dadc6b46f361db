"""Regulators in discrete time: ours with steps and checks, every number to 30 digits, and scipy's P in floats."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from scipy.linalg import solve_discrete_are

from benchmarks.timing import Failure, Row, side_by_side
from solver.engine import solve_part
from solver.problem.model import Part
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue

A, B = [[-3, 2, -4], [1, 5, 0], [2, -1, 3]], [[1], [-2], [4]]
AT_MOST = 150


def read() -> Part:
    """The part that asks for P, K and the poles of three states with integers drawn at random."""
    plant = f"{{time: discrete, A: {A}, B: {B}}}"
    text = f"system: {plant}\nfind: {{a: {{task: lqr, method: hamiltonian, R: 1}}}}\n"
    return read_problem(Source("file.yaml", text), catalogue()).parts[0]


def ours(part: Part) -> Callable[[], Any]:
    """P, K and the poles with their steps, checked."""
    return lambda: solve_part(part, {})


def by_scipy() -> Any:
    """P in floats."""
    return solve_discrete_are(np.array(A, dtype=float), np.array(B, dtype=float), np.eye(3), np.eye(1))


def rows() -> Iterator[Row | Failure]:
    """Return the lines of the table."""
    mine, theirs = side_by_side(ours(read()), by_scipy)
    yield Row("discrete LQR, n = 3, random integers", mine, "scipy solve_discrete_are, floats", theirs, None, AT_MOST)
