"""How every task grows with the order of the plant: one question by each method, solved and checked, n = 2 … 10.

Targets: two seconds for dense rational plants of order 8 and for companion plants of order 10, and five seconds for
the regulator of a plant of order 4 with random integers.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import sympy as sp

from benchmarks.matrices import companion_of_integers, dense, random_integers
from benchmarks.timing import forget
from solver.engine import solve_part
from solver.limits import Exceeded, Limits, call_within
from solver.problem.model import Part
from solver.systems import StateSpace
from solver.tasks import catalogue

ORDERS = (2, 4, 6, 8, 10)
LIMIT = Limits(seconds=40)
TARGETS = {("dense", 8): 2.0, ("companion", 10): 2.0, ("random", 4): 5.0}
"""Seconds of processor time, by kind of plant and order."""

LARGEST = {"phase_portrait": 2}
"""Tasks about one order only."""

WITH_PARAMETER = ("stability_range", "parameter_condition")
REGULATORS = ("lqr", "kalman_filter", "optimal_tracking")
"""These are also timed for random integers, where everything is irrational."""


@dataclass(frozen=True)
class Cell:
    """One measurement; `seconds` is None where there is nothing to measure, `remark` what did not go well."""

    kind: str
    n: int
    seconds: float | None
    remark: str = ""

    @property
    def met(self) -> bool:
        """Whether the target is met, if there is one."""
        if self.seconds is None:
            return not self.remark
        return not self.remark and self.seconds <= TARGETS.get((self.kind, self.n), float("inf"))

    def __str__(self) -> str:
        if self.seconds is None:
            return self.remark or "–"
        shown = f"{self.seconds:.2f}" + (f" ({self.remark})" if self.remark else "")
        return shown if self.met else f"**{shown}**"


@dataclass(frozen=True)
class Line:
    """One line of the table."""

    task: str
    method: str
    kind: str
    cells: tuple[Cell, ...]

    @property
    def met(self) -> bool:
        """Whether all targets of the line are met."""
        return all(cell.met for cell in self.cells)

    def __str__(self) -> str:
        return " | ".join(["", self.task, self.method, self.kind, *map(str, self.cells), ""]).strip()


HEADER = "\n".join(
    [
        "| task | method | plant | " + " | ".join(f"n = {n}" for n in ORDERS) + " |",
        "|---|---|---|" + "---|" * len(ORDERS),
    ]
)


def plant(n: int, kind: str) -> StateSpace:
    """A controllable, observable plant of one input and output: dense or companion with eigenvalues −1 … −n, random."""
    if kind == "random":
        B, C = random_integers(n, 1, seed=n + 1), random_integers(1, n, seed=n + 2)
        return StateSpace(random_integers(n, n, seed=n), B, C, sp.ImmutableMatrix([[0]]))
    full = kind == "dense"
    A = dense(n) if full else companion_of_integers(n)
    B = sp.ImmutableMatrix(n, 1, lambda i, _: 2 * i % 5 - 1 if full else int(bool(i == n - 1)))
    C = sp.ImmutableMatrix(1, n, lambda _, j: (j * j + 1) % 4 if full else int(bool(j == 0)))
    return StateSpace(A, B, C, sp.ImmutableMatrix([[0]]))


def asked_about(task: str, n: int, kind: str) -> StateSpace:
    """The plant of a question, with a parameter k where the task is about one."""
    P, k = plant(n, kind), sp.Symbol("k")
    if task not in WITH_PARAMETER or P.B is None or P.C is None:
        return P
    if task == "stability_range":
        return StateSpace(sp.ImmutableMatrix(P.A - k * P.B * P.C), P.B, P.C, P.D)
    return StateSpace(P.A, P.B + sp.ImmutableMatrix(n, 1, lambda i, _: k * int(bool(i == 0))), P.C, P.D)


def poles(count: int) -> tuple[sp.Expr, ...]:
    """The poles −2, −3, …"""
    return tuple(sp.Integer(-i - 1) for i in range(1, count + 1))


def options(task: str, n: int) -> dict[str, Any]:
    """What a question of the task needs beside the plant."""
    s, t = sp.Symbol("s"), sp.Symbol("t")
    weights = {"Q": sp.ImmutableMatrix(sp.eye(n)), "R": sp.ImmutableMatrix([[1]])}
    needed: dict[str, dict[str, Any]] = {
        "similarity_transformation": {"T": sp.ImmutableMatrix(n, n, lambda i, j: int(bool(j >= i)))},
        "matrix_function": {"function": sp.exp(sp.Symbol("A") * t)},
        "response": {"kind": "complete", "input": (sp.exp(-t),), "initial_state": sp.ImmutableMatrix(sp.ones(n, 1))},
        "desired_poles": {"damping_ratio": sp.Rational(1, 2), "settling_time": sp.Integer(4)},
        "pole_placement": {"poles": poles(n)},
        "reference_tracking": {"poles": poles(n)},
        "servo": {"poles": poles(n + 1)},
        "model_matching": {"target": 1 / sp.expand((s + 20) ** n)},
        "observer": {"poles": poles(n)},
        "reduced_observer": {"poles": poles(n - 1)},
        "observer_feedback": {"poles": poles(n), "observer_poles": poles(n)},
        **dict.fromkeys(REGULATORS, weights),
    }
    return needed.get(task, {})


def asked(task: str, method: str, n: int, kind: str) -> Part:
    """The question of order n."""
    declared = catalogue()[task]
    defaults = {
        name: option.default if option.default is not None else getattr(option.kind, "words", (None,))[0]
        for name, option in declared.options_for(method).items()
    }
    given = {name: value for name, value in defaults.items() if value is not None}
    return Part("a", task, (method,), asked_about(task, n, kind), {**given, **options(task, n)})


def seconds(task: str, method: str, n: int, kind: str) -> tuple[float, str]:
    """Processor time of solving and checking, after a small question of the same kind, and what did not go well."""
    solve_part(asked(task, method, 2, kind), {})  # imports and one-time tables
    part = asked(task, method, n, kind)
    forget()
    start = time.process_time()
    result = solve_part(part, {})[0]
    taken = time.process_time() - start
    return taken, "" if str(result.status) == "verified" else f"{result.status}: {result.reason}"


def lines(chosen: str | None = None) -> Iterator[Line]:
    """A line for each task, method and kind of plant; times in seconds."""
    for task, declared in catalogue().items():
        if chosen not in (None, task):
            continue
        for method in declared.methods_for(False):
            if method == "unity_rank":
                continue  # for several inputs
            for kind in ("dense", "companion", *(("random",) if task in REGULATORS else ())):
                yield Line(task, method, kind, tuple(_cell(task, method, kind, n) for n in ORDERS))


def _cell(task: str, method: str, kind: str, n: int) -> Cell:
    if n > LARGEST.get(task, n):
        return Cell(kind, n, None)
    try:
        return Cell(kind, n, *call_within(LIMIT, seconds, task, method, n, kind))
    except Exceeded as limit:
        return Cell(kind, n, None, str(limit))
