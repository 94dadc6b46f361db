"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.digital.deadbeat import Stage, stages_to_rest
from solver.exact.digital.direct_design import (
    DirectDesign,
    DirectTarget,
    admissible_target,
    direct_design,
    direct_target,
    factors_in,
    monic_fraction,
    not_inside,
)
from solver.exact.digital.fractions import FractionInZ
from solver.exact.digital.holds import Held, augmented, held_blocks, integral_of_exponential, zero_order_hold
from solver.exact.digital.jury import (
    DiscCounts,
    JuryConditions,
    JuryRow,
    JuryTable,
    bilinear_image,
    disc_counts,
    inside_by_jury,
    jury_conditions,
    jury_table,
    off_the_point_minus_one,
)
from solver.exact.digital.maps import (
    Mapped,
    MappedQuotient,
    Rule,
    longest_period,
    mapped_matrices,
    mapped_quotient,
    rule_of,
)
from solver.exact.digital.matched import MappedRoot, Matched, factors_in_z, mapped_roots, matched, product_in_z
from solver.exact.digital.pid import DiscretePid, discrete_pid, integral_weights
from solver.exact.digital.pulses import Pulse, SampledTerm, dead_time_in_periods, pulse, two_factors
from solver.exact.digital.sampled_loops import SampledLoop, closed_in_z, in_series_in_z

__all__ = [
    "DirectDesign",
    "DirectTarget",
    "DiscCounts",
    "DiscretePid",
    "FractionInZ",
    "Held",
    "JuryConditions",
    "JuryRow",
    "JuryTable",
    "Mapped",
    "MappedQuotient",
    "MappedRoot",
    "Matched",
    "Pulse",
    "Rule",
    "SampledLoop",
    "SampledTerm",
    "Stage",
    "admissible_target",
    "augmented",
    "bilinear_image",
    "closed_in_z",
    "dead_time_in_periods",
    "direct_design",
    "direct_target",
    "disc_counts",
    "discrete_pid",
    "factors_in",
    "factors_in_z",
    "held_blocks",
    "in_series_in_z",
    "inside_by_jury",
    "integral_of_exponential",
    "integral_weights",
    "jury_conditions",
    "jury_table",
    "longest_period",
    "mapped_matrices",
    "mapped_quotient",
    "mapped_roots",
    "matched",
    "monic_fraction",
    "not_inside",
    "off_the_point_minus_one",
    "product_in_z",
    "pulse",
    "rule_of",
    "stages_to_rest",
    "two_factors",
    "zero_order_hold",
]
