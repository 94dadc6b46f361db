"""Inverse Laplace transforms of order six: ours, and sympy's."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from benchmarks.timing import Row, milliseconds, once
from solver import exact

t, s = sp.Symbol("t"), sp.Symbol("s")
positive_t = sp.Symbol("t", positive=True)  # the peer is quicker with it

REPEATED = 10 / ((s + 1) * (s + 3) * (s**2 + 2 * s + 5) ** 2)
"""Order six, a complex pair twice."""


def ours(F: sp.Expr) -> sp.Expr:
    """The function of time, and the partial fractions."""
    (term,) = exact.read_image(F, s)
    if term.image.proper is not None:
        term.image.proper.partial_fractions(s)
    function: sp.Expr = term.image.function(t)
    return function


def rows(*, quick: bool = False) -> Iterator[Row]:
    """The lines of the table; `quick` leaves out the peer, which takes seconds."""
    mine = milliseconds(lambda: ours(REPEATED))
    if quick:
        yield Row("inverse Laplace, order 6, pair twice", mine)
        return
    peer = once(lambda: sp.inverse_laplace_transform(REPEATED, s, positive_t))
    yield Row("inverse Laplace, order 6, pair twice", mine, "sympy inverse_laplace_transform", peer, 40)
