"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.functions.antiderivatives import Antiderivative, antiderivative
from solver.exact.functions.closed_forms import MatrixFunction, exponential, interpolation_coefficients, power
from solver.exact.functions.covering import (
    AtUpperRoot,
    Compared,
    Covered,
    at_upper_roots,
    compared,
    covered,
    put_together,
)
from solver.exact.functions.derivatives import derivative_of
from solver.exact.functions.fractions import Fraction, fractions_of, keeps_quadratic
from solver.exact.functions.geometric import geometric_terms
from solver.exact.functions.interpolation import Condition, interpolation
from solver.exact.functions.jordan_blocks import exponential_of_blocks, function_of_blocks, power_of_blocks
from solver.exact.functions.matrix_functions import (
    FunctionOfMatrix,
    asks_for_roots,
    matrix_function,
)
from solver.exact.functions.rational import RationalMatrix, fraction_of_term, resolvent_matrix
from solver.exact.functions.remainders import Remainder, remainder_identity
from solver.exact.functions.scalar_functions import ScalarFunction
from solver.exact.functions.transforms import (
    Denominators,
    Transformed,
    pairs_for,
    partial_fractions,
    resolvent,
    resolvent_cancels,
    transform_pairs,
    transformed_fractions,
)

__all__ = [
    "Antiderivative",
    "AtUpperRoot",
    "Compared",
    "Condition",
    "Covered",
    "Denominators",
    "Fraction",
    "FunctionOfMatrix",
    "MatrixFunction",
    "RationalMatrix",
    "Remainder",
    "ScalarFunction",
    "Transformed",
    "antiderivative",
    "asks_for_roots",
    "at_upper_roots",
    "compared",
    "covered",
    "derivative_of",
    "exponential",
    "exponential_of_blocks",
    "fraction_of_term",
    "fractions_of",
    "function_of_blocks",
    "geometric_terms",
    "interpolation",
    "interpolation_coefficients",
    "keeps_quadratic",
    "matrix_function",
    "pairs_for",
    "partial_fractions",
    "power",
    "power_of_blocks",
    "put_together",
    "remainder_identity",
    "resolvent",
    "resolvent_cancels",
    "resolvent_matrix",
    "transform_pairs",
    "transformed_fractions",
]
