"""Whether two values agree: entry by entry, each by its own size, and no further than the arithmetic can tell.

The residual of an entry is |l − r| / max(|l|, |r|, n/τ) with n the noise that rounding explains and τ the tolerance;
so it is at most τ if and only if the entry agrees to τ relative to its own size, or the difference is mere noise.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import DOUBLE, Arithmetic, Array, multiple
from solver.numeric.evaluation.values import SAFETY, NotEvaluable, ShapeMismatch, Undefined, Value, filled, shape_of
from solver.words import Phrase

TOLERANCE = 1e-9
QUIET = 1e-10
"""Noise up to this absolute size is low enough to tell that what is stated to be zero is zero."""

Point = dict[Any, complex]
Sides = Callable[[Sequence[Point], Arithmetic], tuple[Value, Value]]
"""Evaluates both sides of an equality at some points; raises Undefined or NotEvaluable."""


def residuals(left: Value, right: Value, points: int, arithmetic: Arithmetic) -> tuple[Array, Array]:
    """Return the largest residual at each point (P,), and whether that settles it (P,) or takes more digits."""
    l_shape, r_shape = shape_of(left) or (1, 1), shape_of(right) or (1, 1)
    if l_shape != r_shape:
        sizes = ["×".join(map(str, shape)) for shape in (l_shape, r_shape)]
        raise ShapeMismatch(Phrase("the shapes differ: {left} and {right}", left=sizes[0], right=sizes[1]))
    if 0 in l_shape:
        return np.zeros(points), np.ones(points, dtype=bool)
    (l_value, l_size), (r_value, r_size) = _flat(left, points), _flat(right, points)
    difference = np.where(l_value == r_value, 0.0, arithmetic.size(l_value - r_value))  # ∞ = ∞
    size = np.maximum(arithmetic.size(l_value), arithmetic.size(r_value))
    noise = SAFETY * arithmetic.eps * (l_size + r_size)
    scale = np.maximum(size, noise / TOLERANCE)
    residual = np.where(difference == 0, 0.0, difference / np.where(scale == 0, 1.0, scale))
    if arithmetic is not DOUBLE:
        residual = np.where((difference != 0) & (_infinite(l_value) | _infinite(r_value)), np.inf, residual)
    agree = difference <= TOLERANCE * size
    if arithmetic is DOUBLE and agree.all():
        return residual.max(axis=1), np.ones(points, dtype=bool)
    zero = (l_value == 0) | (r_value == 0)
    settled = agree | (zero & (difference <= noise) & (noise <= QUIET))
    hidden = ~agree & (difference <= noise) & (noise > 1e-3 * np.maximum(size, 1.0))
    if arithmetic is not DOUBLE and np.any(hidden):
        raise NotEvaluable("the decimals in the formula carry too few digits to judge the equality")
    return residual.max(axis=1), settled.all(axis=1)


def _infinite(values: Array) -> Array:
    """Where numbers of mpmath are ∞, and not just too large for doubles."""
    with np.errstate(all="ignore"):
        return np.asarray((values == 2 * values) & (values != 0), dtype=bool)


def _flat(value: Value, points: int) -> tuple[Array, Array]:
    """Return values and magnitudes as arrays (P, entries)."""
    shown, size = filled(value, points)
    return shown.reshape(points, -1), size.reshape(points, -1)


def worst_residual(sides: Sides, points: Sequence[Point]) -> tuple[float, int]:
    """Return the largest residual over the points, and the number of digits that decided (15, 50 or 100).

    Agreement in doubles is conclusive. What doubles leave open, disagreement included, is decided point by point
    with 50 and, if rounding still could hide it, 100 digits. Raises Undefined if a side has no value somewhere.
    """
    with np.errstate(all="ignore"):
        residual, settled = _in_doubles(sides, points)
        digits = DOUBLE.digits
        for p in map(int, np.flatnonzero(~settled)):
            residual[p], needed = _with_many_digits(sides, points[p])
            digits = max(digits, needed)
            if residual[p] > TOLERANCE:  # one point at which the sides differ is enough
                return float(residual[p]), digits
    return float(np.max(residual, initial=0.0)), digits


def _in_doubles(sides: Sides, points: Sequence[Point]) -> tuple[Array, Array]:
    """Return residuals and what they settle; a point at which doubles give no value (overflow, say) is left open."""
    try:
        left, right = sides(points, DOUBLE)
    except Undefined:
        if len(points) == 1:
            return np.full(1, np.nan), np.zeros(1, dtype=bool)
        each = [_in_doubles(sides, [point]) for point in points]
        return np.concatenate([residual for residual, _ in each]), np.concatenate([settled for _, settled in each])
    return residuals(left, right, len(points), DOUBLE)


def _with_many_digits(sides: Sides, point: Point) -> tuple[float, int]:
    for digits in (50, 100):
        arithmetic = multiple(digits)
        try:
            left, right = sides([point], arithmetic)
            residual, settled = residuals(left, right, 1, arithmetic)
        except (ZeroDivisionError, OverflowError) as trouble:
            raise Undefined(Phrase("the formula is not defined here ({trouble})", trouble=str(trouble))) from trouble
        if settled[0] or residual[0] > TOLERANCE:  # more digits would change nothing
            break
    if np.isnan(residual[0]):
        if all(np.any(np.isinf(arithmetic.size(side.value))) for side in (left, right)):
            raise Undefined("the values are too large to be compared")
        return math.inf, digits
    return float(residual[0]), digits


def worst_of(residuals: Iterable[float]) -> float:
    """Return the largest residual; infinity if one is not a number, which `max` would pass over."""
    found = list(residuals)
    return math.inf if any(map(math.isnan, found)) else max(found)
