"""Plants of several inputs and outputs, in either description, as a transfer matrix."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact, systems
from solver.stated.matrices import determinant
from solver.tasks.representation.lowest_terms import fractions_of
from solver.tasks.representation.plants import matrices_of, stated_transfer, variable_of
from solver.tasks.representation.transfer_function import transfer_function_of

if TYPE_CHECKING:
    from solver.systems import StateSpace
    from solver.tasks.needed import InputOutput

LARGEST = 6
"""Of more states the adjugate fills pages."""


@lemma("plants")
def transfer_matrix_of(plant: InputOutput) -> Derivation[exact.TransferMatrix]:
    """G as it is given, or from A, B, C, D; not cancelled."""
    if isinstance(plant, systems.TransferFunction):
        return (yield from fractions_of(plant))
    if plant.order > LARGEST:
        return (yield from _by_machine(plant))
    return (yield from transfer_function_of(plant))


@lemma("plants")
def _by_machine(plant: StateSpace) -> Derivation[exact.TransferMatrix]:
    """G of many states, whose adjugate nobody writes down."""
    x = variable_of(plant)
    G = exact.transfer_matrix(*matrices_of(plant), x)
    yield Step(
        "by_machine",
        claims={
            "chi": Claim(determinant(exact.pencil(plant.A, x)), G.chi, rf"$\det({x}I - A)$"),
            "G": Claim(stated_transfer(plant, x), G.matrix, f"$G({x})$"),
        },
        x=x,
        n=plant.order,
    )
    return G
