"""Usual mistakes with scaling: factors upside down, β on the wrong side of the bar, levels exchanged."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.tasks.analog.machine_form import form_of
from solver.tasks.analog.scaling import maxima_of, voltages_of
from solver.tasks.modelling.first_order import result_of

if TYPE_CHECKING:
    from solver.derivation import Task
    from solver.systems import Equations
    from solver.tasks.analog.machine_options import MachineOptions

    Scaled = Attempt[Equations, MachineOptions]

UPSIDE_DOWN = Slip("factor_upside_down", "the factors are upside down: volts per unit is reference over maximum")
NO_REFERENCE = Slip("reference_forgotten", "it is one over the maximum: the reference voltage is forgotten")
MULTIPLIED = Slip("time_scale_multiplied", "the right sides are multiplied by β: as dx/dt = β dx/dτ, they are divided")
NOT_SLOWED = Slip("time_scale_forgotten", "the time scale is forgotten: each right side is divided by β")
EXCHANGED = Slip(
    "levels_exchanged",
    "the levels are exchanged: a coefficient is multiplied by the level of its output over that of its input",
)
NOT_SCALED = Slip("not_scaled", "the variables are only renamed: the coefficients are those before the scaling")


def register(task: Task[Equations, Any]) -> None:
    """Register what goes wrong with scaling."""
    task.mistake(UPSIDE_DOWN, "scale_factors")(upside_down)
    task.mistake(NO_REFERENCE, "scale_factors")(without_the_reference)
    task.mistake(MULTIPLIED, "scaled_equations")(multiplied)
    task.mistake(NOT_SLOWED, "scaled_equations")(not_slowed)
    task.mistake(EXCHANGED, "scaled_equations")(exchanged)
    task.mistake(NOT_SCALED, "scaled_equations")(not_scaled)


def _question(attempt: Scaled) -> tuple[exact.MachineEquations, dict[Any, Any], Any, Any]:
    """The equations, the maxima, the reference and β."""
    given = attempt.given
    equations = result_of(form_of(given))
    own = {given.system.symbol(jet): value for jet, value in (given.options.maximum or {}).items()}
    maxima = result_of(maxima_of(equations, own))
    return equations, maxima, given.options.volts, given.options.beta


def upside_down(attempt: Scaled) -> Iterable[Any]:
    """Maximum over reference."""
    _, maxima, reference, _ = _question(attempt)
    yield {x: value / reference if value != 0 else sp.S.One for x, value in maxima.items()}


def without_the_reference(attempt: Scaled) -> Iterable[Any]:
    """1/maximum."""
    _, maxima, reference, _ = _question(attempt)
    if reference != 1:
        yield exact.scale_factors(maxima, sp.S.One)


def multiplied(attempt: Scaled) -> Iterable[Any]:
    """β in place of 1/β."""
    yield from _scaled(attempt, lambda L: L, lambda beta: 1 / beta, slow=True)


def not_slowed(attempt: Scaled) -> Iterable[Any]:
    """Without β."""
    yield from _scaled(attempt, lambda L: L, lambda _: sp.S.One, slow=True)


def exchanged(attempt: Scaled) -> Iterable[Any]:
    """L_in/L_out in place of L_out/L_in."""
    yield from _scaled(attempt, lambda L: 1 / L, lambda beta: beta)


def not_scaled(attempt: Scaled) -> Iterable[Any]:
    """The coefficients as they were."""
    yield from _scaled(attempt, lambda _: sp.S.One, lambda beta: beta)


def _scaled(
    attempt: Scaled, level: Callable[[Any], Any], slower: Callable[[Any], Any], *, slow: bool = False
) -> Iterator[Any]:
    """The equations with other levels, or another β where there is one."""
    equations, maxima, reference, beta = _question(attempt)
    if not (slow and beta == 1):
        factors = {x: level(L) for x, L in exact.scale_factors(maxima, reference).items()}
        yield voltages_of(exact.scaled(equations, exact.Scaling(factors, slower(beta))))
