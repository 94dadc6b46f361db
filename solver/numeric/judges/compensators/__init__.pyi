"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.compensators.compensators import (
    CompensatorQuestion,
    compensator_residual,
    controller_from,
    faults_of,
    fits_the_sections,
    is_the_crossover,
    least_gain_residual,
)
from solver.numeric.judges.compensators.pid import PidQuestion, pid_residual

__all__ = [
    "CompensatorQuestion",
    "PidQuestion",
    "compensator_residual",
    "controller_from",
    "faults_of",
    "fits_the_sections",
    "is_the_crossover",
    "least_gain_residual",
    "pid_residual",
]
