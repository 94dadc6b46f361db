"""The smallest positive semidefinite solution of a Riccati equation: the cost where the state need not go to zero.

What Q does not see of the state costs nothing while it is left alone, so the solution vanishes there; of the rest it is
the stabilizing solution, the only one that is positive semidefinite.
Source: H. L. Trentelman, A. A. Stoorvogel, M. Hautus, Control Theory for Linear Systems (2001), chapter 10.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from solver.exact.linear_algebra.fields import domain_matrix, matrix_of
from solver.exact.optimal.discrete_riccati import discrete_riccati
from solver.exact.optimal.riccati import is_stable, riccati
from solver.exact.structure.ranks import hidden_part, null_basis


@dataclass(frozen=True)
class MinimalSolution:
    """The solution P (n×n), columns that span what Q does not see, and the eigenvalues there that do not decay."""

    P: sp.ImmutableMatrix
    unseen: sp.ImmutableMatrix
    modes: list[sp.Expr]


def minimal_solution(
    A: sp.ImmutableMatrix,
    B: sp.ImmutableMatrix,
    Q: sp.ImmutableMatrix,
    R: sp.ImmutableMatrix,
    *,
    discrete: bool = False,
) -> MinimalSolution | None:
    """Return it for A n×n, B n×m, Q n×n ≥ 0, R m×m > 0; None where it is the stabilizing one. Raises NotExact."""
    hidden = hidden_part(sp.ImmutableMatrix(A.T), Q)
    modes = [mode for mode in hidden.spectrum.eigenvalues if not is_stable(mode, discrete=discrete)] if hidden else []
    if hidden is None or not modes:
        return None
    unseen = sp.ImmutableMatrix(hidden.N.T)
    if hidden.N.rows == A.rows:
        return MinimalSolution(sp.ImmutableMatrix(sp.zeros(*A.shape)), unseen, modes)
    echelon, pivots = domain_matrix(null_basis(hidden.N).T).rref()
    L = matrix_of(echelon)  # its pivot columns are those of the identity, so A, B, Q of L x are read off
    seen_A, seen_B = (sp.ImmutableMatrix(M.applyfunc(sp.cancel)) for M in ((L * A)[:, list(pivots)], L * B))
    seen_Q = sp.ImmutableMatrix(Q.extract(list(pivots), list(pivots)))
    P = (discrete_riccati if discrete else riccati)(seen_A, seen_B, seen_Q, R).stabilizing.P
    return MinimalSolution(sp.ImmutableMatrix((L.T * P * L).expand()), unseen, modes)
