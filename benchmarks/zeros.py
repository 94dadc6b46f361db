"""Poles and zeros of several inputs and outputs: ours with every step, and sympy's inverse and determinant."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from random import Random
from typing import Any

import sympy as sp

from benchmarks.timing import Failure, Row, side_by_side
from solver.engine import found_by
from solver.problem.model import Part
from solver.systems import StateSpace
from solver.tasks import catalogue

TASK = "transfer_matrix_poles_zeros"


def plant(n: int, seed: int = 3) -> StateSpace:
    """A system of n states, two inputs and two outputs, with small integers."""
    random = Random(seed)
    A, B, C = (
        sp.ImmutableMatrix(rows, columns, lambda *_: random.randint(-3, 3))
        for rows, columns in ((n, n), (n, 2), (2, n))
    )
    return StateSpace(A, B, C)


def ours(system: StateSpace, method: str) -> Callable[[], Any]:
    """All answers, with the steps that lead to them."""
    declared = catalogue()[TASK]
    options = {name: each.default for name, each in declared.options.items() if each.default is not None}
    part = Part("a", TASK, (method,), system, options)
    return lambda: found_by(method, part, {}, [])


def by_sympy(system: StateSpace) -> Callable[[], Any]:
    """G by the inverse of sI − A, its determinant, and the roots of numerator and denominator in decimals."""
    A, B, C, s = system.A, system.B, system.C, sp.Symbol("s")

    def run() -> Any:
        G = (C * (s * sp.eye(A.rows) - A).inv() * B).applyfunc(sp.cancel)
        return [sp.Poly(part, s).nroots() for part in sp.fraction(sp.cancel(G.det()))]

    return run


def rows() -> Iterator[Row | Failure]:
    """Return the lines of the table."""
    mine, theirs = side_by_side(ours(plant(4), "rosenbrock"), by_sympy(plant(4)))
    yield Row("poles and zeros, Rosenbrock, 4 states, 2×2", mine, "sympy inverse, determinant, roots", theirs, None, 60)
    for method, n, at_most in (("minors", 4, 120), ("rosenbrock", 10, 1000), ("minors", 10, 1000)):
        mine, _ = side_by_side(ours(plant(n), method), lambda: None)
        yield Row(f"poles and zeros, {method}, {n} states, 2×2", mine, at_most=at_most)
