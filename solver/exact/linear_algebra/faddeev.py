"""Faddeev–LeVerrier: the characteristic polynomial and the adjugate together, without a division but by integers.

N₀ = I, aₖ = −tr(A Nₖ₋₁)/k, Nₖ = A Nₖ₋₁ + aₖ I; then χ(x) = Σ aₖ x^{n−k} (a₀ = 1), adj(xI − A) = Σ Nₖ x^{n−1−k}.
Source: F. R. Gantmacher, The Theory of Matrices I, chapter IV §5.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from math import lcm
from operator import mul
from typing import Any

import sympy as sp
from sympy import QQ
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.fields import domain_matrix, expression, in_powers, matrix_of


@dataclass(frozen=True)
class FaddeevLeVerrier:
    """χ and adj of xI − A over K: `chi` = (1, a₁, …, aₙ), highest power first; `N` = (N₀, …, Nₙ₋₁), n×n."""

    chi: tuple[Any, ...]
    N: tuple[DomainMatrix, ...]
    domain: Any

    @cached_property
    def coefficients(self) -> tuple[sp.Expr, ...]:
        """1, a₁, …, aₙ as expressions."""
        return tuple(expression(self.domain, c) for c in self.chi)

    @cached_property
    def adjugate_coefficients(self) -> tuple[sp.ImmutableMatrix, ...]:
        """N₀, …, Nₙ₋₁ as matrices."""
        return tuple(matrix_of(N) for N in self.N)

    def characteristic_polynomial(self, x: sp.Symbol) -> sp.Expr:
        """χ(x) = det(xI − A), expanded."""
        return in_powers(self.chi, self.domain, x)

    def adjugate(self, x: sp.Symbol) -> sp.ImmutableMatrix:
        """adj(xI − A), entries expanded in x."""
        if x not in self._adjugates:
            self._adjugates[x] = self._adjugate(x)
        return self._adjugates[x]

    @cached_property
    def _adjugates(self) -> dict[sp.Symbol, sp.ImmutableMatrix]:
        return {}

    def _adjugate(self, x: sp.Symbol) -> sp.ImmutableMatrix:
        n = len(self.N)
        flat = zip(*(N.to_list_flat() for N in self.N), strict=True)
        return sp.ImmutableMatrix(n, n, [in_powers(entry, self.domain, x) for entry in flat])


@lru_cache(maxsize=64)
def faddeev_leverrier(A: sp.ImmutableMatrix) -> FaddeevLeVerrier:
    """Run the recursion for A (n×n)."""
    M = domain_matrix(A, real=False)
    K, n = M.domain, A.rows
    if K.is_QQ:
        return _over_integers(M)
    identity = DomainMatrix.eye(n, K).to_dense()
    N, chi, coefficients = identity, [K.one], []
    for k in range(1, n + 1):
        coefficients.append(N)
        AN = M * N
        rows = AN.to_list()
        a = -sum((rows[i][i] for i in range(n)), K.zero) / K(k)
        chi.append(a)
        N = AN + identity * a
    return FaddeevLeVerrier(tuple(chi), tuple(coefficients), K)


def _over_integers(M: DomainMatrix) -> FaddeevLeVerrier:
    """The recursion for F = dM, d the common denominator: all its numbers are integers, N_k = N_k(F)/dᵏ."""
    rows, n = M.to_list(), M.shape[0]
    d = lcm(*(int(x.denominator) for row in rows for x in row))
    F = [[int(x.numerator) * (d // int(x.denominator)) for x in row] for row in rows]
    N = [[int(i == j) for j in range(n)] for i in range(n)]
    chi, coefficients, scale = [QQ.one], [], 1
    for k in range(1, n + 1):
        coefficients.append(DomainMatrix([[QQ(x, scale) for x in row] for row in N], (n, n), QQ))
        columns = list(zip(*N, strict=True))
        N = [[sum(map(mul, row, column)) for column in columns] for row in F]
        a = -sum(N[i][i] for i in range(n)) // k
        for i in range(n):
            N[i][i] += a
        scale *= d
        chi.append(QQ(a, scale))
    return FaddeevLeVerrier(tuple(chi), tuple(coefficients), QQ)
