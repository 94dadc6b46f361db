"""Controllable canonical form of a transfer matrix: companion blocks, one for each input."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

Polynomials = Sequence[Sequence[sp.Expr]]
Matrices = tuple[sp.ImmutableMatrix, sp.ImmutableMatrix, sp.ImmutableMatrix, sp.ImmutableMatrix]


def controllable_form(numerators: Polynomials, denominators: Polynomials, x: sp.Symbol) -> Matrices:
    """Return A, B, C, D of the p×m matrix of proper fractions N/D in x, not cancelled; exact.

    Each input has one companion block (the coefficients in its last row) of the least common denominator of its column;
    so for one input and one output the order is the degree of the denominator as given. Source: Kailath, Linear
    Systems (1980), section 2.1.
    """
    outputs, inputs = len(numerators), len(numerators[0])
    blocks, B_blocks, C_blocks = [], [], []
    D = sp.zeros(outputs, inputs)
    for j in range(inputs):
        common, tops = _over_common_denominator(
            [numerators[i][j] for i in range(outputs)], [denominators[i][j] for i in range(outputs)], x
        )
        a = list(reversed(common.all_coeffs()))[:-1]
        n = len(a)
        rows = []
        for i, top in enumerate(tops):
            b = _padded(top, n + 1)
            D[i, j] = b[n]
            rows.append([sp.cancel(b[k] - b[n] * a[k]) for k in range(n)])
        blocks.append(sp.Matrix(n, n, lambda i, k, a=a, n=n: -a[k] if i == n - 1 else int(k == i + 1)))
        B_blocks.append(sp.Matrix(n, 1, lambda i, _, n=n: int(i == n - 1)))
        C_blocks.append(sp.Matrix(outputs, n, [entry for row in rows for entry in row]))
    A, B, C = sp.diag(*blocks), sp.diag(*B_blocks), sp.Matrix.hstack(*C_blocks)
    return tuple(sp.ImmutableMatrix(M) for M in (A, B, C, D))  # type: ignore[return-value]  # four of them


def _over_common_denominator(
    tops: Sequence[sp.Expr], bottoms: Sequence[sp.Expr], x: sp.Symbol
) -> tuple[sp.Poly, list[sp.Poly]]:
    """Return the monic least common denominator of a column and the numerators over it."""
    polynomials, _ = sp.parallel_poly_from_expr([*tops, *bottoms], x, field=True)
    count = len(tops)
    common = polynomials[count].monic()
    for bottom in polynomials[count + 1 :]:
        common = common.lcm(bottom).monic()
    return common, [
        top * common.quo(bottom) for top, bottom in zip(polynomials[:count], polynomials[count:], strict=True)
    ]


def _padded(polynomial: sp.Poly, length: int) -> list[sp.Expr]:
    """Return the coefficients by rising power, filled up with zeros."""
    rising = list(reversed(polynomial.all_coeffs()))
    return rising + [sp.Integer(0)] * (length - len(rising))
