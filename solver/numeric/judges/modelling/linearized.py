"""Whether A, B, C, D are the linear model of equations about a point: by differences of them, and by simulation."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from random import Random
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.expressions import evaluate
from solver.numeric.evaluation.points import SEED, PointSource, free_symbols, whole_symbols
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.modelling.equations import Jet, Question, states_of
from solver.numeric.judges.modelling.jets import JetEquations, Jets, further

TRIALS, ATTEMPTS, REST, LARGE = 2, 24, 1e-8, 20.0
SAYS = {
    "A": "differences of the equations around the point, in the states",
    "B": "differences of the equations around the point, in the inputs",
    "C": "differences of the outputs around the point, in the states",
    "D": "differences of the outputs around the point, in the inputs",
}
Numbers = Mapping[Any, complex]


@dataclass
class Around:
    """The equations at numbers for the parameters and names, where they are at rest."""

    equations: JetEquations
    states: list[Jet]
    inputs: list[Jet]
    numbers: Numbers
    jets: Jets

    @property
    def is_real(self) -> bool:
        """Whether nothing is complex: a square root may be, at random numbers."""
        return all(abs(complex(value).imag) < 1e-8 * max(1.0, abs(value)) for value in self.jets.values())

    @property
    def size(self) -> float:
        """The largest of the numbers, which an adjustment may have moved far away."""
        return max((abs(value) for value in self.numbers.values()), default=0.0)

    def moved(self) -> Array:
        """The derivatives of the states (discrete: how far they are from the next ones)."""
        now = np.array([self.jets[jet] if self.equations.discrete else 0.0 for jet in self.states], dtype=complex)
        after = np.array([self.jets.get((name, k + 1), np.nan) for name, k in self.states])
        by: Array = after - now
        return by

    def matrices(self, outputs: Sequence[Any]) -> dict[str, Array] | None:
        """A, B, C, D by differences."""
        given = [*self.states, *self.inputs]
        others = [jet for jet in self.jets if jet[0] in {name for name, _ in self.inputs} and jet[1]]
        slopes = self.equations.slopes(self.jets, given, others)
        if slopes is None:
            return None
        n, nothing = len(self.states), np.full(len(given), np.nan)
        rows = np.array([slopes.get((name, k + 1), nothing) for name, k in self.states])
        told = free_symbols(outputs)
        inside = [jet for symbol, jet in self.equations.jets.items() if symbol in told and jet in slopes]
        partial = self.equations.differences([(e, 0) for e in outputs], self.jets, inside)
        through = partial @ np.array([slopes[jet] for jet in inside]).reshape(len(inside), len(given))
        return {"A": rows[:, :n], "B": rows[:, n:], "C": through[:, :n], "D": through[:, n:]}


@dataclass(frozen=True)
class Asked:
    """A question about a point by what tells it from others: what is compared is the identity alone."""

    identity: tuple[Any, ...]
    question: Question = field(compare=False)
    values: Mapping[Any, Any] = field(compare=False)
    symbols: Sequence[Any] = field(compare=False)
    discrete: bool = field(compare=False)
    adjusted: bool = field(compare=False)


def resting_points(
    question: Question, values: Mapping[Any, Any], others: Sequence[Any], *, discrete: bool, adjusted: bool = True
) -> Sequence[Around]:
    """Return numbers at which a point of states and inputs is one of rest; names, then parameters, are adjusted to it.

    `values` are the point by symbols, `others` whatever else is to be evaluated there.
    """
    everything = [*question.equations, *question.outputs, *values.values(), *others]
    known = {symbol for symbol in question.jets if symbol not in values or values[symbol] != symbol}
    symbols = tuple(sorted(free_symbols(everything) - known, key=str))
    fields = (tuple(each.items()) if isinstance(each, Mapping) else tuple(each) for each in question)
    identity = (*fields, tuple(values.items()), symbols, discrete, adjusted)
    return _resting_points(Asked(identity, question, values, symbols, discrete, adjusted))


@lru_cache(maxsize=16)
def _resting_points(asked: Asked) -> tuple[Around, ...]:
    """The same points serve all answers about them: to find them takes most of the time."""
    random = Random(SEED)  # noqa: S311 - nothing secret
    question, values, symbols, discrete = asked.question, asked.values, asked.symbols, asked.discrete
    whole = whole_symbols(symbols=frozenset(symbols))
    source = PointSource(symbols, whole)
    free_ones = [s for s in symbols if s not in whole]
    names = [s for s in free_ones if s in question.jets]
    real_ones: list[Around] = []
    complex_ones: list[Around] = []
    for _ in range(ATTEMPTS):
        numbers = dict(source.draw())
        found = jets_at(question, values, numbers, random, discrete=discrete)
        for free in (names, free_ones) if asked.adjusted else ():
            if found is not None and speed_at(found) > REST:
                found = _adjusted(question, values, numbers, free, random, discrete=discrete) or found
        if found is None or (asked.adjusted and (speed_at(found) > REST or found.size > LARGE)):
            continue
        (real_ones if found.is_real else complex_ones).append(found)
        if len(real_ones) == TRIALS:
            break
    return tuple([*real_ones, *complex_ones][:TRIALS])


def speed_at(found: Around) -> float:
    """Return how fast the states move there."""
    return float(np.max(np.abs(found.moved()), initial=0.0))


def jets_at(
    question: Question,
    values: Mapping[Any, Any],
    numbers: Numbers,
    random: Random,
    near: Around | None = None,
    *,
    discrete: bool,
) -> Around | None:
    """Return all jets at a point with numbers for its symbols, `near` known ones; None where none are found."""
    states, inputs = states_of(question), [(name, 0) for name in question.inputs]
    by_jet = {question.jets[symbol]: value for symbol, value in values.items() if symbol in question.jets}
    try:
        given = {jet: evaluate(by_jet[jet], numbers) for jet in [*states, *inputs]}
    except (NotEvaluable, KeyError):
        return None
    still = {(name, k): given[name, 0] if discrete else 0.0 for name, _ in inputs for k in range(1, 3 + len(states))}
    equations = JetEquations(question.equations, question.jets, question.unknowns, numbers, discrete, further(question))
    jets = equations.solved({**still, **given}, random, near.jets if near else None)
    return None if jets is None else Around(equations, states, inputs, numbers, jets)


def _adjusted(
    question: Question,
    values: Mapping[Any, Any],
    numbers: dict[Any, complex],
    free: Sequence[Any],
    random: Random,
    *,
    discrete: bool,
) -> Around | None:
    """Move the free symbols until nothing moves: Newton's method by the shortest steps."""
    here: Around | None = None
    for _ in range(12):
        here = jets_at(question, values, numbers, random, here, discrete=discrete)
        if here is None or not free:
            return None
        if speed_at(here) <= REST / 100:
            break
        slopes = []
        for symbol in free:
            step = 1e-6 * max(1.0, abs(numbers[symbol]))
            there = jets_at(
                question, values, {**numbers, symbol: numbers[symbol] + step}, random, here, discrete=discrete
            )
            if there is None:
                return None
            slopes.append((there.moved() - here.moved()) / step)
        move = np.linalg.lstsq(np.array(slopes).T, -here.moved(), rcond=1e-9)[0]
        numbers.update({symbol: numbers[symbol] + by for symbol, by in zip(free, move, strict=True)})
    return jets_at(question, values, numbers, random, here, discrete=discrete)


