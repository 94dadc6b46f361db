"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.modelling.circuits import CircuitModel, Law, circuit_model, degenerate
from solver.exact.modelling.collecting import collected, grouped
from solver.exact.modelling.highest import are_linear_in, solved_linearly
from solver.exact.modelling.manipulator import Manipulator, christoffel, manipulator_form
from solver.exact.modelling.quotients import is_zero, jacobian, normal
from solver.exact.modelling.time_derivatives import time_derivative
from solver.exact.modelling.turns import Solved, Turn, solved_in_turn

__all__ = [
    "CircuitModel",
    "Law",
    "Manipulator",
    "Solved",
    "Turn",
    "are_linear_in",
    "christoffel",
    "circuit_model",
    "collected",
    "degenerate",
    "grouped",
    "is_zero",
    "jacobian",
    "manipulator_form",
    "normal",
    "solved_in_turn",
    "solved_linearly",
    "time_derivative",
]
