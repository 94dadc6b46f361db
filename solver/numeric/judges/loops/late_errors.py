"""The error of a loop with a dead time, simulated: what leaves the plant entered it one dead time before."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.loops.errors import LoopInNumbers, Point

SETTLED = 20.0
"""The time of the first simulation, in units of the slowest time constant of the open loop and of the dead time."""
A_STEP = 0.05
"""Samples are so far apart at most, in units of the fastest time constant."""
SAMPLES = (4, 64)
"""So many are in a dead time."""
MOST = 300_000
SAME = 1e-5
GROWN = 1.9
"""An error that grows like a power of t does so, at least, from one late time to the other, twice as late."""


def simulated_by_steps(loop: LoopInNumbers, signals: Sequence[Any], t: Any, point: Point) -> tuple[float, float]:
    """Return e at two late times, half of the simulated time and its end; longer and longer until it stays."""
    roots = np.abs(loop.poles)
    m = int(np.clip(ceil(loop.delay * max(roots, default=0.0) / A_STEP), *SAMPLES))
    h = loop.delay / m
    paths = [_path(loop, number, h) for number in (0, 1)]
    count = ceil(SETTLED * (loop.delay + 1 / min(roots, default=1 / loop.delay)) / h)
    while count <= MOST:
        e = _errors(loop, paths, [_samples(each, t, point, h * np.arange(count + 1)) for each in signals], m)
        early, late = float(e[len(e) // 2]), float(e[-1])
        stays = abs(late - early) <= SAME * max(1e-3, abs(late))
        if stays or abs(late) > GROWN * abs(early) > GROWN:
            return early, late
        count *= 4
    raise NotEvaluable("the loop settles too slowly to be simulated")


def _samples(signal: Any, t: Any, point: Point, times: Array) -> Array:
    here = {symbol: complex(value) for symbol, value in point.items()}
    rows = [{**here, t: complex(time)} for time in times]
    found: Array = np.ravel(value_of(signal, Environment.at(rows)).value).real * np.ones(len(times))
    return found


def _path(loop: LoopInNumbers, number: int, h: float) -> tuple[Array, ...]:
    """From what enters C (0) or G (1) to y and to H y, without the dead time, exact for what is linear in a step."""
    from scipy.signal import cont2discrete  # noqa: PLC0415

    (c, d), (p, q), (k, n) = loop.C, loop.G, loop.H
    above = np.polymul(c if number == 0 else d, p)
    below = np.polymul(np.polymul(d, q), n)
    rows = [np.polymul(above, n), np.polymul(above, k)]
    size = len(below) - 1
    rows = np.array([np.concatenate([np.zeros(size + 1 - len(row)), row]) for row in rows]) / below[0]
    direct = rows[:, :1]
    if not size:
        return np.zeros((0, 0)), np.zeros((0, 1)), np.zeros((2, 0)), direct
    A: Array = np.vstack([below[1:] / -below[0], np.eye(size)[:-1]])
    system = A, np.eye(size)[:, :1], rows[:, 1:] - direct * below[1:] / below[0], direct
    found: tuple[Array, ...] = cont2discrete(system, h, method="foh")[:4]
    return found


def _errors(loop: LoopInNumbers, paths: Sequence[tuple[Array, ...]], signals: Sequence[Array], m: int) -> Array:
    """r − y at the samples; what is fed back is that of m samples before."""
    r, disturbance = signals
    y, back = np.zeros(len(r)), np.zeros(len(r))
    states = [np.zeros(path[0].shape[0]) for path in paths]
    for k in range(len(r) - m):
        entering = (r[k] - (back[k] if loop.closed else 0.0), disturbance[k])
        left = np.zeros(2)
        for i, (A, B, C, D) in enumerate(paths):
            left += C @ states[i] + D[:, 0] * entering[i]
            states[i] = A @ states[i] + B[:, 0] * entering[i]
        y[k + m], back[k + m] = left
    return r - y


__all__ = ["simulated_by_steps"]
