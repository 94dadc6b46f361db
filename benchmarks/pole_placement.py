"""Ackermann's formula with rational numbers: ours, and the textbook formula on sympy matrices."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from benchmarks.matrices import random_rational, x
from benchmarks.timing import Failure, Row, side_by_side
from solver import exact


def textbook(A: sp.Matrix, b: sp.Matrix, coefficients: list[sp.Rational]) -> sp.Matrix:
    """K = [0 … 0 1] 𝒞⁻¹ φ(A) as printed."""
    n = A.rows
    controllability = sp.Matrix.hstack(*(A**i * b for i in range(n)))
    phi = sum((c * A ** (n - i) for i, c in enumerate(coefficients)), sp.zeros(n))
    last = sp.Matrix(1, n, lambda _, j: int(j == n - 1))
    return last * controllability.inv() * phi


def rows() -> Iterator[Row | Failure]:
    """Return the lines of the table, n = 3 … 12."""
    place = getattr(exact, "ackermann", None)
    if place is None:
        yield Failure("Ackermann, n = 3 … 12", "solver.exact has no `ackermann` yet")
        return
    for n in (3, 4, 6, 8, 10, 12):
        A, b = random_rational(n, n, seed=n), random_rational(n, 1, seed=100 + n)
        coefficients = sp.Poly(sp.prod([x + i for i in range(1, n + 1)]), x).all_coeffs()
        M, column = sp.Matrix(A), sp.Matrix(b)
        mine, peer = side_by_side(
            lambda A=A, b=b, c=coefficients: place(A, b, c),
            lambda M=M, column=column, c=coefficients: textbook(M, column, c),
        )
        yield Row(f"Ackermann, rationals, n = {n}", mine, "textbook formula, sympy Matrix", peer, 10)
