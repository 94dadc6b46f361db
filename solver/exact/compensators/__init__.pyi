"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.compensators.pid import (
    ClosedLoop,
    ComparedGains,
    Tuned,
    TuningRule,
    closed_by,
    pid_parts,
    placed_gains,
    tuned,
    tuning_rules,
    wanted_polynomial,
)
from solver.exact.compensators.reaction_curve import NoCurve, ReactionCurve, reaction_curve
from solver.exact.compensators.ultimate_gain import (
    Axis,
    Crossing,
    GainInterval,
    UltimateGain,
    on_the_axis,
    ultimate_gain,
)

__all__ = [
    "Axis",
    "ClosedLoop",
    "ComparedGains",
    "Crossing",
    "GainInterval",
    "NoCurve",
    "ReactionCurve",
    "Tuned",
    "TuningRule",
    "UltimateGain",
    "closed_by",
    "on_the_axis",
    "pid_parts",
    "placed_gains",
    "reaction_curve",
    "tuned",
    "tuning_rules",
    "ultimate_gain",
    "wanted_polynomial",
]
