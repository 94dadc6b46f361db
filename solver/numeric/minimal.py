"""What of a system its transfer function shows: a minimal part by orthogonal bases, its poles and its zeros.

All with 50 digits, so that ranks are beyond doubt. A system is a quadruple of matrices A n×n, B n×m, C p×n, D p×m.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import reduce
from random import Random
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.arithmetic import Array, multiple
from solver.numeric.environment import Environment
from solver.numeric.evaluate import value_of
from solver.numeric.multiple_precision import determinant
from solver.numeric.points import SEED, admissible, free_symbols
from solver.numeric.values import NotEvaluable

Quadruple = tuple[Any, Any, Any, Any]
MANY = multiple(50)
NOTHING = 1e-20
"""A part of a vector of unit length that is smaller than this is rounding (of exact entries, or of 30 digits)."""

ROUNDING = 1e-35
"""A coefficient, scaled to the size of the polynomial on its circle, that is smaller than this is rounding."""


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
    for point in _points(plant, poles):
        A, B, C, _ = quadruple_at(plant, point)
        small, _, _ = minimal_part(A, B, C)
        if len(poles) != len(small):
            return float("inf")
        worst = max(worst, _difference(small, _numbers(poles, point)))
    return worst


def cancelled_residual(plant: Quadruple, cancelled: Sequence[Any]) -> float:
    """Return the largest relative difference of det(xI − A) and det(xI − A_min) Π(x − cᵢ)."""
    worst = 0.0
    for point in _points(plant, cancelled):
        A, B, C, _ = quadruple_at(plant, point)
        small, _, _ = minimal_part(A, B, C)
        if len(small) + len(cancelled) != len(A):
            return float("inf")
        worst = max(worst, _difference(A, _numbers(cancelled, point), small))
    return worst


def order_of_minimal_part(plant: Quadruple) -> int:
    """Return the McMillan degree, parameters at random values."""
    point = _points(plant)[0]
    A, B, C, _ = quadruple_at(plant, point)
    return len(minimal_part(A, B, C)[0])


def characteristic_residual(plant: Quadruple, candidate: Any) -> float:
    """Return the largest relative difference of det(xI − A_min) and det(xI − candidate)."""
    worst = 0.0
    for point in _points(plant, candidate):
        A, B, C, _ = quadruple_at(plant, point)
        small, _, _ = minimal_part(A, B, C)
        if candidate.rows != candidate.cols or candidate.rows != len(small):
            return float("inf")
        worst = max(worst, _difference(small, [], _value(candidate, point)))
    return worst


def zero_residual(plant: Quadruple, zeros: Sequence[Any]) -> float:
    """Return 0 for the transmission zeros with multiplicity, else what is left over when they are divided out.

    They are the common roots of the system determinants of all squarings of G; two random ones have no other.
    """
    worst = 0.0
    for point in _points(plant, zeros):
        worst = max(worst, _zeros_at(quadruple_at(plant, point), _numbers(zeros, point)))
    return worst


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
        length = _length(vector)
        for _ in range(2 if length else 0):
            for q in basis:
                vector = vector - q * (_conjugate(q) @ vector)
        left = _length(vector)
        if left > NOTHING * max(length, _length(A.reshape(-1)) * 1e-10):
            basis.append(vector / left)
            waiting.append(A @ basis[-1])
    if not basis:
        return A[:0, :0], B[:0], C[:, :0]
    Q = np.array(basis, dtype=object).T
    adjoint = _conjugate(Q).T
    return adjoint @ A @ Q, adjoint @ B, C @ Q


def _difference(A: Array, roots: Iterable[Any], factor: Array | None = None) -> float:
    """The largest relative difference of det(xI − A) and Π(x − rᵢ) det(xI − F), at x of the sizes of eigenvalues."""
    worst, listed = 0.0, list(roots)
    for x in _probes(A):
        left = _shifted_determinant(A, x)
        right = _shifted_determinant(factor, x) if factor is not None else MANY.number(1)
        for root in listed:
            right = right * (x - root)
        worst = max(worst, float(abs(left - right) / max(abs(left), abs(right))))
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


def _zeros_at(plant: tuple[Array, Array, Array, Array], zeros: list[Any]) -> float:
    A, B, C, D = plant
    A, B, C = minimal_part(A, B, C)
    random = Random(SEED)  # noqa: S311 - nothing secret
    rank = _normal_rank(A, B, C, D)
    square = C.shape[0] == B.shape[1] == rank
    quotients = []
    for _ in range(1 if square else 2):
        mixed = (A, B, C, D) if square else _squared(A, B, C, D, rank, random)
        quotient, left = _divided(_system_polynomial(*mixed), zeros)
        if left > 1e-9:
            return left
        quotients.append(quotient)
    if square:
        return 0.0 if len(quotients[0]) == 1 else float("inf")
    return 0.0 if rank == 0 or _coprime(*quotients) else float("inf")


def _normal_rank(A: Array, B: Array, C: Array, D: Array) -> int:
    """The rank of G(x) at a random x."""
    x = MANY.number(complex(0.7312, 1.1173)) * (1 + _length(A.reshape(-1)))
    n = len(A)
    pencil = np.vstack([np.hstack([x * np.eye(n, dtype=int).astype(object) - A, -B]), np.hstack([C, D])])
    return _rank(pencil) - n


def _rank(M: Array) -> int:
    """The rank by orthogonalization, the largest column first."""
    columns = [M[:, j] for j in range(M.shape[1])]
    largest = max((_length(column) for column in columns), default=0)
    found = 0
    while columns and largest:
        lengths = [_length(column) for column in columns]
        first = int(np.argmax(lengths))
        if lengths[first] <= NOTHING * largest:
            break
        q = columns.pop(first) / lengths[first]
        columns = [column - q * (_conjugate(q) @ column) for column in columns]
        found += 1
    return found


def _squared(A: Array, B: Array, C: Array, D: Array, r: int, random: Random) -> tuple[Array, Array, Array, Array]:
    """L G R with random L (r×p) and R (m×r)."""
    L, R = (
        np.array([[MANY.number(random.uniform(-2, 2)) for _ in range(columns)] for _ in range(rows)], dtype=object)
        for rows, columns in ((r, C.shape[0]), (B.shape[1], r))
    )
    L, R = L.reshape(r, C.shape[0]), R.reshape(B.shape[1], r)
    return A, B @ R, L @ C, L @ D @ R


def _system_polynomial(A: Array, B: Array, C: Array, D: Array) -> list[Any]:
    """The coefficients (lowest power first) of det [xI − A, −B; C, D], which is det(xI − A) det G(x)."""
    n = len(A)
    one = np.eye(n, dtype=int).astype(object)
    radius = max(MANY.number(1).real, *(abs(entry) for entry in A.reshape(-1))) if n else MANY.number(1).real
    turn = [MANY.context.expjpi(MANY.context.mpf(2 * k) / (n + 1)) for k in range(n + 1)]
    values = [
        determinant(np.vstack([np.hstack([radius * w * one - A, -B]), np.hstack([C, D])])) if n + len(D) else 1
        for w in turn
    ]
    scaled = [
        sum(values[k] * turn[(-i * k) % (n + 1)] for k in range(n + 1)) / (n + 1) for i in range(n + 1)
    ]  # the coefficients times powers of the radius
    largest = max(abs(c) for c in scaled)
    scaled = [c if abs(c) > ROUNDING * largest else MANY.number(0) for c in scaled]
    while len(scaled) > 1 and scaled[-1] == 0:
        scaled.pop()
    return [c / radius**i for i, c in enumerate(scaled)]


def _divided(p: list[Any], zeros: list[Any]) -> tuple[list[Any], float]:
    """The quotient of p by Π(x − zᵢ), and the size of what is left over relative to the terms of p.

    Zeros at the origin come first, while the coefficients there are exactly zero.
    """
    worst = 0.0
    for zero in sorted(zeros, key=abs):
        quotient: list[Any] = []
        value, size = MANY.number(0), MANY.context.mpf(0)
        for c in reversed(p):
            value, size = value * zero + c, size * abs(zero) + abs(c)
            quotient.append(value)
        rest = quotient.pop()
        worst = max(worst, float(abs(rest) / size) if size else 0.0)
        p = quotient[::-1]
        if not p:
            return p, float("inf")
    return p, worst


def _coprime(p: list[Any], q: list[Any]) -> bool:
    """Whether two polynomials (not constant both) have no common root: Sylvester's matrix has full rank."""
    m, n = len(p) - 1, len(q) - 1
    if m < 0 or n < 0:
        return False
    if m == 0 or n == 0:
        return True
    zero = MANY.number(0)
    rows = [[zero] * i + p + [zero] * (n - 1 - i) for i in range(n)]
    rows += [[zero] * i + q + [zero] * (m - 1 - i) for i in range(m)]
    return _rank(np.array(rows, dtype=object).T) == m + n


def _points(*formulas: Any) -> list[Any]:
    symbols: frozenset[Any] = frozenset().union(*(free_symbols(formula) for formula in formulas))
    return admissible(symbols, 2)


def _value(M: Any, point: Any) -> Array:
    if 0 in M.shape:
        return np.zeros(M.shape, dtype=object)
    found = value_of(M, Environment.at([dict(point)], MANY))
    return np.broadcast_to(found.value, (1, *M.shape))[0]


def _numbers(values: Iterable[Any], point: Any) -> list[Any]:
    environment = Environment.at([dict(point)], MANY)
    numbers = [value_of(value, environment).value for value in values]
    if any(np.ndim(number) > 1 for number in numbers):
        raise NotEvaluable("a list of numbers is expected")
    return [number if np.ndim(number) == 0 else number[0] for number in numbers]


def _length(vector: Array) -> Any:
    return MANY.context.sqrt(sum((abs(entry) ** 2 for entry in vector), MANY.context.mpf(0)))


def _conjugate(M: Array) -> Array:
    return np.frompyfunc(MANY.context.conj, 1, 1)(M)
