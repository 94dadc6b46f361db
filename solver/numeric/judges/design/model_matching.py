"""Model matching judged in numbers: zeros and degrees, realizations and closed loops at random points."""

from __future__ import annotations

from typing import Any

import numpy as np
import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.numeric.evaluation.arithmetic import Array, multiple
from solver.numeric.evaluation.compare import with_many_digits, worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.multiple_precision import solution
from solver.numeric.judges.design.placement import rational_points

Fraction = tuple[Any, Any]
NEAR = 1e-5
MANY = multiple(50)
POINTS = (0.7 + 1.9j, -2.3 + 0.8j, 1.6 - 0.6j, 3.1 + 2.7j)


def _polynomial(expression: Any, x: Any, point: Any) -> Array:
    """Return the coefficients, highest power first, at values of the parameters."""
    return np.array([complex(c) for c in sp.Poly(expression.subs(point), x).all_coeffs()])


def matching_possible(plant: Fraction, target: Any, x: Any, *, discrete: bool) -> bool:
    """Whether the target's zeros are among the plant's, relative degrees agree, and what is hidden decays."""
    above, below = sp.fraction(sp.cancel(target))
    for point in rational_points(*plant, target):
        here = {symbol: value for symbol, value in point.items() if symbol != x}
        N, D, M, E = (_polynomial(p, x, here) for p in (*plant, above, below))
        if len(D) - len(N) != len(E) - len(M):
            return False
        left = list(np.roots(N))
        for zero in np.roots(M):
            near = min(left, key=lambda other: abs(other - zero), default=None)
            if near is None or abs(near - zero) > NEAR * (1 + abs(zero)):
                return False
            left.remove(near)
        if any((abs(zero) >= 1 - NEAR) if discrete else (zero.real >= -NEAR) for zero in left):
            return False
    return True


def fraction_of(matrices: Any, x: Any) -> Fraction:
    """Return numerator and denominator of C (xI − A)⁻¹ B + D of one input and output, by sympy's `charpoly`.

    By the matrix determinant lemma C (xI − A)⁻¹ B = det(xI − A + BC)/det(xI − A) − 1.
    """
    A, B, C, D = matrices
    closed, chi = (_characteristic_polynomial(M, x) for M in (A - B * C, A))
    return sp.expand(closed - chi + D[0, 0] * chi), chi


def _characteristic_polynomial(M: Any, x: Any) -> Any:
    found = DomainMatrix.from_Matrix(sp.Matrix(M), extension=True)
    return sum(found.domain.to_sympy(c) * x**i for i, c in enumerate(reversed(found.charpoly())))


def direct_term(plant: Fraction, x: Any) -> Any:
    """Return D (1×1) of a proper fraction: its value at infinity."""
    N, P = (sp.Poly(p, x) for p in plant)
    return sp.ImmutableMatrix([[N.LC() / P.LC() if N.degree() == P.degree() else 0]])


def first_row_form(plant: Fraction, x: Any) -> Any:
    """Return A, B, C, D with the coefficients of the denominator in the first row: the form the course uses."""
    N, P = (sp.Poly(p, x) for p in plant)
    n, d = P.degree(), direct_term(plant, x)
    a = [c / P.LC() for c in P.all_coeffs()]
    b = [sp.Integer(0)] * (n - N.degree()) + [c / P.LC() for c in N.all_coeffs()]
    A = sp.ImmutableMatrix(n, n, lambda i, j: -a[j + 1] if i == 0 else int(i == j + 1))
    B = sp.ImmutableMatrix(n, 1, lambda i, _: int(i == 0))
    return A, B, sp.ImmutableMatrix(1, n, [b[i + 1] - d[0, 0] * a[i + 1] for i in range(n)]), d


def _transfer(matrices: Any, point: Any, at: complex) -> Any:
    """Return C (xI − A)⁻¹ B + D at a point, with 50 digits."""
    A, B, C, D = (value_of(M, Environment.at([point], MANY)).value[0] for M in matrices)
    pencil = MANY.number(at) * np.eye(len(A), dtype=int).astype(object) - A
    return (C @ solution(pencil, B) + D)[0, 0]


def _number(expression: Any, point: Any) -> Any:
    return np.ravel(value_of(expression, Environment.at([point], MANY)).value)[0]


def _fits(matrices: Any, inputs: int = 1) -> bool:
    A, B, C, D = matrices
    return A.rows == A.cols and B.shape == (A.rows, inputs) and C.shape == (1, A.rows) and D.shape == (1, inputs)


def realization_residual(matrices: Any, plant: Fraction, x: Any) -> float:
    """Return the largest relative difference of C (xI − A)⁻¹ B + D and the plant at random points."""
    if not _fits(matrices):
        return float("inf")
    worst = 0.0
    for point in rational_points(*matrices, *(p.subs(x, 0) for p in plant)):
        for at in POINTS:
            expected = _number(plant[0] / plant[1], {**point, x: at})
            worst = worst_of((worst, float(abs(_transfer(matrices, point, at) - expected) / abs(expected))))
    return with_many_digits(worst, *matrices, *plant)


def matched_residual(matrices: Any, K: Any, target: Any, x: Any) -> float:
    """Return how far (C − DK)(xI − A + BK)⁻¹B + D is from a constant multiple of the target, at random points."""
    A, B, C, D = matrices
    if not _fits(matrices) or K.shape != (1, A.rows):
        return float("inf")
    loop = (sp.Matrix(A - B * K), B, sp.Matrix(C - D * K), D)
    worst = 0.0
    for point in rational_points(*matrices, K, target.subs(x, sp.Rational(1, 7))):
        ratios = [_transfer(loop, point, at) / _number(target, {**point, x: at}) for at in POINTS]
        worst = worst_of((worst, *(float(abs(ratio / ratios[0] - 1)) for ratio in ratios)))
    return with_many_digits(worst, *matrices, K, target)
