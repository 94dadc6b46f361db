"""What remains of an error, judged twice: by s E(s) beside the origin, and by the signals of the loop simulated.

A loop is its factors C, G, H as expressions in s (discrete: z) and whether it is closed; signals are expressions in t.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache, reduce
from itertools import pairwise
from operator import mul
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.compare import worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import admissible, free_symbols
from solver.numeric.evaluation.quadrature import legendre
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.representation.minimal import MANY, numbers_at

POINTS = 2
TRIED = 400
BESIDE = (1e-13, 5e-14)
"""So far from the origin s E(s) is taken, in units of the slowest root."""
BESIDE_ZERO, BESIDE_ONE = ("1e-18", "1e-20"), ("1e-9", "1e-11")
"""Where the order of a pole is seen: beside one what is left of (z − 1)⁴ must be more than is rounded away."""
WRONG = float("inf")
SETTLED = 40.0
"""The time of a simulation in units of the slowest time constant."""
STEPS = 4000

Point = Mapping[Any, complex]
Quotient = tuple[Array, Array]
"""Numerator and denominator in numbers, the highest power first."""


@dataclass(frozen=True)
class LoopInNumbers:
    """The factors of a loop at a point, and the poles of what it makes of its signals."""

    C: Quotient
    G: Quotient
    H: Quotient
    factors: tuple[Any, ...]
    """C, G, H as they are given."""
    closed: bool
    discrete: bool = False
    delay: float = 0.0
    """Of the plant, continuous."""

    @property
    def characteristic(self) -> Array:
        """The denominator of the loop, nothing cancelled."""
        (c, _), (p, _), (h, _) = self.C, self.G, self.H
        return np.polyadd(self.opened, _times(c, p, h)) if self.closed else self.opened

    @property
    def opened(self) -> Array:
        """The denominator of L, of C G where the loop is not closed."""
        (_, d), (_, q), (_, k) = self.C, self.G, self.H
        return _times(d, q, k) if self.closed else _times(d, q)

    @property
    def poles(self) -> Array:
        """The roots of the characteristic polynomial, without those of integrators where the loop is open.

        With a dead time in a closed loop those of the open loop, integrators apart: they say how fast it may be.
        """
        opened = not self.closed or self.delay > 0
        p = np.trim_zeros(self.opened if opened else self.characteristic, "f")
        while opened and abs(np.polyval(p, float(self.discrete))) <= 1e-12 * np.sum(np.abs(p)):
            p = np.polydiv(p, [1.0, -float(self.discrete)])[0]
        return np.roots(p)

    @property
    def slowest(self) -> float:
        """How fast the slowest mode decays: the least −Re p, in discrete time −ln|p|; one without modes."""
        sizes = -np.log(np.abs(self.poles) + 1e-300) if self.discrete else -self.poles.real
        return float(min(sizes, default=1.0))

    @property
    def numerators(self) -> tuple[Array, Array]:
        """What the output has above the characteristic polynomial, of the reference and of the disturbance."""
        (c, d), (p, _), (_, k) = self.C, self.G, self.H
        return (_times(c, p, k), _times(p, d, k)) if self.closed else (_times(c, p), _times(p, d))

    def error_at(self, s: Any, value: Any, point: Point) -> tuple[Any, Any]:
        """Return what the error makes of the reference and of the disturbance where s has a value, in many digits."""
        here = Environment.at([{**point, s: value}], MANY)
        C, G, H = (np.ravel(value_of(each, here).value)[0] for each in self.factors)
        G = G * MANY.context.exp(-value * self.delay) if self.delay else G
        below = 1 + C * G * H if self.closed else 1
        return 1 - C * G / below, -G / below


Loops = Callable[[], Sequence[tuple[Point, LoopInNumbers]]]
"""What finds loops in numbers, with the values of the parameters."""


Simulation = Callable[[LoopInNumbers, Sequence[Any], Any, Point], tuple[float, float]]
"""What finds e at two late times."""


def _times(*factors: Array) -> Array:
    return reduce(np.polymul, factors)


def stable_loops(
    factors: Sequence[Any],
    s: Any,
    others: Any,
    *,
    closed: bool,
    discrete: bool = False,
    delay: Any = sp.S.Zero,
    late_stable: Callable[[Point], bool] = lambda _: True,
) -> list[tuple[Point, LoopInNumbers]]:
    """Return the loop in numbers at some values of the parameters for which it is stable; raises NotEvaluable.

    With a dead time in a closed loop `late_stable` says whether it is.
    """
    symbols = free_symbols([*factors, *others, delay]) - {s}
    found = []
    for point in admissible(symbols, TRIED if symbols else 1):
        C, G, H = (_quotient(each, s, point) for each in factors)
        (late,) = numbers_at([delay], point)
        loop = LoopInNumbers(C, G, H, tuple(factors), closed, discrete, float(complex(late).real))
        if late_stable(point) if closed and loop.delay else loop.slowest > 0:
            found.append((point, loop))
        if len(found) == (POINTS if symbols else 1):
            return found
    if not found:
        raise NotEvaluable("no values of the parameters were found for which the loop is stable")
    return found


def _quotient(element: Any, s: Any, point: Point) -> Quotient:
    known = {symbol: sp.Float(complex(value).real, 17) for symbol, value in point.items()}
    above, below = sp.fraction(sp.together(element.xreplace(known)))
    top, bottom = (np.array([float(c) for c in sp.Poly(each, s).all_coeffs()]) for each in (above, below))
    return top, bottom


def residual_beside_origin(loops: Loops, signals: Sequence[Any], s: Any, t: Any, error: Any) -> float:
    """Return how far s E(s) beside the origin is from the limit of e; ∞ where one of them alone is without end."""
    worst, signals = 0.0, list(map(_lasting, signals))
    for point, loop in loops():
        found = [_scaled_transform(loop, signals, s, t, point, beside) for beside in BESIDE]
        (claimed,) = numbers_at([error], point) if error not in (sp.oo, -sp.oo) else (error,)
        ratio = abs(found[1]) / (abs(found[0]) or MANY.context.mpf(1))
        grows = bool(abs(found[1]) > 1e6 and ratio > 1.5)
        if claimed in (sp.oo, -sp.oo):
            right = grows and (found[1].real > 0) == (claimed == sp.oo)
            worst = worst if right else WRONG
        elif grows:
            return WRONG
        else:
            limit = 2 * found[1] - found[0]
            worst = worst_of((worst, float(abs(limit - claimed) / max(1e-3, abs(claimed)))))
    return worst


def _lasting(signal: Any) -> Any:
    """A signal without its impulses, of which nothing remains."""
    return signal.replace(sp.DiracDelta, lambda *_: sp.S.Zero)


def _scaled_transform(loop: LoopInNumbers, signals: Sequence[Any], s: Any, t: Any, point: Point, beside: float) -> Any:
    """The product s E(s) = Σ W(s) ∫ f(x/s) e^{−x} dx at a point beside the origin."""
    slowest = min((abs(root) for root in loop.poles), default=1.0)
    value = MANY.context.mpf(beside) * float(slowest)
    total = MANY.context.mpf(0)
    for transfer, signal in zip(loop.error_at(s, value, point), signals, strict=True):
        if signal != 0:
            total += transfer * _mean(signal, t, tuple(point.items()), value)
    return total


@lru_cache(maxsize=256)
def _mean(signal: Any, t: Any, point: tuple[tuple[Any, complex], ...], s: Any) -> Any:
    """∫ f(x/s) e^{−x} dx from 0 to ∞; whoever marks asks for it with every answer."""
    u, weights = _decaying()
    values = np.ravel(value_of(signal, _times_at(dict(point), t, u / s)).value)
    return np.sum(values * weights)


@cache
def _decaying() -> tuple[Array, Array]:
    """Nodes of Gauss's rule on panels that become shorter towards zero, and the weights with e^{−x} in them."""
    x, w = legendre(MANY, 40)
    edges = [MANY.context.mpf(0), *(MANY.context.mpf(2) ** i for i in range(-60, 8))]
    nodes, weights = [], []
    for a, b in pairwise(edges):
        half = (b - a) / 2
        nodes += [a + half * (1 + each) for each in x]
        weights += [half * each for each in w]
    u = np.array(nodes, dtype=object)
    decay = np.array([MANY.context.exp(-each) for each in u], dtype=object)
    return u, decay * np.array(weights, dtype=object)


