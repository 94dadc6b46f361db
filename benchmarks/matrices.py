"""The matrices that are timed."""

from __future__ import annotations

from random import Random

import sympy as sp

x = sp.Symbol("x")


def companion(polynomial: sp.Expr) -> sp.ImmutableMatrix:
    """The companion matrix (ones above the diagonal, coefficients in the last row) of a monic polynomial in x."""
    _, *low = sp.Poly(polynomial, x).all_coeffs()
    n = len(low)
    return sp.ImmutableMatrix(n, n, lambda i, j: -low[n - 1 - j] if i == n - 1 else int(j == i + 1))


def companion_of_integers(n: int) -> sp.ImmutableMatrix:
    """The companion matrix of (x + 1)(x + 2)…(x + n)."""
    return companion(sp.prod([x + i for i in range(1, n + 1)]))


def dense(n: int) -> sp.ImmutableMatrix:
    """A full matrix with the eigenvalues −1, …, −n: a diagonal one after a unimodular similarity."""
    lower = sp.Matrix(n, n, lambda i, j: 1 if i == j else ((2 * i + j) % 3 - 1 if i > j else 0))
    upper = sp.Matrix(n, n, lambda i, j: 1 if i == j else ((i + 2 * j) % 3 - 1 if i < j else 0))
    T = lower * upper
    return sp.ImmutableMatrix(T * sp.diag(*range(-n, 0)) * T.inv())


def random_rational(rows: int, columns: int, seed: int) -> sp.ImmutableMatrix:
    """Entries p/q with |p| ≤ 9 and q ≤ 4."""
    source = Random(seed)
    return sp.ImmutableMatrix(
        rows, columns, lambda *_: sp.Rational(source.choice([*range(-9, 0), *range(1, 10)]), source.randint(1, 4))
    )


def random_integers(rows: int, columns: int, seed: int) -> sp.ImmutableMatrix:
    """Entries from −5 to 5."""
    source = Random(seed)
    return sp.ImmutableMatrix(rows, columns, lambda *_: source.randint(-5, 5))
