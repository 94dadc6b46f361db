"""Judges of a scaling, in numbers: the largest size by simulation, scaled equations at random points.

The motion is followed by steps of the matrix exponential, short for the fastest mode, until the slowest one is gone;
a cubic through values and slopes tells between which samples a size is largest, and the exponential where.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from random import Random
from typing import Any

import numpy as np
import sympy as sp
from scipy.linalg import expm, matrix_balance
from scipy.optimize import brentq

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.expressions import evaluate
from solver.numeric.evaluation.points import SEED, PointSource, free_symbols
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.analog.posed import TIME, Asked, Posed
from solver.numeric.judges.modelling.equations import Jet

TRIALS = 3
PER_FASTEST = 12.0
"""Samples in 1/|λ| of the fastest mode."""
LATEST = 30.0
"""In time constants of the slowest mode."""
MOST = 60_000
"""Steps of that length; what comes later is followed in as many longer ones."""
ROUNDED = 1e-14
LEAST, MOST_LOST = 3e-10, 1e-6
NEXT = 1e-9
SMALL = 1e-7
"""What stays below that, relatively to the others, is no motion."""


def largest_sizes(asked: Asked) -> dict[Jet, float]:
    """The largest size of each state for t ≥ 0. Raises NotEvaluable where there are symbols."""
    if free_symbols([*asked.question.equations, *asked.initial.values()]) - set(asked.question.jets):
        raise NotEvaluable("the equations have symbols")
    posed = asked.posed
    sizes = np.zeros(len(posed.states))
    x = posed.start
    for start, end in _intervals(posed):
        fine = start + MOST / _fastest(posed) / PER_FASTEST
        for a, b in ((start, min(fine, end)), (fine, end)):
            if a < b:
                x, reached = _followed(posed, x, a, b)
                sizes = np.maximum(sizes, reached)
    sizes[sizes < SMALL * max(1e-300, float(np.max(sizes, initial=0.0)))] = 0.0
    return dict(zip(posed.states, (float(each) for each in sizes), strict=True))


def accuracy(asked: Asked) -> float:
    """What rounding leaves of a simulation, relatively: more where the modes are nearly alike."""
    vectors = np.linalg.eig(matrix_balance(Posed(asked).A)[0])[1]
    return float(np.clip(ROUNDED * np.linalg.cond(vectors), LEAST, MOST_LOST))


def _intervals(posed: Posed) -> Iterator[tuple[float, float]]:
    """From one jump of the inputs to the next, the last until nothing moves any more."""
    jumps = {0.0}
    for function in posed.functions.values():
        for step in function.atoms(sp.Heaviside):
            inside = sp.Poly(step.args[0], TIME)
            at = float(-inside.nth(0) / inside.nth(1))
            jumps |= {at} if at > 0 else set()
    rates = np.linalg.eigvals(posed.A)
    fading = [-rate.real for rate in rates if rate.real < -1e-9 * max(1.0, abs(rate))]
    slow = [*fading, *_changes(posed)]
    lasting = [abs(rate) for rate in rates if abs(rate.real) <= 1e-9 * max(1.0, abs(rate)) and abs(rate) > 1e-9]
    ends = sorted(jumps)
    last = ends[-1] + max(LATEST / min(slow, default=np.inf), 2.2 * np.pi / min(lasting, default=np.inf), 1e-3)
    yield from zip(ends, [*ends[1:], last], strict=True)


def _fastest(posed: Posed) -> float:
    """The fastest rate of the modes and of the inputs."""
    return float(max([*np.abs(np.linalg.eigvals(posed.A)), *_changes(posed), 1e-9]))


def _changes(posed: Posed) -> list[float]:
    """How fast the inputs change."""
    found = []
    for function in posed.functions.values():
        for each in function.atoms(sp.exp, sp.sin, sp.cos):
            rate = abs(complex(sp.diff(each.args[0], TIME).evalf(15)))
            found += [rate] if rate > 0 else []
    return found


def _followed(posed: Posed, x: Array, start: float, end: float) -> tuple[Array, Array]:
    """The states at the end of an interval without jumps, and the largest sizes within it."""
    fastest = max(_fastest(posed), 1.0 / (end - start))
    steps = int(min(MOST, np.ceil((end - start) * fastest * PER_FASTEST))) + 1
    h = (end - start) / steps
    roots, weights = np.polynomial.legendre.leggauss(4 if fastest * h < 1.0 else 24)
    times = start + h * np.arange(steps + 1)
    inside = np.clip(times, start + NEXT * (end - start), end - NEXT * (end - start))
    nodes = times[:-1, None] + h * (1 + roots) / 2
    drives = _drive(posed, nodes)
    pulls = [w * h / 2 * expm(posed.A * h * (1 - s) / 2) @ posed.B for s, w in zip(roots, weights, strict=True)]
    forced = sum((drives[:, q] @ pull.T for q, pull in enumerate(pulls)), np.zeros((steps, len(x))))
    E, states = expm(posed.A * h), np.empty((steps + 1, len(x)))
    states[0] = x
    for i in range(steps):
        states[i + 1] = E @ states[i] + forced[i]
    slopes = states @ posed.A.T + _drive(posed, inside) @ posed.B.T
    tops = np.max(np.abs(states), axis=0)
    for i, step in enumerate(_steps_with_tops(states, slopes, h)):
        tops[i] = max(tops[i], _refined(posed, i, states[step], times[step], h) if step >= 0 else 0.0)
    return states[-1], tops


def _steps_with_tops(states: Array, slopes: Array, h: float) -> list[int]:
    """The step in which the size of each state is largest between its samples, by cubics; -1 where in none."""
    p, q, a, b = states[:-1], states[1:], h * slopes[:-1], h * slopes[1:]
    c3, c2, c1 = 2 * (p - q) + a + b, 3 * (q - p) - 2 * a - b, a
    sizes = np.zeros_like(p)
    with np.errstate(all="ignore"):
        root = np.sqrt(c2**2 - 3 * c3 * c1)
        for s in ((-c2 + root) / (3 * c3), (-c2 - root) / (3 * c3), -c1 / (2 * c2)):
            inside = (s > 0) & (s < 1)
            at = np.where(inside, s, 0.0)
            sizes = np.where(inside, np.maximum(sizes, np.abs(((c3 * at + c2) * at + c1) * at + p)), sizes)
    return [int(np.argmax(each)) if np.any(each) else -1 for each in sizes.T]


def _refined(posed: Posed, i: int, x: Array, start: float, h: float) -> float:
    """The size of a state where its slope changes its sign within a step, by the matrix exponential from its start."""
    roots, weights = np.polynomial.legendre.leggauss(6)

    def after(s: float) -> Array:
        inputs = _drive(posed, start + s * (1 + roots) / 2)
        pulls = (w * s / 2 * expm(posed.A * s * (1 - r) / 2) @ posed.B @ u
                 for r, w, u in zip(roots, weights, inputs, strict=True))  # fmt: skip
        return np.asarray(expm(posed.A * s) @ x + sum(pulls))

    def slope(s: float) -> float:
        return float(posed.A[i] @ after(s) + posed.B[i] @ _drive(posed, np.array([start + s]))[0])

    a, b = NEXT * h, (1 - NEXT) * h
    if slope(a) * slope(b) > 0:
        return max(abs(float(after(a)[i])), abs(float(after(b)[i])))
    return abs(float(after(brentq(slope, a, b, xtol=1e-14 * h))[i]))


def scaled_residuals(
    asked: Asked, factors: Mapping[Jet, Any], rows: Sequence[Any], volts: Mapping[str, Jet]
) -> Iterator[float]:
    """Yield for each row dX/dτ how far it is from (L/β) x' at random points; `volts` are the scaled variables by name.

    Without states the rows are the voltages of the readouts. They are in the scaled variables, in inputs that have no
    function (in units) and in tau. Raises NotEvaluable.
    """
    random = Random(SEED)  # noqa: S311 - nothing secret
    worst = [0.0] * len(rows)
    known = {*asked.question.jets, TIME}
    symbols = sorted(free_symbols([*asked.question.equations, asked.time_scale, *factors.values()]) - known, key=str)
    source = PointSource(symbols)
    for _ in range(TRIALS):
        at = {s: sp.Float(complex(v).real, 20) for s, v in dict(source.draw()).items()}
        put = asked.question._replace(equations=[e.xreplace(at) for e in asked.question.equations])
        posed = replace(asked, question=put).posed
        beta = float(asked.time_scale.xreplace(at))
        L = {jet: float(value.xreplace(at)) for jet, value in factors.items()}
        x, t = np.array([random.uniform(0.5, 2.0) for _ in posed.states]), random.uniform(0.3, 2.0)
        drive = _drive(posed, np.array([t]))[0]
        rows_over = posed.matrix if posed.states else np.array(list(posed.rows.values()))
        terms = rows_over * np.concatenate([x, drive])
        scales = [L[jet] / beta for jet in posed.states] or [L[name, 0] for name in posed.rows]
        values = _values(posed, x, t, L, beta, volts) | {str(s): float(v) for s, v in at.items()}
        for i, (row, parts, scale) in enumerate(zip(rows, terms, scales, strict=True)):
            inside = free_symbols([row])
            if {str(s) for s in inside} - set(values):
                worst[i] = np.inf
                continue
            given, wanted = complex(evaluate(row, {s: values[str(s)] for s in inside})), scale * parts.sum()
            worst[i] = max(worst[i], abs(given - wanted) / max(abs(scale) * np.abs(parts).sum(), 1e-300))
    yield from worst


def _drive(posed: Posed, times: Array) -> Array:
    """The inputs and 1 in a last axis; derivatives of inputs, which no state takes here, are left out."""
    orders = [*(k for _, k in posed._driving), 0]
    columns = [
        np.zeros(times.size) if k else each.at(times.reshape(-1)) for k, each in zip(orders, posed.signals, strict=True)
    ]
    return np.stack([column.reshape(times.shape) for column in columns], axis=-1)


def _values(
    posed: Posed, x: Array, t: float, L: Mapping[Jet, float], beta: float, volts: Mapping[str, Jet]
) -> dict[str, float]:
    """What the symbols of a scaled equation are at a point."""
    inputs = {name: complex(evaluate(function, {TIME: t})).real for name, function in posed.functions.items()}
    units = {**dict(zip(posed.states, x, strict=True)), **{(name, 0): value for name, value in inputs.items()}}
    scaled = {name: L.get(jet, 1.0) * units[jet] for name, jet in volts.items() if jet in units}
    return {**inputs, "tau": beta * t, **scaled}
