"""A circuit as a transfer function, by impedances and nodal analysis."""

from __future__ import annotations

from solver.derivation import Derivation
from solver.derivation.conversion import conversion
from solver.systems import Circuit, TransferFunction
from solver.tasks.modelling.nodal_analysis import transfer_function_of_circuit
from solver.words import Reason


def _refuses(circuit: Circuit) -> Reason | None:
    """Constant sources, and outputs that are no sums, have no transfer function."""
    return None if circuit.is_linear else Reason("circuits/not_linear")


@conversion(
    Circuit,
    TransferFunction,
    gives=lambda has: ("impedances", "transfer_function") if "inputs" in has else (),
    refuses=_refuses,
)
def by_impedances(circuit: Circuit) -> Derivation[TransferFunction]:
    """Node voltages from the current law, nothing cancelled against the natural frequencies."""
    return (yield from transfer_function_of_circuit(circuit))
