"""Mistakes that several tasks declare."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeVar

from solver.derivation import Attempt, Options, Slip
from solver.lazy import sympy as sp
from solver.lazy import systems

if TYPE_CHECKING:
    from solver.systems import StateSpace

O = TypeVar("O", bound=Options)

EXCHANGED = Slip("ports", "$B$ and $C$ are exchanged")
ADDED = Slip("feedback_sign", "$+$ stands where $-$ belongs: the feedback is subtracted")
GAIN_ADDED = Slip("sign", r"it is the gain of $A + B\sym{K}$; the feedback is subtracted, $A - B\sym{K}$")
OBSERVER_ADDED = Slip("sign", r"it is the gain of $A + \sym{L}C$; the error obeys $A - \sym{L}C$")
DIAGONAL = Slip("diagonal_entries", "these are the entries on the diagonal of $A$")
MINUS_DETERMINANT = Slip("minus_determinant", r"it is $\det(A - \lambda I)$, not $\det(\lambda I - A)$")
OF_THE_NEGATIVE = Slip("sign", "it is the inverse of $A - sI$")
NOT_ATTAINABLE = Slip("not_attainable", "these are the vectors asked for, and not all of them are attainable")
NOT_DIVIDED = Slip("adjugate", "this is the adjugate; it is not yet divided by the determinant")
OPEN_LOOP = Slip("open_loop", "it is that of $CG$, of the loop that is not closed")
OTHER_SIDE = Slip("left_right", "left and right eigenvectors are exchanged")
ENTRY_BY_ENTRY = Slip("entrywise", "the function is taken of each entry; it is a function of the matrix")
WITHOUT_INITIAL_STATE = Slip("without_initial_state", "the initial state is forgotten")
WITHOUT_CROSS_WEIGHT = Slip("without_cross_weight", "the cross weight is forgotten")
WEIGHT_REVERSED = Slip("weight_sign", "the right side has the wrong sign: $-Q$ for $Q$")
OTHER_SOLUTION = Slip("other_solution", "it solves the Riccati equation, but it is not the stabilising solution")
OF_ANOTHER_SOLUTION = Slip(
    "other_solution", "it comes from a solution of the Riccati equation that is not the stabilising one"
)
CONTINUOUS_RICCATI = Slip(
    "continuous_riccati", "it solves the Riccati equation of continuous time; the plant is one of discrete time"
)
WEIGHT_ALONE = Slip("input_weight", r"$R$ is inverted where $R + B^{T}PB$ belongs")
WITHOUT_A = Slip("without_A", r"$A$ is missing: it is $(R + B^{T}PB)^{-1}B^{T}P$")
PREDICTION_FOR_CURRENT = Slip("prediction_gain", "it is the gain of the prediction, not that of the current estimate")
CURRENT_FOR_PREDICTION = Slip("current_gain", "it is the gain of the current estimate, not that of the prediction")
STACKED = Slip(
    "stacked", "$B$, $AB$, … stand beside each other, $C$, $CA$, … one below the other; here it is the reverse"
)


def in_continuous_time(system: Any, options: O) -> tuple[Any, O] | None:
    """The question about the same matrices in continuous time."""
    return (replace(system, discrete=False, sample_time=None), options) if system.discrete else None


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


def negative(wrong: Attempt[Any, Options]) -> Iterable[Any]:
    """The gain of the other sign."""
    yield -wrong.ours


def not_closed(system: Any, options: Any) -> tuple[Any, Any] | None:
    """The question about C G, for one about the closed loop."""
    return None if options.feedback is None else (system, replace(options, feedback=None))
