"""The exact kernels: algebra on matrices over a field, with no prose and no floats."""

from solver.exact.decomposition import (
    Decomposition,
    controllable_decomposition,
    kalman_decomposition,
    observable_decomposition,
)
from solver.exact.companion import controllable_form
from solver.exact.eigen import Eigenspace, Eigenstructure, eigenstructure
from solver.exact.faddeev import FaddeevLeVerrier, faddeev_leverrier
from solver.exact.fields import NotExact
from solver.exact.functions import MatrixFunction, exponential, interpolation_coefficients, power
from solver.exact.interpolation import Condition, interpolation
from solver.exact.matrices import determinant_and_adjugate, inverse, multiply, powers, taylor, truncated_series
from solver.exact.pole_placement import ackermann, controllability_matrix
from solver.exact.row_reduction import RowReduction, null_space, row_reduce
from solver.exact.spectrum import Factor, Root, Spectrum, factored, spectrum
from solver.exact.transfer import TransferMatrix, transfer_matrix, transfer_matrix_of_fractions
from solver.exact.transforms import partial_fractions, resolvent, transform_pairs

__all__ = [
    "Condition",
    "Decomposition",
    "Eigenspace",
    "Eigenstructure",
    "Factor",
    "FaddeevLeVerrier",
    "MatrixFunction",
    "NotExact",
    "Root",
    "RowReduction",
    "Spectrum",
    "TransferMatrix",
    "ackermann",
    "controllability_matrix",
    "controllable_form",
    "controllable_decomposition",
    "determinant_and_adjugate",
    "eigenstructure",
    "exponential",
    "factored",
    "faddeev_leverrier",
    "interpolation",
    "interpolation_coefficients",
    "inverse",
    "kalman_decomposition",
    "multiply",
    "null_space",
    "observable_decomposition",
    "partial_fractions",
    "power",
    "powers",
    "resolvent",
    "row_reduce",
    "spectrum",
    "taylor",
    "transfer_matrix",
    "transfer_matrix_of_fractions",
    "transform_pairs",
    "truncated_series",
]
