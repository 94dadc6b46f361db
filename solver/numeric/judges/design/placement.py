"""Eigenvalues that feedback moves, and those that it leaves where they are."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from random import Random
from typing import Any

import mpmath
import numpy as np
import sympy as sp

from solver.numeric.evaluation.compare import Residual, worst_of
from solver.numeric.evaluation.equalities import equality_residual
from solver.numeric.evaluation.inside import admits
from solver.numeric.evaluation.points import SEED, admissible, free_symbols, holds_decimals
from solver.numeric.evaluation.precision import TOLERANCE
from solver.numeric.judges.linear_algebra.eigen import (
    DIGITS,
    eigenvalues_in_decimals,
    in_decimals,
    spectrum_residual,
)
from solver.stated.algebra import difference, product

NEAR = 1e-9
MULTIPLE = 1e-14
"""Eigenvalues found with 60 digits are known to more than this, fourfold ones too."""


def placed_residual(
    A: Any, B: Any, K: Any, poles: Sequence[Any], row: Any = None, unknowns: Sequence[Any] = ()
) -> float:
    """Return the largest relative difference of det(xI − A + BK) and Π(x − pᵢ) at random x; K may hold free symbols.

    Where fewer than n poles are given, the modes that no gain (of the shape `row`) moves count as the others.
    Infinite if shapes misfit.
    """
    if K.shape != (B.cols, A.rows):
        return float("inf")
    return placed_matrix_residual(A, B, sp.ImmutableMatrix(A - B * K), poles, row, unknowns)


def placed_matrix_residual(
    A: Any, B: Any, loop: Any, poles: Sequence[Any], row: Any = None, unknowns: Sequence[Any] = ()
) -> float:
    """Return what `placed_residual` does, for a closed-loop matrix (n×n)."""
    if loop.shape != A.shape:
        return float("inf")
    if len(poles) >= A.rows:
        return spectrum_residual(loop, list(poles))
    worst = 0.0
    for point, listed in all_poles(A, B, poles, row, unknowns, loop):
        worst = worst_of((worst, spectrum_residual(sp.ImmutableMatrix(loop.subs(point)), listed)))
    return worst


def all_poles(
    A: Any, B: Any, poles: Sequence[Any], row: Any, unknowns: Sequence[Any], *others: Any
) -> list[tuple[dict[Any, Any], list[Any]]]:
    """Return points (values of all symbols, also those of `others`) and all n poles there, fixed ones last."""
    found = []
    for point in rational_points(A, B, list(poles), *others):
        listed = [(sp.Integer(0) + pole).subs(point) for pole in poles]
        if len(poles) < A.rows:
            here = row.subs({s: v for s, v in point.items() if s not in unknowns}) if row is not None else None
            listed += fixed_modes(A.subs(point), B.subs(point), here, unknowns)
        found.append((point, listed))
    return found


def roots_residual(
    polynomial: Any, x: Any, A: Any, B: Any, poles: Sequence[Any], row: Any = None, unknowns: Sequence[Any] = ()
) -> float:
    """Return the largest relative difference of a polynomial in x and Π(x − pᵢ) over all n poles, at random x."""
    worst = 0.0
    for point, listed in all_poles(A, B, poles, row, unknowns, polynomial.subs(x, 0)):
        here = polynomial.subs({symbol: value for symbol, value in point.items() if symbol != x})
        factors = product(*(difference(x, root) for root in listed))
        points = [{x: value} for value in (0.7 + 1.3j, -1.1 + 0.4j, 2.3 - 0.9j)]
        worst = worst_of((worst, equality_residual(factors, here, points)))
    return worst


def range_residual(A: Any, B: Any, loop: Any) -> float:
    """Return how far A − loop is from B X, X any gain, relative to A − loop; 0 where they are equal."""
    if loop.shape != A.shape:
        return float("inf")
    worst = 0.0
    for point in rational_points(A, B, loop):
        gap = np.array(sp.Matrix((A - loop).subs(point)).evalf(20).tolist(), dtype=complex)
        columns = np.array(B.subs(point).evalf(20).tolist(), dtype=complex)
        X = np.linalg.lstsq(columns, gap, rcond=None)[0]
        worst = worst_of((worst, float(np.max(np.abs(columns @ X - gap)) / max(1.0, np.max(np.abs(gap))))))
    return worst


def fit_residual(row: Any, unknowns: Sequence[Any], K: Any) -> float:
    """Return how far the row K is from the shape `row`, linear in its unknowns."""
    if K.shape != row.shape:
        return float("inf")
    own = list(unknowns)
    worst = 0.0
    for point in rational_points(row, K):
        parameters = {symbol: value for symbol, value in point.items() if symbol not in own}
        M, c = _linear([entry.subs(parameters) for entry in row], own)
        columns, constant = (np.array(each.evalf(20).tolist(), dtype=complex) for each in (M, c))
        target = np.array(K.T.subs(point).evalf(20).tolist(), dtype=complex) + constant
        theta = np.linalg.lstsq(columns, target, rcond=None)[0]
        worst = worst_of((worst, float(np.max(np.abs(columns @ theta - target)) / max(1.0, np.max(np.abs(target))))))
    return worst


def rational_points(*formulas: Any) -> list[dict[Any, Any]]:
    """Return two points with short rational values for all symbols (one empty point where there are none)."""
    symbols = frozenset().union(*map(free_symbols, formulas))
    points = admissible(symbols, 2)
    return [_rational(point) for point in points]


def _rational(point: Mapping[Any, complex]) -> dict[Any, Any]:
    """The point in short rational numbers, longer ones where the conditions would not hold."""
    for below in (64, 2**16, 2**30):
        found = {symbol: sp.Rational(round(complex(value).real * below), below) for symbol, value in point.items()}
        if admits(found):
            break
    return found


def fixed_modes(A: Any, B: Any, row: Any = None, unknowns: Sequence[Any] = ()) -> list[Any]:
    """Return the eigenvalues that two random gains leave where they are, with multiplicity, as decimals.

    A n×n and B n×m hold numbers. `row` is the shape of the gain (1×n), affine in the unknowns; by default any gain.
    """
    random = Random(SEED)  # noqa: S311 - nothing secret
    spectra = []
    for _ in range(2):
        if row is None:
            K = sp.Matrix(B.cols, A.rows, lambda *_: sp.Rational(random.randint(-400, 400), 97))
        else:
            K = row.subs({unknown: sp.Rational(random.randint(-400, 400), 97) for unknown in unknowns})
        spectra.append(eigenvalues_in_decimals(A - B * K))
    first, second = spectra
    found = []
    for value in first:
        near = min(second, key=lambda other: abs(other - value), default=None)
        if near is not None and abs(near - value) < NEAR * (1 + abs(value)):
            second.remove(near)
            found.append(value)
    return [in_decimals(value) for value in found]


def modes_residual(expected: Sequence[Any], found: Sequence[Any]) -> float:
    """Return the largest distance of numbers paired off greedily, relative to their size; infinite unless as many."""
    if len(expected) != len(found):
        return float("inf")
    left = _numbers(found)
    worst = 0.0
    for z in _numbers(expected):
        nearest = min(left, key=lambda other: abs(other - z))
        left.remove(nearest)
        worst = worst_of((worst, float(abs(nearest - z) / (1 + abs(z)))))
    return Residual(worst, TOLERANCE if holds_decimals([expected, found]) else MULTIPLE)


def _numbers(values: Sequence[Any]) -> list[Any]:
    with mpmath.workdps(DIGITS):
        return [mpmath.mpmathify(sp.N(value, DIGITS)) for value in values]


def fixed_modes_residual(A: Any, B: Any, found: Sequence[Any], row: Any = None, unknowns: Sequence[Any] = ()) -> float:
    """Return how far the modes found are from those that no gain (of the shape `row`) moves."""
    worst = 0.0
    for point in rational_points(A, B, list(found)):
        here = row.subs({s: v for s, v in point.items() if s not in unknowns}) if row is not None else None
        modes = fixed_modes(A.subs(point), B.subs(point), here, unknowns)
        worst = worst_of((worst, modes_residual(modes, [(sp.Integer(0) + value).subs(point) for value in found])))
    return worst


def shape_residual(
    A: Any, b: Any, row: Any, unknowns: Sequence[Any], conditions: Sequence[Any], poles: Sequence[Any]
) -> float:
    """Return how far the gains `row` that meet the conditions are from all those that place the poles.

    `conditions` are expressions that are zero, linear in the unknowns (numbers otherwise). Infinite if they leave more
    or less free than the poles do.
    """
    M, c = _linear(conditions, unknowns)
    if M.rank() != sp.Matrix.hstack(M, c).rank():
        return float("inf")
    freedom = len(unknowns) - int(M.rank())
    base = {unknown: sp.Integer(0) for unknown in unknowns}
    origin = sp.Matrix(_coefficients(A - b * row.subs(base)))
    columns = [
        sp.Matrix(_coefficients(A - b * row.subs({**base, unknown: sp.Integer(1)}))) - origin for unknown in unknowns
    ]
    if len(unknowns) - int(sp.Matrix.hstack(*columns).rank(iszerofunc=_negligible)) != freedom:
        return float("inf")
    solution = M.gauss_jordan_solve(c)
    random = Random(SEED)  # noqa: S311 - nothing secret
    point = {parameter: sp.Rational(random.randint(-300, 300), 97) for parameter in solution[1]}
    values = dict(zip(unknowns, [entry.subs(point) for entry in solution[0]], strict=True))
    loop = sp.ImmutableMatrix(A - b * row.subs(values))
    if len(poles) < A.rows:
        poles = [*poles, *fixed_modes(A, b, row, unknowns)]
    return spectrum_residual(loop, list(poles))


def _negligible(value: Any) -> bool:
    return bool(abs(sp.N(value)) < 1e-12)


def _linear(conditions: Sequence[Any], unknowns: Sequence[Any]) -> tuple[Any, Any]:
    """Return M and c of the conditions M θ = c."""
    nothing = dict.fromkeys(unknowns, sp.Integer(0))
    M = sp.Matrix(len(conditions), len(unknowns), lambda i, j: sp.diff(conditions[i], unknowns[j]))
    return M, sp.Matrix(len(conditions), 1, [-each.subs(nothing) for each in conditions])


def _coefficients(M: Any) -> list[Any]:
    return list(M.charpoly().all_coeffs())
