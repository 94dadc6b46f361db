"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.classical.damping import (
    cases_fault,
    critical_residual,
    damping_ratio_residual,
    damping_words,
    natural_frequency_residual,
)
from solver.numeric.judges.classical.poles import shown_poles, time_constants_residual
from solver.numeric.judges.classical.reductions import dominant_residual, reduced_residual
from solver.numeric.judges.classical.sampled_responses import (
    is_bounded,
    largest_sample_fault,
    overshoots,
    samples_fault,
)
from solver.numeric.judges.classical.step_responses import (
    Specification,
    largest_sampled_difference,
    largest_size_residual,
    specification_residual,
    undershoot_residual,
)
from solver.numeric.judges.classical.values import dc_gain_residual, leading_gain_residual

__all__ = [
    "Specification",
    "cases_fault",
    "critical_residual",
    "damping_ratio_residual",
    "damping_words",
    "dc_gain_residual",
    "dominant_residual",
    "is_bounded",
    "largest_sample_fault",
    "largest_sampled_difference",
    "largest_size_residual",
    "leading_gain_residual",
    "natural_frequency_residual",
    "overshoots",
    "reduced_residual",
    "samples_fault",
    "shown_poles",
    "specification_residual",
    "time_constants_residual",
    "undershoot_residual",
]
