"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.digital.deadbeat import fewest_steps, remaining, states_at_rest
from solver.numeric.judges.digital.sampled import Sampling, loop_residual, stated_pulse
from solver.numeric.judges.digital.tables import jury_fault, table_fault

__all__ = ["fewest_steps", "jury_fault", "remaining", "states_at_rest", "table_fault"]
