"""Functions of a matrix with many digits: products, inverses and e^X by themselves, roots and logarithms by Newton.

What they start from is scipy's principal value in doubles. For matrices and answers that are exact.
"""

from __future__ import annotations

import warnings
from collections.abc import Mapping
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array, multiple
from solver.numeric.evaluation.compare import Residual
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.multiple_precision import exponential, inverse
from solver.numeric.evaluation.precision import EXACT
from solver.numeric.evaluation.values import NotEvaluable
from solver.words import Phrase

MANY = multiple(60)
STEPS = 8
ENOUGH = 1e-40


def exact_residual(A: Any, function: Any, variable: Any, F: Any, point: Mapping[Any, complex]) -> Residual:
    """Return the largest difference of F and f(A) at a point, relative to each entry but to no less than its noise."""
    here = Environment.at([dict(point)], MANY)
    matrix, own = (value_of(M, here).value[0] for M in (A, F))
    wanted = _walk(function, variable, matrix, here)
    largest = max(map(abs, wanted.ravel())) or 1
    gaps = [abs(a - b) / max(abs(b), largest * NOISE) for a, b in zip(own.ravel(), wanted.ravel(), strict=True)]
    return Residual(float(max(gaps)), EXACT.tolerance)


NOISE = 1e-15
"""Entries that are smaller than this, relative to the largest, may hold the rounding of zero."""


def _walk(function: Any, variable: Any, A: Array, here: Environment) -> Array:
    """Return the function with the matrix in place of its variable; what is free of it is a multiple of I."""
    if not function.has(variable):
        return np.ravel(np.asarray(value_of(function, here).value, dtype=object))[0] * _one(A)
    if function == variable:
        return A
    if function.is_Pow:
        return _power(function, variable, A, here)
    parts = [_walk(part, variable, A, here) for part in function.args]
    if function.is_Add:
        return np.asarray(sum(parts[1:], parts[0]))
    if function.is_Mul:
        found = parts[0]
        for part in parts[1:]:
            found = found @ part
        return found
    return _elementary(type(function), parts[0])


def _one(A: Array) -> Array:
    return MANY.array(np.eye(len(A)))


def _power(function: Any, variable: Any, A: Array, here: Environment) -> Array:
    base, exponent = function.args
    if exponent.has(variable):
        if base.has(variable):
            raise NotEvaluable("a power of a matrix to a matrix has no algorithm here")
        b = np.ravel(np.asarray(value_of(base, here).value, dtype=object))[0]
        return _exponential(MANY.apply("log", b) * _walk(exponent, variable, A, here))
    B = _walk(base, variable, A, here)
    order = np.ravel(np.asarray(value_of(exponent, here).value, dtype=object))[0].real
    if order == int(order):
        return _whole(B if order >= 0 else inverse(B), abs(int(order)))
    return _root(B) if exponent == sp.S.Half else _exponential(order * _logarithm(B))


def _whole(B: Array, order: int) -> Array:
    found = _one(B)
    while order:
        found, B, order = found @ B if order % 2 else found, B @ B, order // 2
    return found


def _elementary(function: Any, X: Array) -> Array:
    j = MANY.imaginary()
    if function in (sp.sin, sp.cos, sp.tan):
        up, down = _exponential(j * X), _exponential(-j * X)
        sine, cosine = (up - down) / (2 * j), (up + down) / 2
        return sine if function is sp.sin else cosine if function is sp.cos else sine @ inverse(cosine)
    if function in (sp.sinh, sp.cosh, sp.tanh):
        up, down = _exponential(X), _exponential(-X)
        sine, cosine = (up - down) / 2, (up + down) / 2
        return sine if function is sp.sinh else cosine if function is sp.cosh else sine @ inverse(cosine)
    if function is sp.exp:
        return _exponential(X)
    if function is sp.log:
        return _logarithm(X)
    raise NotEvaluable(Phrase("no algorithm for the function {function} of a matrix", function=function.__name__))


def _exponential(X: Array) -> Array:
    return exponential(X, MANY.context)[0]


def _root(B: Array) -> Array:
    """The root next to scipy's: X ← (X + X⁻¹B)/2."""
    from scipy.linalg import sqrtm  # noqa: PLC0415

    return _newton(B, sqrtm, lambda X: (inverse(X) @ B - X) / 2)


def _logarithm(B: Array) -> Array:
    """The logarithm next to scipy's: X ← X + e^{−X}B − I."""
    from scipy.linalg import logm  # noqa: PLC0415

    return _newton(B, logm, lambda X: _exponential(-X) @ B - _one(X))


def _newton(B: Array, start: Any, step: Any) -> Array:
    approximate = np.asarray(MANY.approximate(B), dtype=complex)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of a singular matrix: then Newton's method says so
        X = MANY.array(start(approximate if np.any(approximate.imag) else approximate.real))
    for _ in range(STEPS):
        change = step(X)
        X = X + change
        if max(map(abs, change.ravel())) <= ENOUGH * max(1, *map(abs, X.ravel())):
            return X
    raise NotEvaluable("Newton's method does not converge")
