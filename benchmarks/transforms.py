"""Inverse Laplace and z-transforms of order six: ours, and sympy's."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from benchmarks.timing import Row, milliseconds, once
from solver import exact

t, s, k, z = sp.symbols("t s k z")
positive_t = sp.Symbol("t", positive=True)  # the peer is quicker with it

REPEATED = 10 / ((s + 1) * (s + 3) * (s**2 + 2 * s + 5) ** 2)
"""Order six, a complex pair twice."""

SAMPLED = z * (z + 1) / ((z - 1) * (z + sp.Rational(1, 3)) * (z**2 - z + sp.Rational(1, 2)) ** 2)
"""The same of a sequence."""


def ours(F: sp.Expr) -> sp.Expr:
    """The function of time, and the partial fractions."""
    (term,) = exact.read_image(F, s)
    if term.image.proper is not None:
        term.image.proper.partial_fractions(s)
    function: sp.Expr = term.image.function(t)
    return function


def our_sequence(F: sp.Expr) -> sp.Expr:
    """The sequence, and the partial fractions of F/z."""
    (term,) = exact.read_sequence_image(F, z)
    if term.image.divided.proper is not None:
        term.image.divided.proper.partial_fractions(z)
    function: sp.Expr = term.image.function(k)
    return function


def by_residues(F: sp.Expr) -> sp.Expr:
    """sympy has no inverse z-transform: the residues of F z^{k−1} at the roots of the denominator."""
    positive = sp.Symbol("k", positive=True, integer=True)
    kernel = F * z ** (positive - 1)
    return sp.Add(*(sp.residue(kernel, z, root) for root in sp.roots(sp.denom(sp.together(F)), z)))


def rows(*, quick: bool = False) -> Iterator[Row]:
    """The lines of the table; `quick` leaves out the peer, which takes seconds."""
    mine = milliseconds(lambda: ours(REPEATED))
    sampled = milliseconds(lambda: our_sequence(SAMPLED))
    if quick:
        yield Row("inverse Laplace, order 6, pair twice", mine)
        yield Row("inverse z, order 6, pair twice", sampled, at_most=20)
        return
    peer = once(lambda: sp.inverse_laplace_transform(REPEATED, s, positive_t))
    yield Row("inverse Laplace, order 6, pair twice", mine, "sympy inverse_laplace_transform", peer, 40)
    peer = once(lambda: by_residues(SAMPLED))
    yield Row("inverse z, order 6, pair twice", sampled, "sympy residue", peer, 20, 20)
