"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.modelling.equations import Question, eliminated_residual, model_residuals

__all__ = ["Question", "eliminated_residual", "model_residuals"]
