"""Usual mistakes with controls of least energy: signs and factors of the costates, weights, times run backwards."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks import mistakes
from solver.tasks.variations.energy_question import EnergyOptions, Transfer

if TYPE_CHECKING:
    from solver.derivation import Task
    from solver.systems import System
    from solver.tasks.needed import WithInput

SIGN = Slip("sign", "the sign is reversed")
COSTATE_SIGN = Slip("costate_sign", r"it solves $\dot{\lambda} = +A^{T}\lambda$; the costate equation has a minus")
FACTOR = Slip(
    "factor", r"the factor before the integral is forgotten: $\partial H/\partial u$ is $2cRu + B^{T}\lambda$"
)
WITHOUT_WEIGHT = Slip("without_weight", "the weight $R^{-1}$ is forgotten")
BACKWARDS = Slip("backwards", r"it is the integral with $e^{-At}$; here the Gramian has $e^{At}$")
NOT_HALVED = Slip("not_halved", "the factor before the integral is forgotten")


def register(task: Task[WithInput, EnergyOptions]) -> None:
    """Register what goes wrong with controls of least energy."""
    task.mistake(SIGN, "u", "costates")(reversed_sign)
    task.mistake(COSTATE_SIGN, "costates")(costates_forwards)
    task.mistake(FACTOR, "costates")(other_factors)
    task.mistake(NOT_HALVED, "cost")(whole_integral)
    task.mistake(BACKWARDS, "gramian")(gramian_backwards)
    task.mistaken_question(WITHOUT_WEIGHT)(without_weight)
    task.mistaken_question(mistakes.WITHOUT_INITIAL_STATE)(without_initial_state)


def reversed_sign(wrong: Attempt[WithInput, EnergyOptions]) -> Iterable[Any]:
    """The value of the other sign."""
    ours = wrong.ours
    yield [-each for each in ours] if isinstance(ours, list) else -ours


def costates_forwards(wrong: Attempt[WithInput, EnergyOptions]) -> Iterable[Any]:
    """e^{Aᵀt} λ(0) for e^{−Aᵀt} λ(0)."""
    A, t = wrong.given.system.A, sp.Symbol("t")
    start = sp.Matrix([each.xreplace({t: sp.S.Zero}) for each in wrong.ours])
    yield list((exact.exponential(A, t).matrix.T * start).expand())


def other_factors(wrong: Attempt[WithInput, EnergyOptions]) -> Iterable[Any]:
    """The costates of twice the cost, or of half of it."""
    yield [2 * each for each in wrong.ours]
    yield [each / 2 for each in wrong.ours]


def whole_integral(wrong: Attempt[WithInput, EnergyOptions]) -> Iterable[Any]:
    """The integral without the factor before it."""
    yield wrong.ours / Transfer.of(wrong.given).factor


def gramian_backwards(wrong: Attempt[WithInput, EnergyOptions]) -> Iterable[Any]:
    """∫ e^{−At} B R⁻¹ Bᵀ e^{−Aᵀt} dt."""
    transfer = Transfer.of(wrong.given)
    inverse = sp.ImmutableMatrix(transfer.R.inv())
    yield exact.finite_gramian(sp.ImmutableMatrix(-transfer.A), transfer.B, transfer.T, inverse)


def without_weight(system: System, options: EnergyOptions) -> tuple[System, EnergyOptions] | None:
    """The question with R = I."""
    return None if options.R is None else (system, replace(options, R=None))


def without_initial_state(system: System, options: EnergyOptions) -> tuple[System, EnergyOptions] | None:
    """The motion from rest."""
    x0 = options.initial_state
    if x0 is None or options.final_state is None:
        return None
    return system, replace(options, initial_state=sp.ImmutableMatrix(sp.zeros(*x0.shape)))
