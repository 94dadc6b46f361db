"""The exact hold of order zero for a symbolic period: ours, and sympy's `Matrix.exp` with its integral."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import sympy as sp

from benchmarks.matrices import companion_of_integers, dense
from benchmarks.timing import Row, milliseconds, once
from solver import exact

T, tau = sp.symbols("T tau", positive=True)
ORDER, FASTER, AT_MOST = 6, 20, 40


def ours(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix) -> exact.Held:
    """Φ and Γ."""
    return exact.zero_order_hold(A, B, T)


def sympys(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix) -> tuple[sp.Matrix, sp.Matrix]:
    """e^{AT} and its integral, entry by entry."""
    moved = (sp.Matrix(A) * tau).exp()
    return moved.subs(tau, T), (moved * B).applyfunc(lambda entry: sp.integrate(entry, (tau, 0, T)))


def rows() -> Iterator[Row]:
    """The lines of the table."""
    last = sp.ImmutableMatrix(sp.eye(ORDER)[:, ORDER - 1])
    for name, A in (("companion", companion_of_integers(ORDER)), ("dense", dense(ORDER))):
        mine = milliseconds(partial(ours, sp.ImmutableMatrix(A), last))
        peer = once(partial(sympys, A, last)) if name == "companion" else None
        yield Row(f"hold, symbolic T, {name}, n = {ORDER}", mine, "sympy exp and integrate" if peer else "", peer,
                  FASTER if peer else None, AT_MOST)  # fmt: skip
