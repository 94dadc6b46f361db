"""Linear algebra on arrays of mpmath numbers, and the matrix exponential by whole numbers in fixed point."""

from __future__ import annotations

from math import ceil, log2
from typing import Any

import numpy as np
from numpy.typing import NDArray

from solver.numeric.values import NotEvaluable, Undefined

Array = NDArray[Any]


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
        table[j] = table[j] / table[j, j]
        for i in range(n):
            if i != j and table[i, j] != 0:
                table[i] -= table[j] * table[i, j]
    return table[:, n:]


def exponential(M: Array, context: Any) -> tuple[Array, Array]:
    """Return e^M (mpmath numbers) and the absolute error of each entry (floats).

    Scaling, Taylor series and squaring in fixed point with Python's whole numbers. The error is measured: the
    difference from a second run with fewer bits and M rounded to 15 bits less.
    """
    n = len(M)
    real = np.array([[entry.real for entry in row] for row in M], dtype=object)
    imaginary = np.array([[entry.imag for entry in row] for row in M], dtype=object)
    if np.any(imaginary != 0):  # e^M as a block of the exponential of a real matrix of twice the size
        real = np.block([[real, -imaginary], [imaginary, real]])
    norm = max((float(sum(abs(entry) for entry in row)) for row in real), default=0.0)
    if not norm < 2.0**60:
        raise NotEvaluable("the exponent of the matrix exponential is too large")
    halvings = max(0, ceil(log2(norm)) + 4) if norm > 0 else 0
    bits = context.prec + 4 * halvings + 64
    fine = _fixed_point(_rounded(real, context.prec, context), halvings, bits, context)
    coarse = _fixed_point(_rounded(real, context.prec - 15, context), halvings, bits - 64, context)
    error = np.asarray(np.abs(fine - coarse), dtype=float)
    if len(fine) > n:
        fine = fine[:n, :n] + context.mpc(0, 1) * fine[n:, :n]
        error = error[:n, :n] + error[n:, :n]
    return np.frompyfunc(context.mpc, 1, 1)(fine), error


def _rounded(M: Array, bits: int, context: Any) -> Array:
    """Round entries to a number of significant bits."""
    with context.workprec(bits):
        return np.array([[+entry for entry in row] for row in M], dtype=object)


def _fixed_point(M: Array, halvings: int, bits: int, context: Any) -> Array:
    """(Σ Xᵏ/k!)^(2^h) with X = M/2^h, all numbers multiples of 2^−bits."""
    n = len(M)
    X = np.array([[int(context.ldexp(entry, bits - halvings)) for entry in row] for row in M], dtype=object)
    one = np.array([[(1 << bits) if i == j else 0 for j in range(n)] for i in range(n)], dtype=object)
    total, term, k = one + X, X, 1
    while np.any(term != 0) and k < bits:
        k += 1
        term = (term @ X >> bits) // k
        term = np.where(term == -1, 0, term)  # a shift rounds down: −2^−bits would stay for ever
        total = total + term
    for _ in range(halvings):
        total = total @ total >> bits
    return np.array([[context.ldexp(context.mpf(entry), -bits) for entry in row] for row in total], dtype=object)
