"""Whether two values agree: entry by entry, each by its own size, and no further than the arithmetic can tell.

The residual of an entry is |l − r| / max(|l|, |r|, n/τ) with n the noise that rounding explains and τ the tolerance;
so it is at most τ if and only if the entry agrees to τ relative to its own size, or the difference is mere noise.
Where all entries clearly agree nobody asks for the noise, and n is 0.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import DOUBLE, Arithmetic, Array, multiple
from solver.numeric.evaluation.environment import Point
from solver.numeric.evaluation.precision import DECIMALS, EXACT, SHOWN, TOLERANCE, Precision, precision_of
from solver.numeric.evaluation.sides import Sides
from solver.numeric.evaluation.values import SAFETY, NotEvaluable, ShapeMismatch, Undefined, Value, filled, shape_of
from solver.words import Phrase

QUIET = 1e-10
"""Noise up to this absolute size is low enough to tell that what is stated to be zero is zero."""

TINY = 1e-300
CLEARLY = 1e-2
"""Values that are so much nearer than they must be agree, whatever rounding might explain."""

MANY = (30, 50, 100)
"""Digits with which it is tried to settle what doubles leave open."""


class Residual(float):
    """A relative difference, with the largest one that is no error: it depends on what was compared."""

    tolerance: float = TOLERANCE

    def __new__(cls, value: float, tolerance: float = TOLERANCE) -> Residual:
        """Make a residual with its tolerance."""
        self = super().__new__(cls, value)
        self.tolerance = tolerance
        return self


def residuals(
    left: Value, right: Value, points: int, arithmetic: Arithmetic, tolerance: float = TOLERANCE
) -> tuple[Array, Array]:
    """Return the residual of each entry at each point (P×entries), and whether that settles it or takes more digits."""
    l_shape, r_shape = shape_of(left) or (1, 1), shape_of(right) or (1, 1)
    if l_shape != r_shape:
        sizes = ["×".join(map(str, shape)) for shape in (l_shape, r_shape)]
        raise ShapeMismatch(Phrase("the shapes differ: {left} and {right}", left=sizes[0], right=sizes[1]))
    if 0 in l_shape:
        return np.zeros((points, 0)), np.ones((points, 0), dtype=bool)
    left, right = (_flat(side, points) for side in (left, right))
    l_value, r_value = left.value, right.value
    difference = arithmetic.size(l_value - r_value)
    size = np.maximum(arithmetic.size(l_value), arithmetic.size(r_value))
    if arithmetic is not DOUBLE:
        difference = np.where(l_value == r_value, 0.0, difference)  # ∞ = ∞
    clear = difference <= CLEARLY * tolerance * size
    if clear.all() and size.max() < np.inf:
        return difference / np.maximum(size, TINY), clear
    noise = SAFETY * arithmetic.eps * (left.magnitude + right.magnitude)
    scale = np.maximum(size, noise / tolerance)
    residual = np.where(difference == 0, 0.0, difference / np.where(scale == 0, 1.0, scale))  # the noise may be unknown
    if arithmetic is not DOUBLE and np.isinf(size).any():
        residual = np.where((difference != 0) & (_infinite(l_value) | _infinite(r_value)), np.inf, residual)
    agree = difference <= tolerance * size
    zero = (l_value == 0) | (r_value == 0)
    settled = agree | (zero & (difference <= noise) & (noise <= QUIET))
    hidden = ~agree & (difference <= noise) & (noise > 1e-3 * np.maximum(size, 1.0))
    if arithmetic.digits == MANY[-1] and np.any(hidden):
        raise NotEvaluable("the decimals in the formula carry too few digits to judge the equality")
    return residual, settled


def _infinite(values: Array) -> Array:
    """Where numbers of mpmath are ∞, and not just too large for doubles."""
    with np.errstate(all="ignore"):
        return np.asarray((values == 2 * values) & (values != 0), dtype=bool)


def _flat(value: Value, points: int) -> Value:
    """Return values and magnitudes as arrays (P, entries)."""
    full = filled(value, points)
    return Value(full.value.reshape(points, -1), lambda: full.magnitude.reshape(points, -1))


def worst_residual(sides: Sides, points: Sequence[Point], precision: Precision = DECIMALS) -> tuple[Residual, int]:
    """Return the largest residual over the points, and the number of digits that decided (15 to 100).

    What doubles leave open, disagreement included, is decided entry by entry and point by point with 50 and, if
    rounding still could hide it, 100 digits. Where both sides are exact, agreement in doubles is conclusive at all
    points but the last, at which they must agree to 20 digits, evaluated with 30. Raises Undefined if a side has no
    value somewhere.
    """
    tolerance, exactly, digits = precision.tolerance, precision is EXACT, DOUBLE.digits
    with np.errstate(all="ignore"):
        known = _in_doubles(sides, points, precision.settled)
        in_doubles = max(float(residual[settled].max(initial=0.0)) for residual, settled in known)
        if not exactly and all(settled.all() for _, settled in known):
            return Residual(in_doubles, tolerance), digits
        found = 0.0 if exactly else in_doubles
        for p, settled in enumerate(row for _, rows in known for row in rows):
            to_all_digits = exactly and p == len(points) - 1
            if settled.all() and not to_all_digits:
                continue
            asked = sides if to_all_digits else _left_open(sides, settled)
            try:
                here, needed = _with_many_digits(asked, points[p], tolerance)
            except NotEvaluable:
                if not settled.all():
                    raise
                return Residual(in_doubles, SHOWN.tolerance), digits
            found, digits = max(found, here), max(digits, needed)
            if found > tolerance:  # one point at which the sides differ is enough
                break
    return Residual(found, tolerance), digits


def _in_doubles(sides: Sides, points: Sequence[Point], tolerance: float) -> list[tuple[Array, Array]]:
    """Return the residuals of the entries (P×entries) and what they settle.

    Where a side has no value somewhere, those of each point by itself: one, open, where there is no value.
    """
    try:
        left, right = sides.values(points, DOUBLE)
    except Undefined:
        if len(points) == 1:
            return [(np.full((1, 1), np.nan), np.zeros((1, 1), dtype=bool))]
        return [known for point in points for known in _in_doubles(sides, [point], tolerance)]
    return [residuals(left, right, len(points), DOUBLE, tolerance)]


def _left_open(sides: Sides, settled: Array) -> Sides:
    """Return the sides of the entries that are not settled; the whole sides where these can't be taken apart."""
    return (sides.of_entries(np.flatnonzero(~settled), len(settled)) if settled.any() else None) or sides


