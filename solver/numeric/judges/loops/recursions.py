"""What remains of the error of a discrete loop, judged by its recursion: in many digits, and by scipy."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from math import ceil
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.compare import worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.loops.errors import (
    WRONG,
    LoopInNumbers,
    Loops,
    Point,
    residual_beside_origin,
    residual_of_simulation,
)
from solver.numeric.judges.loops.late_errors import simulated_by_steps
from solver.numeric.judges.representation.minimal import MANY, numbers_at

DIED_OUT = 45.0
"""So many times the slowest time constant later its mode is below 10⁻¹⁹."""
MOST_SAMPLES = {True: 20_000, False: 2_000_000}
"""Of the recursion in many digits, and of that in doubles."""
GROWS = 1.2
"""By so much an error that grows does so from one half of the time to the other."""

Residual = Callable[[Loops, Sequence[Any], Any, Any, Any], float]


def error_judges(*, discrete: bool, late: bool = False) -> list[tuple[str, Residual, float]]:
    """Return the judges of what remains of an error: the oracle, the residual, what it may be."""
    if discrete:
        return [
            ("the recursion of the loop (50 digits)", residual_of_recursion, 1e-11),
            ("scipy.signal.lfilter, the loop simulated", residual_of_filter, 1e-3),
        ]
    if late:
        by_steps = partial(residual_of_simulation, simulated=simulated_by_steps)
        return [
            ("mpmath, s E(s) beside the origin (50 digits)", residual_beside_origin, 1e-11),
            ("scipy, the loop simulated from dead time to dead time", by_steps, 1e-3),
        ]
    return [
        ("mpmath, s E(s) beside the origin (50 digits)", residual_beside_origin, 1e-11),
        ("scipy.signal.lsim, the loop simulated", residual_of_simulation, 1e-3),
    ]


def residual_of_recursion(loops: Loops, signals: Sequence[Any], z: Any, k: Any, error: Any) -> float:
    """Return how far the error of the loop is from its limit once its modes have died out, in 50 digits."""
    return _residual(loops, signals, z, k, error, many=True)


def residual_of_filter(loops: Loops, signals: Sequence[Any], z: Any, k: Any, error: Any) -> float:
    """The same in doubles, by `lfilter`."""
    return _residual(loops, signals, z, k, error, many=False)


def _residual(loops: Loops, signals: Sequence[Any], z: Any, k: Any, error: Any, *, many: bool) -> float:
    worst, signals = 0.0, list(map(_without_impulses, signals))
    for point, loop in loops():
        count = ceil(2 * DIED_OUT / min(loop.slowest, *(_decay(each, k, point) for each in signals))) + 20
        if count > MOST_SAMPLES[many]:
            raise NotEvaluable("the modes of the loop die out too slowly for its recursion")
        e = _error(loop, signals, z, k, point, count, many=many)
        early, late = e[count // 2], e[-1]
        grows = abs(late) > GROWS * abs(early) and abs(late - early) > 1e-6
        if error in (sp.oo, -sp.oo):
            worst = worst if grows and (late > 0) == (error == sp.oo) else WRONG
        elif grows:
            return WRONG
        else:
            (claimed,) = (MANY.context.re(each) for each in numbers_at([error], point))
            worst = worst_of((worst, float(abs(late - claimed) / max(1e-3, abs(claimed), abs(early - late)))))
    return worst


def _without_impulses(signal: Any) -> Any:
    """A signal without its impulses, of which nothing remains; step(0) is one."""
    late = signal.replace(sp.DiracDelta, lambda *_: sp.S.Zero)
    return late.replace(sp.Heaviside, lambda x, *_: sp.Heaviside(x + sp.Rational(1, 2)))


def _decay(signal: Any, k: Any, point: Point) -> float:
    """How fast the slowest of the powers in a signal that die out does so, 1 without."""
    bases = [each.base ** each.exp.coeff(k) for each in signal.atoms(sp.Pow) if each.exp.has(k)]
    bases += [sp.exp(each.exp.coeff(k)) for each in signal.atoms(sp.exp) if each.exp.has(k)]
    sizes = [abs(complex(number)) for number in numbers_at(bases, point)]
    return min([1.0, *(-float(np.log(size)) for size in sizes if 0 < size < 1)])


def _error(
    loop: LoopInNumbers, signals: Sequence[Any], z: Any, k: Any, point: Point, count: int, *, many: bool
) -> Array:
    """The samples of r − y, the modes of the loop taken along that cancel in it."""
    e = np.zeros(count, dtype=object if many else float)
    factors = _in_many_digits(loop, z, point) if many else loop
    for number, (top, signal) in enumerate(zip(factors.numerators, signals, strict=True)):
        if signal != 0:
            f = _samples(signal, k, point, count, many=many)
            filtered = _filtered if many else _lfilter
            e = e + (f if number == 0 else 0) - filtered(top, factors.characteristic, f)
    return e


def _samples(signal: Any, k: Any, point: Point, count: int, *, many: bool) -> Array:
    """The values of a signal at 0, 1, …."""
    context = MANY.context
    if many:
        at = Environment.at([{**point, k: context.mpf(i)} for i in range(count)], MANY)
        found = np.ravel(value_of(signal, at).value)
        return np.array([context.re(each) for each in found], dtype=object) * np.ones(count, dtype=object)
    here = {symbol: complex(value) for symbol, value in point.items()}
    at = Environment.at([{**here, k: complex(i)} for i in range(count)])
    return np.ravel(value_of(signal, at).value).real * np.ones(count)


def _in_many_digits(loop: LoopInNumbers, z: Any, point: Point) -> LoopInNumbers:
    """The same loop with coefficients in many digits."""

    def numbers(polynomial: Any) -> Array:
        listed = numbers_at(sp.Poly(polynomial, z).all_coeffs(), point)
        return np.array([MANY.context.re(c) for c in listed], dtype=object)

    fractions = [sp.fraction(sp.together(factor)) for factor in loop.factors]
    C, G, H = ((numbers(above), numbers(below)) for above, below in fractions)
    return LoopInNumbers(C, G, H, loop.factors, loop.closed, discrete=True)


def _aligned(top: Array, bottom: Array) -> tuple[Array, Array]:
    """Numerator and denominator in z⁻¹, the first of the denominator 1."""
    lead = next(i for i, c in enumerate(bottom) if abs(c) > 1e-30)
    below = bottom[lead:]
    while len(top) > len(below):
        top = top[1:]  # what is before are zeros: the loop is causal
    return np.concatenate([np.zeros(len(below) - len(top), dtype=top.dtype), top]) / below[0], below / below[0]


def _filtered(top: Array, bottom: Array, f: Array) -> Array:
    """Y of a recursion, sample by sample."""
    b, a = _aligned(top, bottom)
    n, y = len(a) - 1, np.zeros(len(f), dtype=object)
    state = [MANY.context.mpf(0)] * (n + 1)
    for i, u in enumerate(f):  # the direct form II transposed
        y[i] = b[0] * u + state[0]
        for j in range(n):
            state[j] = b[j + 1] * u + state[j + 1] - a[j + 1] * y[i]
    return y


def _lfilter(top: Array, bottom: Array, f: Array) -> Array:
    from scipy.signal import lfilter  # noqa: PLC0415 - only where a response is judged

    return np.asarray(lfilter(*_aligned(top, bottom), f))
