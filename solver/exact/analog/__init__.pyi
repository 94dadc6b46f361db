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

__all__ = [
    "Integrated",
    "MachineEquations",
    "NotLinearCombination",
    "Scaling",
    "Summed",
    "combined",
    "machine_equations",
    "scale_factors",
    "scaled",
    "scaled_symbols",
]
