"""The control of least energy that takes x(0) = x₀ to x(T) = x_f, from the weighted controllability Gramian.

W(T) = ∫₀ᵀ e^{At} B R⁻¹ Bᵀ e^{Aᵀt} dt. The state x_f is reached if and only if d = x_f − e^{AT} x₀ lies in the image of
W, which is that of [B, AB, …]; then u = R⁻¹ Bᵀ e^{Aᵀ(T−t)} η with W η = d, and ∫ uᵀ R u dt = dᵀ η.
Source: R. W. Brockett, Finite Dimensional Linear Systems (1970), section 22.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.exact.functions.closed_forms import exponential
from solver.exact.linear_algebra.fields import domain_matrix, matrix_of
from solver.exact.optimal.weighting import weighted_transpose
from solver.exact.structure.controllability import controllability_matrix
from solver.exact.structure.decomposition import independent_columns
from solver.exact.structure.gramian import finite_gramian
from solver.exact.structure.ranks import hidden_part
from solver.exact.variations.exponential_sums import (
    ExponentialSum,
    Rows,
    determinant_and_adjugate,
    multiplied,
    read_matrix,
)
from solver.exact.variations.quotients import quotient


class NotReachable(Exception):  # noqa: N818 - a finding
    """Rows q with q e^{At} B = 0 at all times, for which q (x_f − e^{AT} x₀), the `values`, is not zero."""

    def __init__(self, rows: sp.ImmutableMatrix, values: tuple[sp.Expr, ...]) -> None:
        super().__init__(str(values))
        self.rows, self.values = rows, values


@dataclass(frozen=True)
class MinimumEnergy:
    """What the control is made of, t from 0 to T: `transition` is e^{At}, `drift` e^{AT} x₀, `gap` x_f − e^{AT} x₀.

    `eta` solves W η = `gap`; it is the only solution if `unreached` (rows q with q W = 0) is empty. `energy` is
    ∫ uᵀ R u dt, `adjoint` e^{Aᵀ(T−t)} η, `start` its value at 0, and `spread` W(t) e^{−Aᵀt}, the part of x(t) that is
    linear in it: x = e^{At} x₀ + `spread` · `start`. Inputs are a column.
    """

    transition: sp.ImmutableMatrix
    drift: sp.ImmutableMatrix
    gap: sp.ImmutableMatrix
    gramian: sp.ImmutableMatrix
    eta: sp.ImmutableMatrix
    unreached: sp.ImmutableMatrix
    u: sp.ImmutableMatrix
    x: sp.ImmutableMatrix
    adjoint: sp.ImmutableMatrix
    start: sp.ImmutableMatrix
    spread: sp.ImmutableMatrix
    energy: sp.Expr


def minimum_energy(
    A: sp.ImmutableMatrix,
    B: sp.ImmutableMatrix,
    R: sp.ImmutableMatrix,
    ends: tuple[sp.ImmutableMatrix, sp.ImmutableMatrix],
    T: sp.Expr,
) -> MinimumEnergy:
    """Return it for A n×n, B n×m, R m×m > 0 and the ends x₀, x_f (n×1).

    Raises NotReachable, and NotExact where the spectrum of A has no usable form.
    """
    t = sp.Symbol("t")
    times: set[Any] = {t, *T.free_symbols}
    x0, xf = ends
    e = exponential(A, t).matrix
    at_end = e.xreplace({t: T})
    drift = _multiplied_out(at_end, x0, times)
    gap = sp.ImmutableMatrix((xf - drift).applyfunc(sp.expand))
    unreached = _unreached(A, B, gap, times)
    V = _inverse(R)
    W = finite_gramian(A, B, T, V)
    basis = _reached_basis(A, B)
    numerators, D = _solved(W, basis, gap, times)
    turned = read_matrix(e.T.xreplace({t: sp.expand(T - t)}), times)
    eta = _over(numerators, D)
    adjoint = multiplied(turned, numerators)
    law = sp.ImmutableMatrix(weighted_transpose(B, R))
    u = multiplied(read_matrix(law, times), adjoint)
    so_far = read_matrix(finite_gramian(A, B, t, V), times)
    motion = multiplied(so_far, adjoint)
    spread = multiplied(so_far, read_matrix(e.T.xreplace({t: -t}), times))
    free = multiplied(read_matrix(e, times), read_matrix(x0, times))
    x = [[(free[i][0] * D) + motion[i][0]] for i in range(A.rows)]
    start = multiplied(read_matrix(at_end.T, times), numerators)
    energy = multiplied(read_matrix(gap.T, times), numerators)[0][0]
    return MinimumEnergy(
        e, drift, gap, W, eta, unreached, _over(u, D), _over(x, D), _over(adjoint, D), _over(start, D),
        _each(spread), quotient(energy, D, rising=True),
    )  # fmt: skip


def _inverse(R: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    return matrix_of(domain_matrix(R).inv())


def _multiplied_out(M: sp.MatrixBase, v: sp.MatrixBase, times: Iterable[sp.Symbol]) -> sp.ImmutableMatrix:
    """M v, written as sums."""
    return _each(multiplied(read_matrix(M, times), read_matrix(v, times)))


def _each(M: Rows) -> sp.ImmutableMatrix:
    """A matrix of sums as it is written."""
    one = ExponentialSum.constant(sp.S.One)
    return sp.ImmutableMatrix([[quotient(entry, one) for entry in row] for row in M])


def _unreached(
    A: sp.ImmutableMatrix, B: sp.ImmutableMatrix, gap: sp.ImmutableMatrix, times: set[sp.Symbol]
) -> sp.ImmutableMatrix:
    """Rows that annihilate what is reached; raises NotReachable where one does not annihilate the gap."""
    hidden = hidden_part(A, B)
    if hidden is None:
        return sp.ImmutableMatrix(0, A.rows, [])
    left = multiplied(read_matrix(hidden.N, times), read_matrix(gap, times))
    missed = [i for i, row in enumerate(left) if row[0]]
    if missed:
        one = ExponentialSum.constant(sp.S.One)
        rows = sp.ImmutableMatrix(hidden.N.extract(missed, list(range(A.rows))))
        raise NotReachable(rows, tuple(quotient(left[i][0], one) for i in missed))
    return hidden.N


def _reached_basis(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    """Columns of [B, AB, …] that span what is reached; the identity where that is everything."""
    reached = controllability_matrix(A, B)
    columns = independent_columns(reached)
    if len(columns) == A.rows:
        return sp.ImmutableMatrix(sp.eye(A.rows))
    return sp.ImmutableMatrix(reached.extract(list(range(A.rows)), list(columns)))


def _solved(
    W: sp.ImmutableMatrix, basis: sp.ImmutableMatrix, gap: sp.ImmutableMatrix, times: set[sp.Symbol]
) -> tuple[Rows, ExponentialSum]:
    """η = V ζ with (Vᵀ W V) ζ = Vᵀ d, as numerators over one denominator."""
    V, Vt = read_matrix(basis, times), read_matrix(basis.T, times)
    inner = multiplied(multiplied(Vt, read_matrix(W, times)), V)
    D, adjugate = determinant_and_adjugate(inner)
    return multiplied(V, multiplied(adjugate, multiplied(Vt, read_matrix(gap, times)))), D


def _over(numerators: Rows, D: ExponentialSum) -> sp.ImmutableMatrix:
    """A column of sums over one denominator, each in its own shortest form."""
    return sp.ImmutableMatrix([quotient(row[0], D, rising=True) for row in numerators])
