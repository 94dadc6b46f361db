"""Realizations of a transfer matrix in companion form, exact, of the order of its uncancelled denominators.

With one input and one output G = N/χ + D, χ = xⁿ + aₙ₋₁xⁿ⁻¹ + … + a₀, N = bₙ₋₁xⁿ⁻¹ + … + b₀. With several there is a
block for each input (output), over the least common denominator of its column (row). Source: T. Kailath, Linear Systems
(1980), sections 2.1 and 6.1.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import sympy as sp

from solver.exact.linear_algebra.fields import expression
from solver.exact.representation.polynomials import companion, elements, expanded, least_common_multiple
from solver.exact.representation.transfer import TransferMatrix

Matrix = sp.ImmutableMatrix


@dataclass(frozen=True)
class Realization:
    """A n×n, B n×m, C p×n, D p×m; `sizes` are the orders of the diagonal blocks of A."""

    A: sp.ImmutableMatrix
    B: sp.ImmutableMatrix
    C: sp.ImmutableMatrix
    D: sp.ImmutableMatrix
    sizes: tuple[int, ...] = ()

    @property
    def dual(self) -> Realization:
        """Aᵀ, Cᵀ, Bᵀ, Dᵀ."""
        A, B, C, D = (Matrix(M.T) for M in (self.A, self.C, self.B, self.D))
        return Realization(A, B, C, D, self.sizes)


def controllable_realization(G: TransferMatrix, *, first_row: bool = False) -> Realization:
    """Companion blocks, one for each input; the coefficients in the last row, or (states in reverse) in the first."""
    outputs, inputs = G.shape
    blocks, columns = [], []
    for j in range(inputs):
        common = least_common_multiple(row[j] for row in G.bottoms)
        n, K = common.degree(), common.domain
        tops = [elements(G.remainders[i][j] * common.quo(G.bottoms[i][j]), n) for i in range(outputs)]
        block = companion(common)
        numerators = sp.Matrix(outputs, n, [expression(K, c) for row in tops for c in row])
        blocks.append(block[::-1, ::-1] if first_row else block)
        columns.append(numerators[:, ::-1] if first_row else numerators)
    sizes = [block.rows for block in blocks]
    unit = [sp.Matrix(n, 1, lambda i, _, n=n: sp.Integer(int(i == (0 if first_row else n - 1)))) for n in sizes]
    return Realization(
        Matrix(sp.diag(*blocks)),
        Matrix(sp.diag(*unit)),
        Matrix(sp.Matrix.hstack(*columns)),
        G.direct,
        tuple(sizes),
    )


def observable_realization(G: TransferMatrix, *, first_row: bool = False) -> Realization:
    """The dual of the controllable form of Gᵀ."""
    transposed = replace(G, tops=tuple(zip(*G.tops, strict=True)), bottoms=tuple(zip(*G.bottoms, strict=True)))
    return controllable_realization(transposed, first_row=first_row).dual


def common_denominators(
    G: TransferMatrix, *, by_rows: bool = False
) -> list[tuple[list[tuple[sp.Expr, sp.Expr]], list[sp.Expr], sp.Expr]]:
    """For each column (row) of G − D: its fractions, the numerators over their common denominator, and this."""
    tops, bottoms = ((list(rows) if by_rows else list(zip(*rows, strict=True))) for rows in (G.remainders, G.bottoms))
    found = []
    for numerators, denominators in zip(tops, bottoms, strict=True):
        common = least_common_multiple(denominators)
        over = [expanded(p * common.quo(q)) for p, q in zip(numerators, denominators, strict=True)]
        pairs = [(expanded(p), expanded(q)) for p, q in zip(numerators, denominators, strict=True)]
        found.append((pairs, over, expanded(common)))
    return found
