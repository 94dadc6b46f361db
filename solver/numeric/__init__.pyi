"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.claims import check_claim, check_residual, check_steps
from solver.numeric.compare import TOLERANCE
from solver.numeric.decomposition import (
    coordinates_residual,
    hidden_polynomial_residual,
    kalman_orders,
    separation_residual,
    visible_part_residual,
)
from solver.numeric.eigen import (
    chain_residual,
    eigenpair_residual,
    left_residual,
    polynomial_residual,
    spectrum_residual,
)
from solver.numeric.evaluation import evaluate, values_at
from solver.numeric.exponential import equality_residual, exponential_residual, power_residual
from solver.numeric.forms import has_companion_blocks, is_chain_form, is_companion, is_diagonal, is_unit_vector
from solver.numeric.jordan import chains_residual, diagonalizable, is_jordan_form, same_jordan_structure
from solver.numeric.matrix_functions import matrix_function_residual
from solver.numeric.minimal import (
    cancelled_residual,
    characteristic_residual,
    order_of_minimal_part,
    pole_residual,
    realized,
)
from solver.numeric.model_matching import (
    direct_term,
    first_row_form,
    fraction_of,
    matched_residual,
    matching_possible,
    realization_residual,
)
from solver.numeric.observers import (
    closing_residual,
    driven_error_residual,
    joined_spectrum_residual,
    row_space_residual,
)
from solver.numeric.placement import (
    fit_residual,
    fixed_modes_residual,
    placed_matrix_residual,
    placed_residual,
    range_residual,
    roots_residual,
    shape_residual,
)
from solver.numeric.ranks import independent, rank
from solver.numeric.regions import counterexample
from solver.numeric.regulator import Weights, control_residual, cost_residual, gain_residual, loop_residual
from solver.numeric.response import (
    beginnings,
    convolution_formula,
    impulses,
    intervals,
    residual_of_pairs,
    sampled,
    samples,
    time_scale,
)
from solver.numeric.riccati import (
    equations_residual,
    hamiltonian_spectrum_residual,
    riccati_residual,
    stabilizes,
    symmetry_residual,
)
from solver.numeric.riccati_solutions import all_distinct, definiteness_holds, number_of_solutions
from solver.numeric.rounding import agrees_to_digits
from solver.numeric.second_order import second_order_poles, second_order_residual
from solver.numeric.set_point import reference_residual_at_optimum, set_point_residual
from solver.numeric.stability import externally_stable, locations, planar_kinds, routh_fault, spread_points
from solver.numeric.structure import (
    every_fall_is_named,
    hidden_modes_decay,
    hidden_modes_residual,
    krylov_matrix,
    rank_falls_where,
)
from solver.numeric.tracking import completed_residual, feedforward_residual, steady_residual
from solver.numeric.trajectory import difference, final_output, largest_output, samples_of_output, simulations
from solver.numeric.values import NotEvaluable, ShapeMismatch, Undefined
from solver.numeric.zeros import zero_residual

__all__ = [
    "TOLERANCE",
    "NotEvaluable",
    "ShapeMismatch",
    "Undefined",
    "Weights",
    "agrees_to_digits",
    "all_distinct",
    "beginnings",
    "cancelled_residual",
    "chain_residual",
    "chains_residual",
    "characteristic_residual",
    "check_claim",
    "check_residual",
    "check_steps",
    "closing_residual",
    "completed_residual",
    "control_residual",
    "convolution_formula",
    "coordinates_residual",
    "cost_residual",
    "counterexample",
    "definiteness_holds",
    "diagonalizable",
    "difference",
    "direct_term",
    "driven_error_residual",
    "eigenpair_residual",
    "equality_residual",
    "equations_residual",
    "evaluate",
    "every_fall_is_named",
    "exponential_residual",
    "externally_stable",
    "feedforward_residual",
    "final_output",
    "first_row_form",
    "fit_residual",
    "fixed_modes_residual",
    "fraction_of",
    "gain_residual",
    "hamiltonian_spectrum_residual",
    "has_companion_blocks",
    "hidden_modes_decay",
    "hidden_modes_residual",
    "hidden_polynomial_residual",
    "impulses",
    "independent",
    "intervals",
    "is_chain_form",
    "is_companion",
    "is_diagonal",
    "is_jordan_form",
    "is_unit_vector",
    "joined_spectrum_residual",
    "kalman_orders",
    "krylov_matrix",
    "largest_output",
    "left_residual",
    "locations",
    "loop_residual",
    "matched_residual",
    "matching_possible",
    "matrix_function_residual",
    "number_of_solutions",
    "order_of_minimal_part",
    "placed_matrix_residual",
    "placed_residual",
    "planar_kinds",
    "pole_residual",
    "polynomial_residual",
    "power_residual",
    "range_residual",
    "rank",
    "rank_falls_where",
    "realization_residual",
    "realized",
    "reference_residual_at_optimum",
    "residual_of_pairs",
    "riccati_residual",
    "roots_residual",
    "routh_fault",
    "row_space_residual",
    "same_jordan_structure",
    "sampled",
    "samples",
    "samples_of_output",
    "second_order_poles",
    "second_order_residual",
    "separation_residual",
    "set_point_residual",
    "shape_residual",
    "simulations",
    "spectrum_residual",
    "spread_points",
    "stabilizes",
    "steady_residual",
    "symmetry_residual",
    "time_scale",
    "values_at",
    "visible_part_residual",
    "zero_residual",
]
