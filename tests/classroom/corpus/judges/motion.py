"""Judges of motion in time: exponentials by scipy, responses by quadrature or step by step."""

import numpy as np
import sympy as sp
from scipy.integrate import quad_vec
from scipy.linalg import expm
from scipy.optimize import brentq

from tests.classroom.corpus.judges.registry import MOMENTS, SAMPLES, difference, judge, matrix
from tests.classroom.corpus.meanings import Meaning
from tests.hunt.asked import Point
from tests.hunt.plants import matrices


@judge("state_transition_matrix", "Phi")
def transition(point: Point, meant: Meaning):
    A = matrices(point)[0]
    if point.discrete:
        return [matrix(meant, A.shape, k=k) - np.linalg.matrix_power(A, k) for k in range(1, 9)]
    return [matrix(meant, A.shape, t=t) - expm(A * t) for t in MOMENTS]


@judge("state_transition_matrix", "Phi_truncated")
def truncated(point: Point, meant: Meaning):
    A = matrices(point)[0]
    left = []
    for t in MOMENTS:
        total, term = np.zeros_like(A, dtype=float), np.eye(len(A))
        for i in range(point.option("terms", 3)):
            total, term = total + term, term @ A * t / (i + 1)
        left.append(matrix(meant, A.shape, t=t) - total)
    return left


def _inputs(point: Point, now: float) -> np.ndarray:
    raw = point.option("input")
    written = raw if isinstance(raw, list) else [raw]
    name = sp.Symbol("k" if point.discrete else "t")
    return np.array([[complex(point.exactly(each).subs(name, now).evalf())] for each in written])


def _states(point: Point, now: float) -> tuple[np.ndarray, np.ndarray]:
    """x and y at a moment."""
    A, B, C, D = matrices(point)
    kind = point.option("kind", "complete")
    start = point.option("initial_state", point.question.system.get("initial_state"))
    x = np.zeros((len(A), 1)) if start is None or kind == "zero_state" else point.matrix(start, column=True)
    driven = point.option("input") is not None and kind != "zero_input"
    u_now = _inputs(point, now) if driven else np.zeros((B.shape[1], 1))
    if point.discrete:
        for k in range(int(now)):
            x = A @ x + (B @ _inputs(point, k) if driven else 0)
        return x, C @ x + D @ u_now
    x = expm(A * now) @ x
    if driven:
        x = x + quad_vec(lambda tau: expm(A * (now - tau)) @ B @ _inputs(point, tau), 0, now, epsabs=1e-11)[0]
    return x, C @ x + D @ u_now


_SEEN: dict[str, list[tuple[np.ndarray, np.ndarray]]] = {}


def _motion(point: Point) -> list[tuple[np.ndarray, np.ndarray]]:
    key = f"{point.question} {point.values}"
    if key not in _SEEN:
        _SEEN[key] = [_states(point, now) for now in (SAMPLES if point.discrete else MOMENTS)]
    return _SEEN[key]


def _at(point: Point) -> list[dict[str, float]]:
    return [{"k": k} for k in SAMPLES] if point.discrete else [{"t": t} for t in MOMENTS]


@judge("response", "x")
def states(point: Point, meant: Meaning):
    return [matrix(meant, x.shape, **now) - x for now, (x, _) in zip(_at(point), _motion(point), strict=True)]


@judge("response", "y")
def outputs(point: Point, meant: Meaning):
    return [
        difference(meant(**now).reshape(y.shape), y) for now, (_, y) in zip(_at(point), _motion(point), strict=True)
    ]


@judge("response", "y_final")
def final_value(point: Point, meant: Meaning):
    A, B, C, D = matrices(point)
    u = _inputs(point, 60.0)
    rest = np.linalg.inv((np.eye(len(A)) - A) if point.discrete else -A)
    return np.ravel(meant()) - np.ravel(C @ rest @ B @ u + D @ u)


_PEAKS: dict[str, tuple[float, float]] = {}


def _peak(point: Point) -> tuple[float, float]:
    """When the first output is largest, and how large: where its derivative changes its sign beside the best sample."""
    key = repr(point.question)
    if key not in _PEAKS:
        _PEAKS[key] = _found_peak(point)
    return _PEAKS[key]


def _found_peak(point: Point) -> tuple[float, float]:
    A, B, C, _ = matrices(point)

    def slope(now: float) -> float:
        driven = point.option("kind", "complete") != "zero_input"
        change = A @ _states(point, now)[0] + (B @ _inputs(point, now) if driven else 0)
        return float(np.real((C @ change)[0, 0]))

    moments = np.linspace(0.01, 6, 60)
    largest = max(range(len(moments)), key=lambda i: abs(_states(point, moments[i])[1][0, 0]))
    best = brentq(slope, moments[largest - 1], moments[largest + 1], xtol=1e-13)
    return best, float(np.real(_states(point, best)[1][0, 0]))


@judge("response", "t_peak")
def time_of_peak(point: Point, meant: Meaning):
    return np.ravel(meant()) - _peak(point)[0]


@judge("response", "y_peak")
def height_of_peak(point: Point, meant: Meaning):
    return np.ravel(meant()) - _peak(point)[1]
