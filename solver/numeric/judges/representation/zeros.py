"""Transmission zeros judged: the common roots of the system determinants of random squarings of G, with 50 digits."""

from __future__ import annotations

from collections.abc import Sequence
from random import Random
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.compare import with_many_digits, worst_of
from solver.numeric.evaluation.multiple_precision import determinant
from solver.numeric.evaluation.points import SEED
from solver.numeric.judges.representation.minimal import (
    MANY,
    NOTHING,
    Quadruple,
    conjugate,
    length,
    minimal_part,
    numbers_at,
    points_of,
    quadruple_at,
)

ROUNDING = 1e-35
"""A coefficient, scaled to the size of the polynomial on its circle, that is smaller than this is rounding."""


def zero_residual(plant: Quadruple, zeros: Sequence[Any]) -> float:
    """Return 0 for the transmission zeros with multiplicity, else what is left over when they are divided out.

    They are the common roots of the system determinants of all squarings of G; two random ones have no other.
    """
    worst = 0.0
    for point in points_of(plant, zeros):
        worst = worst_of((worst, _zeros_at(quadruple_at(plant, point), numbers_at(zeros, point))))
    return with_many_digits(worst, *plant, zeros)


def _zeros_at(plant: tuple[Array, Array, Array, Array], zeros: list[Any]) -> float:
    A, B, C, D = plant
    A, B, C = minimal_part(A, B, C)
    random = Random(SEED)  # noqa: S311 - nothing secret
    rank = _normal_rank(A, B, C, D)
    square = C.shape[0] == B.shape[1] == rank
    quotients, worst = [], 0.0
    for _ in range(1 if square else 2):
        mixed = (A, B, C, D) if square else _squared(A, B, C, D, rank, random)
        quotient, left = divided(_system_polynomial(*mixed), zeros)
        if left > 1e-9:
            return left
        worst = max(worst, left)
        quotients.append(quotient)
    if square:
        return worst if len(quotients[0]) == 1 else float("inf")
    return worst if rank == 0 or coprime(*quotients) else float("inf")


def _normal_rank(A: Array, B: Array, C: Array, D: Array) -> int:
    """The rank of G(x) at a random x."""
    x = MANY.number(complex(0.7312, 1.1173)) * (1 + length(A.reshape(-1)))
    n = len(A)
    pencil = np.vstack([np.hstack([x * np.eye(n, dtype=int).astype(object) - A, -B]), np.hstack([C, D])])
    return rank_of(pencil) - n


def rank_of(M: Array) -> int:
    """The rank by orthogonalization, the largest column first."""
    columns = [M[:, j] for j in range(M.shape[1])]
    largest = max((length(column) for column in columns), default=0)
    found = 0
    while columns and largest:
        lengths = [length(column) for column in columns]
        first = int(np.argmax(lengths))
        if lengths[first] <= NOTHING * largest:
            break
        q = columns.pop(first) / lengths[first]
        columns = [column - q * (conjugate(q) @ column) for column in columns]
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


def divided(p: list[Any], zeros: list[Any]) -> tuple[list[Any], float]:
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
        worst = worst_of((worst, float(abs(rest) / size) if size else 0.0))
        p = quotient[::-1]
        if not p:
            return p, float("inf")
    return p, worst


def coprime(p: list[Any], q: list[Any]) -> bool:
    """Whether two polynomials (not constant both) have no common root: Sylvester's matrix has full rank."""
    m, n = len(p) - 1, len(q) - 1
    if m < 0 or n < 0:
        return False
    if m == 0 or n == 0:
        return True
    zero = MANY.number(0)
    rows = [[zero] * i + p + [zero] * (n - 1 - i) for i in range(n)]
    rows += [[zero] * i + q + [zero] * (m - 1 - i) for i in range(m)]
    return rank_of(np.array(rows, dtype=object).T) == m + n
