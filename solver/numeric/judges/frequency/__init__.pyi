"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.frequency.crossings import (
    are_half_turns,
    decimal,
    direction,
    fits,
    has_phase,
    is_everywhere,
    is_real,
    is_size_equation,
    is_slope_equation,
    list_residual,
)
from solver.numeric.judges.frequency.loops import (
    NumericLoop,
    NumericMargins,
    closed_loop_poles,
    margin_residual,
    numeric_loop,
    numeric_margins,
    roots_outside,
    unstable_poles,
)

__all__ = [
    "NumericLoop",
    "NumericMargins",
    "are_half_turns",
    "closed_loop_poles",
    "decimal",
    "direction",
    "fits",
    "has_phase",
    "is_everywhere",
    "is_real",
    "is_size_equation",
    "is_slope_equation",
    "list_residual",
    "margin_residual",
    "numeric_loop",
    "numeric_margins",
    "roots_outside",
    "unstable_poles",
]
