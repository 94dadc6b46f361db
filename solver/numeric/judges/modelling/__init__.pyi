"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.modelling.beginnings import beginning_residual
from solver.numeric.judges.modelling.circuits import frequencies_residual, state_residuals, transfer_residual
from solver.numeric.judges.modelling.conditions import condition_residual, motion_where
from solver.numeric.judges.modelling.equations import Question, eliminated_residual, model_residuals, states_of
from solver.numeric.judges.modelling.functions import function_residuals, value_residual
from solver.numeric.judges.modelling.linearized import linear_residuals, shrinking
from solver.numeric.judges.modelling.motion import (
    Balance,
    energy_of_motion_residual,
    energy_residual,
    equation_balance,
    form_residual,
)
from solver.numeric.judges.modelling.points import is_regular_at, missing, substitution_residual

__all__ = [
    "Balance",
    "Question",
    "beginning_residual",
    "condition_residual",
    "eliminated_residual",
    "energy_of_motion_residual",
    "energy_residual",
    "equation_balance",
    "form_residual",
    "frequencies_residual",
    "function_residuals",
    "is_regular_at",
    "linear_residuals",
    "missing",
    "model_residuals",
    "motion_where",
    "shrinking",
    "state_residuals",
    "states_of",
    "substitution_residual",
    "transfer_residual",
    "value_residual",
]
