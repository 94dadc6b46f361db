"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.variations.conjugate import conjugate_residual, legendre_residual
from solver.numeric.judges.variations.equations import Adjoined, stationary_equations
from solver.numeric.judges.variations.extremals import (
    constraints_residual,
    ends_residual,
    stationary_residual,
    value_residual,
)
from solver.numeric.judges.variations.paths import Path, paths, variation_residual
from solver.numeric.judges.variations.problem import End, Problem
from solver.numeric.judges.variations.second_variations import end_residual, first_variation_residual, nature_holds
from solver.numeric.judges.variations.transfers import (
    Transfer,
    arrival_residual,
    costate_residual,
    energy_residual,
    motion_residual,
    necessary_conditions_residual,
    orthogonality_residual,
    reaches_everything,
    weighted_gramian_residual,
)

__all__ = [
    "Adjoined",
    "End",
    "Path",
    "Problem",
    "Transfer",
    "arrival_residual",
    "conjugate_residual",
    "constraints_residual",
    "costate_residual",
    "end_residual",
    "ends_residual",
    "energy_residual",
    "first_variation_residual",
    "legendre_residual",
    "motion_residual",
    "nature_holds",
    "necessary_conditions_residual",
    "orthogonality_residual",
    "paths",
    "reaches_everything",
    "stationary_equations",
    "stationary_residual",
    "value_residual",
    "variation_residual",
    "weighted_gramian_residual",
]
