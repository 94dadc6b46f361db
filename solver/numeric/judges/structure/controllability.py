"""Controllability and its dual judged: Krylov's matrix, and hidden modes by their polynomial in an orthonormal basis.

The basis is found with so many digits that multiple modes at zero are told from small ones.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any

import mpmath
import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array, multiple
from solver.numeric.evaluation.compare import worst_of
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import PointSource, free_symbols
from solver.numeric.evaluation.values import NotEvaluable
from solver.numeric.judges.linear_algebra.eigen import spectrum_residual

DIGITS, CARRIED = 150, 160
"""Digits that are kept of what B does not reach, and with which it is found: those that are kept are right."""

DIGITS_OF_EIGENVALUES = 100

ZERO = mpmath.mpf(10) ** -25
NEAR = 1e-10
"""Eigenvalues nearer to the boundary of the region of stability count as on it."""


def krylov_matrix(A: Any, B: Any) -> Any:
    """Return [B, AB, …, Aⁿ⁻¹B], multiplied out by sympy."""
    blocks = [sp.Matrix(B)]
    for _ in range(A.rows - 1):
        blocks.append(A * blocks[-1])
    return sp.ImmutableMatrix(sp.Matrix.hstack(*blocks))


def hidden_modes_residual(A: Any, B: Any, modes: Sequence[Any]) -> float:
    """Return how far Π(x − λᵢ) is from the characteristic polynomial of what B does not reach, relatively.

    Infinite if the number of modes is wrong. Raises NotEvaluable.
    """
    symbols = free_symbols([A, B, list(modes)])
    worst = 0.0
    for point in PointSource(symbols).several(2 if symbols else 1):
        exact = {symbol: sp.Rational(value.real) for symbol, value in _complex(point).items()}
        H = _unreached(A.xreplace(exact), B.xreplace(exact))
        if len(modes) != H.rows:
            return float("inf")
        if H.rows:
            here = [mode.xreplace(exact) for mode in modes]
            worst = worst_of((worst, spectrum_residual(H, here)))
    return worst


def hidden_modes_decay(A: Any, B: Any, *, discrete: bool) -> bool:
    """Whether all that B does not reach decays, at random values of the parameters.

    Raises NotEvaluable where it depends on them.
    """
    symbols = free_symbols([A, B])
    found = set()
    for point in PointSource(symbols).several(5 if symbols else 1):
        exact = {symbol: sp.Rational(value.real) for symbol, value in _complex(point).items()}
        found.add(_decays(_unreached(A.xreplace(exact), B.xreplace(exact)), discrete=discrete))
    if len(found) > 1:
        raise NotEvaluable("it depends on the values of the parameters")
    return found.pop()


class HiddenPart:
    """What B does not reach at a point, as a matrix; None where B reaches less than for general parameters."""

    def __init__(self, A: Any, B: Any) -> None:
        self.A, self.B = A, B

    @cached_property
    def order(self) -> int:
        """How many modes B does not reach for general parameters."""
        points = PointSource(free_symbols([self.A, self.B])).several(2)
        exact = ({symbol: sp.Rational(value.real) for symbol, value in _complex(point).items()} for point in points)
        return min(self._at(point).rows for point in exact)

    def __call__(self, point: Mapping[Any, Any]) -> Any:
        """Return the matrix, exact where A and B are rational there."""
        found = self._at(point)
        return found if found.rows == self.order else None

    def _at(self, point: Mapping[Any, Any]) -> Any:
        A, B = (M.xreplace(dict(point)) for M in (self.A, self.B))
        if not all(entry.is_Rational for entry in (*A, *B)):
            return _unreached(A, B)
        rows = sp.Matrix(krylov_matrix(A, B)).T.nullspace()
        if not rows:
            return sp.ImmutableMatrix(0, 0, [])
        N = sp.Matrix.hstack(*rows).T
        return sp.ImmutableMatrix((N * N.T).LUsolve(N * A.T * N.T).T)


def _decays(H: Any, *, discrete: bool) -> bool:
    """Whether the eigenvalues are inside the region of stability; those that may be on its boundary are not."""
    if H.rows == 0:
        return True
    many = multiple(DIGITS_OF_EIGENVALUES)
    mp, M = many.context, value_of(H, Environment.at([{}], many)).value[0]
    values = mp.eig(mp.matrix(M.tolist()), right=False) if len(M) > 1 else [M[0, 0]]
    return all((abs(value) - 1 if discrete else mp.re(value)) < -NEAR * (1 + abs(value)) for value in values)


def _complex(point: Mapping[Any, Any]) -> dict[Any, complex]:
    return {symbol: complex(value) for symbol, value in point.items()}


def hidden_of_both_residual(A: Any, B: Any, C: Any, modes: Sequence[Any]) -> float:
    """Return what `hidden_modes_residual` does, for the modes that B does not reach or C does not see.

    B or C is None where it does not matter. Those are the modes that B does not reach, and of the part that it reaches
    those that C does not see.
    """
    symbols = free_symbols([A, list(modes), *(M for M in (B, C) if M is not None)])
    worst = 0.0
    for point in PointSource(symbols).several(2 if symbols else 1):
        exact = {symbol: sp.Rational(value.real) for symbol, value in _complex(point).items()}
        hidden, F, H = [], A.xreplace(exact), C.xreplace(exact) if C is not None else None
        if B is not None:
            hidden = [_unreached(F, B.xreplace(exact))]
            F, H = _restricted(F, B.xreplace(exact), H)
        if H is not None:
            hidden.append(_unreached(F.T, H.T))
        whole = sp.ImmutableMatrix(sp.diag(*hidden))
        if len(modes) != whole.rows:
            return float("inf")
        if whole.rows:
            worst = worst_of(
                (worst, spectrum_residual(whole, [(sp.Integer(0) + mode).xreplace(exact) for mode in modes]))
            )
    return worst


def _unreached(A: Any, B: Any) -> Any:
    """N A Nᴴ with orthonormal rows N of the complement of the span of B, AB, …, in decimals."""
    F, _, outside = _bases(A, B)
    return _in_basis(F, outside)


def _bases(A: Any, B: Any) -> tuple[Array, list[Array], list[Array]]:
    """Return A with many digits, an orthonormal basis of the span of B, AB, …, and one of its complement."""
    many = multiple(CARRIED)
    F, G = (value_of(M, Environment.at([{}], many)).value[0] for M in (A, B))
    noise = _noise(F)
    reached: list[Array] = []
    fresh = [G[:, j] for j in range(G.shape[1])]
    while fresh:
        added = [q for v in fresh if (q := _added(reached, v, many.context)) is not None]
        fresh = [v for q in added if float(np.max(many.size(v := F @ q))) > noise]
    whole = list(reached)
    unit = many.array(np.eye(len(F)))
    return F, reached, [q for j in range(len(F)) if (q := _added(whole, unit[:, j], many.context)) is not None]


def _noise(F: Array) -> float:
    return 1e-40 * float(np.max(multiple(CARRIED).size(F), initial=0.0))


def _in_basis(F: Array, basis: list[Array]) -> Any:
    """Qᴴ F Q in decimals."""
    k, noise = len(basis), _noise(F)
    rows = [[sum(a.conjugate() * b for a, b in zip(q, F @ p, strict=True)) for p in basis] for q in basis]
    return sp.ImmutableMatrix(k, k, [_decimal(entry) if abs(entry) > noise else 0 for row in rows for entry in row])


def _restricted(A: Any, B: Any, C: Any) -> tuple[Any, Any]:
    """Return A and C (or None) on the span of B, AB, …, in an orthonormal basis of it, in decimals."""
    F, reached, _ = _bases(A, B)
    if C is None or not reached:
        return _in_basis(F, reached), None
    H = value_of(C, Environment.at([{}], multiple(CARRIED))).value[0]
    columns = [H @ q for q in reached]
    seen = sp.ImmutableMatrix(len(H), len(columns), lambda i, j: _decimal(columns[j][i]))
    return _in_basis(F, reached), seen


def _added(basis: list[Array], v: Array, mp: Any) -> Array | None:
    """Make v orthonormal to the basis and append it; None if it lies in its span."""
    length = mp.sqrt(sum(abs(a) ** 2 for a in v))
    if length == 0:
        return None
    v = v / length
    for _ in range(2):  # twice is enough (Kahan)
        for q in basis:
            v = v - q * sum(a.conjugate() * b for a, b in zip(q, v, strict=True))
    length = mp.sqrt(sum(abs(a) ** 2 for a in v))
    if length < ZERO:
        return None
    basis.append(v / length)
    return basis[-1]


def _decimal(number: Any) -> Any:
    real = sp.Float(number.real, DIGITS)
    return real if not number.imag else real + sp.I * sp.Float(number.imag, DIGITS)
