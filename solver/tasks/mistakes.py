"""Mistakes that several tasks declare."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeVar

from solver.derivation import Attempt, Options
from solver.lazy import sympy as sp
from solver.lazy import systems

if TYPE_CHECKING:
    from solver.systems import StateSpace

O = TypeVar("O", bound=Options)

EXCHANGED = "$B$ and $C$ are exchanged"
ADDED = "$+$ stands where $-$ belongs: the feedback is subtracted"
DIAGONAL = "these are the entries on the diagonal of $A$"
UPSIDE_DOWN = "numerator and denominator are exchanged"


def inputs_for_outputs(system: Any, options: O) -> tuple[StateSpace, O] | None:
    """Cᵀ for B and Bᵀ for C."""
    if not isinstance(system, systems.StateSpace) or system.B is None or system.C is None:
        return None
    if system.B.cols != system.C.rows:
        return None
    return replace(system, B=sp.ImmutableMatrix(system.C.T), C=sp.ImmutableMatrix(system.B.T)), options


def plus_for_minus(wrong: Attempt[StateSpace, Options]) -> Iterable[Any]:
    """A + BK for A − BK, A + LC for A − LC."""
    A = wrong.given.system.A
    if wrong.ours.shape == A.shape:
        yield 2 * A - wrong.ours


def diagonal_entries(wrong: Attempt[StateSpace, Options]) -> Iterable[Any]:
    """The diagonal of A for its eigenvalues."""
    yield list(wrong.given.system.A.diagonal())


def upside_down(wrong: Attempt[Any, Options]) -> Iterable[Any]:
    """The denominator over the numerator of one channel."""
    if isinstance(wrong.ours, sp.Expr):
        yield 1 / wrong.ours
