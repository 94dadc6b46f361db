"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.design.eigenvectors import (
    Attainable,
    Nearest,
    attainable_eigenvectors,
    conjugated,
    nearest_eigenvector,
    parts_of_columns,
    squared_length,
)
from solver.exact.design.model_matching import Matching, descending_form, matching
from solver.exact.design.observers import Partition, chosen_error_matrix, left_inverse, measured_first
from solver.exact.design.placement import (
    combine,
    companion_rows,
    conjugate_pairs,
    divided,
    fixed_factor,
    loop_coefficients,
    monic,
    polynomial_in,
    polynomial_of_matrix,
    roots_of,
    toeplitz,
)
from solver.exact.design.pole_mapping import pole_in_z
from solver.exact.design.pole_placement import ackermann
from solver.exact.design.second_order import Inconsistent, SecondOrder, second_order, specified
from solver.exact.design.set_point import NoSetPoint, SetPoint, equations_of_rest, set_point
from solver.exact.design.single_input import Direction, direction, lifted_gain
from solver.exact.design.tracking import added, at_rest, with_integrators

__all__ = [
    "Attainable",
    "Direction",
    "Inconsistent",
    "Matching",
    "Nearest",
    "NoSetPoint",
    "Partition",
    "SecondOrder",
    "SetPoint",
    "ackermann",
    "added",
    "at_rest",
    "attainable_eigenvectors",
    "chosen_error_matrix",
    "combine",
    "companion_rows",
    "conjugate_pairs",
    "conjugated",
    "descending_form",
    "direction",
    "divided",
    "equations_of_rest",
    "fixed_factor",
    "left_inverse",
    "lifted_gain",
    "loop_coefficients",
    "matching",
    "measured_first",
    "monic",
    "nearest_eigenvector",
    "parts_of_columns",
    "pole_in_z",
    "polynomial_in",
    "polynomial_of_matrix",
    "roots_of",
    "second_order",
    "set_point",
    "specified",
    "squared_length",
    "toeplitz",
    "with_integrators",
]
