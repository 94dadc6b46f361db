"""Is F the function f(A)? Judged by scipy's algorithms for functions of matrices, at random values of symbols."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import DOUBLE, Array
from solver.numeric.evaluation.compare import worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import PointSource, free_symbols, holds_decimals, whole_symbols
from solver.numeric.evaluation.precision import TOLERANCE
from solver.numeric.evaluation.values import SAFETY, NotEvaluable
from solver.numeric.judges.time_response.exact_functions import exact_residual
from solver.numeric.judges.time_response.rational_functions import equals_in_fractions, is_rational
from solver.words import Phrase

POINTS = 4
MOST_BLURRED = 1e-5
"""Relative to f(A): an answer further off than this is wrong, however ill-conditioned f(A) is."""


def matrix_function_residual(A: Any, function: Any, variable: Any, F: Any) -> float:
    """Return the largest difference of F and f(A) (n×n), relative to the largest entry of f(A)."""
    if F.shape != A.shape:
        return float("inf")
    if is_rational(A, function, variable, F):
        return 0.0 if equals_in_fractions(A, function, variable, F) else float("inf")
    symbols = (free_symbols(A) | free_symbols(F) | free_symbols(function)) - {variable}
    source = PointSource(symbols, whole_symbols(function, names={"k"}) - {variable})
    points = source.several(POINTS if symbols else 1)
    decimals = holds_decimals([A, F, function])
    try:
        found = worst_of(_residual_at(A, function, variable, F, point) for point in points)
    except NotEvaluable:  # too large for doubles
        if decimals:
            raise
        return exact_residual(A, function, variable, F, points[-1])
    if not found <= TOLERANCE or decimals:
        return found
    try:
        return exact_residual(A, function, variable, F, points[-1])
    except NotEvaluable:
        return found


def _residual_at(A: Any, function: Any, variable: Any, F: Any, point: Mapping[Any, complex]) -> float:
    here = Environment.at([dict(point)])
    matrix = value_of(A, here).value[0]
    with np.errstate(all="ignore"):
        wanted = _walk(function, variable, matrix, here)
        nearby = _walk(function, variable, _rounded_otherwise(matrix), here)
    size = max(float(np.max(np.abs(wanted))), 1e-12)
    blurred = min(SAFETY * float(np.max(np.abs(nearby - wanted))), MOST_BLURRED * size)
    found = value_of(F, here)
    known = np.broadcast_to(SAFETY * DOUBLE.eps * found.magnitude, found.value.shape)[0] + blurred
    difference = np.maximum(np.abs(found.value[0] - wanted) - known, 0.0)
    return float(np.max(difference) / size)


def _rounded_otherwise(A: Array) -> Array:
    """A with other rounding errors: how far f moves tells what doubles know of it (at 0 a root: half)."""
    signs = np.random.default_rng(1).choice((-1.0, 1.0), A.shape)
    return np.asarray(A + DOUBLE.eps * float(np.max(np.abs(A))) * signs)


def _walk(function: Any, variable: Any, A: Array, here: Environment) -> Array:
    """Return the function with the matrix in place of its variable; what is free of it is a multiple of I."""
    if not function.has(variable):
        return _number(function, here) * np.eye(len(A))
    if function == variable:
        return A
    if function.is_Pow:
        return _power(function, variable, A, here)
    parts = [_walk(part, variable, A, here) for part in function.args]
    if function.is_Add:
        return np.asarray(np.sum(parts, axis=0))
    if function.is_Mul:
        return np.asarray(np.linalg.multi_dot(parts))
    return _elementary(type(function))(parts[0])


def _number(expression: Any, here: Environment) -> complex:
    return complex(np.asarray(value_of(expression, here).value).reshape(-1)[0])


def _power(function: Any, variable: Any, A: Array, here: Environment) -> Array:
    from scipy.linalg import expm, fractional_matrix_power, sqrtm  # noqa: PLC0415

    base, exponent = function.args
    if not base.has(variable):
        return np.asarray(expm(np.log(_number(base, here)) * _walk(exponent, variable, A, here)))
    B = _walk(base, variable, A, here)
    if exponent.has(variable):
        raise NotEvaluable("a power of a matrix to a matrix has no algorithm here")
    if exponent == sp.S.Half:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of a singular matrix; its root is compared like any other
            return np.asarray(sqrtm(B))
    order = _number(exponent, here).real
    return np.asarray(
        np.linalg.matrix_power(B, round(order)) if order == round(order) else fractional_matrix_power(B, order)
    )


def _elementary(function: Any) -> Callable[[Array], Array]:
    from scipy import linalg  # noqa: PLC0415

    known: dict[Any, Callable[[Array], Array]] = {
        sp.exp: linalg.expm,
        sp.sin: linalg.sinm,
        sp.cos: linalg.cosm,
        sp.tan: linalg.tanm,
        sp.sinh: linalg.sinhm,
        sp.cosh: linalg.coshm,
        sp.tanh: linalg.tanhm,
        sp.log: linalg.logm,
        sp.atan: lambda X: (linalg.logm(np.eye(len(X)) + 1j * X) - linalg.logm(np.eye(len(X)) - 1j * X)) / 2j,
        sp.asin: _arcsine,
        sp.acos: lambda X: np.pi / 2 * np.eye(len(X)) - _arcsine(X),
    }
    if function not in known:
        raise NotEvaluable(Phrase("no algorithm for the function {function} of a matrix", function=function.__name__))
    return known[function]


def _arcsine(X: Array) -> Array:
    """Return −j log(jX + √(I − X²))."""
    from scipy.linalg import logm, sqrtm  # noqa: PLC0415

    return np.asarray(-1j * logm(1j * X + sqrtm(np.eye(len(X)) - X @ X)))
