"""Linear algebra on arrays of mpmath numbers, and the matrix exponential by whole numbers in fixed point."""

from __future__ import annotations

from collections.abc import Callable
from math import ceil, factorial, isqrt, log2
from typing import Any

import numpy as np
from numpy.typing import NDArray

from solver.numeric.evaluation.values import NotEvaluable, Undefined

Array = NDArray[Any]

LARGEST_NORM = 2.0**60
MOST_SHIFTED = 200
"""Rows and columns are balanced by no more than two to this power."""


def determinant(M: Array) -> Any:
    """Det M of a square array of mpmath numbers, by elimination with partial pivoting."""
    M = M.copy()
    result = M[0, 0] * 0 + 1
    for j in range(len(M)):
        p = j + int(np.argmax([abs(entry) for entry in M[j:, j]]))
        if M[p, j] == 0:
            return M[p, j]
        if p != j:
            M[[j, p]] = M[[p, j]]
            result = -result
        result = result * M[j, j]
        for i in range(j + 1, len(M)):
            M[i, j + 1 :] -= M[j, j + 1 :] * (M[i, j] / M[j, j])
    return result


def inverse(M: Array) -> Array:
    """M⁻¹ of a square array of mpmath numbers, by Gauss and Jordan; raises Undefined if M is singular."""
    n = len(M)
    zero = M[0, 0] * 0
    table = np.hstack([M, np.array([[zero + (i == j) for j in range(n)] for i in range(n)], dtype=object)])
    for j in range(n):
        p = j + int(np.argmax([abs(entry) for entry in table[j:, j]]))
        if table[p, j] == 0:
            raise Undefined("the matrix to invert is singular")
        table[[j, p]] = table[[p, j]]
        there = j + 1 + np.flatnonzero(table[j, j + 1 :])  # what is zero stays as it is, and costs as much as the rest
        table[j, there] = table[j, there] / table[j, j]
        for i in range(n):
            if i != j and table[i, j] != 0:
                table[i, there] -= table[j, there] * table[i, j]
    return table[:, n:]


def solution(M: Array, right: Array) -> Array:
    """M⁻¹ N of arrays of mpmath numbers, by elimination; raises Undefined if M is singular."""
    n = len(M)
    table = np.hstack([M, right])
    for j in range(n):
        p = j + int(np.argmax([abs(entry) for entry in table[j:, j]]))
        if table[p, j] == 0:
            raise Undefined("the matrix to invert is singular")
        table[[j, p]] = table[[p, j]]
        for i in range(j + 1, n):
            if table[i, j] != 0:
                table[i, j + 1 :] -= table[j, j + 1 :] * (table[i, j] / table[j, j])
    X = right.copy()
    for i in range(n - 1, -1, -1):
        known = table[i, i + 1 : n] @ X[i + 1 :] if i + 1 < n else 0
        X[i] = (table[i, n:] - known) / table[i, i]
    return X


def remainder(columns: Array, right: Array, context: Any, nothing: float) -> Array:
    """What is left of the columns of N (n×k) when their parts in the span of the columns of M (n×m) are taken away.

    By orthogonalization, the longest column first; a column of which less than `nothing` is left adds nothing.
    """
    rest = [columns[:, j] for j in range(columns.shape[1]) if any(columns[:, j])]
    rest = [column / _length(column, context) for column in rest]
    left = right.copy()
    while rest:
        lengths = [_length(column, context) for column in rest]
        longest = int(np.argmax(lengths))
        if lengths[longest] <= nothing:
            break
        q = rest.pop(longest) / lengths[longest]
        for _ in range(2):  # twice is enough (Kahan)
            rest = [column - q * context.fdot(column, q, conjugate=True) for column in rest]
            for j in range(left.shape[1]):
                left[:, j] = left[:, j] - q * context.fdot(left[:, j], q, conjugate=True)
    return left


def _length(column: Array, context: Any) -> Any:
    return context.sqrt(context.fsum(column, absolute=True, squared=True))


