"""Judges of motion in time: exponentials by scipy, responses by quadrature or step by step."""

import itertools

import numpy as np
import sympy as sp
from scipy.linalg import expm

from tests.hunt.asked import Point, delta
from tests.hunt.judges.found import Found
from tests.hunt.plants import matrices

MOMENTS = (0.35, 1.7, 3.6)
SAMPLES = 9


def state_transition_matrix(point: Point, found: Found) -> None:
    A = matrices(point)[0]
    if point.discrete:
        for k in range(SAMPLES):
            found.same(f"A^{k}", found.matrix("Phi", k=k), np.linalg.matrix_power(A, k))
        return
    for t in MOMENTS:
        found.same(f"exp(A {t})", found.matrix("Phi", t=sp.Rational(str(t))), expm(A * t))
    if "Phi_truncated" in found:
        terms, total, term = point.option("terms", 3), np.zeros_like(A), np.eye(len(A))
        for i in range(terms):
            total, term = total + term, term @ A * 0.35 / (i + 1)
        found.same("first terms", found.matrix("Phi_truncated", t=sp.Rational("0.35")), total)


def response(point: Point, found: Found) -> None:
    A, B, C, D = matrices(point)
    kind = point.option("kind", "complete")
    start = point.option("initial_state", point.question.system.get("initial_state"))
    x0 = np.zeros((len(A), 1)) if start is None or kind == "zero_state" else point.matrix(start, column=True)
    raw = point.option("input")
    written = [] if raw is None or kind == "zero_input" else raw if isinstance(raw, list) else [raw]
    inputs = [point.exactly(each) for each in written] or [sp.S.Zero] * B.shape[1]
    if point.discrete:
        _step_by_step(found, (A, B, C, D), x0, inputs)
    else:
        _by_quadrature(found, (A, B, C, D), x0, inputs)
    _final_value_and_peak(point, found)


def _step_by_step(found: Found, plant: tuple[np.ndarray, ...], x0: np.ndarray, inputs: list[sp.Expr]) -> None:
    A, B, C, D = plant
    k = sp.Symbol("k")
    x = x0
    for now in range(SAMPLES):
        u = np.array([[complex(_kronecker(each).subs(k, now).evalf(25))] for each in inputs])
        if "x" in found:
            found.same(f"x({now})", found.matrix("x", k=now), x)
        if "y" in found:
            found.same(f"y({now})", found.matrix("y", k=now), C @ x + D @ u)
        x = A @ x + B @ u


def _kronecker(u: sp.Expr) -> sp.Expr:
    return u.replace(delta, lambda a: sp.KroneckerDelta(a, 0)).replace(
        lambda e: isinstance(e, sp.Heaviside), lambda e: sp.Heaviside(e.args[0], 1)
    )


def _by_quadrature(found: Found, plant: tuple[np.ndarray, ...], x0: np.ndarray, inputs: list[sp.Expr]) -> None:
    A, B, C, D = plant
    t = sp.Symbol("t")
    jumps = sorted({float(sp.solve(e.args[0], t)[0]) for u in inputs for e in u.atoms(sp.Heaviside, delta)})
    smooth = [u.replace(delta, lambda _: sp.S.Zero) for u in inputs]
    value = sp.lambdify(t, smooth, "numpy")
    pulses = [(i, float(sp.solve(e.args[0], t)[0]), u.coeff(e)) for i, u in enumerate(inputs) for e in u.atoms(delta)]

    def u_at(now: float) -> np.ndarray:
        return np.array(value(now), dtype=complex)[:, None]

    for now in MOMENTS:
        x = expm(A * now) @ x0
        for tau, weight in _nodes([0.0, *(jump for jump in jumps if 0 < jump < now), now]):
            x = x + weight * expm(A * (now - tau)) @ B @ u_at(tau)
        for i, moment, weight in pulses:
            if 0 <= moment < now:
                x = x + complex(weight.subs(t, moment)) * expm(A * (now - moment)) @ B[:, [i]]
        moment_exactly = sp.Rational(str(now))
        if "x" in found:
            found.same(f"x({now})", found.matrix("x", t=moment_exactly), x)
        if "y" in found:
            found.same(f"y({now})", found.matrix("y", t=moment_exactly), C @ x + D @ u_at(now))


def _nodes(ends: list[float]) -> list[tuple[float, float]]:
    """Gauss's nodes and weights, two dozen between any two ends."""
    nodes, weights = np.polynomial.legendre.leggauss(24)
    spans = [(a, b - a) for a, b in itertools.pairwise(ends)]
    return [(a + h * (x + 1) / 2, h * w / 2) for a, h in spans for x, w in zip(nodes, weights, strict=True)]


def _final_value_and_peak(point: Point, found: Found) -> None:
    if "y_final" not in found and "t_peak" not in found:
        return
    y = found.quickly("y", "k" if point.discrete else "t")
    if "y_final" in found:
        found.same("final value", y(4000 if point.discrete else 400), found.matrix("y_final"), 1e-6)
    if "t_peak" in found:
        peak, when = found.matrix("y_peak"), found.number("t_peak").real
        found.same("value at the peak", y(round(when) if point.discrete else when), peak)
        times = range(12) if point.discrete else [i / 7 for i in range(1, 40)]
        found.holds("a larger value", all(abs(y(each)[0, 0]) <= abs(peak[0, 0]) * (1 + 1e-9) for each in times))
