"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.time_response.exponential import exponential_residual, power_residual
from solver.numeric.judges.time_response.matrix_functions import matrix_function_residual
from solver.numeric.judges.time_response.response import (
    beginnings,
    convolution_formula,
    impulses,
    intervals,
    residual_of_pairs,
    sampled,
    samples,
    time_scale,
)
from solver.numeric.judges.time_response.trajectory import (
    difference,
    final_output,
    largest_output,
    samples_of_output,
    simulations,
)

__all__ = [
    "beginnings",
    "convolution_formula",
    "difference",
    "exponential_residual",
    "final_output",
    "impulses",
    "intervals",
    "largest_output",
    "matrix_function_residual",
    "power_residual",
    "residual_of_pairs",
    "sampled",
    "samples",
    "samples_of_output",
    "simulations",
    "time_scale",
]
