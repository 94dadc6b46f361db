"""Whether unknowns within their bounds make residuals vanish that are known by their sizes only."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.points import SEED

ENOUGH = 0.002
"""What may be left of a residual, beside what the unknowns change in it."""

CURVED = 0.02
"""By so much tangents may lie above residuals that are not quite linear."""

TINY = 1e-12
"""A residual of numbers that agree in doubles."""

STEP = 1e-6
"""Of the differences that slopes are made of, in units of the bounds."""

ASIDE = 2e-3
"""How far from the lowest point a tangent is taken: residuals that are equally high there have no slope in common."""

MOST_CUTS = 24

Sizes = Callable[[Array], Array]
"""The sizes of the residuals at some values of the unknowns, as many at all of them."""


def can_vanish(sizes: Sizes, unknowns: int) -> bool:
    """Whether some u with |uⱼ| ≤ 1 makes all residuals small at once, to first order in u.

    A residual is the largest of linear functions, so its size is convex and lies above its tangents. The u where the
    highest of all tangents found so far is least is tried next, until the residuals are small there or the tangents
    are not (J. E. Kelley, The cutting-plane method for solving convex programs, 1960).
    """
    u = np.zeros(unknowns)
    start = sizes(u)
    reach = _reach(sizes, start, unknowns) + TINY
    slopes, levels = np.empty((0, unknowns)), np.empty(0)
    aside = np.random.default_rng(SEED).uniform(-ASIDE, ASIDE, (MOST_CUTS, unknowns))
    for offset in aside:
        if np.all(sizes(u) / reach <= ENOUGH):
            return True
        at = u + offset
        slope = _slopes(sizes, at) / reach[:, None]
        slopes, levels = np.concatenate([slopes, slope]), np.concatenate([levels, sizes(at) / reach - slope @ at])
        u, least = _lowest(slopes, levels)
        if least > CURVED:
            return False
    return False


def _reach(sizes: Sizes, start: Array, unknowns: int) -> Array:
    """How far each residual can be changed: the sum of what each unknown changes in it by itself."""
    total = np.zeros_like(start)
    for unit in np.eye(unknowns):
        total += np.maximum(np.abs(sizes(unit) - start), np.abs(sizes(-unit) - start))
    return total


def _slopes(sizes: Sizes, u: Array) -> Array:
    """The slopes of each residual's size in each unknown, by central differences (residuals × unknowns)."""
    steps = STEP * np.eye(len(u))
    return np.array([(sizes(u + step) - sizes(u - step)) / (2 * STEP) for step in steps]).T


def _lowest(slopes: Array, levels: Array) -> tuple[Array, float]:
    """The u in the box where the highest of the tangents levels + slopes u is least, and that least height."""
    from scipy.optimize import linprog  # noqa: PLC0415 - only what leaves a choice needs it

    n = slopes.shape[1]
    bounds = [(-1.0, 1.0)] * n + [(None, None)]
    A = np.hstack([slopes, -np.ones((len(slopes), 1))])
    found = linprog(np.append(np.zeros(n), 1.0), A_ub=A, b_ub=-levels, bounds=bounds, method="highs")
    solution = np.asarray(found.x)
    return solution[:n], float(solution[n])
