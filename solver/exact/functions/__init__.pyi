"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.functions.closed_forms import MatrixFunction, exponential, interpolation_coefficients, power
from solver.exact.functions.interpolation import Condition, interpolation
from solver.exact.functions.jordan_blocks import exponential_of_blocks, function_of_blocks, power_of_blocks
from solver.exact.functions.matrix_functions import (
    FunctionOfMatrix,
    asks_for_roots,
    matrix_function,
)
from solver.exact.functions.rational import RationalMatrix, resolvent_matrix
from solver.exact.functions.remainders import Remainder, remainder_identity
from solver.exact.functions.scalar_functions import ScalarFunction
from solver.exact.functions.transforms import (
    Denominators,
    pairs_for,
    partial_fractions,
    resolvent,
    resolvent_cancels,
    transform_pairs,
)

__all__ = [
    "Condition",
    "Denominators",
    "FunctionOfMatrix",
    "MatrixFunction",
    "RationalMatrix",
    "Remainder",
    "ScalarFunction",
    "asks_for_roots",
    "exponential",
    "exponential_of_blocks",
    "function_of_blocks",
    "interpolation",
    "interpolation_coefficients",
    "matrix_function",
    "pairs_for",
    "partial_fractions",
    "power",
    "power_of_blocks",
    "remainder_identity",
    "resolvent",
    "resolvent_cancels",
    "resolvent_matrix",
    "transform_pairs",
]
