"""A realization of a transfer function for the judges: one companion block for each of its entries."""

from __future__ import annotations

import sympy as sp

Block = tuple[sp.Matrix, sp.Matrix, sp.Matrix, sp.Expr]


def realized(G: sp.ImmutableMatrix, variable: sp.Symbol) -> tuple[sp.ImmutableMatrix, ...]:
    """A, B, C, D with states in parallel, those of each entry of G in lowest terms: from rest, they do as G does."""
    p, m = G.shape
    A: list[sp.Matrix] = []
    B, C, D = sp.zeros(0, m), sp.zeros(p, 0), sp.zeros(p, m)
    for i in range(p):
        for j in range(m):
            block, last, above, D[i, j] = _block(G[i, j], variable)
            n = block.rows
            A.append(block)
            B = B.col_join(sp.zeros(n, j).row_join(last).row_join(sp.zeros(n, m - j - 1)))
            C = C.row_join(sp.zeros(i, n).col_join(above).col_join(sp.zeros(p - i - 1, n)))
    return tuple(sp.ImmutableMatrix(M) for M in (sp.diag(*A), B, C, D))


def _block(entry: sp.Expr, x: sp.Symbol) -> Block:
    """The companion matrix of the denominator, made monic; what of the numerator is of its degree is D."""
    top, bottom = (sp.Poly(each, x) for each in sp.fraction(sp.together(entry)))
    n, lead = bottom.degree(), bottom.LC()
    below = [c / lead for c in reversed(bottom.all_coeffs())][:n]
    above = [top.coeff_monomial(x**i) / lead for i in range(n + 1)]
    companion = sp.Matrix(n, n, lambda i, j: -below[j] if i == n - 1 else sp.Integer(int(j == i + 1)))
    last = sp.Matrix(n, 1, lambda i, _: sp.Integer(int(i == n - 1)))
    return companion, last, sp.Matrix(1, n, [above[i] - above[n] * below[i] for i in range(n)]), above[n]
