"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.digital.deadbeat import fewest_steps, remaining
from solver.numeric.judges.digital.tables import jury_fault, table_fault

__all__ = ["fewest_steps", "jury_fault", "remaining", "table_fault"]