def _times_at(point: Point, t: Any, times: Array) -> Environment:
    return Environment.at([{**point, t: each} for each in times], MANY)


def residual_of_simulation(
    loops: Loops, signals: Sequence[Any], _s: Any, t: Any, error: Any, simulated: Simulation | None = None
) -> float:
    """Return how far the error of the simulated loop is from its limit, late; ∞ where one alone is without end."""
    worst, signals = 0.0, list(map(_lasting, signals))
    for point, loop in loops():
        early, late = (simulated or _simulated)(loop, signals, t, point)
        if error in (sp.oo, -sp.oo):
            grows = abs(late) > 1.5 * abs(early) and (late > 0) == (error == sp.oo)
            worst = worst if grows else WRONG
            continue
        (claimed,) = (complex(each).real for each in numbers_at([error], point))
        worst = worst_of((worst, abs(late - claimed) / max(1e-3, abs(claimed), abs(early - late))))
    return worst


def _simulated(loop: LoopInNumbers, signals: Sequence[Any], t: Any, point: Point) -> tuple[float, float]:
    """e at two late times, from r, d and the output, whose state goes on by e^{Ah} with the signals linear between."""
    from scipy.signal import lsim  # noqa: PLC0415

    slowest = loop.slowest
    unit = np.linspace(0.0, SETTLED, STEPS + 1)
    here = {symbol: complex(value) for symbol, value in point.items()}
    e = np.zeros(len(unit))
    for number, (top, signal) in enumerate(zip(loop.numerators, signals, strict=True)):
        if signal == 0:
            continue
        rows = [{**here, t: complex(time)} for time in unit / slowest]
        f = np.ravel(value_of(signal, Environment.at(rows)).value).real * np.ones(len(unit))
        e += f if number == 0 else 0.0
        above, below = (np.trim_zeros(_slower(each, slowest), "f") for each in (top, loop.characteristic))
        if len(above):
            e -= lsim((above, below), f, unit)[1]
    return float(e[len(e) // 2]), float(e[-1])


def _slower(polynomial: Array, rate: float) -> Array:
    """The coefficients in s/rate."""
    n = len(polynomial) - 1
    return np.array([c * rate ** (n - i) for i, c in enumerate(polynomial)])


def order_at_origin(numerator: Any, denominator: Any, s: Any, where: Any = 0) -> set[int]:
    """Return the orders of the pole of a quotient at the origin, or at 1, that are found by how fast it grows."""
    found = set()
    F = numerator / denominator
    distances = BESIDE_ONE if int(where) else BESIDE_ZERO
    for point in admissible(free_symbols([numerator, denominator]) - {s}, POINTS):
        near, nearer = (
            abs(np.ravel(value_of(F, Environment.at([{**point, s: int(where) + MANY.context.mpf(at)}], MANY)).value)[0])
            for at in distances
        )
        found.add(round(float(MANY.context.log10(nearer / near)) / 2) if nearer and near else 0)
    return found


def sign_residual(loops: Sequence[tuple[Point, LoopInNumbers]], s: Any, sign: int) -> float:
    """Return 0 where C G H has a sign just to the right of the origin, of z = 1, else infinity."""
    for point, loop in loops:
        here = Environment.at(
            [{**point, s: MANY.context.mpf(BESIDE_ONE[0]) + 1 if loop.discrete else MANY.context.mpf(BESIDE_ZERO[0])}],
            MANY,
        )
        value = reduce(mul, (np.ravel(value_of(each, here).value)[0] for each in loop.factors))
        if not value.real * sign > 0:
            return WRONG
    return 0.0


def holds_where_positive(condition: Any, positive: Sequence[Any]) -> bool:
    """Whether a condition holds at random points exactly where all expressions are positive."""
    for point in admissible(free_symbols(list(positive)), TRIED // 10):
        at = {symbol: sp.Float(complex(value).real) for symbol, value in point.items()}
        wanted = all(bool(each.subs(at) > 0) for each in positive)
        if bool(condition.subs(at)) != wanted:
            return False
    return True
