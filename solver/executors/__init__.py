"""Where calls are made: in processes of this machine that stay alive, or on a cluster. What is found is the same.

A caller hands over a function of a module and the arguments of each call, all of which can be sent, and is given the
results, or `Exceeded` for a call that met its limit. Who makes the calls is decided in one place, by whoever started
the command.
"""

from solver.executors.executor import Arguments, Executor, Unavailable
from solver.executors.processes import Processes

__all__ = ["Arguments", "Executor", "Processes", "Unavailable"]
