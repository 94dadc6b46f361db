"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.frequency.corners import are_slopes, bode_gain_residual, corner_residual
from solver.numeric.judges.frequency.crossings import (
    are_flat,
    are_half_turns,
    decimal,
    direction,
    fits,
    has_no_peak,
    has_phase,
    is_everywhere,
    is_real,
    is_size_equation,
    is_slope_equation,
    list_residual,
    peak_of,
)
from solver.numeric.judges.frequency.loops import (
    NumericLoop,
    NumericMargins,
    margin_residual,
    numeric_margins,
    roots_outside,
    unstable_poles,
)
from solver.numeric.judges.frequency.numbers import closed_loop_poles, numeric_loop
from solver.numeric.judges.frequency.responses import ClosedResponse, closed_response, frequencies_asked
from solver.numeric.judges.frequency.turns import crossing_residual, turns_about
from solver.numeric.judges.frequency.values import values_of_parameters

__all__ = [
    "ClosedResponse",
    "NumericLoop",
    "NumericMargins",
    "are_flat",
    "are_half_turns",
    "are_slopes",
    "bode_gain_residual",
    "closed_loop_poles",
    "closed_response",
    "corner_residual",
    "crossing_residual",
    "decimal",
    "direction",
    "fits",
    "frequencies_asked",
    "has_no_peak",
    "has_phase",
    "is_everywhere",
    "is_real",
    "is_size_equation",
    "is_slope_equation",
    "list_residual",
    "margin_residual",
    "numeric_loop",
    "numeric_margins",
    "peak_of",
    "roots_outside",
    "turns_about",
    "unstable_poles",
    "values_of_parameters",
]
