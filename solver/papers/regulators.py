"""Regulators and filters of which there is no formula: their answers in decimals, for many draws, by scipy."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
import sympy as sp

from solver.derivation import Given
from solver.numeric.judges.optimal import optimum_in_floats
from solver.papers.niceness import Array, Numbers
from solver.tasks.design.kalman_gain import intensities
from solver.tasks.design.regulator import given_or_identity
from solver.tasks.design.weights import state_weight

GAINS = {"lqr": "K", "kalman_filter": "L"}
"""The tasks, and the names of their gains."""

LOOPS = {"lqr": "closed_loop_A", "kalman_filter": "error_A"}


@dataclass(frozen=True, slots=True)
class Weighed:
    """A regulator, or the one that is dual to a filter: A n×n, B n×m, the weights Q n×n, R m×m, N n×m."""

    A: Any
    B: Any
    Q: Any
    R: Any
    N: Any
    discrete: bool

    @property
    def matrices(self) -> tuple[Any, ...]:
        """A, B, Q, R, N."""
        return self.A, self.B, self.Q, self.R, self.N


def weighed(task: str, given: Given[Any, Any]) -> Weighed:
    """Return the regulator that a part of one of the tasks asks for."""
    system, options = given.system, given.options
    if task == "kalman_filter":
        B = system.C.T
        return Weighed(system.A.T, B, *intensities(given), sp.zeros(*B.shape), system.discrete)
    R = given_or_identity(options.R, system.B.cols)
    N = options.N if options.N is not None else sp.zeros(*system.B.shape)
    return Weighed(system.A, system.B, state_weight(given), R, N, system.discrete)


def numbers_of(task: str, answer: str, problem: Weighed) -> Numbers | None:
    """Return how an answer follows from the entries of the matrices, None where it does not."""
    if answer not in {"P", GAINS[task], LOOPS[task], "eigenvalues"}:
        return None
    what = {GAINS[task]: "K", LOOPS[task]: "closed_loop"}.get(answer, answer)
    return partial(answers_in_floats, shape=problem.B.shape, discrete=problem.discrete, what=what)


def answers_in_floats(entries: Array, *, shape: tuple[int, int], discrete: bool, what: str) -> Array:
    """Return an answer for each column of entries, those of A, B, Q, R, N row by row; nan where there is none."""
    n, m = shape
    shapes = ((n, n), (n, m), (n, n), (m, m), (n, m))
    ends = np.cumsum([rows * columns for rows, columns in shapes])[:-1]
    found = [_answer(np.split(column.real, ends), shapes, what, discrete=discrete) for column in entries.T]
    size = max((each.size for each in found if each is not None), default=1)
    return np.array([np.full(size, np.nan) if each is None else each for each in found]).T + 0j


def _answer(parts: Any, shapes: Any, what: str, *, discrete: bool) -> Array | None:
    matrices = [part.reshape(shape) for part, shape in zip(parts, shapes, strict=True)]
    if not all(np.isfinite(each).all() for each in matrices):
        return None
    optimum = optimum_in_floats(matrices, discrete=discrete)
    if optimum is None:
        return None
    if what == "eigenvalues":
        return np.linalg.eigvals(optimum.closed_loop)
    return {"P": optimum.P, "K": optimum.K, "closed_loop": optimum.closed_loop}[what].ravel()
