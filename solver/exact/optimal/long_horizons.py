"""Where the recursion P ← Q + AᵀPA − AᵀPB (R + BᵀPB)⁻¹ BᵀPA settles that starts at a terminal weight S ≥ 0.

It settles at the stabilizing solution where Q sees every mode that does not decay, or S is positive definite on the
others; from S = 0 at the smallest positive semidefinite solution.
Source: S. W. Chan, G. C. Goodwin, K. S. Sin, Convergence properties of the Riccati difference equation in optimal
filtering of nonstabilizable systems, IEEE Trans. AC-29 (1984).
"""

from __future__ import annotations

import sympy as sp

from solver.exact.linear_algebra.fields import NotExact
from solver.exact.optimal.discrete_riccati import Undetermined, discrete_riccati
from solver.exact.optimal.minimal import minimal_solution
from solver.exact.optimal.riccati import NotStabilizable
from solver.exact.optimal.root_choices import OnTheAxis


def limit_of_the_recursion(
    A: sp.ImmutableMatrix, B: sp.ImmutableMatrix, Q: sp.ImmutableMatrix, R: sp.ImmutableMatrix, S: sp.ImmutableMatrix
) -> tuple[sp.ImmutableMatrix, sp.ImmutableMatrix | None] | None:
    """Return the limit (n×n), and the stabilizing solution where it is another one; None where nothing is known.

    Raises NotExact.
    """
    try:
        stabilizing = discrete_riccati(A, B, Q, R).stabilizing.P
    except (NotStabilizable, OnTheAxis, Undetermined):
        return None
    found = minimal_solution(A, B, Q, R, discrete=True)
    if found is None or _is_definite_on(S, found.unseen):
        return stabilizing, None
    return (found.P, stabilizing) if S.is_zero_matrix else None


def _is_definite_on(S: sp.ImmutableMatrix, V: sp.ImmutableMatrix) -> bool:
    """Whether VᵀSV is known to be positive definite, for S ≥ 0."""
    if S.free_symbols or V.free_symbols:
        raise NotExact("optimal/parameters")
    return bool((V.T * S * V).rank() == V.cols)
