"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.compensators.pid import PidQuestion, pid_residual

__all__ = ["PidQuestion", "pid_residual"]
