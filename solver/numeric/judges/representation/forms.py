"""The canonical forms by inspection: where ones, zeros and the free entries of A stand.

Entries are exact, or decimals as a student writes them; parameters take random values.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import admissible, free_symbols

SAME = 1e-9


def values_of(M: Any) -> Array:
    """Return the entries of a matrix as complex numbers, parameters at random values."""
    if 0 in M.shape:
        return np.zeros(M.shape, dtype=complex)
    found = value_of(M, Environment.at([dict(admissible(free_symbols(M), 1)[0])]))
    return np.broadcast_to(found.value, (1, *M.shape))[0]


def is_companion(A: Any, *, transposed: bool, first: bool) -> bool:
    """Whether A has ones above the diagonal (`first`: below it) and else zeros but in its last (first) row.

    `transposed`: the same of Aᵀ.
    """
    M = values_of(A.T if transposed else A)
    n = len(M)
    if first:
        M = M[::-1, ::-1]
    shift = np.eye(n, k=1)
    return M.shape == (n, n) and bool(np.all(np.abs((M - shift)[: n - 1]) <= SAME))


def has_companion_blocks(A: Any, B: Any, channels: int) -> bool:
    """Whether all rows of A but one for each channel only pass on another state, untouched by B (None: not asked)."""
    M = values_of(A)
    n = len(M)
    shifts = [_is_unit(M[i]) and abs(M[i, i]) <= SAME for i in range(n)]
    if B is not None:
        driven = np.abs(values_of(B)).sum(axis=1) > SAME
        shifts = [shift and not driven[i] for i, shift in enumerate(shifts)]
    return M.shape == (n, n) and n - sum(shifts) <= channels


def _is_unit(row: Array) -> bool:
    ones = np.abs(row - 1) <= SAME
    return bool(ones.sum() == 1 and np.all(np.abs(row[~ones]) <= SAME))


def is_unit_vector(v: Any, place: int) -> bool:
    """Whether a row or column is zero but for a one at a place."""
    flat = values_of(v).reshape(-1)
    return bool(np.all(np.abs(flat - np.eye(len(flat))[place]) <= SAME))


def is_diagonal(A: Any) -> bool:
    """Whether A is zero off its diagonal."""
    M = values_of(A)
    return M.shape[0] == M.shape[1] and bool(np.all(np.abs(M - np.diag(np.diag(M))) <= SAME))


def is_chain_form(A: Any, *, above: bool, real: bool) -> bool:
    """Whether A has eigenvalues on its diagonal, ones below it (`above`) inside chains of equal ones, and else zeros.

    `real`: conjugate pairs are blocks [[σ, ω], [−ω, σ]] (either sign of ω), chained by 2×2 identities, and all is real.
    """
    M = values_of(A)
    if M.shape[0] != M.shape[1] or (real and np.any(np.abs(M.imag) > SAME)):
        return False
    if above:
        M = _reversed_blocks(M, _block_sizes(M, real=real))
    return _is_lower_chain(M, _block_sizes(M, real=real))


def _block_sizes(M: Array, *, real: bool) -> list[int]:
    """Orders of the diagonal blocks: 2 where both entries beside the diagonal are not zero."""
    sizes, i = [], 0
    while i < len(M):
        pair = real and i + 1 < len(M) and abs(M[i, i + 1]) > SAME and abs(M[i + 1, i]) > SAME
        sizes.append(2 if pair else 1)
        i += sizes[-1]
    return sizes


def _reversed_blocks(M: Array, sizes: list[int]) -> Array:
    starts = np.cumsum([0, *sizes[:-1]])
    order = [int(start) + k for start, size in reversed(list(zip(starts, sizes, strict=True))) for k in range(size)]
    return M[np.ix_(order, order)]


def _is_lower_chain(M: Array, sizes: list[int]) -> bool:
    starts = [int(start) for start in np.cumsum([0, *sizes[:-1]])]
    left = M.copy()
    for k, (start, size) in enumerate(zip(starts, sizes, strict=True)):
        here = slice(start, start + size)
        block = M[here, here]
        if size == 2 and not _is_pair(block):
            return False
        left[here, here] = 0
        if k and sizes[k - 1] == size:
            before = slice(starts[k - 1], start)
            link = M[here, before]
            if np.all(np.abs(link - np.eye(size)) <= SAME) and np.allclose(M[before, before], block, SAME, SAME):
                left[here, before] = 0
    return bool(np.all(np.abs(left) <= SAME))


def _is_pair(block: Array) -> bool:
    """[[σ, ω], [−ω, σ]], or [[σ, 1], [δ², σ]] where the sign of δ² is left open."""
    same = abs(block[0, 0] - block[1, 1]) <= SAME * (1 + abs(block[0, 0]))
    opposite = abs(block[0, 1] + block[1, 0]) <= SAME * (1 + abs(block[0, 1]))
    return bool(same and (opposite or abs(block[0, 1] - 1) <= SAME))
