"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.time_response.exponential import exponential_residual, power_residual
from solver.numeric.judges.time_response.matrix_functions import matrix_function_residual
from solver.numeric.judges.time_response.realizing import realized
from solver.numeric.judges.time_response.refined import limit_residual, peak_residual
from solver.numeric.judges.time_response.response import (
    beginnings,
    convolution_formula,
    delayed,
    impulses,
    intervals,
    residual_of_pairs,
    sampled,
    samples,
    time_scale,
)
from solver.numeric.judges.time_response.trajectory import simulations

__all__ = [
    "beginnings",
    "convolution_formula",
    "delayed",
    "exponential_residual",
    "impulses",
    "intervals",
    "limit_residual",
    "matrix_function_residual",
    "peak_residual",
    "power_residual",
    "realized",
    "residual_of_pairs",
    "sampled",
    "samples",
    "simulations",
    "time_scale",
]
