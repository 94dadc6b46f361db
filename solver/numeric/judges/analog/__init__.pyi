"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.analog.posed import Asked
from solver.numeric.judges.analog.programs import (
    expected_overload,
    freed_gap,
    overload_of,
    overload_residual,
    readout_gaps,
    within_digits,
)
from solver.numeric.judges.analog.repairs import repair_of
from solver.numeric.judges.analog.scaling import accuracy, largest_sizes, scaled_residuals
from solver.numeric.judges.analog.stages import output_residual, transform_residual

__all__ = [
    "Asked",
    "accuracy",
    "expected_overload",
    "freed_gap",
    "largest_sizes",
    "output_residual",
    "overload_of",
    "overload_residual",
    "readout_gaps",
    "repair_of",
    "scaled_residuals",
    "transform_residual",
    "within_digits",
]
