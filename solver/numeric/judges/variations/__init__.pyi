"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.variations.conjugate import conjugate_residual, legendre_residual
from solver.numeric.judges.variations.equations import Adjoined, stationary_equations
from solver.numeric.judges.variations.extremals import (
    constraints_residual,
    ends_residual,
    stationary_residual,
    value_residual,
)
from solver.numeric.judges.variations.horizon_costs import others_cost_more
from solver.numeric.judges.variations.horizon_equations import (
    Steps,
    cost_matrices_residual,
    differential_equations_residual,
    long_steps_residual,
    step_gains_residual,
    step_inputs_residual,
    step_states_residual,
    steps_cost_residual,
)
from solver.numeric.judges.variations.horizons import (
    Horizon,
    gain_path_residual,
    horizon_cost_residual,
    long_horizon_residual,
    optimal_input_residual,
    optimal_motion_residual,
    path_residual,
)
from solver.numeric.judges.variations.paths import variation_residual
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
    "Horizon",
    "Problem",
    "Steps",
    "Transfer",
    "arrival_residual",
    "conjugate_residual",
    "constraints_residual",
    "cost_matrices_residual",
    "costate_residual",
    "differential_equations_residual",
    "end_residual",
    "ends_residual",
    "energy_residual",
    "first_variation_residual",
    "gain_path_residual",
    "horizon_cost_residual",
    "legendre_residual",
    "long_horizon_residual",
    "long_steps_residual",
    "motion_residual",
    "nature_holds",
    "necessary_conditions_residual",
    "optimal_input_residual",
    "optimal_motion_residual",
    "orthogonality_residual",
    "others_cost_more",
    "path_residual",
    "reaches_everything",
    "stationary_equations",
    "stationary_residual",
    "step_gains_residual",
    "step_inputs_residual",
    "step_states_residual",
    "steps_cost_residual",
    "value_residual",
    "variation_residual",
    "weighted_gramian_residual",
]
