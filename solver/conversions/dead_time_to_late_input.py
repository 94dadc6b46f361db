"""A transfer function with a dead time is realized without it; its input comes later by the dead time."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.conversions.transfer_function_to_state_space import realized
from solver.derivation import Derivation
from solver.derivation.conversion import conversion
from solver.lazy import sympy as sp
from solver.systems import DeadTime, LateInput, StateSpace
from solver.tasks.time_response.dead_time import dead_time_apart

if TYPE_CHECKING:
    from sympy import Expr


@conversion(DeadTime, LateInput, gives=lambda _: ("motion", "states"))
def late_input_of(G: DeadTime) -> Derivation[LateInput]:
    """y = G₀ e^{−Ts} u: the rational factor is driven by u(t − T). A constant one has no states."""
    yield from dead_time_apart(G)
    rational = G.rational.uncancelled[0, 0]
    constant = not rational.has(G.variable)
    plant = _without_states(rational) if constant else (yield from realized(G.rational))
    return LateInput(plant, G.delay)


def _without_states(gain: Expr) -> StateSpace:
    """Y = K u."""
    A, B, C = (sp.ImmutableMatrix(*shape, []) for shape in ((0, 0), (0, 1), (1, 0)))
    return StateSpace(A, B, C, sp.ImmutableMatrix([[gain]]))
