"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.loops.errors import (
    holds_where_positive,
    order_at_origin,
    sign_residual,
    stable_loops,
)
from solver.numeric.judges.loops.flow_graphs import are_loops, are_paths, determinant_residual, transfer_residual
from solver.numeric.judges.loops.recursions import error_judges
from solver.numeric.judges.loops.sensitivities import loop_sensitivity_residual, parameter_sensitivity_residual

__all__ = [
    "are_loops",
    "are_paths",
    "determinant_residual",
    "error_judges",
    "holds_where_positive",
    "loop_sensitivity_residual",
    "order_at_origin",
    "parameter_sensitivity_residual",
    "sign_residual",
    "stable_loops",
    "transfer_residual",
]
