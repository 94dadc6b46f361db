"""Linear equations in numbers over time: steps of the matrix exponential, the inputs by Gauss's rule within each.

The steps are short at first and double their length, so that a fast mode is seen and a slow one settles.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
import sympy as sp
from scipy.linalg import expm

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.expressions import values_at

NODES = 3
STEPS = 96
"""Steps between two doublings of their length."""
LONG, LEAST = 9.0, 2.0
"""Time constants of the slowest mode, and of the fastest one, that are seen."""
MOST_BLOCKS = 40
GROWTH = 7.0
"""An unstable mode is followed until it has grown by e to this."""
STILL = 1e-9


class Signal(NamedTuple):
    """A function of the time as it is given, with the symbol of the time in it; a constant has none."""

    function: Any
    time: Any = None

    def at(self, times: Array, slower: float = 1.0) -> Array:
        """Return the values at times that run that much faster than the function's own."""
        if self.time is None or not self.function.has(self.time):
            return np.broadcast_to(values_at(self.function, sp.Symbol("t"), np.zeros(1)), times.shape)
        return np.asarray(values_at(self.function, self.time, times / slower))

    @property
    def rates(self) -> list[float]:
        """How fast it changes: the factors of the time within its functions, and 1/t of its jumps."""
        found = []
        for each in self.function.atoms(sp.Function) if self.time is not None else ():
            inside = sp.expand(each.args[0])
            for part in (inside.coeff(self.time, 1), inside.coeff(self.time, 1) / (inside.coeff(self.time, 0) or 1)):
                if part.is_number and part != 0:
                    found.append(abs(complex(part.evalf(15))))
        return [each for each in found if np.isfinite(each) and each > 0]


class Grid:
    """The times of a simulation: blocks of steps of equal length, each block twice as long as the one before."""

    def __init__(self, rates: Sequence[complex], changes: Sequence[float]) -> None:
        """`rates` are the eigenvalues, `changes` how fast the inputs change, by the same clock."""
        sizes = [abs(rate) for rate in rates if abs(rate) > STILL] + list(changes)
        fastest = max(sizes, default=1.0)
        slow = [abs(rate.real) if abs(rate.real) > 1e-6 * abs(rate) else abs(rate) / 3 for rate in rates]
        slowest = min([each for each in slow if each > STILL * fastest] + list(changes), default=1.0)
        grown = max((rate.real for rate in rates), default=0.0)
        end = max(LONG / slowest, LEAST / fastest)
        if grown > 1e-6 * fastest:
            end = min(end, GROWTH / grown)
        first = min(end, 8.0 / fastest)
        blocks = max(1, int(np.ceil(np.log2(end / first + 1.0))))
        self.lengths = [first / (2.0**blocks - 1) * max(end / first, 1.0) / STEPS * 2.0**i for i in range(blocks)]

    @cached_property
    def times(self) -> Array:
        """The ends of all steps, with 0."""
        return np.concatenate([[0.0], np.cumsum(np.repeat(self.lengths, STEPS))])

    @cached_property
    def nodes(self) -> Array:
        """The times within the steps at which the inputs are taken (steps×NODES)."""
        inside = (np.polynomial.legendre.leggauss(NODES)[0] + 1) / 2
        return np.asarray(self.times[:-1, None] + np.repeat(self.lengths, STEPS)[:, None] * inside)

    def faster(self, by: float) -> Grid:
        """Return the grid by a clock that is that many times as fast."""
        other = Grid.__new__(Grid)
        other.lengths = [each * by for each in self.lengths]
        return other

    def until(self, end: float) -> Grid:
        """Return the grid of steps of equal length until a time that may be later, or earlier, than its own end."""
        other = Grid.__new__(Grid)
        blocks = max(1, int(np.ceil(end / (STEPS * self.lengths[0]))))
        blocks = min(blocks, MOST_BLOCKS)
        other.lengths = [end / (STEPS * blocks)] * blocks
        return other

    def states(self, A: Array, B: Array, start: Array, inputs: Callable[[Array], Array]) -> Array:
        """Return x of x' = A x + B u at all times (times×n); `inputs` gives u (…×m) at an array of times."""
        roots, weights = np.polynomial.legendre.leggauss(NODES)
        u = inputs(self.nodes)
        found = np.empty((len(self.times), len(A)))
        found[0] = start
        at, length, parts = 0, 0.0, [np.empty(0)]
        for h in self.lengths:
            if length and np.isclose(h, 2 * length, rtol=1e-12):
                parts = [part @ part for part in parts]
            elif not length or h != length:
                parts = [expm(A * (h * share)) for share in (1.0, *((1 - roots) / 2))]
            length, E = h, parts[0]
            pulls = [w * h / 2 * part @ B for part, w in zip(parts[1:], weights, strict=True)]
            block = u[at : at + STEPS]
            forced = sum((block[:, q] @ pull.T for q, pull in enumerate(pulls)), np.zeros((STEPS, len(A))))
            for j in range(STEPS):
                found[at + 1] = E @ found[at] + forced[j]
                at += 1
        return found
