"""Realizations in series and in a feedback loop, by their states together."""

from __future__ import annotations

import sympy as sp

from solver.exact.linear_algebra.affine import tidy
from solver.exact.linear_algebra.matrices import determinant, inverse, multiply
from solver.exact.representation.realization import Realization

Matrix = sp.ImmutableMatrix


def constant_realization(D: sp.ImmutableMatrix) -> Realization:
    """A matrix of numbers (p×m), which has no states."""
    return Realization(Matrix(0, 0, []), Matrix(0, D.cols, []), Matrix(D.rows, 0, []), D)


def in_series(first: Realization, second: Realization) -> Realization:
    """What `second` makes of the outputs of `first`: the states of the first above those of the second.

    x₁' = A₁x₁ + B₁u, x₂' = A₂x₂ + B₂(C₁x₁ + D₁u), y = C₂x₂ + D₂(C₁x₁ + D₁u).
    """
    n, k = first.A.rows, second.A.rows
    return Realization(
        _blocks([[first.A, sp.zeros(n, k)], [_times(second.B, first.C), second.A]]),
        _blocks([[first.B], [_times(second.B, first.D)]]),
        _blocks([[_times(second.D, first.C), second.C]]),
        Matrix(_times(second.D, first.D).applyfunc(tidy)),
    )


def fed_back(forward: Realization, back: Realization) -> Realization | None:
    """The loop e = r − H y, y = L e of L (`forward`) and H (`back`): the states of L above those of H.

    With E = (I + D_H D_L)⁻¹ it is e = E (r − C_H x_H − D_H C_L x_L). None where E does not exist.
    """
    L, H = forward, back
    n, k, m = L.A.rows, H.A.rows, L.B.cols
    through = Matrix(sp.eye(m) + _times(H.D, L.D))
    if determinant(through) == 0:
        return None
    E = inverse(through)
    seen = _blocks([[_times(H.D, L.C), H.C]])  # e = E (r − seen x)
    own = _blocks([[L.A, sp.zeros(n, k)], [_times(H.B, L.C), H.A]])
    inputs = _blocks([[_times(L.B, E)], [_times(H.B, _times(L.D, E))]])
    outputs = _blocks([[L.C, sp.zeros(L.C.rows, k)]])
    direct = _times(L.D, E)
    return Realization(
        Matrix((own - _times(inputs, seen)).applyfunc(tidy)),
        Matrix(inputs.applyfunc(tidy)),
        Matrix((outputs - _times(direct, seen)).applyfunc(tidy)),
        Matrix(direct.applyfunc(tidy)),
    )


def _times(left: sp.MatrixBase, right: sp.MatrixBase) -> sp.ImmutableMatrix:
    """The product, also of matrices without rows or columns."""
    if 0 in left.shape or 0 in right.shape:
        return Matrix(sp.zeros(left.rows, right.cols))
    return multiply(Matrix(left), Matrix(right))


def _blocks(rows: list[list[sp.MatrixBase]]) -> sp.ImmutableMatrix:
    """The matrix of these blocks, some without rows or columns."""
    lines = [sp.Matrix.hstack(*(sp.Matrix(block) for block in row)) for row in rows]
    return Matrix(sp.Matrix.vstack(*lines).applyfunc(tidy))
