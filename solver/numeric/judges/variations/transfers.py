"""A control that takes x(0) = x₀ to x(T) = x_f with the least ∫ uᵀRu dt, judged in floats by what defines it.

It arrives, and it is orthogonal, ∫ uᵀ R v dt = 0, to every v that moves the state from rest to rest: so any other
control that arrives, u + v, costs ∫ vᵀ R v dt more. Integrals are Gauss's, with e^{At} by scipy at each node.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.compare import worst_of
from solver.numeric.evaluation.environment import Point
from solver.numeric.evaluation.expressions import evaluate
from solver.numeric.evaluation.points import PointSource, free_symbols
from solver.numeric.evaluation.values import ShapeMismatch, Undefined
from solver.numeric.judges.variations.sampled import at_admissible_points, functions_at, real, relative
from solver.words import Phrase

NODES = 24
"""Of Gauss's formula, in each of the pieces of the horizon."""
MOST_PIECES = 40
OTHERS = 4
"""How many other controls are tried."""
TIMES = (0.0, 0.37, 0.71, 1.0)
"""Where the state is compared, as parts of the horizon."""
FAINT = 1e-11
"""Singular values of a Gramian below this part of the largest belong to what is not reached."""


class Transfer(NamedTuple):
    """The question: A n×n, B n×m, R m×m, x₀ and x_f n×1, T, and the factor before the integral."""

    A: Any
    B: Any
    R: Any
    x0: Any
    xf: Any
    T: Any
    factor: Any


class Optimal:
    """The optimal control in numbers, at one point of the parameters."""

    def __init__(self, transfer: Transfer, point: Point) -> None:
        self.point = point
        self.A, self.B, self.R, self.x0, self.xf = (real(evaluate(M, point)) for M in transfer[:5])
        self.T, self.factor = (float(np.real(evaluate(value, point))) for value in transfer[5:])
        if np.linalg.eigvalsh(self.R)[0] <= 0 or self.T <= 0:
            raise Undefined("R or T is not positive here")

    @cached_property
    def nodes(self) -> tuple[Array, Array]:
        """Times and weights of Gauss's formula on the horizon, in pieces that suit the fastest mode."""
        pieces = int(np.clip(np.ceil(np.abs(self.A).sum(axis=1).max() * self.T / 6), 1, MOST_PIECES))
        x, w = np.polynomial.legendre.leggauss(NODES)
        ends = np.linspace(0, self.T, pieces + 1)
        half = np.diff(ends) / 2
        return (ends[:-1, None] + half[:, None] * (x + 1)).ravel(), (half[:, None] * w).ravel()

    @cached_property
    def towards_the_end(self) -> Array:
        """e^{A(T − t)} B at each node."""
        return np.array([self.motion(self.T - t) @ self.B for t in self.nodes[0]])

    def motion(self, t: float) -> Array:
        """e^{At} by scipy."""
        from scipy.linalg import expm  # noqa: PLC0415

        return np.asarray(expm(self.A * t))

    @cached_property
    def gramian(self) -> Array:
        """∫ e^{At} B R⁻¹ Bᵀ e^{Aᵀt} dt."""
        E = self.towards_the_end
        return np.asarray(np.einsum("k,kim,mp,kjp->ij", self.nodes[1], E, np.linalg.inv(self.R), E))

    @cached_property
    def gap(self) -> Array:
        """x_f − e^{AT} x₀."""
        return np.asarray(self.xf - self.motion(self.T) @ self.x0)

    @cached_property
    def eta(self) -> Array:
        """The least solution of W η = gap."""
        return np.asarray(np.linalg.lstsq(self.gramian, self.gap, rcond=FAINT)[0])

    def control(self, t: float) -> Array:
        """u at a time (m×1)."""
        return np.asarray(np.linalg.solve(self.R, (self.motion(self.T - t) @ self.B).T @ self.eta))

    def state(self, t: float) -> Array:
        """x at a time (n×1), by the formula of convolution."""
        x, w = np.polynomial.legendre.leggauss(2 * NODES)
        s, weights = t * (x + 1) / 2, w * t / 2
        driven = sum(
            (c * self.motion(t - at) @ self.B @ self.control(at) for at, c in zip(s, weights, strict=True)),
            np.zeros_like(self.x0),
        )
        return np.asarray(self.motion(t) @ self.x0 + driven)

    @property
    def cost(self) -> float:
        """The factor times the integral."""
        return self.factor * float((self.gap.T @ self.eta)[0, 0])


