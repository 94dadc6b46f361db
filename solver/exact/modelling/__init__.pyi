"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.modelling.highest import are_linear_in, solved_linearly
from solver.exact.modelling.quotients import is_zero, jacobian, normal
from solver.exact.modelling.time_derivatives import time_derivative

__all__ = [
    "are_linear_in",
    "is_zero",
    "jacobian",
    "normal",
    "solved_linearly",
    "time_derivative",
]
