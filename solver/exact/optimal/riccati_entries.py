"""The entries of a Riccati equation multiplied out."""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.fields import domain_matrix
from solver.exact.optimal.weighting import block_matrix


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


def discrete_riccati_entries(
    A: sp.ImmutableMatrix, B: sp.ImmutableMatrix, Q: sp.ImmutableMatrix, R: sp.ImmutableMatrix, P: sp.ImmutableMatrix
) -> tuple[sp.Expr, sp.ImmutableMatrix]:
    """δ = det(R + BᵀPB), and δ (Q + AᵀPA − P − AᵀPB (R + BᵀPB)⁻¹ BᵀPA) (n×n), polynomials in the entries of P."""
    n, m = B.shape
    blocks = [[A, B, Q], [sp.zeros(m, n), R, sp.zeros(m, n)]]
    numbers = domain_matrix(block_matrix(blocks))
    ring = numbers.domain[tuple(sorted(P.free_symbols, key=str))]
    rows = [[ring.ring.ground_new(c) for c in row] for row in numbers.to_list()]
    known = DomainMatrix(rows, numbers.shape, ring)
    a, b, q, r = known[:n, :n], known[:n, n : n + m], known[:n, n + m :], known[n:, n : n + m]
    p = DomainMatrix([[ring.from_sympy(entry) for entry in row] for row in P.tolist()], (n, n), ring).to_dense()
    weight = (r + b.transpose() * p * b).to_dense()
    delta, adjugate = _determinant_and_adjugate(weight)
    seen = b.transpose() * p * a
    found = (q + a.transpose() * p * a - p) * delta - seen.transpose() * adjugate * seen
    entries = [ring.to_sympy(entry) for row in found.to_dense().to_list() for entry in row]
    return sp.expand(ring.to_sympy(delta)), sp.ImmutableMatrix(n, n, entries).applyfunc(sp.expand)


def riccati_weight(B: sp.ImmutableMatrix, R: sp.ImmutableMatrix, P: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    """R + BᵀPB (m×m) multiplied out."""
    return expanded(R + B.T * P * B)


def expanded(M: sp.MatrixBase) -> sp.ImmutableMatrix:
    """The entries multiplied out, but not what stands under a root of parameters."""
    return sp.ImmutableMatrix(M.applyfunc(expanded_around_roots))


def expanded_around_roots(value: sp.Expr) -> sp.Expr:
    """The expression multiplied out, but not what stands under a root of parameters."""
    half = sp.Rational(1, 2)
    roots = {each: sp.Dummy() for each in value.atoms(sp.Pow) if each.exp == half and each.free_symbols}
    if not roots:
        return sp.expand(value)
    squares = {dummy: root.base for root, dummy in roots.items()}
    x = sp.Poly(sp.expand(value.xreplace(roots)), *squares)
    terms = []
    for powers, c in x.terms():
        parts = zip(squares.items(), powers, strict=True)
        terms.append(c * sp.Mul(*(square ** (power // 2) * dummy ** (power % 2) for (dummy, square), power in parts)))
    back = {dummy: root for root, dummy in roots.items()}
    return sp.expand(sp.Add(*terms)).xreplace(back)


def _determinant_and_adjugate(M: DomainMatrix) -> tuple[Any, DomainMatrix]:
    """Of a square matrix over a ring; of order 1 without any division."""
    if M.shape == (1, 1):
        return M.to_list()[0][0], DomainMatrix.eye(1, M.domain).to_dense()
    adjugate, determinant = M.adj_det()
    return determinant, adjugate.to_dense()
