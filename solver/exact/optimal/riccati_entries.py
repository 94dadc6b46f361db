"""The entries of a Riccati equation multiplied out."""

from __future__ import annotations

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.fields import domain_matrix


def riccati_entries(
    A: sp.ImmutableMatrix, G: sp.ImmutableMatrix, Q: sp.ImmutableMatrix, P: sp.ImmutableMatrix
) -> sp.ImmutableMatrix:
    """AᵀP + PA − PGP + Q (n×n) for a symmetric matrix P of unknowns; raises NotExact."""
    n = A.rows
    known = domain_matrix(sp.ImmutableMatrix(sp.Matrix.hstack(*map(sp.Matrix, (A, G, Q)))))
    if not known.domain.is_QQ:
        return sp.ImmutableMatrix((A.T * P + P * A - P * G * P + Q).expand())
    ring = known.domain[tuple(sorted(P.free_symbols, key=str))]
    a, g, q = (known[:, i * n : (i + 1) * n].convert_to(ring) for i in range(3))
    p = DomainMatrix([[ring.from_sympy(entry) for entry in row] for row in P.tolist()], (n, n), ring)
    rows = (a.transpose() * p + p * a - p * g * p + q).to_dense().to_list()
    return sp.ImmutableMatrix(n, n, [ring.to_sympy(entry) for row in rows for entry in row])
