"""The exact kernels: algebra on matrices over a field, with no prose and no floats."""

from solver.exact.companion import controllable_form
from solver.exact.decomposition import (
    Decomposition,
    controllable_decomposition,
    independent_columns,
    kalman_decomposition,
    observable_decomposition,
)
from solver.exact.eigen import Eigenspace, Eigenstructure, eigenstructure
from solver.exact.faddeev import FaddeevLeVerrier, faddeev_leverrier
from solver.exact.fields import NotExact
from solver.exact.functions import MatrixFunction, exponential, interpolation_coefficients, power
from solver.exact.interpolation import Condition, interpolation
from solver.exact.matrices import determinant_and_adjugate, inverse, multiply, powers, taylor, truncated_series
from solver.exact.observers import Partition, chosen_error_matrix, left_inverse, measured_first
from solver.exact.placement import (
    ControllablePart,
    Direction,
    Solution,
    affine,
    combine,
    companion_rows,
    controllable_part,
    direction,
    divided,
    fixed_factor,
    lifted_gain,
    loop_coefficients,
    monic,
    polynomial_in,
    polynomial_of_matrix,
    roots_of,
    solve_affine,
    tidy,
    toeplitz,
)
from solver.exact.pole_placement import ackermann, controllability_matrix
from solver.exact.rational import RationalMatrix, between
from solver.exact.response import ClosedForm, Piece, Response, piece_response, read_inputs, response
from solver.exact.row_reduction import RowReduction, null_space, row_reduce
from solver.exact.spectrum import Factor, Root, Spectrum, factored, spectrum
from solver.exact.transfer import TransferMatrix, transfer_matrix, transfer_matrix_of_fractions
from solver.exact.transforms import pairs_for, partial_fractions, resolvent, transform_pairs

__all__ = [
    "ClosedForm",
    "Condition",
    "ControllablePart",
    "Decomposition",
    "Direction",
    "Eigenspace",
    "Eigenstructure",
    "Factor",
    "FaddeevLeVerrier",
    "MatrixFunction",
    "NotExact",
    "Partition",
    "Piece",
    "RationalMatrix",
    "Response",
    "Root",
    "RowReduction",
    "Solution",
    "Spectrum",
    "TransferMatrix",
    "ackermann",
    "affine",
    "between",
    "chosen_error_matrix",
    "combine",
    "companion_rows",
    "controllability_matrix",
    "controllable_decomposition",
    "controllable_form",
    "controllable_part",
    "determinant_and_adjugate",
    "direction",
    "divided",
    "eigenstructure",
    "exponential",
    "factored",
    "faddeev_leverrier",
    "fixed_factor",
    "independent_columns",
    "interpolation",
    "interpolation_coefficients",
    "inverse",
    "kalman_decomposition",
    "left_inverse",
    "lifted_gain",
    "loop_coefficients",
    "measured_first",
    "monic",
    "multiply",
    "null_space",
    "observable_decomposition",
    "pairs_for",
    "partial_fractions",
    "piece_response",
    "polynomial_in",
    "polynomial_of_matrix",
    "power",
    "powers",
    "read_inputs",
    "resolvent",
    "response",
    "roots_of",
    "row_reduce",
    "solve_affine",
    "spectrum",
    "taylor",
    "tidy",
    "toeplitz",
    "transfer_matrix",
    "transfer_matrix_of_fractions",
    "transform_pairs",
    "truncated_series",
]
