"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.digital.deadbeat import fewest_steps, remaining, states_at_rest
from solver.numeric.judges.digital.direct import DirectQuestion, direct_plant, loop_fault, wanted_loop
from solver.numeric.judges.digital.matching import mapped_residual, matched_residual
from solver.numeric.judges.digital.pulses import controller_samples, pid_samples, recursion_samples
from solver.numeric.judges.digital.sampled import Sampling, loop_residual, periods, stated_pulse
from solver.numeric.judges.digital.tables import jury_fault, table_fault

__all__ = [
    "DirectQuestion",
    "Sampling",
    "controller_samples",
    "direct_plant",
    "fewest_steps",
    "jury_fault",
    "loop_fault",
    "loop_residual",
    "mapped_residual",
    "matched_residual",
    "periods",
    "pid_samples",
    "recursion_samples",
    "remaining",
    "stated_pulse",
    "states_at_rest",
    "table_fault",
    "wanted_loop",
]
