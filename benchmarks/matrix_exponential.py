"""The matrix exponential e^{At}: ours, sympy's `Matrix.exp`, and the inverse Laplace transform entry by entry."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from benchmarks.matrices import companion, companion_of_integers, dense, x
from benchmarks.timing import Row, milliseconds, once, side_by_side
from solver import exact

t, s = sp.Symbol("t"), sp.Symbol("s")
positive_t = sp.Symbol("t", positive=True)  # the peers are up to three times faster with it

TARGETS = {3: (4, 15, 3), 6: (5, 40, 13), 10: (5, 60, 60)}
"""By the order n: times faster than `Matrix.exp`, than the inverse Laplace transform; milliseconds at most."""


def ours(A: sp.ImmutableMatrix) -> sp.ImmutableMatrix:
    """e^{At}."""
    Phi: sp.ImmutableMatrix = exact.exponential(A, t).matrix
    return Phi


def sympy_exponential(A: sp.ImmutableMatrix) -> sp.Matrix:
    """e^{At} by sympy's Jordan form."""
    return (sp.Matrix(A) * positive_t).exp()


def entrywise_inverse_laplace(A: sp.ImmutableMatrix) -> sp.Matrix:
    """e^{At} by the inverse Laplace transform of every entry of (sI − A)⁻¹."""
    resolvent = (s * sp.eye(A.rows) - sp.Matrix(A)).inv()
    return resolvent.applyfunc(lambda entry: sp.inverse_laplace_transform(entry, s, positive_t))


def rows(*, quick: bool = False) -> Iterator[Row]:
    """The lines of the table; `quick` leaves out the peers that take seconds."""
    for n, (faster, than_transform, at_most) in TARGETS.items():
        A = companion_of_integers(n)
        mine, peer = side_by_side(lambda A=A: ours(A), lambda A=A: sympy_exponential(A))
        yield Row(f"e^(At), companion, n = {n}", mine, "sympy (A*t).exp()", peer, faster, at_most)
        if not quick:
            peer = once(lambda A=A: entrywise_inverse_laplace(A))
            yield Row(f"e^(At), companion, n = {n}", mine, "sympy inverse Laplace, entrywise", peer, than_transform)
    A = dense(6)
    mine, peer = side_by_side(lambda: ours(A), lambda: sympy_exponential(A))
    yield Row("e^(At), dense, n = 6", mine, "sympy (A*t).exp()", peer, 5, 13)
    for name, polynomial in (("cubic x³ + x + 1", x**3 + x + 1), ("quartic x⁴ + x + 1", x**4 + x + 1)):
        A = companion(polynomial)
        yield Row(f"e^(At), irreducible {name}", milliseconds(lambda A=A: ours(A)), at_most=30)
