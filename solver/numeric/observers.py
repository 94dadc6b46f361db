"""Observers judged by what they must do: the spectrum of the error, and an error that nothing else drives."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from solver.numeric.arithmetic import Array
from solver.numeric.eigen import spectrum_residual
from solver.numeric.environment import Environment
from solver.numeric.evaluate import value_of
from solver.numeric.points import admissible, free_symbols


def error_spectrum_residual(M: Any, poles: Sequence[Any], A: Any, C: Any) -> float:
    """Return how far det(xI − M) is from the polynomial asked for, M (n×n) the matrix A − LC of the error.

    Of fewer than n poles: with the eigenvalues that (A, C) does not show, which no gain moves, in addition.
    """
    if M.shape != A.shape or len(poles) > A.rows:
        return float("inf")
    if len(poles) == A.rows:
        return spectrum_residual(M, poles)
    return max(_spectrum_residual_at(*values) for values in _at_points(M, list(poles), A, C))


def _spectrum_residual_at(M: Array, poles: Array, A: Array, C: Array) -> float:
    hidden = unseen_eigenvalues(A, C)
    if len(hidden) + len(poles) != len(A):
        return float("inf")
    found, wanted = np.poly(M), np.poly(np.concatenate([poles, hidden]))
    scale = 1.0 + max(np.max(np.abs(np.linalg.eigvals(M)), initial=0.0), np.max(np.abs(poles), initial=0.0))
    return float(np.max(np.abs(found - wanted) / scale ** np.arange(len(found))))


def unseen_eigenvalues(A: Array, C: Array) -> Array:
    """Return the eigenvalues of A (n×n) on the null space of the observability matrix of (A, C), C p×n."""
    n = len(A)
    size, first = float(np.linalg.norm(A)), float(np.linalg.norm(C))
    blocks = [C / (first or 1.0)]
    for _ in range(n - 1):
        blocks.append(blocks[-1] @ A / (size or 1.0))
    _, values, rows = np.linalg.svd(np.vstack(blocks))
    rank = int(np.sum(values > 1e-9 * values[0])) if values[0] > 0 else 0
    null = rows[rank:].conj().T
    return np.asarray(np.linalg.eigvals(null.conj().T @ A @ null)) if null.size else np.zeros(0)


def row_space_residual(X: Any, C: Any) -> float:
    """Return how far the rows of X (k×n) are from combinations of the rows of C (p×n), relative to their size."""
    if X.cols != C.cols:
        return float("inf")
    return max(_row_space_residual_at(*values) for values in _at_points(X, C))


def _row_space_residual_at(X: Array, C: Array) -> float:
    left = X - X @ np.linalg.pinv(C) @ C
    return float(np.linalg.norm(left)) / max(1.0, float(np.linalg.norm(X)))


def driven_error_residual(A: Any, C: Any, E: Any, J: Any, G: Any) -> float:
    """Return how much the plant drives the error Π x − ω of ω' = Jω + G x, at the best Π = E − LC over all L.

    A n×n, C p×n, E q×n, J q×q, G q×n. The error is autonomous if and only if Π A = J Π + G for some such Π.
    """
    q, n = E.shape
    if J.shape != (q, q) or G.shape != (q, n):
        return float("inf")
    return max(_driven_error_at(*values) for values in _at_points(A, C, E, J, G))


def _driven_error_at(A: Array, C: Array, E: Array, J: Array, G: Array) -> float:
    """Least squares for vec L in L (C A) − J (L C) = E A − J E − G, columns stacked."""
    identity = np.eye(len(J))
    operator = np.kron((C @ A).T, identity) - np.kron(C.T, J)
    right = (E @ A - J @ E - G).flatten(order="F")
    solution = np.linalg.lstsq(operator, right, rcond=None)[0]
    size = max(1.0, *(float(np.linalg.norm(each)) for each in (E @ A, J @ E, G)))
    return float(np.linalg.norm(operator @ solution - right)) / size


def _at_points(*formulas: Any) -> Iterator[list[Array]]:
    """Yield the values of matrices and lists as arrays at random values of their symbols."""
    symbols = frozenset().union(*map(free_symbols, formulas))
    for point in admissible(symbols, 2):
        environment = Environment.at([dict(point)])
        yield [np.asarray(value_of(formula, environment).value[0]) for formula in formulas]
