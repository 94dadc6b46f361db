"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.classical.damping import (
    Cases,
    Damping,
    NoFrequency,
    damped_frequency,
    damping_cases,
    damping_of,
    damping_parameter,
    poles_of_damping,
)
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
    "Cases",
    "Damping",
    "Decay",
    "Mode",
    "NoFrequency",
    "PoleZeroForm",
    "ValueAtZero",
    "damped_frequency",
    "damping_cases",
    "damping_of",
    "damping_parameter",
    "decay",
    "pole_factors",
    "pole_zero_factors",
    "poles_of_damping",
    "real_factors",
    "value_at_zero",
]
