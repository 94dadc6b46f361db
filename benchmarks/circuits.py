"""A ladder of inductors and capacitors in state space, all symbols: how the time grows with its number of states."""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import partial

from benchmarks.timing import Failure, Row, milliseconds
from solver.engine import found_by
from solver.problem.model import Part
from solver.problem.reader import read_problem
from solver.problem.source import Source
from solver.tasks import catalogue


def ladder(n: int) -> Part:
    """The question about a ladder of n inductors and capacitors between two resistors."""
    lines, node = ["V1 1 0 u", "R1 1 2"], 2
    for i in range(1, n // 2 + 1):
        lines += [f"L{i} {node} {node + 1}", f"C{i} {node + 1} 0"]
        node += 1
    system = {"circuit": [*lines, f"R2 {node} 0"], "outputs": [f"v_{node}"]}
    text = f"system: {json.dumps(system)}\nfind: {{a: state_space_model}}\n"
    return read_problem(Source("ladder.yaml", text), catalogue()).parts[0]


def rows() -> Iterator[Row | Failure]:
    """Return the lines of the table, a shorter ladder first."""
    for n, at_most in ((4, None), (10, 200)):
        part = ladder(n)
        time = milliseconds(partial(found_by, "kirchhoff", part, {}))
        yield Row(f"ladder of {n} L and C to A, B, C, D", time, at_most=at_most)
