"""A circuit in state space, for questions about a plant."""

from __future__ import annotations

from collections.abc import Iterable

from solver.derivation import Derivation
from solver.derivation.conversion import Provided, conversion
from solver.systems import Circuit, StateSpace
from solver.tasks.modelling.kirchhoff import equations_of_circuit
from solver.tasks.modelling.linear_model import state_space_of
from solver.words import Reason


def _gives(has: Provided) -> Iterable[str]:
    """A and C, with inputs B, D and a transfer function, with initial values an initial state."""
    of_inputs = ("B", "D", "transfer_function") if "inputs" in has else ()
    return ("A", "C", *of_inputs, *(("initial_state", "x0") if "initial_state" in has else ()))


def _refuses(circuit: Circuit) -> Reason | None:
    """Constant sources, and outputs that are no sums, leave no A, B, C, D."""
    return None if circuit.is_linear else Reason("circuits/not_linear")


@conversion(Circuit, StateSpace, gives=_gives, refuses=_refuses)
def in_state_space(circuit: Circuit) -> Derivation[StateSpace]:
    """The state equations by Kirchhoff's laws, their matrices read off."""
    model = yield from equations_of_circuit(circuit)
    found = yield from state_space_of(model)
    return found.plant
