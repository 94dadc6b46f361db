"""Random systems with a chosen Jordan structure, for hypothesis."""

import sympy as sp
from hypothesis import strategies as st

eigenvalues = st.sampled_from([sp.Rational(p, q) for p in range(-4, 3) for q in (1, 2)])


def real_block(sigma: sp.Rational, omega: sp.Rational, size: int) -> sp.Matrix:
    """The real Jordan block of the pair σ ± jω, of multiplicity `size`."""
    block = sp.zeros(2 * size)
    for i in range(size):
        block[2 * i : 2 * i + 2, 2 * i : 2 * i + 2] = sp.Matrix([[sigma, omega], [-omega, sigma]])
        if i:
            block[2 * i - 2 : 2 * i, 2 * i : 2 * i + 2] = sp.eye(2)
    return block


def jordan_block(value: sp.Rational, size: int) -> sp.Matrix:
    """The upper Jordan block of a real eigenvalue."""
    return sp.Matrix(size, size, lambda i, j: value if i == j else int(j == i + 1))


@st.composite
def unimodular(draw: st.DrawFn, n: int) -> sp.Matrix:
    """An integer matrix of determinant 1, as a product of a lower and an upper triangular one."""
    entries = st.integers(-1, 1)
    lower = sp.Matrix(n, n, lambda i, j: 1 if i == j else (draw(entries) if i > j else 0))
    upper = sp.Matrix(n, n, lambda i, j: 1 if i == j else (draw(entries) if i < j else 0))
    return lower * upper


@st.composite
def systems(draw: st.DrawFn, largest: int = 6, *, defective: bool = True) -> sp.ImmutableMatrix:
    """A rational matrix n×n, 1 ≤ n ≤ `largest`, made from Jordan blocks (real ones for conjugate pairs)."""
    n = draw(st.integers(1, largest))
    blocks: list[sp.Matrix] = []
    left = n
    while left:
        size = draw(st.integers(1, min(left, 3))) if defective else 1
        if left >= 2 * size and draw(st.booleans()):
            omega = draw(st.sampled_from([sp.Integer(1), sp.Integer(2), sp.Rational(1, 2)]))
            blocks.append(real_block(draw(eigenvalues), omega, size))
        else:
            blocks.append(jordan_block(draw(eigenvalues), size))
        left -= blocks[-1].rows
    T = draw(unimodular(n))
    return sp.ImmutableMatrix(T * sp.diag(*blocks) * T.inv())
