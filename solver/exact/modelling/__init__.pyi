"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.modelling.circuits import CircuitModel, Law, circuit_model, degenerate
from solver.exact.modelling.highest import are_linear_in, solved_linearly
from solver.exact.modelling.quotients import is_zero, jacobian, normal
from solver.exact.modelling.time_derivatives import time_derivative
from solver.exact.modelling.turns import Solved, Turn, solved_in_turn

__all__ = [
    "CircuitModel",
    "Law",
    "Solved",
    "Turn",
    "are_linear_in",
    "circuit_model",
    "degenerate",
    "is_zero",
    "jacobian",
    "normal",
    "solved_in_turn",
    "solved_linearly",
    "time_derivative",
]
