"""The Riccati equation AᵀP + PA − (PB + N) R⁻¹ (BᵀP + Nᵀ) + Q = 0: judges of a solution, its entries, its spectrum.

In discrete time it is Q + AᵀPA = P + (AᵀPB + N) (R + BᵀPB)⁻¹ (BᵀPA + Nᵀ).
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import reduce
from operator import mul
from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.compare import Residual, worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.equalities import equality_residual
from solver.numeric.evaluation.expressions import evaluate, value_of
from solver.numeric.evaluation.multiple_precision import determinant, solution
from solver.numeric.evaluation.points import PointSource, free_symbols, holds_decimals
from solver.numeric.evaluation.precision import SHOWN
from solver.numeric.evaluation.values import ShapeMismatch
from solver.numeric.judges.optimal.refined import MANY, Refined, sharpened
from solver.numeric.judges.optimal.regulator import Optimum, Weights, matrix_at, optima, relative, stable, worst
from solver.stated import Stated
from solver.stated.algebra import difference, product, total
from solver.stated.matrices import determinant as stated_determinant
from solver.stated.matrices import inverse, transpose
from solver.words import Phrase

LARGEST_FACTOR = 1000
"""An equation may be multiplied by a fraction of such numbers; one a little beside it is an error."""
NEAR = 1e-8


def riccati_residual(weights: Weights, P: Any) -> float:
    """Return the largest entrywise relative difference of the sides of the equation, P exact or not."""
    Q = weights.Q
    if getattr(P, "shape", None) != Q.shape:
        raise ShapeMismatch(Phrase("P must be {rows}×{columns}", rows=Q.rows, columns=Q.cols))
    return equality_residual(*riccati_sides(weights, P), [optimum.point for optimum in optima(weights, (P,))])


def riccati_sides(weights: Weights, P: Any) -> tuple[Stated, Stated]:
    """AᵀP + PA + Q and (PB + N) R⁻¹ (BᵀP + Nᵀ), as stated; those of discrete time."""
    A, B, Q, R, N = weights
    if weights.discrete:
        seen = product(transpose(B), P, A) if N.is_zero_matrix else total(product(transpose(B), P, A), transpose(N))
        quadratic = product(transpose(seen), inverse(total(R, product(transpose(B), P, B))), seen)
        return total(Q, product(transpose(A), P, A)), total(P, quadratic)
    linear = total(product(transpose(A), P), product(P, A), Q)
    if N.is_zero_matrix:
        return linear, product(P, B, inverse(R), transpose(B), P)
    return linear, product(total(product(P, B), N), inverse(R), total(product(transpose(B), P), transpose(N)))


def symmetry_residual(weights: Weights, P: Any) -> float:
    """Return how far P is from being real and symmetric."""

    def judge(optimum: Optimum) -> float:
        value = matrix_at(P, optimum.point, optimum.A.shape)
        found = relative(value - value.T, value)
        if found > 0 and not holds_decimals(P):
            return equality_residual(transpose(P), P, [optimum.point])
        return found

    return worst(weights, judge, P)


def stabilizes(weights: Weights, P: Any) -> bool:
    """Whether A − B R⁻¹ (BᵀP + Nᵀ) is Hurwitz, or the loop of discrete time within the unit circle."""

    def holds(optimum: Optimum) -> bool:
        value = matrix_at(P, optimum.point, optimum.A.shape)
        return stable(optimum.A - optimum.B @ optimum.gain_of(value), discrete=optimum.discrete)

    return all(holds(optimum) for optimum in optima(weights, (P,)))


def hamiltonian_spectrum_residual(weights: Weights, eigenvalues: Sequence[Any]) -> float:
    """Return the largest relative difference of Π(x − λᵢ)(−x − λᵢ)·(−1)ⁿ and det(xI − H) at some x.

    Infinite unless there are n eigenvalues, all with negative real parts. So they are the stable ones of H. In discrete
    time Π(x − λᵢ)(1 − xλᵢ) is compared with the determinant of the pencil, up to a factor, with all |λᵢ| < 1.
    """
    n = weights.A.rows
    if len(eigenvalues) != n:
        return float("inf")
    listed = sp.ImmutableMatrix([list(eigenvalues)])

    def judge(optimum: Optimum) -> float:
        unknown = free_symbols(listed) - set(optimum.point)
        if unknown:
            return float("inf")
        values = evaluate(listed, optimum.point)[0]
        if not np.all(np.abs(values) < 1 if optimum.discrete else values.real < 0):
            return float("inf")
        if optimum.discrete:
            found = _pencil_gap(optimum, values)
            return sharpened(found, weights, optimum, listed, lambda many: _many_pencil_gap(many, listed, optimum))
        H = hamiltonian(optimum)
        size = max(1e-3, float(np.abs(values).mean()))
        gaps = []
        for x in size * np.exp(1j * np.array([0.4, 1.3, 2.1])) * np.array([0.7, 1.0, 1.6]):
            stated, found = np.linalg.det(x * np.eye(2 * n) - H), np.prod((x - values) * (x + values))
            gaps.append(abs(stated - found) / max(abs(stated), abs(found)))
        return sharpened(float(max(gaps)), weights, optimum, listed, lambda many: _spectral_gap(many, listed, optimum))

    return worst(weights, judge, listed)


def _spectral_gap(many: Refined, listed: Any, optimum: Optimum) -> tuple[Array, ...]:
    """Return the difference of det(xI − H) and Π(x − λᵢ)(x + λᵢ) at some x, and the product."""
    values = value_of(listed, Environment.at([dict(optimum.point)], MANY)).value[0, 0]
    n = len(many.A)
    x = MANY.number(0.9 + 1.1j) * (1 + sum(abs(value) for value in values) / n)
    one = np.eye(n, dtype=int).astype(object)
    G, cross = many.B @ solution(many.R, many.B.T), solution(many.R, many.N.T)
    A, Q = many.A - many.B @ cross, many.Q - many.N @ cross
    pencil = np.block([[x * one - A, G], [Q, x * one + A.T]])
    found = reduce(mul, [(x - value) * (x + value) for value in values])
    return np.array([determinant(pencil) - found]), np.array([found])


PLACES = (0.8 + 0.3j, -0.4 + 1.1j, 1.7 - 0.2j)


def _pencil_gap(optimum: Optimum, values: Array) -> float:
    """Return how much the quotient of the determinant and Π(x − λᵢ)(1 − xλᵢ) differs from place to place."""
    found = [np.linalg.det(_pencil(optimum, x)) / np.prod((x - values) * (1 - x * values)) for x in PLACES]
    return float(max(abs(each - found[0]) for each in found) / max(map(abs, found)))


def _many_pencil_gap(many: Refined, listed: Any, optimum: Optimum) -> tuple[Array, ...]:
    """Return the difference of two such quotients, and one of them, with many digits."""
    values = value_of(listed, Environment.at([dict(optimum.point)], MANY)).value[0, 0]
    found = []
    for place in PLACES[:2]:
        x = MANY.number(place)
        whole = reduce(mul, [(x - value) * (1 - x * value) for value in values])
        found.append(determinant(_pencil(many, x)) / whole)
    return np.array([found[0] - found[1]]), np.array([found[0]])


def _pencil(found: Optimum | Refined, x: Any) -> Array:
    """The equations of the optimal motion xᵏ(x₀, λ₀, u₀): [xI − A, 0, −B; −Q, I − xAᵀ, −N; Nᵀ, xBᵀ, R]."""
    A, B, Q, R, N = found.A, found.B, found.Q, found.R, found.N
    n = len(A)
    one, zero = (M.astype(int).astype(A.dtype) for M in (np.eye(n), np.zeros((n, n))))
    return np.block([[x * one - A, zero, -B], [-Q, one - x * A.T, -N], [N.T, x * B.T, R]])


def hamiltonian(optimum: Optimum) -> Array:
    """H = [[A, −B R⁻¹ Bᵀ], [−Q, −Aᵀ]], with A − B R⁻¹ Nᵀ and Q − N R⁻¹ Nᵀ in place of A and Q."""
    G = np.linalg.solve(optimum.R, optimum.B.T)
    A, Q = optimum.without_products()
    return np.block([[A, -optimum.B @ G], [-Q, -A.T]])


def equations_residual(weights: Weights, equations: Sequence[Any]) -> float:
    """Return how far n(n+1)/2 expressions in p11, p12, … are from the entries of the Riccati equation.

    Each may carry a constant factor, and their order is free. Infinite for another number of them. In discrete time
    each may also be multiplied by det(R + BᵀPB).
    """
    n = weights.A.rows
    P = unknown_matrix(n)
    left = difference(*riccati_sides(weights, P))
    pairs = [(i, j) for i in range(n) for j in range(i, n)]
    if len(equations) != len(pairs):
        return float("inf")
    listed = sp.ImmutableMatrix([list(equations)]).xreplace(
        {sp.Symbol(f"p{j + 1}{i + 1}"): P[i, j] for i, j in pairs if i != j}
    )
    by = stated_determinant(total(weights.R, product(transpose(weights.B), P, weights.B)))
    source = PointSource(free_symbols(P) - free_symbols(weights.A))
    for _ in range(len(pairs) + 2):  # so that no value of P goes with the same of a weight
        source.draw()
    samples = []
    for optimum in optima(weights):
        for _ in range(4):
            point = {**optimum.point, **source.draw()}
            if free_symbols(listed) - set(point):
                return float("inf")
            stated = evaluate(left, point)
            factor = complex(np.ravel(evaluate(by, point))[0]) if weights.discrete else 1
            samples.append(([stated[i, j] for i, j in pairs], list(evaluate(listed, point)[0]), factor))
    stated, given, factors = (np.array(each) for each in zip(*samples, strict=True))
    forms = [stated.T, (stated * factors[:, None]).T] if weights.discrete else [stated.T]
    return _matched(np.array(forms), given.T)


def _matched(forms: Array, given: Array) -> float:
    """Return the worst gap when each row stated is paired with the nearest row given that is left, up to a factor.

    `forms` are forms of the rows, any of which will do.
    """
    left = list(range(len(given)))
    worst_gap = 0.0
    for rows in np.swapaxes(forms, 0, 1):
        gaps = {k: min(_gap_up_to_factor(row, given[k]) for row in rows) for k in left}
        best = min(gaps, key=lambda k: gaps[k])
        worst_gap = worst_of((worst_gap, gaps[best]))
        left.remove(best)
    return worst_gap


def _gap_up_to_factor(row: Array, other: Array) -> float:
    size, factor = np.vdot(other, other), np.vdot(other, row)
    if size == 0 or factor == 0:
        return float("inf") if np.abs(row).max() > 0 else 0.0
    exactly = Fraction(float(np.real(factor / size))).limit_denominator(LARGEST_FACTOR)
    ratio = float(exactly) if abs(factor / size - float(exactly)) < NEAR * abs(factor / size) else factor / size
    return Residual(relative(row - ratio * other, row), SHOWN.tolerance)


def unknown_matrix(n: int) -> sp.ImmutableMatrix:
    """The symmetric matrix of p11, p12, …: indices from 1, from n = 10 on with an underscore."""
    between = "" if n < 10 else "_"
    return sp.ImmutableMatrix(n, n, lambda i, j: sp.Symbol(f"p{min(i, j) + 1}{between}{max(i, j) + 1}"))