def _with_many_digits(sides: Sides, point: Point, tolerance: float) -> tuple[float, int]:
    for digits in MANY if tolerance < TOLERANCE else MANY[1:]:
        arithmetic = multiple(digits)
        try:
            left, right = sides.values([point], arithmetic)
            residual, settled = residuals(left, right, 1, arithmetic, tolerance)
        except (ZeroDivisionError, OverflowError) as trouble:
            raise Undefined(Phrase("the formula is not defined here ({trouble})", trouble=str(trouble))) from trouble
        found = float(residual.max(initial=0.0))
        if settled.all() or found > tolerance:  # more digits would change nothing
            break
    if math.isnan(found):
        if all(np.any(np.isinf(arithmetic.size(side.value))) for side in (left, right)):
            raise Undefined("the values are too large to be compared")
        return math.inf, digits
    return found, digits


def with_many_digits(residual: float, *formulas: Any) -> Residual:
    """Return a residual found with 50 digits or more, with the tolerance that suits what was compared."""
    return Residual(residual, precision_of(*formulas).tolerance)


def worst_of(residuals: Iterable[float]) -> float:
    """Return the residual that exceeds its tolerance most; infinity if one is not a number, which `max` would pass."""
    found = list(residuals)
    if any(map(math.isnan, found)):
        return math.inf
    return max(found, key=lambda residual: residual / tolerance_of(residual))


def tolerance_of(residual: float) -> float:
    """Return the tolerance of a residual; that of doubles where it says none."""
    return residual.tolerance if isinstance(residual, Residual) else TOLERANCE
