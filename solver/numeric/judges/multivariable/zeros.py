"""Zeros of every kind judged: where a pencil xE − M falls in rank, with 50 digits and with their multiplicities.

The roots that the largest minors of a pencil have in common are those of two random compressions L (xE − M) R of it
to a square. A system is a quadruple of matrices A n×n, B n×m, C p×n, D p×m.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from random import Random
from typing import Any, Literal

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.compare import with_many_digits, worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.multiple_precision import determinant, solution
from solver.numeric.evaluation.points import SEED
from solver.numeric.judges.representation.minimal import (
    MANY,
    Quadruple,
    length,
    minimal_part,
    numbers_at,
    points_of,
    quadruple_at,
)
from solver.numeric.judges.representation.zeros import ROUNDING, coprime, divided, rank_of

Kind = Literal["transmission", "invariant", "input", "output"]
LOST = 1e-9
"""What is left over of a polynomial relative to its terms when no root is divided out, or a wrong one."""


MONIC = 1e-15
"""What a leading coefficient may differ from one: it is one in any decimals."""


def zeros_residual(plant: Quadruple, zeros: Sequence[Any], kind: Kind) -> float:
    """Return 0 for the zeros of a kind with multiplicity, else what is left over when they are divided out."""
    worst = 0.0
    for point in points_of(plant, zeros):
        numbers = numbers_at(zeros, point)
        worst = worst_of((worst, _left_over(_determinants(plant, point, kind), _of_roots(numbers), numbers)))
    return with_many_digits(worst, *plant, zeros)


def zero_polynomial_residual(plant: Quadruple, polynomial: Any, x: Any, kind: Kind = "transmission") -> float:
    """Return 0 for the monic polynomial of the zeros of a kind, else what is left over when it is divided out."""
    worst = 0.0
    for point in points_of(plant, polynomial.xreplace({x: 1})):
        coefficients = _coefficients(polynomial, x, point)
        if coefficients is None or abs(coefficients[-1] - 1) > MONIC:
            return float("inf")
        found = _left_over(_determinants(plant, point, kind), coefficients, None)
        worst = worst_of((worst, found))
    return with_many_digits(worst, *plant, polynomial)


def pole_polynomial_residual(plant: Quadruple, polynomial: Any, x: Any) -> float:
    """Return the largest relative difference from det(xI − A) of the minimal part, coefficient by coefficient."""
    worst = 0.0
    for point in points_of(plant, polynomial.xreplace({x: 1})):
        A, B, C, _ = quadruple_at(plant, point)
        small, _, _ = minimal_part(A, B, C)
        n = len(small)
        coefficients = _coefficients(polynomial, x, point)
        if coefficients is None or len(coefficients) != n + 1:
            return float("inf")
        right = _pencil_polynomial(np.eye(n, dtype=int).astype(object), small, n, _radius(small))
        size = max(abs(c) for c in right)
        gap = max(
            (abs(a - b) / (abs(a) + size * ROUNDING) for a, b in zip(right, coefficients, strict=True)), default=0
        )
        worst = worst_of((worst, float(gap)))
    return with_many_digits(worst, *plant, polynomial)


def normal_rank(plant: Quadruple) -> int:
    """Return the rank of G at a random point, parameters at random values."""
    A, B, C, D = quadruple_at(plant, points_of(plant)[0])
    E, M = _pencil(A, B, C, D, "invariant")
    return _rank(E, M, _radius(A)) - len(A)


def directions_residual(plant: Quadruple, directions: Any, zeros: Sequence[Any] | None) -> float:
    """Return how far G(z) u is from zero for the columns u, each at its zero; without zeros, at any of them.

    Columns for a multiple zero must be independent.
    """
    worst = 0.0
    if directions.rows != plant[1].cols:
        return float("inf")
    for point in points_of(plant, directions, zeros or ()):
        A, B, C, D = quadruple_at(plant, point)
        A, B, C = minimal_part(A, B, C)
        columns = [_column(directions[:, j], point) for j in range(directions.cols)]
        places = numbers_at(zeros, point) if zeros is not None else _approximate_zeros(A, B, C, D)
        if len(places) != len(columns) or any(length(u) == 0 for u in columns):
            return float("inf")
        left = list(range(len(places)))
        for k, u in enumerate(columns):
            choices = {i: _blocked(A, B, C, D, places[i], u) for i in ([k] if zeros is not None else left)}
            best = min(choices, key=lambda i: choices[i])
            left.remove(best)
            worst = worst_of((worst, choices[best]))
        alike = {z: [u for u, at in zip(columns, places, strict=True) if abs(at - z) < LOST] for z in places}
        if any(rank_of(np.array(group, dtype=object).T) < len(group) for group in alike.values()):
            return float("inf")
    return with_many_digits(worst, *plant, directions, zeros or ())


def _blocked(A: Array, B: Array, C: Array, D: Array, z: Any, u: Array) -> float:
    """|G(z) u| beside the sizes of its terms; infinite at a pole."""
    n = len(A)
    state = solution(z * np.eye(n, dtype=int).astype(object) - A, (B @ u).reshape(-1, 1))[:, 0] if n else B @ u
    size = length(C.reshape(-1)) * length(state) + length(D.reshape(-1)) * length(u)
    return float(length(C @ state + D @ u) / size) if size else 0.0


def _approximate_zeros(A: Array, B: Array, C: Array, D: Array) -> list[Any]:
    """The transmission zeros to many digits, where they are simple: common roots of two compressions."""
    first, *others = _compressed(*_pencil(A, B, C, D, "invariant"), len(A), _radius(A))
    if len(first) < 2:
        return []
    roots = MANY.context.polyroots(first[::-1], maxsteps=200, extraprec=200)
    kept = []
    for root in roots:
        if all(divided(p, [root])[1] < LOST for p in others):
            kept.append(root)
    return kept


def _determinants(plant: Quadruple, point: Any, kind: Kind) -> tuple[list[Any], ...]:
    """The determinants of compressions of the pencil at a point; found once for all answers that are judged by it."""
    key = (*(sp.ImmutableMatrix(M) for M in plant), tuple(sorted(point.items(), key=str)), kind)
    return _determinants_of(*key)


@lru_cache(maxsize=32)
def _determinants_of(A: Any, B: Any, C: Any, D: Any, point: Any, kind: Kind) -> tuple[list[Any], ...]:
    a, b, c, d = quadruple_at((A, B, C, D), dict(point))
    n = len(a)
    one = np.eye(n, dtype=int).astype(object)
    if kind == "input" and len(minimal_part(a, b, one)[0]) == n:  # every state is reached
        return ([MANY.number(1)],)
    if kind == "output" and len(minimal_part(a, one, c)[0]) == n:
        return ([MANY.number(1)],)
    if kind == "transmission":
        a, b, c = minimal_part(a, b, c)
    return tuple(_compressed(*_pencil(a, b, c, d, kind), len(a), _radius(a)))


def _left_over(polynomials: Sequence[list[Any]], divisor: list[Any], roots: list[Any] | None) -> float:
    """What is left of the polynomials divided by another; infinity where the quotients share a root."""
    quotients, worst = [], 0.0
    for p in polynomials:
        quotient, rest = divided(p, roots) if roots is not None else _quotient(p, divisor)
        if not rest <= LOST:
            return float(rest)
        worst = max(worst, rest)
        quotients.append(quotient)
    if len(quotients) == 1:
        return worst if len(quotients[0]) == 1 else float("inf")
    return worst if len(quotients[0]) == 1 or coprime(*quotients) else float("inf")


def _pencil(A: Array, B: Array, C: Array, D: Array, kind: Kind) -> tuple[Array, Array]:
    """E and M with xE − M = [xI − A, −B; C, D]; of the input its upper rows, of the output its left columns."""
    n, (p, m) = len(A), D.shape
    E = np.zeros((n + p, n + m), dtype=object)
    E[:n, :n] = np.eye(n, dtype=int).astype(object)
    M = np.vstack([np.hstack([A, B]), np.hstack([-C, -D])])
    rows = n if kind == "input" else n + p
    columns = n if kind == "output" else n + m
    return E[:rows, :columns], M[:rows, :columns]


def _compressed(E: Array, M: Array, n: int, radius: Any) -> list[list[Any]]:
    """The determinants of two random compressions to normal rank; of a regular pencil its own."""
    r = _rank(E, M, radius)
    if E.shape == (r, r):
        return [_pencil_polynomial(E, M, n, radius)]
    random = Random(SEED)  # noqa: S311 - nothing secret
    found = []
    for _ in range(2):
        L, R = (
            np.array([[MANY.number(random.uniform(-2, 2)) for _ in range(columns)] for _ in range(rows)], dtype=object)
            for rows, columns in ((r, E.shape[0]), (E.shape[1], r))
        )
        L, R = L.reshape(r, E.shape[0]), R.reshape(E.shape[1], r)
        found.append(_pencil_polynomial(L @ E @ R, L @ M @ R, n, radius))
    return found


def _radius(A: Array) -> Any:
    """The size of the largest eigenvalue, one at least: where polynomials in x have coefficients of one size."""
    found: Any = np.abs(np.linalg.eigvals(np.asarray(MANY.approximate(A), dtype=complex))) if len(A) else []
    return MANY.number(max([1.0, *(float(size) for size in found)])).real


def _rank(E: Array, M: Array, radius: Any) -> int:
    """The rank of xE − M at a random x, somewhat beyond the eigenvalues."""
    x = MANY.number(complex(0.7312, 1.1173)) * radius
    return rank_of(x * E - M)


def _pencil_polynomial(E: Array, M: Array, n: int, radius: Any) -> list[Any]:
    """The coefficients (lowest power first) of det(xE − M), of degree n at most, by values on a circle."""
    if not len(M):
        return [MANY.number(1)]
    turn = [MANY.context.expjpi(MANY.context.mpf(2 * k) / (n + 1)) for k in range(n + 1)]
    values = [determinant(radius * w * E - M) for w in turn]
    scaled = [sum(values[k] * turn[(-i * k) % (n + 1)] for k in range(n + 1)) / (n + 1) for i in range(n + 1)]
    largest = max(abs(c) for c in scaled)
    scaled = [c if abs(c) > ROUNDING * largest else MANY.number(0) for c in scaled]
    while len(scaled) > 1 and scaled[-1] == 0:
        scaled.pop()
    return [c / radius**i for i, c in enumerate(scaled)]


def _quotient(p: list[Any], divisor: list[Any]) -> tuple[list[Any], float]:
    """The quotient of p by a polynomial (lowest powers first), and what is left over relative to the terms of p."""
    rest, k = list(p), len(divisor) - 1
    size = max(abs(c) for c in p)
    quotient = []
    while len(rest) > k:
        factor = rest.pop() / divisor[-1]
        quotient.append(factor)
        for i in range(k):
            rest[len(rest) - k + i] = rest[len(rest) - k + i] - factor * divisor[i]
    left = float(max((abs(c) for c in rest), default=0) / size) if size else 0.0
    return quotient[::-1], left if quotient else float("inf")


def _of_roots(roots: Sequence[Any]) -> list[Any]:
    """The coefficients of Π(x − r), the lowest power first."""
    found = [MANY.number(1)]
    for root in roots:
        shifted, scaled = [MANY.number(0), *found], [*(root * c for c in found), MANY.number(0)]
        found = [a - b for a, b in zip(shifted, scaled, strict=True)]
    return found


def _coefficients(polynomial: Any, x: Any, point: Any) -> list[Any] | None:
    """The coefficients of a polynomial in x at a point, the lowest power first; None for what is none."""
    if not polynomial.is_polynomial(x):
        return None
    return list(reversed(numbers_at(polynomial.as_poly(x).all_coeffs(), point)))


def _column(u: Any, point: Any) -> Array:
    found = value_of(u, Environment.at([dict(point)], MANY))
    return np.broadcast_to(found.value, (1, *u.shape))[0][:, 0]
