"""A system in other coordinates, x = T ξ: the inverse of T, and the products that give the new matrices."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.arithmetic.exactness import where_exact
from solver.arithmetic.inverses import inverted
from solver.arithmetic.products import multiplied
from solver.lazy import exact
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.derivation import Step

LARGEST = 4
"""The products of larger matrices would fill the page."""


@where_exact
def in_coordinates(
    T: ImmutableMatrix,
    back: ImmutableMatrix,
    A: ImmutableMatrix,
    B: ImmutableMatrix | None,
    C: ImmutableMatrix | None,
    *,
    inverse_too: bool = True,
) -> tuple[Step, ...]:
    """T⁻¹ = back, T⁻¹(A T), T⁻¹B and C T (n×n, n×m, p×n); none for an exchange of states, or of many.

    `inverse_too`: the page does not show how T is inverted.
    """
    if T.rows > LARGEST or _exchanges(T):
        return ()
    AT = sp.ImmutableMatrix(exact.multiply(A, T))
    steps = (
        *(inverted("T", T, back) if inverse_too else ()),
        *multiplied(A, T, AT, "AT"),
        *multiplied(back, AT, sp.ImmutableMatrix(exact.multiply(back, AT)), "T^{-1}AT"),
    )
    if B is not None:
        steps += multiplied(back, B, sp.ImmutableMatrix(exact.multiply(back, B)), "T^{-1}B")
    if C is not None:
        steps += multiplied(C, T, sp.ImmutableMatrix(exact.multiply(C, T)), "CT")
    return steps


@where_exact
def both_sides(A: ImmutableMatrix, V: ImmutableMatrix, J: ImmutableMatrix) -> tuple[Step, ...]:
    """A V = V J, multiplied out on both sides; none in decimals, or of many states."""
    if A.rows >= LARGEST or V.has(sp.Float) or J.has(sp.Float):
        return ()
    both = sp.ImmutableMatrix(exact.multiply(V, J))
    return multiplied(A, V, both, "AV") + multiplied(V, J, both, "VJ")


def _exchanges(T: ImmutableMatrix) -> bool:
    """Whether T only changes the order of the states."""
    return all(entry in (0, 1) for entry in T.flat()) and all(sum(T.row(i)) == 1 for i in range(T.rows))
