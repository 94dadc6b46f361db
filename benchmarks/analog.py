"""Programs of an analog computer, with steps and checks and simulated; scipy integrates the equation alone."""

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

COEFFICIENTS = 12, 22, 25, 15, 6
"""Of x to x'''' in x''''' + … = 12, whose roots are irrational."""
EQUATION = "x^(5) + 6x^(4) + 15x''' + 25x'' + 22x' + 12x = 12"
LARGEST = """{x: 2, "x'": 2, "x''": 2, "x'''": 4, "x^(4)": 8}"""
AT_MOST = 150


def read(options: str) -> Part:
    """The part that asks for the program."""
    system = f'{{equations: ["{EQUATION}"], initial: {{x: 0.5, "x\'": 1}}}}'
    text = f"system: {system}\nfind: {{a: {{task: analog_program{options}}}}}\n"
    return read_problem(Source("file.yaml", text), catalogue()).parts[0]


def ours(part: Part) -> Callable[[], Any]:
    """The program with its steps, simulated and checked."""
    return lambda: solve_part(part, {})


def by_scipy() -> Any:
    """The motion alone."""
    matrix = np.vstack([np.eye(5)[1:], -np.array(COEFFICIENTS, dtype=float)])
    drive = 12 * np.eye(5)[4]
    return solve_ivp(lambda _, x: matrix @ x + drive, (0, 20), [0.5, 1, 0, 0, 0], rtol=1e-9, atol=1e-10)


def rows() -> Iterator[Row | Failure]:
    """Return the lines of the table."""
    mine, theirs = side_by_side(ours(read(f", maximum: {LARGEST}")), by_scipy)
    yield Row("analog program, fifth order, simulated", mine, "scipy solve_ivp, motion alone", theirs, None, AT_MOST)
    mine, _ = side_by_side(ours(read("")), lambda: None)
    yield Row("the same, its largest sizes found first", mine)
