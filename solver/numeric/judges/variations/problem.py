"""Functionals as the judges take them, and functions of time in numbers along which they are evaluated.

Derivatives, of functions of time and of integrands, are means over small circles in the complex plane (Cauchy's
formula): nothing is differentiated by formulas.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from math import factorial
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import PointSource, free_symbols
from solver.numeric.evaluation.values import NotEvaluable, Undefined

Jet = tuple[str, int]
TRIALS, ATTEMPTS = 2, 16
NODES = 24
RADIUS = 0.04
"""The circles in time, relative to the time that there is."""
APART, TURNS, FEWER = 1e-2, 12, 8
"""The circles in a derivative, relative to its size or one."""


@dataclass(frozen=True)
class End:
    """What is asked of a function, or of its derivative, at an end: a value, a curve, or nothing.

    It is `kept` where it may have any value, but does not vary.
    """

    value: Any = None
    curve: Any = None
    kept: bool = False

    @property
    def free(self) -> bool:
        """Whether nothing is asked."""
        return self.value is None and self.curve is None and not self.kept


@dataclass(frozen=True)
class Problem:
    """∫ integrand dt from `start` to `stop` (None: free), plus `cost` in the values at the end and t there.

    `constraints` are zero at all times, `integrals` have an integrand and the value of its integral. `jets` tells for
    each symbol which derivative of which function it is.
    """

    integrand: Any
    t: Any
    functions: Sequence[str]
    jets: Mapping[Any, Jet]
    start: Any
    stop: Any
    ends: Mapping[Jet, tuple[End, End]]
    cost: Any
    constraints: Sequence[Any] = ()
    integrals: Sequence[tuple[Any, Any]] = ()

    @cached_property
    def symbols(self) -> dict[Jet, Any]:
        """The symbol of each derivative."""
        return {jet: symbol for symbol, jet in self.jets.items()}

    @cached_property
    def orders(self) -> dict[str, int]:
        """The highest derivative of each function under the integrals and in the constraints."""
        inside = free_symbols([self.integrand, *self.constraints, *(f for f, _ in self.integrals)])
        return {
            name: max((k for symbol, (of, k) in self.jets.items() if of == name and symbol in inside), default=0)
            for name in self.functions
        }

    def end(self, jet: Jet, last: int) -> End:
        """What is asked of a derivative at the first end (0) or the last (1); what is not named is free."""
        return self.ends[jet][last] if jet in self.ends else End()


def is_known(expression: Any, along: Along) -> bool:
    """Whether all names in an answer have values: those of the question and the time."""
    return free_symbols(expression) <= {*along.point, along.problem.t}


def numbers(expression: Any, values: Mapping[Any, Any], count: int) -> Array:
    """Return the values of an expression (count,), where symbols have these values."""
    full = {symbol: np.broadcast_to(np.asarray(value, dtype=complex), (count,)) for symbol, value in values.items()}
    return np.broadcast_to(np.asarray(value_of(expression, Environment(full, count)).value, dtype=complex), (count,))


Function = Callable[[Array], Array]
"""A function of an array of (complex) times."""


@dataclass(frozen=True)
class Along:
    """Functions of time at one point of the parameters, from `start` to `stop`."""

    problem: Problem
    x: Mapping[str, Function]
    point: Mapping[Any, complex]
    start: float
    stop: float

    @property
    def span(self) -> float:
        """How long it takes."""
        return self.stop - self.start

    def inner(self, count: int) -> Array:
        """Times between the ends."""
        places = np.cos(np.pi * (np.arange(count) + 0.5) / count)
        found: Array = self.start + self.span * (0.5 + 0.42 * places)
        return found

    def at_times(self, expression: Any, times: Array) -> Array:
        """Return an expression in t at (complex) times."""
        return numbers(expression, {**self.point, self.problem.t: times}, len(times))

    def derivatives(self, values: Any, times: Array, order: int) -> Array:
        """Return the derivatives 0 … order (rows) of a function of an array of times."""
        r = RADIUS * self.span
        turns = np.exp(2j * np.pi * np.arange(NODES) / NODES)
        around = values((times[:, None] + r * turns[None, :]).reshape(-1)).reshape(len(times), NODES)
        return np.array([factorial(k) * np.mean(around * turns**-k, axis=1) / r**k for k in range(order + 1)])

    def jets(self, times: Array) -> dict[Any, Array]:
        """Return the values of all derivatives that the problem has symbols for."""
        found: dict[Any, Array] = {}
        for name in self.problem.functions:
            mine = {k: symbol for symbol, (of, k) in self.problem.jets.items() if of == name}
            rows = self.derivatives(self.x[name], times, max(mine))
            found |= {symbol: rows[k] for k, symbol in mine.items()}
        return found

    def of(self, expression: Any, times: Array) -> Array:
        """Return an expression in t, the functions and their derivatives along the motion."""
        return numbers(expression, {**self.point, **self.jets(times), self.problem.t: times}, len(times))

    def partial(self, expression: Any, jet: Jet, times: Array) -> Array:
        """Return the partial derivative of an expression by a derivative, along the motion."""
        symbol = self.problem.symbols.get(jet)
        if symbol is None or symbol not in free_symbols(expression):
            return np.zeros(len(times), dtype=complex)
        values = {**self.jets(times), self.problem.t: times}
        turns = np.exp(2j * np.pi * np.arange(TURNS) / TURNS)
        r = APART * np.maximum(1.0, np.abs(values[symbol]))
        many = {each: np.repeat(value, TURNS) for each, value in values.items()}
        many[symbol] = (values[symbol][:, None] + r[:, None] * turns[None, :]).reshape(-1)
        around = numbers(expression, {**self.point, **many}, len(many[symbol])).reshape(len(times), TURNS)
        found: Array = np.mean(around / turns[None, :], axis=1) / r
        return found

    def second_partial(
        self, expression: Any, one: Jet, other: Jet, times: Array, moved: Mapping[Any, Array] | None = None
    ) -> Array:
        """Return ∂²f/∂a∂b along the motion, or where symbols are `moved` away from it."""
        a, b = (self.problem.symbols.get(jet) for jet in (one, other))
        if not {a, b} <= free_symbols(expression):
            return np.zeros(len(times), dtype=complex)
        values = {**self.jets(times), self.problem.t: times}
        values |= {symbol: values[symbol] + by for symbol, by in (moved or {}).items()}
        turns = np.exp(2j * np.pi * np.arange(FEWER) / FEWER)
        size = {each: 3 * APART * np.maximum(1.0, np.abs(values[each])) for each in (a, b)}
        first, second = (turns[:, None] * np.ones(FEWER)).reshape(-1), (np.ones(FEWER)[:, None] * turns).reshape(-1)
        count = FEWER**2
        many = {each: np.repeat(value, count) for each, value in values.items()}
        for each, around in ((a, first), (b, second)):
            many[each] = many[each] + (size[each][:, None] * around[None, :]).reshape(-1)
        found = numbers(expression, {**self.point, **many}, len(times) * count).reshape(len(times), count)
        mixed: Array = np.mean(found / (first * second)[None, :], axis=1) / (size[a] * size[b])
        return mixed  # where both are one symbol too: it is moved by both circles


def points_of(problem: Problem, x: Mapping[str, Any], stop: Any) -> Iterator[tuple[dict[Any, complex], float, float]]:
    """Yield points of the parameters at which the end comes after the start, with both; None as a stop is nan."""
    everything = [problem.integrand, problem.cost, problem.start, stop, *problem.constraints, *x.values(),
                  *(each for pair in problem.integrals for each in pair)]  # fmt: skip
    everything += [part for pair in problem.ends.values() for end in pair for part in (end.value, end.curve)]
    inside = free_symbols([each for each in everything if each is not None])
    source = PointSource(symbol for symbol in inside if symbol not in problem.jets and symbol != problem.t)
    found = 0
    for _ in range(ATTEMPTS):
        point = source.draw()
        try:
            first, last = (complex(np.nan if each is None else numbers(each, point, 1)[0])
                           for each in (problem.start, stop))  # fmt: skip
        except Undefined:
            continue
        if abs(first.imag) > 1e-9 * (1 + abs(first)) or abs(last.imag) > 1e-9 * (1 + abs(last)):
            continue
        if last.real <= first.real:  # not of nan
            continue
        yield point, first.real, last.real
        found += 1
        if found == TRIALS or not source.symbols:
            return
    if not found:
        raise NotEvaluable("no values of the parameters were found for which the end comes after the start")


def given_motions(problem: Problem, x: Mapping[str, Any], t_f: Any = None) -> Iterator[Along]:
    """Yield the functions that expressions in t are, at some points of the parameters."""
    for point, first, last in points_of(problem, x, t_f if problem.stop is None else problem.stop):
        known = {name: _function(value, point, problem.t) for name, value in x.items()}
        yield Along(problem, known, point, first, last)


def _function(expression: Any, point: Mapping[Any, complex], t: Any) -> Function:
    return lambda times: numbers(expression, {**point, t: times}, len(times))
