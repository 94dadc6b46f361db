"""Smith's form and the Smith–McMillan form judged by the minors, as polynomials with 50 digits.

A polynomial is the list of its coefficients, the lowest power first; [] is zero.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from random import Random
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.compare import with_many_digits, worst_of
from solver.numeric.evaluation.points import SEED
from solver.numeric.judges.representation.minimal import MANY, Quadruple, numbers_at, points_of, quadruple_at
from solver.numeric.judges.representation.zeros import ROUNDING, coprime

Coefficients = list[Any]
Rows = list[list[Coefficients]]
Fractions = tuple[Sequence[Sequence[Any]], Sequence[Sequence[Any]]]
MINORS = "mpmath, minors as polynomials (50 digits)"
WRONG = float("inf")
LOST = 1e-9
"""What a division by a wrong polynomial leaves."""


def smith_residual(M: Any, factors: Sequence[Any] | None, x: Any) -> float:
    """Return 0 for the invariant factors of a polynomial matrix (zeros beyond its rank), else what is left over.

    The product of the first k divides all k×k minors, and what is left of these has no root in common.
    """
    if factors is None:
        return WRONG
    worst = 0.0
    without_x = [each.xreplace({x: sp.Integer(2)}) for each in (M, *(sp.S.Zero + factor for factor in factors))]
    for point in points_of(*without_x):
        rows = [[_coefficients(M[i, j], x, point) for j in range(M.cols)] for i in range(M.rows)]
        listed = [_coefficients(each, x, point) for each in factors]
        if any(each is None for each in listed):
            return WRONG
        worst = worst_of((worst, _left_over(rows, listed)))  # type: ignore[arg-type]
    return with_many_digits(worst, M, list(factors))


def smith_mcmillan_residual(plant: Quadruple | Fractions, diagonal: Sequence[Any] | None, x: Any) -> float:
    """Return 0 for the diagonal of the Smith–McMillan form of a plant, else what is left over.

    With N = χ G, a matrix of polynomials, the χ εᵢ/ψᵢ are the invariant factors of N.
    """
    if diagonal is None:
        return WRONG
    worst = 0.0
    pairs = [sp.fraction(sp.together(each)) for each in diagonal]
    flat = [each for part in plant for each in (sp.flatten(part) if isinstance(part, list | tuple) else [part])]
    without_x = [each.xreplace({x: sp.Integer(2)}) for each in (*flat, *(side for pair in pairs for side in pair))]
    for point in points_of(*without_x):
        chi, rows = _of_states(plant, point) if len(plant) == 4 else _of_fractions(plant, x, point)
        factors = []
        for above, below in pairs:
            p, q = _coefficients(above, x, point), _coefficients(below, x, point)
            if p is None or not q:
                return WRONG
            factor, rest = divided(product(chi, p), q)
            if rest > LOST:
                return rest
            factors.append(factor)
        worst = worst_of((worst, _left_over(rows, factors)))
    return with_many_digits(worst, flat, list(diagonal))


def _left_over(rows: Rows, factors: Sequence[Coefficients]) -> float:
    """What is left over where the minors are divided by the products of the factors; infinity for a wrong divisor."""
    random = Random(SEED)  # noqa: S311 - nothing secret
    size = max((abs(c) for row in rows for p in row for c in p), default=MANY.number(0)) or MANY.number(1)
    whole, worst, ended = [MANY.number(1)], 0.0, False
    for k, factor in enumerate(factors, 1):
        minors = [
            _determinant(rows, r, c)
            for r in combinations(range(len(rows)), k)
            for c in combinations(range(len(rows[0])), k)
        ]
        if ended or not factor:
            ended = True
            if factor or any(abs(c) > 1e-25 * abs(size) ** k for minor in minors for c in minor):
                return WRONG
            continue
        worst = worst_of((worst, float(abs(factor[-1] - 1))))
        whole = product(whole, factor)
        mixed: list[Coefficients] = [[], []]
        for minor in minors:
            quotient, rest = divided(minor, whole)
            if rest > LOST:
                return rest
            worst = worst_of((worst, rest))
            mixed = [added(each, quotient, MANY.number(random.uniform(-2, 2))) for each in mixed]
        if not all(mixed) or not coprime(*map(trimmed, mixed)):
            return WRONG
    return worst


def _of_states(plant: Any, point: Any) -> tuple[Coefficients, Rows]:
    """The χ and χ G of a system A, B, C, D, by the recursion of Faddeev and LeVerrier in numbers."""
    A, B, C, D = quadruple_at(plant, point)
    n = len(A)
    one = np.eye(n, dtype=int).astype(object) * MANY.number(1)
    N, chi, markov = one, [MANY.number(1)], []
    for k in range(1, n + 1):
        markov.append(C @ N @ B)
        AN = A @ N
        chi.append(-sum(AN[i, i] for i in range(n)) / k)
        N = AN + chi[-1] * one
    low = chi[::-1]
    rows = [
        [
            trimmed(added([markov[n - 1 - k][i, j] for k in range(n)], low, D[i, j]) if n else [D[i, j]])
            for j in range(D.shape[1])
        ]
        for i in range(D.shape[0])
    ]
    return low, rows


def _of_fractions(plant: Any, x: Any, point: Any) -> tuple[Coefficients, Rows]:
    """The least common denominator of fractions as they are given, and its product with each of them."""
    numerators, denominators = plant
    distinct = list(dict.fromkeys(q for row in denominators for q in row))
    common = sp.lcm_list(distinct) if distinct[1:] else distinct[0]
    chi = _coefficients(common, x, point) or []
    rows = []
    for tops, bottoms in zip(numerators, denominators, strict=True):
        row = []
        for top, bottom in zip(tops, bottoms, strict=True):
            p, q = _coefficients(top, x, point) or [], _coefficients(bottom, x, point) or []
            row.append(divided(product(chi, p), q)[0])
        rows.append(row)
    return [c / chi[-1] for c in chi], [[[c / chi[-1] for c in p] for p in row] for row in rows]


def _coefficients(p: Any, x: Any, point: Any) -> Coefficients | None:
    """The coefficients of a polynomial at a point; None of what is no polynomial."""
    try:
        listed = sp.Poly(p, x).all_coeffs()
    except sp.PolynomialError:
        return None
    if any(c.has(x) for c in listed):
        return None
    return trimmed(numbers_at(reversed(listed), point))


def trimmed(p: Coefficients) -> Coefficients:
    """Return the polynomial without leading coefficients that are rounding."""
    largest = max((abs(c) for c in p), default=0)
    while p and abs(p[-1]) <= ROUNDING * largest:
        p = p[:-1]
    return p


def added(p: Coefficients, q: Coefficients, factor: Any) -> Coefficients:
    """Return p + factor · q."""
    zero, n = MANY.number(0), max(len(p), len(q))
    return [a + factor * b for a, b in zip(p + [zero] * (n - len(p)), q + [zero] * (n - len(q)), strict=True)]


def product(p: Coefficients, q: Coefficients) -> Coefficients:
    """Return p q."""
    if not p or not q:
        return []
    found = [MANY.number(0)] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            found[i + j] = found[i + j] + a * b
    return found


def divided(p: Coefficients, q: Coefficients) -> tuple[Coefficients, float]:
    """Return the quotient of two polynomials, and the remainder relative to p."""
    p, largest = trimmed(p), max((abs(c) for c in p), default=0)
    if not p:
        return [], 0.0
    if len(p) < len(q):
        return [], 1.0
    rest, quotient = list(p), []
    for at in range(len(p) - len(q), -1, -1):
        c = rest[at + len(q) - 1] / q[-1]
        quotient.append(c)
        for i, b in enumerate(q):
            rest[at + i] = rest[at + i] - c * b
    left = max((abs(c) for c in rest[: len(q) - 1]), default=0)
    return quotient[::-1], float(left / largest)


def _determinant(rows: Rows, of_rows: tuple[int, ...], of_columns: tuple[int, ...]) -> Coefficients:
    """The minor of these rows and columns, by Laplace along its first row; coefficients that are rounding are zero."""
    first, *rest = of_rows
    if not rest:
        return rows[first][of_columns[0]]
    found: Coefficients = []
    size = 0.0
    for at, j in enumerate(of_columns):
        if rows[first][j]:
            inner = _determinant(rows, tuple(rest), of_columns[:at] + of_columns[at + 1 :])
            term = product(rows[first][j], inner)
            size = max(size, *(abs(c) for c in term)) if term else size
            found = added(found, term, MANY.number(-1 if at % 2 else 1))
    found = [c if abs(c) > 1e-30 * size else MANY.number(0) for c in found]
    while found and found[-1] == 0:
        found.pop()
    return found
