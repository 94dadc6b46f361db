"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.modelling.equations import Question, eliminated_residual, model_residuals
from solver.numeric.judges.modelling.functions import function_residuals, value_residual

__all__ = ["Question", "eliminated_residual", "function_residuals", "model_residuals", "value_residual"]