def exponential(M: Array, context: Any) -> tuple[Array, Callable[[], Array]]:
    """Return e^M (mpmath numbers) and, when it is called, the absolute error of each entry (floats).

    Balancing, scaling, Taylor series and squaring in fixed point with Python's whole numbers. The error is measured:
    the difference from a second run with fewer bits and M rounded to 15 bits less; not less than the last bit of that.
    """
    n = len(M)
    real = np.array([[entry.real for entry in row] for row in M], dtype=object)
    imaginary = np.array([[entry.imag for entry in row] for row in M], dtype=object)
    if np.any(imaginary != 0):  # e^M as a block of the exponential of a real matrix of twice the size
        real = np.block([[real, -imaginary], [imaginary, real]])
    sizes = np.abs(real).astype(float)
    if not np.all(sizes.sum(axis=1) < LARGEST_NORM):
        raise NotEvaluable("the exponent of the matrix exponential is too large")
    shifts = _balance(sizes)
    norm = float(np.max(np.ldexp(sizes, -shifts).sum(axis=1), initial=0.0))
    halvings = max(0, ceil(log2(norm)) + 4) if norm > 0 else 0
    bits = context.prec + 4 * halvings + 64
    fine = _fixed_point(_rounded(real, context.prec, context), shifts, halvings, bits, context)

    def error() -> Array:
        coarse = _fixed_point(_rounded(real, context.prec - 15, context), shifts, halvings, bits - 64, context)
        found = np.asarray(np.abs(fine - coarse), dtype=float) + np.ldexp(1.0, np.maximum(shifts - bits + 64, -1000))
        return found[:n, :n] + found[n:, :n] if len(fine) > n else found

    value = fine[:n, :n] + context.mpc(0, 1) * fine[n:, :n] if len(fine) > n else fine
    return np.frompyfunc(context.mpc, 1, 1)(value), error


def _balance(sizes: Array) -> Array:
    """Return dᵢ − dⱼ for whole numbers dᵢ: rows and columns of 2^(dⱼ − dᵢ) Mᵢⱼ are of about the same size."""
    from scipy.linalg import matrix_balance  # noqa: PLC0415 - 150 ms that most checks do not need

    if not sizes.any():
        return np.zeros(sizes.shape, dtype=int)
    _, (scale, _) = matrix_balance(sizes, permute=False, separate=True)
    exponents = np.clip(np.round(np.log2(scale)), -MOST_SHIFTED, MOST_SHIFTED).astype(int)
    return np.asarray(exponents[:, None] - exponents[None, :])


def _rounded(M: Array, bits: int, context: Any) -> Array:
    """Round entries to a number of significant bits."""
    with context.workprec(bits):
        return np.array([[+entry for entry in row] for row in M], dtype=object)


def _fixed_point(M: Array, shifts: Array, halvings: int, bits: int, context: Any) -> Array:
    """(Σ Xᵏ/k!)^(2^h) for X = M/2^h balanced by the shifts (and balanced back), all numbers multiples of 2^−bits."""
    n = range(len(M))
    X = [[int(context.ldexp(M[i, j], bits - halvings - int(shifts[i, j]))) for j in n] for i in n]
    total = _taylor(np.array(X, dtype=object).reshape(M.shape), bits)
    for _ in range(halvings):
        total = total @ total >> bits
    rows = [[context.ldexp(context.mpf(total[i, j]), int(shifts[i, j]) - bits) for j in n] for i in n]
    return np.array(rows, dtype=object).reshape(M.shape)


def _taylor(X: Array, bits: int) -> Array:
    """Σ Xᵏ/k! for X of a norm below 1/16, in multiples of 2^−bits, as a polynomial of polynomials of degree below s.

    So it takes about 2√m products of matrices for m terms (Paterson and Stockmeyer, SIAM J. Comput. 2, 1973).
    """
    last, size = 1, -4.0
    while size > -bits:
        last += 1
        size -= 4 + log2(last)
    step = max(1, isqrt(last))
    powers = [np.array([[int(i == j) << bits for j in range(len(X))] for i in range(len(X))], dtype=object), X]
    while len(powers) <= step:
        powers.append(powers[-1] @ X >> bits)
    total = X * 0
    for start in range(last - last % step, -1, -step):
        block = sum(powers[i] // factorial(start + i) for i in range(min(step, last + 1 - start)))
        total = (total @ powers[step] >> bits) + block
    return total
