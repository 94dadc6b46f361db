"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.analog.machine_equations import (
    Integrated,
    MachineEquations,
    NotLinearCombination,
    Scaling,
    Summed,
    combined,
    machine_equations,
    scale_factors,
    scaled,
    scaled_symbols,
)
from solver.exact.analog.maxima import Largest, Undecided, largest_size
from solver.exact.analog.swings import Unbounded, Unsearched

__all__ = [
    "Integrated",
    "Largest",
    "MachineEquations",
    "NotLinearCombination",
    "Scaling",
    "Summed",
    "Unbounded",
    "Undecided",
    "Unsearched",
    "combined",
    "largest_size",
    "machine_equations",
    "scale_factors",
    "scaled",
    "scaled_symbols",
]
