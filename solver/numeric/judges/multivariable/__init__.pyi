"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.multivariable.decoupling import Acting, acting_inputs, channel_polynomials, system_matrix_of
from solver.numeric.judges.multivariable.relative_gains import relative_gain_residual
from solver.numeric.judges.multivariable.smith import MINORS, smith_mcmillan_residual, smith_residual
from solver.numeric.judges.multivariable.zeros import (
    directions_residual,
    normal_rank,
    pole_polynomial_residual,
    zero_polynomial_residual,
    zeros_residual,
)

__all__ = [
    "MINORS",
    "Acting",
    "acting_inputs",
    "channel_polynomials",
    "directions_residual",
    "normal_rank",
    "pole_polynomial_residual",
    "relative_gain_residual",
    "smith_mcmillan_residual",
    "smith_residual",
    "system_matrix_of",
    "zero_polynomial_residual",
    "zeros_residual",
]
