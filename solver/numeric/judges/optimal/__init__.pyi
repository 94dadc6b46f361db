"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.optimal.gain_costs import cost_residual, costs, gain_residual
from solver.numeric.judges.optimal.regulator import (
    DiscreteWeights,
    Weights,
    control_residual,
    current_gain_residual,
    loop_residual,
    optimum_in_floats,
)
from solver.numeric.judges.optimal.riccati import (
    equations_residual,
    hamiltonian_spectrum_residual,
    riccati_residual,
    riccati_sides,
    stabilizes,
    symmetry_residual,
)
from solver.numeric.judges.optimal.riccati_solutions import (
    all_distinct,
    definiteness_holds,
    is_minimal,
    none_missing,
    number_of_solutions,
)

__all__ = [
    "DiscreteWeights",
    "Weights",
    "all_distinct",
    "control_residual",
    "cost_residual",
    "costs",
    "current_gain_residual",
    "definiteness_holds",
    "equations_residual",
    "gain_residual",
    "hamiltonian_spectrum_residual",
    "is_minimal",
    "loop_residual",
    "none_missing",
    "number_of_solutions",
    "optimum_in_floats",
    "riccati_residual",
    "riccati_sides",
    "stabilizes",
    "symmetry_residual",
]
