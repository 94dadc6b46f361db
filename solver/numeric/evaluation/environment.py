"""Where formulas are evaluated: values of the symbols at P points, in one of the two arithmetics."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import DOUBLE, Arithmetic, Array
from solver.numeric.evaluation.values import Value

Point = dict[Any, complex]
"""A value for each symbol."""


class Environment:
    """Values of symbols at P points (arrays (P,), or numbers), and what was evaluated already."""

    __slots__ = ("arithmetic", "memo", "points", "values")

    def __init__(self, values: Mapping[Any, Any], points: int, arithmetic: Arithmetic = DOUBLE) -> None:
        self.values = values
        self.points = points
        self.arithmetic = arithmetic
        self.memo: dict[Any, Value] = {}

    @classmethod
    def at(cls, points: Sequence[Mapping[Any, complex]], arithmetic: Arithmetic = DOUBLE) -> Environment:
        """Return the environment of some points, each a value for every symbol; the values are taken as exact."""
        symbols = list(points[0])
        if arithmetic is not DOUBLE and len(points) == 1:  # numbers: arrays of one would only cost time
            return cls({symbol: arithmetic.number(points[0][symbol]) for symbol in symbols}, 1, arithmetic)
        values = {symbol: arithmetic.array([point[symbol] for point in points]) for symbol in symbols}
        return cls(values, len(points), arithmetic)

    def having(self, values: Mapping[Any, Any]) -> Environment:
        """Return the environment in which some symbols (also) have these values."""
        full = {symbol: self.full(value) for symbol, value in values.items()}
        return Environment({**self.values, **full}, self.points, self.arithmetic)

    def spread(self, symbol: Any, samples: Array) -> Environment:
        """Return the environment in which each point p becomes N points with `symbol` = samples[p, :] (P×N)."""
        count = samples.shape[1]
        values = {each: np.repeat(self.full(value), count) for each, value in self.values.items() if each != symbol}
        return Environment({**values, symbol: samples.reshape(-1)}, self.points * count, self.arithmetic)

    def approximate(self) -> Environment:
        """Return the same points in doubles."""
        values = {symbol: self.full(value).astype(np.complex128) for symbol, value in self.values.items()}
        return Environment(values, self.points)

    def full(self, value: Any) -> Array:
        """Return a scalar as an array (P,)."""
        return np.broadcast_to(np.asarray(value, dtype=self.arithmetic.dtype), (self.points,))

    def stack(self, entries: list[Value], shape: tuple[int, ...]) -> Value:
        """Return the array (P, *shape) of scalars given in row-major order."""
        table, full = (self.points, len(entries)), (self.points, *shape)
        value = np.empty(table, dtype=self.arithmetic.dtype)
        for i, entry in enumerate(entries):
            value[:, i] = entry.value

        def magnitude() -> Array:
            sizes = np.empty(table)
            for i, entry in enumerate(entries):
                sizes[:, i] = entry.magnitude
            return sizes.reshape(full)

        return Value(value.reshape(full), magnitude)


MOST_KEPT = 1000
"""Values that an environment brings along from one derivation to the next; one that has more starts anew."""


@lru_cache(maxsize=16)
def _kept(arithmetic: Arithmetic, points: tuple[tuple[tuple[Any, complex], ...], ...]) -> Environment:
    """Return the environment of points, each a tuple of pairs: the claims of a part and its displays share it."""
    return Environment.at([dict(point) for point in points], arithmetic)


class Environments:
    """The environments in which the claims of one derivation are tried.

    Claims in the same symbols are tried at the same points, and hold the same matrices: each is evaluated once. What
    a formula has at a point depends on nothing else, so the environments used last serve the next derivation, too.
    """

    def __init__(self) -> None:
        self._known: dict[Any, Environment] = {}
        self._met: dict[tuple[int, Arithmetic], tuple[Any, Environment]] = {}

    def at(self, points: Sequence[Mapping[Any, complex]], arithmetic: Arithmetic) -> Environment:
        """Return the environment of these points, which are not changed from now on."""
        met = self._met.get((id(points), arithmetic))  # most claims are tried at the very same points
        if met is None:
            met = self._met[id(points), arithmetic] = points, self._environment(points, arithmetic)
        return met[1]

    def _environment(self, points: Sequence[Mapping[Any, complex]], arithmetic: Arithmetic) -> Environment:
        key = (arithmetic, tuple(tuple(point.items()) for point in points))
        if key not in self._known:
            environment = self._known[key] = _kept(*key)
            if len(environment.memo) > MOST_KEPT:
                environment.memo.clear()
        return self._known[key]
