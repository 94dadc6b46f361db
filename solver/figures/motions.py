"""Motions of linear systems as plots: the state is carried on from moment to moment by one matrix."""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.derivation.figures import DrawnCurve, DrawnPanels, DrawnPlot, Motion, Signals
from solver.figures.sampling import REACH, named_together, plain, window_around
from solver.lazy import numeric

STEPS = 1200
SAMPLES = 20
SLOW = 1e-9
"""A mode that changes no faster than this does not end."""

Array = np.ndarray[Any, np.dtype[np.float64]]


def moved(motion: Motion) -> DrawnPanels:
    """Return a motion as plots below each other."""
    times, states = _course(motion)
    letter = "k" if motion.discrete else "t"
    others = None if motion.beside is None else _beside(motion, times, states[0])
    panels = tuple(_panel(each, letter, times, states, motion, others) for each in motion.panels)
    return DrawnPanels(motion.caption, panels)


def _array(matrix: Any) -> Array:
    return np.real(np.atleast_2d(numeric.evaluate(matrix, {}))).astype(float)


def _course(motion: Motion) -> tuple[Array, Array]:
    """Return moments and the states at them, as rows, as long as they can be drawn."""
    from scipy.linalg import expm  # noqa: PLC0415 - only a motion needs it

    matrix, start = _array(motion.matrix), _array(motion.start)
    n, discrete = len(matrix), motion.discrete
    times = np.arange(SAMPLES + 1.0) if discrete else np.linspace(0, horizon(np.linalg.eigvals(matrix)), STEPS + 1)
    drive = np.zeros((n, 1)) if motion.drive is None else _array(motion.drive)
    driven = np.block([[matrix, drive], [np.zeros((1, n)), np.full((1, 1), 1.0 if discrete else 0.0)]])
    onward = driven if discrete else expm(driven * times[1])
    states = [np.append(start[:, 0], 1.0)]
    for _ in times[1:]:
        states.append(onward @ states[-1])
    found = np.array(states)[:, :n]
    seen = np.all(np.abs(found) < REACH, axis=1)
    return times[seen], found[seen]


def _beside(motion: Motion, times: Array, start: Array) -> Array:
    """Return the states of the other motion at the moments, as rows, as long as they can be drawn."""
    from scipy.integrate import solve_ivp  # noqa: PLC0415 - only a motion needs it

    symbols, functions = motion.beside or ((), ())

    def rate(_: float, z: Array) -> Array:
        at = dict(zip(symbols, map(complex, z), strict=True))
        return np.array([numeric.evaluate(f, at).real for f in functions])

    if motion.discrete:
        states = [start]
        for _ in times[1:]:
            states.append(rate(0.0, states[-1]))
        return np.array(states)
    moved = solve_ivp(rate, (times[0], times[-1]), start, t_eval=times, rtol=1e-6, atol=1e-9)
    return np.array(moved.y.T)


def horizon(eigenvalues: Any) -> float:
    """Five time constants of the slowest mode; where it does not settle, two of the fastest growth."""
    rates = [abs(value.real) for value in eigenvalues if abs(value.real) > SLOW]
    settles = all(value.real < 0 for value in eigenvalues)
    stop = (5 / min(rates) if settles else 2 / max(rates)) if rates else 10.0
    return float(f"{stop:.2g}")


def _panel(
    signals: Signals, letter: str, times: Array, states: Array, motion: Motion, others: Array | None
) -> DrawnPlot:
    values = states @ _array(signals.rows).T
    if signals.offset is not None:
        values = values + _array(signals.offset)[:, 0]
    style = "samples" if motion.discrete else "line"
    curves = []
    for name, y in zip(signals.names, values.T, strict=True):
        x, shown = (times, y) if motion.discrete else plain(times, y)
        curves.append(DrawnCurve(name, style, tuple(x.tolist()), tuple(shown.tolist())))
    if others is not None:
        for name, y in zip(signals.names, (others @ _array(signals.rows).T).T, strict=True):
            x, shown = plain(times[: len(y)], y)
            curves.append(
                DrawnCurve(rf"{name}\ \text{{(nonlinear)}}", "dashed", tuple(x.tolist()), tuple(shown.tolist()))
            )
    together = named_together(curves)
    if signals.level is not None:
        name, value = signals.level
        height = float(_array(value)[0, 0])
        together.insert(0, DrawnCurve(name, "guide", (0.0, float(times[-1])), (height, height)))
    return DrawnPlot(motion.caption, letter, signals.label, tuple(together), (), False, window_around(together, ()))
