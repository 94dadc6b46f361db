"""What of a system its transfer function shows: a minimal part by orthogonal bases, and its poles.

All with 50 digits, so that ranks are beyond doubt. A system is a quadruple of matrices A n×n, B n×m, C p×n, D p×m.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import reduce
from random import Random
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array, multiple
from solver.numeric.evaluation.compare import with_many_digits, worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.multiple_precision import determinant
from solver.numeric.evaluation.points import SEED, admissible, free_symbols
from solver.numeric.evaluation.values import NotEvaluable

Quadruple = tuple[Any, Any, Any, Any]
MANY = multiple(50)
NOTHING = 1e-20
"""A part of a vector of unit length that is smaller than this is rounding (of exact entries, or of 30 digits)."""


def realized(numerators: Sequence[Sequence[Any]], denominators: Sequence[Sequence[Any]], x: Any) -> Quadruple:
    """Return A, B, C, D of a matrix of proper fractions, one companion block an input; not minimal."""
    outputs, inputs = len(numerators), len(numerators[0])
    A, B, C, D = [], [], [], sp.zeros(outputs, inputs)
    for j in range(inputs):
        column = [sp.Poly(row[j], x) for row in denominators]
        distinct = list(dict.fromkeys(column))
        common = reduce(lambda p, q: p * q, distinct)
        low = [c / common.LC() for c in reversed(common.all_coeffs())][:-1]
        n = len(low)
        rows = []
        for i in range(outputs):
            others = reduce(lambda p, q: p * q, [q for q in distinct if q != column[i]], sp.Poly(1, x))
            top = [c / common.LC() for c in reversed((sp.Poly(numerators[i][j], x) * others).all_coeffs())]
            top += [sp.Integer(0)] * (n + 1 - len(top))
            D[i, j] = top[n]
            rows.append([b - top[n] * a for b, a in zip(top[:n], low, strict=True)])
        A.append(sp.Matrix(n, n, lambda i, k, low=low, n=n: -low[k] if i == n - 1 else sp.Integer(int(k == i + 1))))
        B.append(sp.Matrix(n, 1, lambda i, _, n=n: sp.Integer(int(i == n - 1))))
        C.append(sp.Matrix(outputs, n, [entry for row in rows for entry in row]))
    return sp.diag(*A), sp.diag(*B), sp.Matrix.hstack(*C), D


def pole_residual(plant: Quadruple, poles: Sequence[Any]) -> float:
    """Return the largest relative difference of Π(x − pᵢ) and the characteristic polynomial of the minimal part."""
    worst = 0.0
    for point in points_of(plant, poles):
        A, B, C, _ = quadruple_at(plant, point)
        small, _, _ = minimal_part(A, B, C)
        if len(poles) != len(small):
            return float("inf")
        worst = worst_of((worst, _difference(small, numbers_at(poles, point))))
    return with_many_digits(worst, *plant, poles)


def cancelled_residual(plant: Quadruple, cancelled: Sequence[Any]) -> float:
    """Return the largest relative difference of det(xI − A) and det(xI − A_min) Π(x − cᵢ)."""
    worst = 0.0
    for point in points_of(plant, cancelled):
        A, B, C, _ = quadruple_at(plant, point)
        small, _, _ = minimal_part(A, B, C)
        if len(small) + len(cancelled) != len(A):
            return float("inf")
        worst = worst_of((worst, _difference(A, numbers_at(cancelled, point), small)))
    return with_many_digits(worst, *plant, cancelled)


def order_of_minimal_part(plant: Quadruple) -> int:
    """Return the McMillan degree, parameters at random values."""
    point = points_of(plant)[0]
    A, B, C, _ = quadruple_at(plant, point)
    return len(minimal_part(A, B, C)[0])


def characteristic_residual(plant: Quadruple, candidate: Any) -> float:
    """Return the largest relative difference of det(xI − A_min) and det(xI − candidate)."""
    worst = 0.0
    for point in points_of(plant, candidate):
        A, B, C, _ = quadruple_at(plant, point)
        small, _, _ = minimal_part(A, B, C)
        if candidate.rows != candidate.cols or candidate.rows != len(small):
            return float("inf")
        worst = worst_of((worst, _difference(small, [], _value(candidate, point))))
    return with_many_digits(worst, *plant, candidate)


def quadruple_at(plant: Quadruple, point: Any) -> tuple[Array, Array, Array, Array]:
    """Return the four matrices at a point, with 50 digits."""
    A, B, C, D = (_value(M, point) for M in plant)
    return A, B, C, D


def minimal_part(A: Array, B: Array, C: Array) -> tuple[Array, Array, Array]:
    """Return a controllable and observable system with the transfer function C (xI − A)⁻¹ B."""
    A, B, C = _reachable(A, B, C)
    A, C, B = (M.T for M in _reachable(A.T, C.T, B.T))
    return A, B, C


def _reachable(A: Array, B: Array, C: Array) -> tuple[Array, Array, Array]:
    """The system on the space spanned by B, AB, A²B, …, in an orthonormal basis of it."""
    basis: list[Array] = []
    waiting = [B[:, j] for j in range(B.shape[1])]
    while waiting and len(basis) < len(A):
        vector = waiting.pop(0)
        size = length(vector)
        for _ in range(2 if size else 0):
            for q in basis:
                vector = vector - q * (conjugate(q) @ vector)
        left = length(vector)
        if left > NOTHING * max(size, length(A.reshape(-1)) * 1e-10):
            basis.append(vector / left)
            waiting.append(A @ basis[-1])
    if not basis:
        return A[:0, :0], B[:0], C[:, :0]
    Q = np.array(basis, dtype=object).T
    adjoint = conjugate(Q).T
    return adjoint @ A @ Q, adjoint @ B, C @ Q


def _difference(A: Array, roots: Iterable[Any], factor: Array | None = None) -> float:
    """The largest relative difference of det(xI − A) and Π(x − rᵢ) det(xI − F), at x of the sizes of eigenvalues."""
    worst, listed = 0.0, list(roots)
    for x in _probes(A):
        left = _shifted_determinant(A, x)
        right = _shifted_determinant(factor, x) if factor is not None else MANY.number(1)
        for root in listed:
            right = right * (x - root)
        worst = worst_of((worst, float(abs(left - right) / max(abs(left), abs(right)))))
    return worst


def _shifted_determinant(A: Array, x: Any) -> Any:
    n = len(A)
    return determinant(x * np.eye(n, dtype=int).astype(object) - A) if n else MANY.number(1)


def _probes(A: Array) -> list[Any]:
    """Random complex numbers of the sizes of the eigenvalues, so that every one of them shows."""
    approximate = np.asarray(MANY.approximate(A), dtype=complex)
    sizes = {float(f"{abs(value):.0e}") for value in np.linalg.eigvals(approximate)} if len(A) else set()
    random = Random(SEED)  # noqa: S311 - nothing secret
    return [
        MANY.number(complex(size * random.uniform(0.7, 1.4) * np.exp(1j * random.uniform(0.3, 2.8))))
        for size in {*sizes, 1.0}
        if size > 1e-12
        for _ in range(2)
    ]


def points_of(*formulas: Any) -> list[Any]:
    """Return admissible points for all symbols of the formulas: two, or one where there are none."""
    symbols: frozenset[Any] = frozenset().union(*(free_symbols(formula) for formula in formulas))
    return admissible(symbols, 2)


def _value(M: Any, point: Any) -> Array:
    if 0 in M.shape:
        return np.zeros(M.shape, dtype=object)
    found = value_of(M, Environment.at([dict(point)], MANY))
    return np.broadcast_to(found.value, (1, *M.shape))[0]


def value_at_one(G: Any, x: Any) -> Any:
    """What is left of a formula when a number stands for x: its parameters."""
    operands = getattr(G, "operands", None)
    return tuple(value_at_one(each, x) for each in operands) if operands is not None else _without(G, x)


def _without(value: Any, x: Any) -> Any:
    return value.xreplace({x: x**0 * 2}) if hasattr(value, "xreplace") else value


def numbers_at(values: Iterable[Any], point: Any) -> list[Any]:
    """Return the values at a point, with 50 digits; raises NotEvaluable for what is no number."""
    environment = Environment.at([dict(point)], MANY)
    numbers = [value_of(value, environment).value for value in values]
    if any(np.ndim(number) > 1 for number in numbers):
        raise NotEvaluable("a list of numbers is expected")
    return [number if np.ndim(number) == 0 else number[0] for number in numbers]


def length(vector: Array) -> Any:
    """Return the Euclidean length."""
    return MANY.context.sqrt(sum((abs(entry) ** 2 for entry in vector), MANY.context.mpf(0)))


def conjugate(M: Array) -> Array:
    """Return the conjugate entries."""
    return np.frompyfunc(MANY.context.conj, 1, 1)(M)
