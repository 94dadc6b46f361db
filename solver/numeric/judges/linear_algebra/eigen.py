"""Eigenvalues, eigenvectors and chains judged by their defining equations.

Eigenvalues in floats are no judge of multiple ones (an error ε moves them by ε^{1/m}); so spectra are compared by the
values of the characteristic polynomial, which are well conditioned, with as many digits as that takes.
"""

from __future__ import annotations

from collections.abc import Sequence
from random import Random
from typing import Any

import mpmath
import numpy as np
import sympy as sp

from solver.numeric.evaluation.environment import Environment, Point
from solver.numeric.evaluation.equalities import equality_residual
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import SEED, admissible, free_symbols
from solver.stated.algebra import difference, product
from solver.stated.matrices import determinant

SAME_SIZE = 4.0
"""Eigenvalues whose sizes differ by less than this factor share a point of comparison."""

DIGITS = 60
SMALL = 1e-5
LADDER = (1.0, 1e-3, 1e-6, 1e-9, 1e-12, 1e-15)
"""Sizes relative to the entries of A; between two steps an eigenvalue still shows to three digits less."""


def eigenpair_residual(A: Any, eigenvalues: Sequence[Any], V: Any) -> float:
    """Return the largest entrywise relative difference in A vᵢ = λᵢ vᵢ, vᵢ the columns of V (n×k, k eigenvalues).

    Infinite if the shapes do not fit or a column is zero.
    """
    if V.shape != (A.rows, len(eigenvalues)) or _has_zero_column(V):
        return float("inf")
    diagonal = sp.ImmutableMatrix(len(eigenvalues), len(eigenvalues), _diagonal(eigenvalues))
    return equality_residual(product(A, V), product(V, diagonal), _points(A, V, diagonal))


def _diagonal(entries: Sequence[Any]) -> list[Any]:
    return [entries[i] if i == j else 0 for i in range(len(entries)) for j in range(len(entries))]


def chain_residual(A: Any, V: Any, J: Any) -> float:
    """Return the largest entrywise relative difference in A V = V J; infinite if shapes misfit or a column is zero.

    That J is in Jordan form and that the columns are independent are questions of their own.
    """
    if _has_zero_column(V):
        return float("inf")
    return equality_residual(product(A, V), product(V, J), _points(A, V, J))


def left_residual(A: Any, M: Any, J: Any) -> float:
    """Return the largest entrywise relative difference in M A = J M; infinite if shapes misfit or a row is zero."""
    if _has_zero_column(M.T):
        return float("inf")
    return equality_residual(product(M, A), product(J, M), _points(A, M, J))


def decimal_eigenvalues(M: Any) -> list[Any]:
    """Return the eigenvalues of a matrix of numbers, each as often as its multiplicity, as decimals of 60 digits."""
    return [in_decimals(value) for value in eigenvalues_in_decimals(M)]


def eigenvalues_in_decimals(M: Any) -> list[Any]:
    """Return what `decimal_eigenvalues` does, as numbers of mpmath."""
    with mpmath.workdps(DIGITS):
        rows = [[mpmath.mpmathify(sp.N(entry, DIGITS)) for entry in row] for row in M.tolist()]
        if len(rows) < 2:  # mpmath returns eigenvectors too for one row
            return [entry for row in rows for entry in row]
        return list(mpmath.eig(mpmath.matrix(rows), left=False, right=False))


def in_decimals(value: Any) -> Any:
    """Return a number of mpmath as sympy's, real where its imaginary part is rounding."""
    z = mpmath.mpmathify(value)
    real, imaginary = sp.Float(mpmath.re(z), DIGITS), sp.Float(mpmath.im(z), DIGITS)
    return real if abs(imaginary) < sp.Float("1e-12") * (1 + abs(real)) else real + sp.I * imaginary


def _has_zero_column(V: Any) -> bool:
    return any(all(V[i, j] == 0 for i in range(V.rows)) for j in range(V.cols))


def spectrum_residual(A: Any, eigenvalues: Sequence[Any]) -> float:
    """Return the largest relative difference of det(xI − A) and Π(x − λᵢ) at random x of the size of each eigenvalue.

    Infinite if there are not n eigenvalues (each as often as its multiplicity).
    """
    if len(eigenvalues) != A.rows:
        return float("inf")
    x = sp.Dummy("x")
    return _at_random_x(A, product(*(difference(x, value) for value in eigenvalues)), x)


def polynomial_residual(A: Any, polynomial: Any, symbol: Any) -> float:
    """Return the largest relative difference of det(xI − A) and p(x) at random x, p an expression in the symbol."""
    return _at_random_x(A, polynomial, symbol)


def _at_random_x(A: Any, formula: Any, x: Any) -> float:
    pencil = difference(product(x, sp.eye(A.rows)), A)
    points = [
        {**point, x: size * direction}
        for point in _points(A, formula, without=x)
        for size, direction in _directions(_sizes(A, point))
    ]
    return equality_residual(determinant(pencil), formula, points)


def _directions(sizes: list[float]) -> list[tuple[float, complex]]:
    """Pair each size with random complex numbers of about unit size, three pairs at least."""
    random = Random(SEED)  # noqa: S311 - nothing secret
    each = -(-3 // len(sizes))
    return [
        (size, random.uniform(0.8, 1.6) * complex(np.exp(1j * random.uniform(0.3, 2.8))))
        for size in sizes
        for _ in range(each)
    ]


def _sizes(A: Any, point: Point) -> list[float]:
    """Return the sizes of the eigenvalues of A at a point, those close to each other once.

    Small eigenvalues beside a large one are not known from doubles; there a ladder of sizes takes their place.
    """
    A_here = value_of(A, Environment.at([point])).value[0]
    largest = float(np.max(np.abs(A_here), initial=0.0)) or 1.0
    sizes: list[float] = []
    for size in sorted((float(abs(value)) for value in np.linalg.eigvals(A_here)), reverse=True):
        if size <= SMALL * largest:
            return [*sizes, *(largest * step for step in LADDER)]
        if not sizes or size * SAME_SIZE < sizes[-1]:
            sizes.append(size)
    return sizes or [largest]


def _points(*formulas: Any, without: Any = None) -> list[Any]:
    """Return random values of the parameters at which all formulas have values."""
    symbols = frozenset().union(*map(free_symbols, formulas)) - {without}
    return list(admissible(symbols, 2))
