"""Plants of several inputs and outputs, in either description, as a transfer matrix."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.derivation import Derivation, lemma
from solver.lazy import exact, systems
from solver.tasks.representation.lowest_terms import fractions_of
from solver.tasks.representation.transfer_function import transfer_function_of

if TYPE_CHECKING:
    from solver.tasks.needed import InputOutput


@lemma("transfer_function")
def transfer_matrix_of(plant: InputOutput) -> Derivation[exact.TransferMatrix]:
    """G as it is given, or from A, B, C, D; not cancelled."""
    if isinstance(plant, systems.TransferFunction):
        return (yield from fractions_of(plant))
    return (yield from transfer_function_of(plant))
