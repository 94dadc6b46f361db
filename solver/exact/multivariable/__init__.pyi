"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.multivariable.rational_minors import Minor, RationalMinors, rational_minors
from solver.exact.multivariable.rosenbrock import (
    PolynomialMinor,
    SystemMatrix,
    common_decoupling_polynomial,
    system_matrix,
)
from solver.exact.multivariable.zero_directions import Directions, null_directions, zero_directions

__all__ = [
    "Directions",
    "Minor",
    "PolynomialMinor",
    "RationalMinors",
    "SystemMatrix",
    "common_decoupling_polynomial",
    "null_directions",
    "rational_minors",
    "system_matrix",
    "zero_directions",
]
