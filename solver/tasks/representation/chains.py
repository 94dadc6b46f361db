"""The figure of a realization: which integrators follow each other, and what else acts on what."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.derivation.figures import Chains
from solver.words import formula

if TYPE_CHECKING:
    from collections.abc import Iterator

    from sympy import Expr, ImmutableMatrix

    from solver.exact import Realization

LARGEST = 5
"""Realizations of higher order are not drawn."""


def integrators_of(found: Realization, *, discrete: bool) -> tuple[Chains, ...]:
    """Return the block diagram of a realization.

    Nothing with several inputs or outputs: their wires cross so often that no reader follows one. Nothing either where
    chains act on each other or a state on a later one of its chain, which no canonical form does.
    """
    A, B, C, D = found.A, found.B, found.C, found.D
    if B.cols > 1 or C.rows > 1 or A.rows > LARGEST:
        return ()
    rows = chains_of(A)
    if rows is None:
        return ()
    entries = tuple(tuple(_entry(A[i, j]) for j in range(A.cols)) for i in range(A.rows))
    caption = "The realization with delays" if discrete else "The realization with integrators"
    b, c = tuple(map(_entry, B.flat())), tuple(map(_entry, C.flat()))
    return (Chains(caption, rows, entries, b, c, _entry(D[0, 0]), discrete),)


def chains_of(A: ImmutableMatrix) -> tuple[tuple[int, ...], ...] | None:
    """Return the states as chains, each in the order of the signal; None where other wires join or cross them."""
    after: dict[int, int] = {}
    for source, target in sorted(_couplings(A), key=lambda link: (A[link[1], link[0]] != 1, abs(link[0] - link[1]))):
        if source not in after and target not in after.values() and source not in _walk(target, after):
            after[source] = target
    firsts = [state for state in range(A.rows) if state not in after.values()]
    rows = tuple(tuple(_walk(first, after)) for first in firsts)
    place = {state: (row, i) for row, states in enumerate(rows) for i, state in enumerate(states)}
    for source, target in _couplings(A):
        (row, i), (other, j) = place[source], place[target]
        if row != other or (i < j and after.get(source) != target):
            return None
    return rows


def _couplings(A: ImmutableMatrix) -> Iterator[tuple[int, int]]:
    """Yield which state acts on which other one."""
    return ((j, i) for i in range(A.rows) for j in range(A.rows) if i != j and A[i, j] != 0)


def _walk(state: int, after: dict[int, int]) -> list[int]:
    """Return a state and those that follow it."""
    found = [state]
    while found[-1] in after:
        found.append(after[found[-1]])
    return found


def _entry(value: Expr) -> str:
    """Return an entry as LaTeX, "" for zero."""
    return "" if value == 0 else formula(value)