def optimal(transfer: Transfer, *values: Any) -> list[Optimal]:
    """Return the optimum at two admissible points; symbols of weights, times and factors are positive there."""
    symbols = frozenset().union(*map(free_symbols, (*transfer, *values)))
    own = frozenset().union(*map(free_symbols, (transfer.R, transfer.T, transfer.factor)))
    return at_admissible_points(lambda point: Optimal(transfer, point), symbols, own)


def _worst(transfer: Transfer, judge: Callable[[Optimal], float], *values: Any) -> float:
    try:
        return worst_of(judge(each) for each in optimal(transfer, *values))
    except Undefined:
        return float("inf")


def _columns(formula: Any, point: Point, times: Array, rows: int) -> Array:
    """A column of functions of t at some times (k×rows)."""
    return functions_at(formula, point, times, (rows, 1))[:, :, 0]


def arrival_residual(transfer: Transfer, u: Any) -> float:
    """Return how far from x_f the control u(t) (m×1) brings the state, relatively."""

    def judge(best: Optimal) -> float:
        times, weights = best.nodes
        values = _columns(u, best.point, times, best.B.shape[1])
        moved = np.einsum("k,kim,km->i", weights, best.towards_the_end, values)[:, None]
        sizes = np.einsum("k,kim,km->i", weights, np.abs(best.towards_the_end), np.abs(values))
        return relative(moved - best.gap, sizes, best.xf, best.gap)

    return _worst(transfer, judge, u)


def orthogonality_residual(transfer: Transfer, u: Any) -> float:
    """Return the largest cosine of the angle between u(t) and a control that leads from rest to rest, for ∫ uᵀRv dt."""

    def judge(best: Optimal) -> float:
        times, _weights = best.nodes
        values = _columns(u, best.point, times, best.B.shape[1])
        length = np.sqrt(_inner(best, values, values))
        found = []
        for v in _from_rest_to_rest(best):
            found.append(abs(_inner(best, values, v)) / (length * np.sqrt(_inner(best, v, v))) if length else 0.0)
        return float(max(found))

    return _worst(transfer, judge, u)


def _inner(best: Optimal, u: Array, v: Array) -> float:
    """∫ uᵀ R v dt."""
    return float(np.einsum("k,ki,ij,kj->", best.nodes[1], u, best.R, v))


def _from_rest_to_rest(best: Optimal) -> list[Array]:
    """Some controls at the nodes from rest to rest: waves, less the optimal control that does the same."""
    times, weights = best.nodes
    found = []
    for number in range(1, OTHERS + 1):
        phases = np.arange(best.B.shape[1])
        wave = np.cos((2 * number + 1) * times[:, None] / best.T + number + phases)
        moved = np.einsum("k,kim,km->i", weights, best.towards_the_end, wave)[:, None]
        eta = np.linalg.lstsq(best.gramian, moved, rcond=FAINT)[0]
        back = np.array([np.linalg.solve(best.R, E.T @ eta)[:, 0] for E in best.towards_the_end])
        found.append(wave - back)
    return found


def motion_residual(transfer: Transfer, x: Any) -> float:
    """Return how far x(t) (n×1) is from the optimal motion at some times, relatively."""

    def judge(best: Optimal) -> float:
        times = best.T * np.array(TIMES)
        values = _columns(x, best.point, times, best.A.shape[0])
        right = np.array([best.state(t)[:, 0] for t in times])
        return relative(values - right, right, best.x0, best.xf)

    return _worst(transfer, judge, x)


