"""Equations of extremals against the first variation: at random values, velocities and so on of the functions.

Along polynomials that begin with these, the functional's derivatives by each function are taken by circles in the
complex plane (see `problem`); what is submitted must be sums of multiples of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import factorial
from random import Random
from typing import Any, NamedTuple

import numpy as np

from solver.jets import jet_symbol
from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.points import SEED, PointSource, free_symbols
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.variations.problem import Along, Problem, numbers

TRIALS = 2
MOVED = 1e-7
"""A derivative of which the equations depend changes them by more."""
REGULAR = 1e-8


class Balance(NamedTuple):
    """How far each equation is from a sum of multiples, and whether they say as much as the functional does."""

    residuals: list[float]
    independent: bool


class Adjoined(NamedTuple):
    """A functional with what stands beside the multipliers, which are functions, and beside those that are constant."""

    problem: Problem
    bound: Sequence[Any]
    multipliers: Sequence[str]
    constant: Sequence[Any]

    @property
    def names(self) -> tuple[str, ...]:
        """The functions and the multipliers that vary."""
        return (*self.problem.functions, *self.multipliers)

    def symbol(self, jet: Any) -> Any:
        """The symbol of a derivative."""
        return self.problem.symbols.get(jet) or jet_symbol(jet)

    @property
    def integrand(self) -> Any:
        """The integrand with its constraints."""
        varying = [jet_symbol((name, 0)) * each for name, each in zip(self.multipliers, self.bound, strict=True)]
        integrals = [x * f for x, (f, _) in zip(self.constant, self.problem.integrals, strict=True)]
        return sum([*varying, *integrals], start=self.problem.integrand)


def stationary_equations(adjoined: Adjoined, expressions: Sequence[Any]) -> Balance:
    """Compare equations with those of the first variation; factors may depend on all but the highest derivatives."""
    wanted = len(adjoined.problem.functions) + len(adjoined.bound)
    if len(expressions) != wanted:
        return Balance([np.inf] * len(expressions), independent=False)
    residuals, independent = [0.0] * wanted, True
    for place in _places(adjoined, expressions):
        try:
            E, values = place.samples(expressions, 2 * wanted + 4)
        except (NotEvaluable, KeyError):
            return Balance([np.inf] * wanted, independent=False)
        K = np.linalg.lstsq(E, values, rcond=None)[0]
        size = np.maximum(np.max(np.abs(values), axis=0), 1e-12)
        apart = np.max(np.abs(E @ K - values), axis=0) / size
        residuals = [max(old, float(new)) for old, new in zip(residuals, apart, strict=True)]
        rows = K / np.maximum(np.max(np.abs(K), axis=0, keepdims=True), 1e-300)
        independent &= bool(np.linalg.svd(rows, compute_uv=False)[-1] > REGULAR)
    return Balance([each if np.isfinite(each) else np.inf for each in residuals], independent)


def _places(adjoined: Adjoined, expressions: Sequence[Any]) -> Iterator[_Place]:
    problem, random = adjoined.problem, Random(SEED)  # noqa: S311 - nothing secret
    highest = 2 * max([1, *problem.orders.values()])
    jets = {adjoined.symbol((name, k)) for name in adjoined.names for k in range(highest + 1)}
    inside = free_symbols([adjoined.integrand, *adjoined.bound, *expressions]) - jets - {problem.t}
    source = PointSource(inside)
    for _ in range(TRIALS):
        lower = {(name, k): random.uniform(0.4, 1.6) for name in adjoined.names for k in range(highest + 1)}
        yield _Place(adjoined, source.draw(), random.uniform(0.4, 1.3), lower, random)


class _Place:
    """One point of the parameters and the time, and the functions with their derivatives there."""

    def __init__(
        self, adjoined: Adjoined, point: Mapping[Any, complex], time: float, jets: Mapping[Any, float], random: Random
    ) -> None:
        self.adjoined, self.point, self.time, self.jets, self.random = adjoined, point, time, jets, random
        symbols = {adjoined.symbol(jet): jet for jet in jets}
        self.problem = adjoined.problem.__class__(
            adjoined.integrand, adjoined.problem.t, adjoined.names, symbols, None, None, {}, None
        )

    def samples(self, expressions: Sequence[Any], count: int) -> tuple[Array, Array]:
        """Return what is zero by the first variation, and the expressions, at `count` values of what is highest."""
        tops = self.tops()
        E, values = [], []
        for _ in range(count):
            jets = {**self.jets, **{jet: self.random.uniform(-2, 2) for jet in tops}}
            E.append(self.equations(jets))
            values.append([self.number(each, jets) for each in expressions])
        return np.array(E), np.array(values)

    def tops(self) -> list[Any]:
        """The highest derivative of each function on which the equations depend."""
        base, found = self.equations(self.jets), []
        for name in self.adjoined.names:
            orders = sorted((k for of, k in self.jets if of == name), reverse=True)
            for k in orders:
                moved = self.equations({**self.jets, (name, k): self.jets[name, k] + 0.37})
                if np.max(np.abs(moved - base)) > MOVED * max(1.0, float(np.max(np.abs(base)))):
                    found.append((name, k))
                    break
        return found

    def number(self, expression: Any, jets: Mapping[Any, float]) -> complex:
        """Return the value of an expression there."""
        known = {self.adjoined.symbol(jet): value for jet, value in jets.items()}
        return complex(numbers(expression, {**self.point, **known, self.problem.t: self.time}, 1)[0])

    def equations(self, jets: Mapping[Any, float]) -> Array:
        """Return Σ (−1)ᵏ dᵏ/dtᵏ ∂φ/∂q⁽ᵏ⁾ of each function of the question, and the constraints."""
        along = Along(self.problem, {name: self._path(name, jets) for name in self.adjoined.names}, self.point,
                      self.time - 0.5, self.time + 0.5)  # fmt: skip
        at = np.array([self.time], dtype=complex)
        phi = self.adjoined.integrand
        found = []
        for name in self.adjoined.problem.functions:
            terms = []
            for k in range(self.adjoined.problem.orders[name] + 1):
                rates = along.derivatives(lambda times, jet=(name, k): along.partial(phi, jet, times), at, k)
                terms.append((-1) ** k * rates[k][0])
            found.append(sum(terms))
        return np.array([*found, *(self.number(each, jets) for each in self.adjoined.bound)])

    def _path(self, name: str, jets: Mapping[Any, float]) -> Any:
        """The polynomial with these derivatives at the time."""
        coefficients = [(k, value / factorial(k)) for (of, k), value in jets.items() if of == name]
        return lambda times: sum(c * (times - self.time) ** k for k, c in coefficients)
