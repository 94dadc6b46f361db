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
from solver.exact.classical.step_events import Extreme, Rise, StepEvents, step_events

__all__ = [
    "Cases",
    "Damping",
    "Decay",
    "Extreme",
    "Mode",
    "NoFrequency",
    "PoleZeroForm",
    "Rise",
    "StepEvents",
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
    "step_events",
    "value_at_zero",
]
