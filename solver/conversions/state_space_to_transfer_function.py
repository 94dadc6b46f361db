"""The transfer function of a plant in state space, by adjugate over determinant."""

from __future__ import annotations

from solver.derivation import Derivation
from solver.derivation.conversion import conversion
from solver.systems import StateSpace, TransferFunction
from solver.tasks.representation.transfer_function import transfer_function_of


@conversion(
    StateSpace,
    TransferFunction,
    gives=lambda has: ("transfer_function", "path") if "transfer_function" in has else (),
)
def transfer_function_of_states(plant: StateSpace) -> Derivation[TransferFunction]:
    """G = (C adj(xI − A) B + det(xI − A) D)/det(xI − A), the factors that cancel kept beside it."""
    G = yield from transfer_function_of(plant)
    return TransferFunction(
        G.matrix,
        G.numerators,
        G.denominators,
        G.variable,
        plant.discrete,
        plant.sample_time,
        plant.input_names,
        plant.output_names,
    )
