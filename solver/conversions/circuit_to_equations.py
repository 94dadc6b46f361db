"""A circuit as differential equations, by Kirchhoff's laws: the unknowns are its states."""

from __future__ import annotations

from solver.derivation import Derivation
from solver.derivation.conversion import conversion
from solver.systems import Circuit, Equations
from solver.tasks.modelling.kirchhoff import equations_of_circuit


@conversion(
    Circuit, Equations, gives=lambda has: {"equations", "rest", "machine", *(has & {"inputs", "initial_state"})}
)
def by_kirchhoff(circuit: Circuit) -> Derivation[Equations]:
    """L i' = v and C v' = i, the other voltages and currents eliminated."""
    return (yield from equations_of_circuit(circuit))
