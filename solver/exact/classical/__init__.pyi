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
from solver.exact.classical.decay import Decay, DecayMode, decay
from solver.exact.classical.factors import (
    PoleZeroForm,
    ValueAtZero,
    pole_factors,
    pole_zero_factors,
    real_factors,
    value_at_zero,
)
from solver.exact.classical.reduction import NotReduced, Reduction, reduction
from solver.exact.classical.reduction_errors import (
    LargestError,
    largest_difference,
    largest_error,
    reduced_modes,
    reduced_response,
)
from solver.exact.classical.sampled_damping import NoCounterpart, SampledDamping, sampled_damping_of
from solver.exact.classical.sampled_errors import largest_sampled_error
from solver.exact.classical.sampled_events import SampledEvents, sampled_events
from solver.exact.classical.step_events import Extreme, Rise, StepEvents, step_events

__all__ = [
    "Cases",
    "Damping",
    "Decay",
    "DecayMode",
    "Extreme",
    "LargestError",
    "NoCounterpart",
    "NoFrequency",
    "NotReduced",
    "PoleZeroForm",
    "Reduction",
    "Rise",
    "SampledDamping",
    "SampledEvents",
    "StepEvents",
    "ValueAtZero",
    "damped_frequency",
    "damping_cases",
    "damping_of",
    "damping_parameter",
    "decay",
    "largest_difference",
    "largest_error",
    "largest_sampled_error",
    "pole_factors",
    "pole_zero_factors",
    "poles_of_damping",
    "real_factors",
    "reduced_modes",
    "reduced_response",
    "reduction",
    "sampled_damping_of",
    "sampled_events",
    "step_events",
    "value_at_zero",
]
