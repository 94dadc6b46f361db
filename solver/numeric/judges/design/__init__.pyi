"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.design.eigenvectors import assigned_residual, nearest_residual
from solver.numeric.judges.design.model_matching import (
    direct_term,
    first_row_form,
    fraction_of,
    matched_residual,
    matching_possible,
    realization_residual,
)
from solver.numeric.judges.design.observers import (
    closing_residual,
    driven_error_residual,
    joined_spectrum_residual,
    row_space_residual,
)
from solver.numeric.judges.design.placement import (
    fit_residual,
    fixed_modes_residual,
    placed_matrix_residual,
    placed_residual,
    range_residual,
    roots_residual,
    shape_residual,
)
from solver.numeric.judges.design.sampling import sampled_poles
from solver.numeric.judges.design.second_order import second_order_poles, second_order_residual
from solver.numeric.judges.design.set_point import reference_residual_at_optimum, set_point_residual
from solver.numeric.judges.design.tracking import completed_residual, feedforward_residual, steady_residual

__all__ = [
    "assigned_residual",
    "closing_residual",
    "completed_residual",
    "direct_term",
    "driven_error_residual",
    "feedforward_residual",
    "first_row_form",
    "fit_residual",
    "fixed_modes_residual",
    "fraction_of",
    "joined_spectrum_residual",
    "matched_residual",
    "matching_possible",
    "nearest_residual",
    "placed_matrix_residual",
    "placed_residual",
    "range_residual",
    "realization_residual",
    "reference_residual_at_optimum",
    "roots_residual",
    "row_space_residual",
    "sampled_poles",
    "second_order_poles",
    "second_order_residual",
    "set_point_residual",
    "shape_residual",
    "steady_residual",
]
