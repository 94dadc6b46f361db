"""Linear equations in state space, for questions about a plant."""

from __future__ import annotations

from collections.abc import Iterable

from solver.derivation import Derivation
from solver.derivation.conversion import Provided, conversion
from solver.systems import Equations, StateSpace
from solver.tasks.modelling.first_order import is_linear
from solver.tasks.modelling.linear_model import state_space_of
from solver.words import Reason


def _gives(has: Provided) -> Iterable[str]:
    """A and C, with inputs B, D and a transfer function, with initial values an initial state."""
    of_inputs = ("B", "D", "transfer_function") if "inputs" in has else ()
    return ("A", "C", *of_inputs, *(("initial_state", "x0") if "initial_state" in has else ()))


def _refuses(model: Equations) -> Reason | None:
    """Nonlinear equations have no A, B, C, D."""
    return None if is_linear(model) else Reason("equations/linearize_first")


@conversion(Equations, StateSpace, gives=_gives, refuses=_refuses)
def in_state_space(model: Equations) -> Derivation[StateSpace]:
    """Solved for the highest derivatives, the states chosen, the matrices read off."""
    found = yield from state_space_of(model)
    return found.plant
