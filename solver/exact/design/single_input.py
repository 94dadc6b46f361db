"""One input in place of several, and the gain of the part that it reaches."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import product

import sympy as sp

from solver.exact.design.placement import combine
from solver.exact.structure.controllability import reachable_order
from solver.exact.structure.decomposition import Decomposition


def lifted_gain(
    part: Decomposition, k_c: sp.ImmutableMatrix, unknowns: Sequence[sp.Symbol]
) -> tuple[sp.ImmutableMatrix, tuple[sp.Symbol, ...]]:
    """Return k = [k_c, κ] T⁻¹ (1×n) for a `controllable_part`, and κ: the unknowns at the places of its unit vectors.

    They are the entries of k at these places too.
    """
    units = part.bases[1]
    free = tuple(unknowns[units[:, j].flat().index(1)] for j in range(units.cols))
    return combine([*k_c.flat(), *free], part.T_inverse), free


@dataclass(frozen=True)
class Direction:
    """One input in place of several, u = −K₀ x + g v: (A − B K₀, B g) reaches all that (A, B) does.

    `preliminary` is K₀ (m×n), None where none is needed; g is m×1.
    """

    g: sp.ImmutableMatrix
    preliminary: sp.ImmutableMatrix | None


def direction(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix) -> Direction | None:
    """Find the simplest g, and if A has several eigenvectors for one movable eigenvalue a K₀; None if none was found.

    Almost every K₀ and g do (Heymann 1968); simple ones are tried first.
    """
    order = reachable_order(A, B)
    for K0 in _preliminary_gains(B.cols, A.rows):
        loop = A if K0 is None else sp.ImmutableMatrix(A - B * K0)
        for g in _directions(B.cols):
            if reachable_order(loop, sp.ImmutableMatrix(B * g)) == order:
                return Direction(g, K0)
    return None


def _directions(m: int) -> list[sp.ImmutableMatrix]:
    """Single inputs first, then sums of inputs, then combinations in general position."""
    units = [sp.ImmutableMatrix(m, 1, lambda i, _j, c=c: int(i == c)) for c in range(m)]
    if m == 1:
        return units
    sums = [sp.ImmutableMatrix(m, 1, list(signs)) for signs in product((1, -1), repeat=m) if signs[0] == 1]
    general = [sp.ImmutableMatrix(m, 1, lambda i, _j, t=t: t**i) for t in (2, 3, -3, 5, 7)]
    return units + sums[:8] + general


def _preliminary_gains(m: int, n: int) -> Iterable[sp.ImmutableMatrix | None]:
    """None, gains of one entry, chains from state to input, and small numbers in general position."""
    yield None
    for i, j in product(range(m), range(n)):
        yield sp.ImmutableMatrix(m, n, lambda a, b, i=i, j=j: int((a, b) == (i, j)))
    for shift in range(1, n):
        yield sp.ImmutableMatrix(m, n, lambda a, b, shift=shift: -int(a == (b + shift) % n))
    for seed in range(1, 6):
        yield sp.ImmutableMatrix(m, n, lambda a, b, seed=seed: (seed * (3 * a + 1) * (b + 2) ** 2 + a * b) % 7 - 3)
