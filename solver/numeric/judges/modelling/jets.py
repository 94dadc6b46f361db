"""Equations in numbers, linear or not: all jets found by Newton's method where states and inputs are given.

A jet is a derivative of an unknown or an input (discrete: a sample). Equations without derivatives hold with all their
derivatives: these are the Taylor coefficients along a motion, by Cauchy's formula on a small circle.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import factorial
from random import Random
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import free_symbols
from solver.numeric.evaluation.values import Undefined
from solver.numeric.judges.modelling.equations import Question

Jet = tuple[str, int]
Jets = dict[Jet, complex]
RADIUS, SAMPLES = 0.01, 16
"""The circle on which derivatives along a motion are taken."""
APART, TURNS = 1e-3, 6
"""The circle on which differences are taken."""
MOVE = 1e-6
"""How far a jet is moved for the slopes of Newton's method; their error only costs a step."""
ITERATIONS, STARTS, NEAR = 40, 8, 1e-11


@dataclass(frozen=True)
class JetEquations:
    """Expressions that are zero in the symbols of `jets`, at one point of the parameters.

    They are differentiated `further` times, as outputs in higher derivatives need it.
    """

    expressions: Sequence[Any]
    jets: Mapping[Any, Jet]
    unknowns: Sequence[str]
    point: Mapping[Any, complex]
    discrete: bool = False
    further: int = 0

    @cached_property
    def _rows(self) -> list[tuple[Any, int]]:
        """The equations, each with the derivatives (discrete: samples) of it that are used."""
        return [(e, by) for e in self.expressions for by in self._orders(e)]

    @cached_property
    def _highest(self) -> dict[str, int]:
        """The highest derivative of each unknown in the equations (discrete: as they are written)."""
        found: dict[str, int] = {}
        for name, k in sorted(jet for e in self.expressions for jet in self._own(e)):
            found[name] = max(k, found.get(name, k))
        return found

    def _wanted(self, given: Iterable[Jet]) -> list[Jet]:
        return sorted({jet for e, by in self._rows for jet in self._inside(e, by)} - set(given))

    def solved(self, given: Mapping[Jet, complex], random: Random, near: Jets | None = None) -> Jets | None:
        """Return all jets where some are given; None where no values are found. What is not determined is anything.

        It is looked for `near` known values first.
        """
        rows, wanted = self._rows, self._wanted(given)
        for turn in range(STARTS):
            start = np.array([random.uniform(-1.0, 1.0) for _ in wanted], dtype=complex)
            if near is not None and turn == 0:
                start = np.array([near.get(jet, 0.0) for jet in wanted], dtype=complex)
            try:
                found = self._newton(rows, given, wanted, start)
            except Undefined:
                continue
            if found is not None:
                return {**given, **dict(zip(wanted, found, strict=True))}
        return None

    def values(self, expressions: Sequence[Any], at: Mapping[Jet, complex]) -> Array:
        """Return the values of expressions in the jets; nan where one is not known."""
        return np.array([self._row(e, 0, {k: np.array([v]) for k, v in at.items()})[0] for e in expressions])

    def slopes(self, jets: Jets, given: Sequence[Jet], others: Sequence[Jet]) -> dict[Jet, Array] | None:
        """Return how each jet moves with each of the given ones, by differences around values that satisfy all.

        The `others` are given too, and kept. None where the equations are not defined around there.
        """
        wanted = self._wanted([*given, *others])
        moved = [*wanted, *given]
        try:
            slopes = self.differences([(e, by) for e, by in self._rows], jets, moved)
        except Undefined:
            return None
        n = len(wanted)
        solved = np.linalg.lstsq(slopes[:, :n], -slopes[:, n:], rcond=1e-12)[0] if n else np.zeros((0, len(given)))
        return {**dict(zip(wanted, solved, strict=True)), **dict(zip(given, np.eye(len(given)), strict=True))}

    def differences(self, rows: Sequence[tuple[Any, int]], jets: Jets, moved: Sequence[Jet]) -> Array:
        """Return the partial derivatives of expressions, each with how often it is differentiated, by differences."""
        turns = APART * np.exp(2j * np.pi * np.arange(TURNS) / TURNS)
        count = TURNS * len(moved)
        at = {jet: np.full(count, value, dtype=complex) for jet, value in jets.items()}
        for j, jet in enumerate(moved):
            at[jet][TURNS * j : TURNS * (j + 1)] += turns
        values = np.array([self._row(e, by, at) for e, by in rows]).reshape(len(rows), len(moved), TURNS)
        found: Array = np.mean(values / turns, axis=2)
        return found

    def _orders(self, expression: Any) -> range:
        """How often an equation is differentiated: as often as any unknown if no derivative is in it.

        Else until it holds the highest derivative of one of its unknowns: that of x' = rω is needed beside x'' and ω'.
        Discrete: how many samples later it is written; one in past samples so that it holds none.
        """
        later = -min((k for _, k in self._own(expression)), default=0) if self.discrete else 0
        later = max(later, 0)
        own = [(name, k) for name, k in self._own(expression) if name in self.unknowns]
        if any(k + later for _, k in own):
            gap = min(self._highest[name] - k - later for name, k in own)
            return range(later, later + 1 + self.further + max(gap, 0))
        return range(
            later,
            later + 1 + self.further + max((k for name, k in self.jets.values() if name in self.unknowns), default=0),
        )

    def _own(self, expression: Any) -> set[Jet]:
        symbols = free_symbols(expression)
        return {jet for symbol, jet in self.jets.items() if symbol in symbols}

    def _inside(self, expression: Any, by: int) -> set[Jet]:
        lowest = by if self.discrete else 0
        return {(name, k + each) for name, k in self._own(expression) for each in range(lowest, by + 1)}

    def _newton(
        self, rows: Sequence[tuple[Any, int]], given: Mapping[Jet, complex], wanted: Sequence[Jet], z: Array
    ) -> Array | None:
        """Newton's method with least squares; None where it does not arrive."""
        moves = np.vstack([np.zeros(len(wanted)), np.diag(MOVE * np.ones(len(wanted)))])
        for _ in range(ITERATIONS):
            size = np.maximum(1.0, np.abs(z))
            tried = np.concatenate([z + moves * size, z - moves[1:] * size])
            values = self._residuals(rows, given, wanted, tried)
            if not wanted:
                return z
            n = len(wanted)
            slopes = (values[:, 1 : n + 1] - values[:, n + 1 :]) / (2 * MOVE * size)
            if not (np.isfinite(slopes).all() and np.isfinite(values[:, 0]).all()):
                return None
            step = np.linalg.lstsq(slopes, -values[:, 0], rcond=1e-12)[0]
            z = z + step
            if np.max(np.abs(step) / np.maximum(1.0, np.abs(z))) < NEAR:
                left = self._residuals(rows, given, wanted, z[None])[:, 0]
                return z if np.max(np.abs(left)) < 1e-7 * max(1.0, float(np.max(np.abs(z)))) else None
        return None

    def _residuals(
        self, rows: Sequence[tuple[Any, int]], given: Mapping[Jet, complex], wanted: Sequence[Jet], tried: Array
    ) -> Array:
        """The equations and their derivatives (rows) at each of the values that are tried (columns)."""
        count = len(tried)
        at = {jet: np.full(count, value, dtype=complex) for jet, value in given.items()}
        at |= {jet: tried[:, j] for j, jet in enumerate(wanted)}
        return np.array([self._row(e, by, at) for e, by in rows])

    def _row(self, expression: Any, by: int, at: Mapping[Jet, Array]) -> Array:
        count = len(next(iter(at.values()), np.zeros(1)))
        own = {symbol: jet for symbol, jet in self.jets.items() if symbol in free_symbols(expression)}
        if by == 0 or self.discrete:
            moved = {symbol: at.get((name, k + by), np.full(count, np.nan)) for symbol, (name, k) in own.items()}
            return self._evaluated(expression, moved, count)
        turns = RADIUS * np.exp(2j * np.pi * np.arange(SAMPLES) / SAMPLES)
        along = {
            symbol: sum(np.multiply.outer(at[name, k + i], turns**i) / factorial(i) for i in range(by + 1)).reshape(-1)
            for symbol, (name, k) in own.items()
        }
        values = self._evaluated(expression, along, count * SAMPLES).reshape(count, SAMPLES)
        derivatives: Array = factorial(by) * np.mean(values * turns ** (-by), axis=1)
        return derivatives

    def _evaluated(self, expression: Any, values: Mapping[Any, Array], count: int) -> Array:
        if any(np.isnan(value).any() for value in values.values()):
            return np.full(count, np.nan, dtype=complex)
        numbers = {symbol: np.full(count, value, dtype=complex) for symbol, value in self.point.items()}
        found = value_of(expression, Environment({**numbers, **values}, count)).value
        return np.broadcast_to(np.asarray(found, dtype=complex), (count,))


def further(question: Question) -> int:
    """Return how much higher the derivatives in the outputs are than those in the equations."""
    orders = []
    for expressions in (question.outputs, question.equations):
        inside = free_symbols(list(expressions))
        orders.append([k for s, (name, k) in question.jets.items() if s in inside and name in question.unknowns])
    return max(0, max(orders[0], default=0) - max(orders[1], default=0))
