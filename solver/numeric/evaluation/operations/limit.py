"""Limits by sequences: f where x has come closer by halves, with so many digits that rounding does not matter."""

from __future__ import annotations

from collections.abc import Iterator
from functools import reduce
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array, Multiple, multiple
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.points import nodes
from solver.numeric.evaluation.stated import Oracle
from solver.numeric.evaluation.values import SAFETY, NotEvaluable, Value, gathered
from solver.numeric.evaluation.walk import walk
from solver.stated import Stated

ORACLE = Oracle(85, "sequence of points")
SAMPLED = True

START = 1.2360679
"""The first step; no round number, at which something periodic might always have the same value."""

STEPS = 100
STEPS_OF_EXPONENTIALS = 12
"""How often the step is halved; the exponential of a matrix can be evaluated only so far."""

SETTLED = 1e-12
"""How closely, relative to its size, a limit must be known."""


def evaluate(environment: Environment, function: Any, variable: Any, value: Any, side: str) -> Value:
    """The value of the sequence where its last step and its rounding are least; not a number where the sides differ.

    Infinite where the sequence grows without end. Raises NotEvaluable if it does not settle.
    """
    arithmetic = environment.arithmetic
    fine = multiple(max(80, 2 * arithmetic.digits))
    values = {symbol: fine.array(list(environment.full(x))) for symbol, x in environment.values.items()}
    here = Environment(values, environment.points, fine)
    exponentials = any(isinstance(node, Stated) and node.operation == "exponential" for node in nodes(function))
    halvings = START / 2.0 ** np.arange(STEPS_OF_EXPONENTIALS if exponentials else STEPS)
    found = []
    for samples in _approaches(here, value, side, halvings):
        f = gathered(walk(function, here.spread(variable, samples)), here.points, len(halvings))
        found.append(_settled(f.value, f.magnitude, fine))
    limit, error = reduce(lambda one, other: _common(one, other, fine), found)
    rounded = arithmetic.array(limit) if isinstance(arithmetic, Multiple) else fine.approximate(limit)
    size = arithmetic.size(rounded)
    return Value(rounded, np.where(np.isfinite(size), size, 0.0) + error / arithmetic.eps)


def _approaches(here: Environment, value: Any, side: str, halvings: Array) -> Iterator[Array]:
    """Return the points (P×N) of each side from which x comes."""
    steps = here.arithmetic.array(halvings)[None, :]
    if value in (sp.oo, -sp.oo):
        yield np.repeat((1 if value == sp.oo else -1) / steps, here.points, axis=0)
        return
    goal = here.full(walk(value, here).value)[:, None]
    for sign in {"+": (1,), "-": (-1,)}.get(side, (1, -1)):
        yield goal + sign * steps


def _settled(value: Array, magnitude: Array, fine: Multiple) -> tuple[Array, Array]:
    """Return the limits of sequences (P, N, …), which may be infinite, and how well they are known (P, …)."""
    size = fine.size(value)
    with np.errstate(all="ignore"):
        noise = SAFETY * fine.eps * magnitude[:, 1:]
        steps = fine.size(value[:, 1:] - value[:, :-1])
        lately = np.maximum.reduce([steps, *(_delayed(steps, by) for by in (1, 2, 3))])  # one may be small by chance
        error = 10.0 * lately + noise
        growing = (size[:, 1:] > 1.2 * size[:, :-1]) | np.isinf(size[:, 1:])
    endless = np.all(growing[:, growing.shape[1] // 2 :], axis=1)
    best = np.argmin(np.where(np.isnan(error), np.inf, error), axis=1)[:, None]
    limit, known = (np.take_along_axis(part, best, axis=1) for part in (value[:, 1:], error))
    later = np.arange(error.shape[1]).reshape((1, -1, *(1 for _ in error.shape[2:]))) > best
    with np.errstate(all="ignore"):
        strays = later & (fine.size(value[:, 1:] - limit) > 10.0 * noise + 1e3 * known)
    unsettled = (known[:, 0] > SETTLED * (size[:, 0] + fine.size(limit[:, 0]))) | strays.any(axis=1)
    if np.any(unsettled & ~endless):
        raise NotEvaluable("the values do not settle to a limit")
    last = value[:, -1]
    if np.any(endless & (fine.size(fine.apply("im", last)) > 0)):
        raise NotEvaluable("complex values grow without end")
    infinity = np.where(fine.apply("re", last) > 0, fine.context.inf, -fine.context.inf)
    return np.where(endless, infinity, limit[:, 0]), np.where(endless, 0.0, known[:, 0])


def _delayed(steps: Array, by: int) -> Array:
    """Return the steps of some halvings before; the first ones have none, which counts as endless."""
    delayed = np.full_like(steps, np.inf)
    delayed[:, by:] = steps[:, :-by]
    return delayed


def _common(one: tuple[Array, Array], other: tuple[Array, Array], fine: Multiple) -> tuple[Array, Array]:
    """Return the limit from both sides; not a number where they differ."""
    (left, l_error), (right, r_error) = one, other
    with np.errstate(all="ignore"):
        apart = fine.size(left - right)
        agree = (left == right) | (np.isfinite(apart) & (apart <= SETTLED * fine.size(left) + l_error + r_error))
    return np.where(agree, left, fine.context.nan), np.maximum(l_error, r_error)
