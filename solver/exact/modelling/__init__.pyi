"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.modelling.branches import Move, Roots
from solver.exact.modelling.circuits import CircuitModel, Law, circuit_model, degenerate
from solver.exact.modelling.collecting import collected, grouped
from solver.exact.modelling.derivatives import is_nonlinear, partial
from solver.exact.modelling.highest import are_linear_in, coefficients_of, solved_linearly
from solver.exact.modelling.linearized import NotDifferentiable, Partial, Quotient, condition_of, partials_at, put_in
from solver.exact.modelling.manipulator import Manipulator, christoffel, manipulator_form
from solver.exact.modelling.nodal import NodalModel, nodal_model
from solver.exact.modelling.quotients import is_zero, jacobian, normal
from solver.exact.modelling.roots_of_systems import real_solutions
from solver.exact.modelling.time_derivatives import time_derivative
from solver.exact.modelling.turns import Solved, Turn, solved_in_turn

__all__ = [
    "CircuitModel",
    "Law",
    "Manipulator",
    "Move",
    "NodalModel",
    "NotDifferentiable",
    "Partial",
    "Quotient",
    "Roots",
    "Solved",
    "Turn",
    "are_linear_in",
    "christoffel",
    "circuit_model",
    "coefficients_of",
    "collected",
    "condition_of",
    "degenerate",
    "grouped",
    "is_nonlinear",
    "is_zero",
    "jacobian",
    "manipulator_form",
    "nodal_model",
    "normal",
    "partial",
    "partials_at",
    "put_in",
    "real_solutions",
    "solved_in_turn",
    "solved_linearly",
    "time_derivative",
]