def linear_residuals(
    question: Question, values: Mapping[Any, Any], found: Mapping[str, Any], *, discrete: bool
) -> Iterator[tuple[str, str, float]]:
    """Yield for each matrix a label and how far it is from differences of the equations; nan where there are none."""
    worst, tried = dict.fromkeys(found, 0.0), 0
    for around in resting_points(question, values, list(found.values()), discrete=discrete):
        wanted = around.matrices(question.outputs)
        if wanted is None:
            continue
        tried += 1
        for name, M in found.items():
            worst[name] = max(worst[name], _apart(M, wanted[name], around.numbers))
    for name, residual in worst.items():
        yield name, SAYS[name], residual if tried else np.nan


def _apart(M: Any, wanted: Array, numbers: Numbers) -> float:
    if M.shape != wanted.shape:
        return np.inf
    try:
        own = np.array([evaluate(entry, numbers) for entry in M], dtype=complex).reshape(M.shape)
    except (NotEvaluable, KeyError):
        return np.inf
    largest = float(np.max(np.abs(wanted), initial=0.0))
    sizes = np.maximum(1.0, np.abs(wanted)) + 1e-6 * largest  # of each entry, and what the others leave of it
    distance = float(np.max(np.abs(own - wanted) / sizes, initial=0.0))
    return distance if np.isfinite(distance) else np.inf


def shrinking(question: Question, values: Mapping[Any, Any], A: Any, *, discrete: bool) -> float | None:
    """Return by how much the linear motion's error shrinks where the deviation is halved: 1/4, or 0 without an error.

    Both motions start at the same small deviation; the nonlinear one is that of the equations themselves. None where
    no real one is found.
    """
    for around in resting_points(question, values, [A], discrete=discrete):
        if not around.is_real:
            continue
        try:
            M = np.array([evaluate(entry, around.numbers) for entry in A], dtype=complex).reshape(A.shape).real
        except (NotEvaluable, KeyError):
            return np.inf
        if M.shape != (len(around.states), len(around.states)):
            return np.inf
        errors = [_error(around, M, size) for size in (2e-2, 1e-2)]
        if all(map(np.isfinite, errors)):
            return 0.0 if errors[0] < NOTHING else errors[1] / errors[0]
    return None


NOTHING = 1e-8
"""What integration leaves of two equal motions."""


def _error(around: Around, A: Array, size: float) -> float:
    """The distance between the two motions at the end, from a deviation of that size in every state."""
    start = np.array([around.jets[jet] for jet in around.states]).real
    deviation = size * (1 + np.arange(len(start)) / 7) / np.sqrt(len(start))
    end = 0.3 / max(1.0, float(np.linalg.norm(A)))
    if around.equations.discrete:
        nonlinear, linear = start + deviation, deviation
        for _ in range(2):
            nonlinear, linear = _rate(around, nonlinear), A @ linear
        return float(np.max(np.abs(nonlinear - start - linear)))
    moved = solve_ivp(lambda _, x: _rate(around, x), (0.0, end), start + deviation, rtol=1e-6, atol=1e-10)
    linear = solve_ivp(lambda _, x: A @ x, (0.0, end), deviation, rtol=1e-6, atol=1e-10)
    return float(np.max(np.abs(moved.y[:, -1] - start - linear.y[:, -1])))


def _rate(around: Around, x: Array) -> Array:
    """The derivatives of the states (discrete: the next ones) at other states, with the same inputs."""
    names = {name for name, _ in around.inputs}
    inputs = {jet: value for jet, value in around.jets.items() if jet[0] in names}
    given = {**inputs, **dict(zip(around.states, x, strict=True))}
    jets = around.equations.solved(given, Random(SEED), near=around.jets)  # noqa: S311 - nothing secret
    if jets is None:
        return np.full(len(x), np.nan)
    return np.array([jets.get((name, k + 1), np.nan) for name, k in around.states]).real
