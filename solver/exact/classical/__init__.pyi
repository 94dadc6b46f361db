"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.classical.decay import Decay, Mode, decay
from solver.exact.classical.factors import (
    PoleZeroForm,
    ValueAtZero,
    pole_factors,
    pole_zero_factors,
    real_factors,
    value_at_zero,
)

__all__ = [
    "Decay",
    "Mode",
    "PoleZeroForm",
    "ValueAtZero",
    "decay",
    "pole_factors",
    "pole_zero_factors",
    "real_factors",
    "value_at_zero",
]
