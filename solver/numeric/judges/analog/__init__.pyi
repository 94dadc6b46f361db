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

__all__ = [
    "Asked",
    "expected_overload",
    "freed_gap",
    "overload_of",
    "overload_residual",
    "readout_gaps",
    "within_digits",
]
