"""What inputs reach, in coordinates that show it, and one input in place of several."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import product

import sympy as sp

from solver.exact.design.placement import combine
from solver.exact.linear_algebra.fields import domain_matrix
from solver.exact.linear_algebra.matrices import inverse, multiply
from solver.exact.structure.controllability import controllability_matrix


@dataclass(frozen=True)
class ControllablePart:
    """Coordinates x = T ξ in which A is [[A_c, *], [0, A_u]] and B is [[B_c], [0]]; `order` r is the size of A_c.

    The first r columns of T are columns of the controllability matrix, the others the unit vectors of the coordinates
    `free`; so the entries of K = [K_c, κ] T⁻¹ at these places are those of κ.
    """

    T: sp.ImmutableMatrix
    inverse: sp.ImmutableMatrix
    A: sp.ImmutableMatrix
    B: sp.ImmutableMatrix
    order: int
    free: tuple[int, ...]

    @property
    def A_c(self) -> sp.ImmutableMatrix:
        """The controllable block (r×r)."""
        return self.A[: self.order, : self.order]

    @property
    def B_c(self) -> sp.ImmutableMatrix:
        """The input of the controllable block (r×m)."""
        return self.B[: self.order, :]

    @property
    def A_u(self) -> sp.ImmutableMatrix:
        """The block that the input does not reach (n−r × n−r)."""
        return self.A[self.order :, self.order :]


def controllable_part(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix) -> ControllablePart:
    """Decompose (A, B), for general parameters; r may be 0 or n."""
    n = A.rows
    reach = controllability_matrix(A, B)
    columns = tuple(domain_matrix(reach).rref()[1])
    basis = reach[:, list(columns)]
    rows = tuple(domain_matrix(basis).transpose().rref()[1]) if columns else ()
    free = tuple(i for i in range(n) if i not in rows)
    units = sp.eye(n)[:, list(free)]
    T = sp.ImmutableMatrix(sp.Matrix.hstack(sp.Matrix(basis), units))
    back = inverse(T)
    return ControllablePart(T, back, multiply(multiply(back, A), T), multiply(back, B), len(columns), free)


def lifted_gain(
    part: ControllablePart, k_c: sp.ImmutableMatrix, unknowns: Sequence[sp.Symbol]
) -> tuple[sp.ImmutableMatrix, tuple[sp.Symbol, ...]]:
    """Return k = [k_c, κ] T⁻¹ (1×n) with the unknowns of the coordinates `free` for κ, and these unknowns."""
    free = tuple(unknowns[j] for j in part.free)
    return combine([*k_c.flat(), *free], part.inverse), free


def reachable_order(A: sp.ImmutableMatrix, B: sp.ImmutableMatrix) -> int:
    """Return the rank of the controllability matrix (for general parameters)."""
    return int(domain_matrix(controllability_matrix(A, B)).rank())


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
    sums = [sp.ImmutableMatrix(m, 1, list(signs)) for signs in product((1, -1), repeat=m) if m > 1 and signs[0] == 1]
    general = [sp.ImmutableMatrix(m, 1, lambda i, _j, t=t: t**i) for t in (2, 3, -3, 5, 7)]
    return (units + sums[:8] + general) if m > 1 else units


def _preliminary_gains(m: int, n: int) -> Iterable[sp.ImmutableMatrix | None]:
    """None, gains of one entry, chains from state to input, and small numbers in general position."""
    yield None
    for i, j in product(range(m), range(n)):
        yield sp.ImmutableMatrix(m, n, lambda a, b, i=i, j=j: int((a, b) == (i, j)))
    for shift in range(1, n):
        yield sp.ImmutableMatrix(m, n, lambda a, b, shift=shift: -int(a == (b + shift) % n))
    for seed in range(1, 6):
        yield sp.ImmutableMatrix(m, n, lambda a, b, seed=seed: (seed * (3 * a + 1) * (b + 2) ** 2 + a * b) % 7 - 3)
