"""Observers judged by what they must do: the spectrum of the error, and an error that nothing else drives."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import reduce
from operator import mul
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array, multiple
from solver.numeric.evaluation.compare import Residual, worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.multiple_precision import determinant, remainder, solution
from solver.numeric.evaluation.points import admissible, free_symbols, holds_decimals
from solver.numeric.evaluation.precision import EXACT
from solver.numeric.judges.design.placement import fixed_modes, rational_points
from solver.numeric.judges.linear_algebra.eigen import spectrum_residual

MANY = multiple(50)
NOTHING = 1e-30
"""A part of a vector of unit length that is smaller than this is rounding."""
FLOATS = 1e-6
"""Tolerance of a closed loop of decimals."""


def row_space_residual(X: Any, C: Any) -> float:
    """Return how far the rows of X (k×n) are from combinations of the rows of C (p×n), relative to their size."""
    if X.cols != C.cols:
        return float("inf")
    if holds_decimals([X, C]):
        return worst_of(_row_space_residual_at(*values) for values in _at_points(X, C))
    points = admissible(free_symbols([X, C]), 2)
    return exactly(worst_of(_left_over(_at(C, point).T, _at(X, point).T) for point in points))


def exactly(residual: float) -> Residual:
    """Return a residual of exact values found with many digits."""
    return Residual(residual, EXACT.tolerance)


def _left_over(columns: Array, right: Array) -> float:
    """Return what of the right side no combination of columns reaches, relative to the largest entries."""
    if not right.size:
        return 0.0
    left = remainder(columns, right, MANY.context, NOTHING)
    return float(max(map(abs, left.ravel())) / max(1, *map(abs, right.ravel())))


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
    if holds_decimals([A, C, E, J, G]):
        return worst_of(_driven_error_at(*values) for values in _at_points(A, C, E, J, G))
    points = admissible(free_symbols([A, C, E, J, G]), 2)
    return exactly(worst_of(_driven_exactly(*(_at(M, point) for M in (A, C, E, J, G))) for point in points))


def _driven_exactly(A: Array, C: Array, E: Array, J: Array, G: Array) -> float:
    """What `_driven_error_at` does, with many digits."""
    identity = _identity(len(J))
    operator = np.kron((C @ A).T, identity) - np.kron(C.T, J)
    return _left_over(operator, (E @ A - J @ E - G).flatten(order="F")[:, None])


def _driven_error_at(A: Array, C: Array, E: Array, J: Array, G: Array) -> float:
    """Least squares for vec L in L (C A) − J (L C) = E A − J E − G, columns stacked."""
    identity = np.eye(len(J))
    operator = np.kron((C @ A).T, identity) - np.kron(C.T, J)
    right = (E @ A - J @ E - G).flatten(order="F")
    L = np.linalg.lstsq(operator, right, rcond=None)[0]
    size = max(1.0, *(float(np.linalg.norm(each)) for each in (E @ A, J @ E, G)))
    return float(np.linalg.norm(operator @ L - right)) / size


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
        loops = [_at(_with_poles(group, point), {}) for group in groups]
        here = [_at(M, point) for M in plant]
        worst = worst_of((worst, _closing_residual_at(here, G.subs(point), x, loops, order)))
    decimals = holds_decimals([*plant, G, *(M for group in groups for M in _members(group))])
    return Residual(worst, FLOATS if decimals else EXACT.tolerance)


def _members(group: Any) -> list[Any]:
    return [group[0], group[1], list(group[2])] if isinstance(group, tuple) else [group]


def _closing_residual_at(plant: list[Array], G: Any, x: Any, loops: list[Array], order: int) -> float:
    """Return how far the values on a circle around all poles are from those of a polynomial with that lead.

    Its coefficients are found by the discrete Fourier transform; those above the order must be zero.
    """
    A, B, C, D = plant
    reach = max(float(np.max(np.abs(np.linalg.eigvals(_doubles(M))), initial=0.0)) for M in (A, *loops) if M.size)
    radius, count = MANY.number(1.5 * (reach or 1.0)), 2 * order + 5
    turns = [MANY.context.expjpi(MANY.context.mpf(2 * k) / count) for k in range(count)]
    points = [radius * MANY.context.expjpi(MANY.context.mpf("0.6") / count) * turn for turn in turns]
    values = [_denominator_at(s, (A, B, C, D), _at(G, {x: s}), loops) / radius**order for s in points]
    scaled = [sum(value * turns[-k * i % count] for i, value in enumerate(values)) / count for k in range(count)]
    far = _at(G, {x: 1e60}) if np.any(D) else np.zeros((B.shape[1], len(C)), dtype=object)
    lead = 1 / determinant(_identity(len(far)) - far @ D)
    lead *= MANY.context.expjpi(MANY.context.mpf("0.6") * order / count)
    wrong = [abs(scaled[order] - lead), *map(abs, scaled[order + 1 :])]
    return float(max(wrong) / max(1, *map(abs, values)))


def _denominator_at(s: Any, plant: tuple[Array, ...], G: Array, loops: list[Array]) -> Any:
    """The polynomial of the loops over det(I − G G_p) det(sI − A), at s."""
    A, B, C, D = plant
    pencil = s * _identity(len(A)) - A
    G_p = C @ solution(pencil, B) + D
    wanted = reduce(mul, [determinant(s * _identity(len(M)) - M) for M in loops if len(M)], MANY.number(1))
    return wanted / (determinant(_identity(len(G)) - G @ G_p) * determinant(pencil))


def _identity(n: int) -> Array:
    return np.eye(n, dtype=int).astype(object)


def _doubles(M: Array) -> Array:
    return np.asarray(MANY.approximate(M), dtype=complex)


def _at(M: Any, point: Mapping[Any, Any]) -> Array:
    """Return a matrix at a point, with many digits."""
    if 0 in M.shape:
        return np.zeros(M.shape, dtype=object)
    return np.asarray(np.broadcast_to(value_of(M, Environment.at([point], MANY)).value, (1, *M.shape))[0])
