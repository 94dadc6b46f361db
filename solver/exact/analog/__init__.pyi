"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.analog.machine_equations import (
    Integrated,
    MachineEquations,
    NotLinearCombination,
    Scaling,
    Summed,
    combined,
    in_decimals,
    machine_equations,
    scale_factors,
    scaled,
    scaled_symbols,
)
from solver.exact.analog.maxima import Largest, Undecided, largest_size, motions_of
from solver.exact.analog.overload import first_overload
from solver.exact.analog.signs import Signs, carried_signs
from solver.exact.analog.stages import (
    ImpulseAtStartError,
    StageResponse,
    cascade_responses,
    of_time,
    stage_gains,
    stage_response,
)
from solver.exact.analog.swings import Unbounded, Unsearched
from solver.exact.analog.synthesis import NoBound, Row, Synthesis, TooLarge, Wire, bound, synthesized

__all__ = [
    "ImpulseAtStartError",
    "Integrated",
    "Largest",
    "MachineEquations",
    "NoBound",
    "NotLinearCombination",
    "Row",
    "Scaling",
    "Signs",
    "StageResponse",
    "Summed",
    "Synthesis",
    "TooLarge",
    "Unbounded",
    "Undecided",
    "Unsearched",
    "Wire",
    "bound",
    "carried_signs",
    "cascade_responses",
    "combined",
    "first_overload",
    "in_decimals",
    "largest_size",
    "machine_equations",
    "motions_of",
    "of_time",
    "scale_factors",
    "scaled",
    "scaled_symbols",
    "stage_gains",
    "stage_response",
    "synthesized",
]
