"""Observers judged by what they must do: the spectrum of the error, and an error that nothing else drives."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.compare import worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import evaluate, value_of
from solver.numeric.evaluation.points import admissible, free_symbols
from solver.numeric.judges.design.placement import fixed_modes, rational_points
from solver.numeric.judges.linear_algebra.eigen import spectrum_residual


def row_space_residual(X: Any, C: Any) -> float:
    """Return how far the rows of X (k×n) are from combinations of the rows of C (p×n), relative to their size."""
    if X.cols != C.cols:
        return float("inf")
    return worst_of(_row_space_residual_at(*values) for values in _at_points(X, C))


def _row_space_residual_at(X: Array, C: Array) -> float:
    left = X - X @ np.linalg.pinv(C) @ C
    return float(np.linalg.norm(left)) / max(1.0, float(np.linalg.norm(X)))


def driven_error_residual(A: Any, C: Any, E: Any, J: Any, G: Any) -> float:
    """Return how much the plant drives the error Π x − ω of ω' = Jω + G x, at the best Π = E − LC over all L.

    A n×n, C p×n, E q×n, J q×q, G q×n. The error is autonomous if and only if Π A = J Π + G for some such Π.
    """
    q, n = E.shape
    if J.shape != (q, q) or G.shape != (q, n):
        return float("inf")
    return worst_of(_driven_error_at(*values) for values in _at_points(A, C, E, J, G))


def _driven_error_at(A: Array, C: Array, E: Array, J: Array, G: Array) -> float:
    """Least squares for vec L in L (C A) − J (L C) = E A − J E − G, columns stacked."""
    identity = np.eye(len(J))
    operator = np.kron((C @ A).T, identity) - np.kron(C.T, J)
    right = (E @ A - J @ E - G).flatten(order="F")
    solution = np.linalg.lstsq(operator, right, rcond=None)[0]
    size = max(1.0, *(float(np.linalg.norm(each)) for each in (E @ A, J @ E, G)))
    return float(np.linalg.norm(operator @ solution - right)) / size


def _at_points(*formulas: Any) -> Iterator[list[Array]]:
    """Yield the values of matrices and lists as arrays at random values of their symbols."""
    symbols = frozenset().union(*map(free_symbols, formulas))
    for point in admissible(symbols, 2):
        environment = Environment.at([dict(point)])
        yield [np.asarray(value_of(formula, environment).value[0]) for formula in formulas]


def joined_spectrum_residual(found: Sequence[Any], groups: Sequence[Any]) -> float:
    """Return how far the numbers found are from the eigenvalues of several loops together.

    Each group is a matrix, or (A, B, poles): the poles asked for, with the modes that no feedback moves where they
    are fewer than the states.
    """
    worst = 0.0
    for point in rational_points(list(found), *(M for group in groups for M in _members(group))):
        here = [(sp.Integer(0) + value).subs(point) for value in found]
        matrix = sp.ImmutableMatrix(sp.diag(*(_with_poles(group, point) for group in groups)))
        worst = worst_of((worst, spectrum_residual(matrix, here)))
    return worst


def _with_poles(group: Any, point: Mapping[Any, Any]) -> Any:
    """A matrix with the eigenvalues of a group at a point."""
    if not isinstance(group, tuple):
        return sp.Matrix(group.subs(point))
    A, B, poles = group
    listed = [(sp.Integer(0) + pole).subs(point) for pole in poles]
    if len(listed) < A.rows:
        listed += fixed_modes(A.subs(point), B.subs(point))
    return sp.diag(*listed)


def closing_residual(plant: tuple[Any, ...], G: Any, x: Any, groups: Sequence[Any], order: int) -> float:
    """Return how far u = G y (G m×p in x) is from closing the loop of A, B, C, D with the polynomial of the groups.

    For a compensator of that order with denominator q, monic, det(I − G G_p) χ_p q is the polynomial of the loop times
    d = det(I − G(∞)D); so that polynomial over det(I − G G_p) χ_p must be a polynomial of that degree, led by 1/d.
    """
    if G.shape != (plant[1].cols, plant[2].rows):
        return float("inf")
    flat = [*plant, G.subs(x, sp.Rational(1, 3)), *(M for group in groups for M in _members(group))]
    worst = 0.0
    for point in rational_points(*flat):
        here = [M.subs(point) for M in plant]
        loops = [_array(_with_poles(group, point)) for group in groups]
        worst = worst_of((worst, _closing_residual_at([_array(M) for M in here], G.subs(point), x, loops, order)))
    return worst


def _members(group: Any) -> list[Any]:
    return [group[0], group[1], list(group[2])] if isinstance(group, tuple) else [group]


def _array(M: Any) -> Array:
    return np.array([[complex(sp.N(entry, 20)) for entry in row] for row in M.tolist()]).reshape(M.shape)


def _closing_residual_at(plant: list[Array], G: Any, x: Any, loops: list[Array], order: int) -> float:
    """Fit the monic polynomial by its values at points of a circle around all poles, and see how well it fits."""
    A, B, C, D = plant
    reach = max(float(np.max(np.abs(np.linalg.eigvals(M)), initial=0.0)) for M in (A, *loops) if M.size)
    radius, count = 1.5 * (reach or 1.0), 2 * order + 5
    points = radius * np.exp(2j * np.pi * (np.arange(count) + 0.3) / count)
    values = np.array([_denominator_at(s, (A, B, C, D), evaluate(G, {x: s}), loops) for s in points]) / radius**order
    far = np.atleast_2d(evaluate(G, {x: 1e9 * radius})) if np.any(D) else np.zeros((B.shape[1], len(C)))
    lead = 1.0 / np.linalg.det(np.eye(len(far)) - far @ D)
    powers = (points[:, None] / radius) ** np.arange(order)
    right = values - lead * (points / radius) ** order
    fitted = powers @ np.linalg.lstsq(powers, right, rcond=None)[0] if order else np.zeros(count)
    return float(np.max(np.abs(fitted - right)) / max(1.0, float(np.max(np.abs(values)))))


def _denominator_at(s: complex, plant: tuple[Array, ...], G: Array, loops: list[Array]) -> complex:
    """The polynomial of the loops over det(I − G G_p) det(sI − A), at s."""
    A, B, C, D = plant
    pencil = s * np.eye(len(A)) - A
    G_p = C @ np.linalg.solve(pencil, B) + D
    wanted = np.prod([np.linalg.det(s * np.eye(len(M)) - M) for M in loops])
    return complex(wanted / (np.linalg.det(np.eye(len(G)) - G @ G_p) * np.linalg.det(pencil)))