def costate_residual(transfer: Transfer, costates: Any) -> float:
    """Return how far −R⁻¹ Bᵀ λ(t)/(2c) is from the optimal control at some times, relatively; λ n×1, c the factor."""

    def judge(best: Optimal) -> float:
        times = best.T * np.array(TIMES)
        values = _columns(costates, best.point, times, best.A.shape[0])
        controls = np.array([-np.linalg.solve(best.R, best.B.T @ value) / (2 * best.factor) for value in values])
        right = np.array([best.control(t)[:, 0] for t in times])
        return relative(controls - right, right, controls)

    return _worst(transfer, judge, costates)


def energy_residual(transfer: Transfer, cost: Any) -> float:
    """Return the relative difference of a cost and that of the optimal control."""

    def judge(best: Optimal) -> float:
        value = complex(evaluate(cost, best.point))
        return abs(value - best.cost) / max(abs(best.cost), abs(value), 1e-300)

    return _worst(transfer, judge, cost)


def weighted_gramian_residual(transfer: Transfer, W: Any) -> float:
    """Return the relative difference of W (n×n) and ∫ e^{At} B R⁻¹ Bᵀ e^{Aᵀt} dt."""
    if getattr(W, "shape", None) != transfer.A.shape:
        raise ShapeMismatch(Phrase("it must be {rows}×{columns}", rows=transfer.A.rows, columns=transfer.A.cols))

    def judge(best: Optimal) -> float:
        return relative(real(evaluate(W, best.point)) - best.gramian, best.gramian)

    return _worst(transfer, judge, W)


def necessary_conditions_residual(transfer: Transfer, equations: list[Any], names: list[Any]) -> float:
    """Return how far the span of linear expressions, all zero, is from that of the necessary conditions.

    They are λ' + Aᵀλ, 2cRu + Bᵀλ and x' − Ax − Bu in the `names` (λ', λ, u, x', x), in any order and combination.
    """

    def judge(best: Optimal) -> float:
        n, m = best.B.shape
        one, none = np.eye(n), np.zeros
        right = np.block(
            [
                [one, best.A.T, none((n, m)), none((n, n)), none((n, n))],
                [none((m, n)), best.B.T, 2 * best.factor * best.R, none((m, n)), none((m, n))],
                [none((n, n)), none((n, n)), -best.B, one, -best.A],
            ]
        )
        rows = []
        origin = dict.fromkeys(names, 0.0)
        for each in equations:
            zero = evaluate(each, {**best.point, **origin})
            slopes = [evaluate(each, {**best.point, **origin, name: 1.0}) - zero for name in names]
            twice = [evaluate(each, {**best.point, **origin, name: 2.0}) - zero for name in names]
            if abs(zero) > 1e-9 or np.abs(np.array(twice) - 2 * np.array(slopes)).max() > 1e-9:
                return float("inf")
            rows.append(np.real(slopes))
        found = np.array(rows)
        if found.shape != right.shape or np.linalg.matrix_rank(found, tol=1e-9) < len(right):
            return float("inf")
        fit = np.linalg.lstsq(found.T, right.T, rcond=None)[0]
        return relative(found.T @ fit - right.T, right)

    symbols = set(names)
    found = frozenset().union(*map(free_symbols, equations)) - symbols
    if sp.Symbol("t") in found:
        return float("inf")
    return _worst(transfer, judge, sp.ImmutableMatrix([sorted(found, key=str)]))


def reaches_everything(A: Any, B: Any) -> bool:
    """Whether [B, AB, …] has full rank, at a random point."""
    point = PointSource(free_symbols([A, B])).draw()
    here, block = (np.asarray(evaluate(M, point)) for M in (A, B))
    blocks = [block]
    for _ in range(A.rows - 1):
        blocks.append(here @ blocks[-1])
    return int(np.linalg.matrix_rank(np.hstack(blocks))) == A.rows
