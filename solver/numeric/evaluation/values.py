"""Numbers with what is known of their rounding: the value and the size of what was added up to get it.

The oracles never trust a digit that cancellation may have spoiled. Every value carries a magnitude m: to first order
its absolute error is a small multiple of ε m, ε the unit roundoff of the arithmetic (running error analysis, Higham,
Accuracy and Stability of Numerical Algorithms, section 3.3).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

from solver.words import Phrase

SAFETY = 64.0
"""Errors above SAFETY · ε · magnitude are not explained by rounding."""


class _Told(ValueError):  # noqa: N818 - what is wrong is the formula, or what is known of it, not the program
    """An error that carries its reason, a text or a phrase."""

    def __init__(self, reason: str) -> None:
        super().__init__(reason)
        self.reason = reason


class NotEvaluable(_Told):
    """The oracle has no sound way of evaluating a formula; the reason says why."""


class NoRule(NotEvaluable):
    """The oracle has never been taught what a formula holds. No problem may need such a rule; a test holds that."""

    def __init__(self, what: str) -> None:
        super().__init__(Phrase("no rule for {what}", what=what))


class Undefined(NotEvaluable):
    """The formula has no finite value at a point (division by zero, overflow); another point may do."""


class ShapeMismatch(_Told):
    """A formula joins matrices whose shapes do not fit."""


class Value:
    """Values at P points: a scalar has shape () or (P,), a matrix (P, rows, columns), a list of k scalars (P, k).

    `magnitude` has the shape of `value` or broadcasts to it; real numbers (floats), not negative. It may be given as a
    function, which is called when it is asked for: where values agree, nobody asks what rounding might explain.
    """

    __slots__ = ("_magnitude", "value")

    def __init__(self, value: Any, magnitude: Any | Callable[[], Any]) -> None:
        self.value = value
        self._magnitude = magnitude

    @property
    def magnitude(self) -> Any:
        """The size of what was added up to get the value."""
        if callable(self._magnitude):
            self._magnitude = self._magnitude()
        return self._magnitude

    def known(self) -> Value:
        """Return the value itself, with its magnitude found."""
        return Value(self.value, self.magnitude)

    def __iter__(self) -> Iterator[Any]:
        yield self.value
        yield self.magnitude

    @property
    def is_matrix(self) -> bool:
        """Whether the value is a matrix at each point."""
        return getattr(self.value, "ndim", 0) == 3


def shape_of(value: Value) -> tuple[int, ...]:
    """Shape of the value at one point: () for a scalar."""
    return tuple(getattr(value.value, "shape", ()))[1:]


def filled(value: Value, points: int) -> Value:
    """Return the value with an entry at each of P points for all that broadcasts, in both arrays."""
    full = (points, *np.shape(value.value)[1:])
    return Value(_spread_to(full, value.value), lambda: _spread_to(full, value.magnitude))


def _spread_to(shape: tuple[int, ...], part: Any) -> Any:
    return part if np.shape(part) == shape else np.broadcast_to(part, shape)


def gathered(value: Value, points: int, count: int) -> Value:
    """Return values at N samples for each of P points, found all at once (P·N, …), as arrays (P, N, …)."""
    shape, full = (points, count, *np.shape(value.value)[1:]), filled(value, points * count)
    return Value(full.value.reshape(shape), lambda: full.magnitude.reshape(shape))
