"""The discrete regulator over N steps: the Riccati difference equation run back from the end, exactly."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from solver.exact.linear_algebra.affine import tidy
from solver.exact.linear_algebra.fields import matrix_of, side_by_side


@dataclass(frozen=True)
class Recursion:
    """P₀ … P_N (n×n) and K₀ … K_{N−1} (m×n), and x₀ … x_N, u₀ … u_{N−1} where a start is given."""

    P: tuple[sp.ImmutableMatrix, ...]
    K: tuple[sp.ImmutableMatrix, ...]
    x: tuple[sp.ImmutableMatrix, ...] = ()
    u: tuple[sp.ImmutableMatrix, ...] = ()


def riccati_recursion(
    A: sp.ImmutableMatrix,
    B: sp.ImmutableMatrix,
    Q: sp.ImmutableMatrix,
    R: sp.ImmutableMatrix,
    S: sp.ImmutableMatrix,
    steps: int,
    x0: sp.ImmutableMatrix | None = None,
) -> Recursion:
    """P_k = Q + AᵀP_{k+1}(A − BK_k), K_k = (R + BᵀP_{k+1}B)⁻¹BᵀP_{k+1}A from P_N = S back, N = `steps`.

    Raises NotExact where the entries have no common field.
    """
    Ps: list[sp.ImmutableMatrix] = [S]
    Ks: list[sp.ImmutableMatrix] = []
    for _ in range(steps):
        a, b, q, r, p = side_by_side(A, B, Q, R, Ps[0])
        K = (r + b.transpose() * p * b).lu_solve(b.transpose() * p * a)
        Ks.insert(0, matrix_of(K))
        Ps.insert(0, matrix_of(q + a.transpose() * p * (a - b * K)))
    if x0 is None:
        return Recursion(tuple(Ps), tuple(Ks))
    x: list[sp.ImmutableMatrix] = [x0]
    u: list[sp.ImmutableMatrix] = []
    for gain in Ks:
        u.append(sp.ImmutableMatrix((-gain * x[-1]).applyfunc(tidy)))
        x.append(sp.ImmutableMatrix((A * x[-1] + B * u[-1]).applyfunc(tidy)))
    return Recursion(tuple(Ps), tuple(Ks), tuple(x), tuple(u))
