"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.frequency.loops import (
    NumericLoop,
    NumericMargins,
    numeric_loop,
    numeric_margins,
    roots_outside,
    unstable_poles,
)

__all__ = [
    "NumericLoop",
    "NumericMargins",
    "numeric_loop",
    "numeric_margins",
    "roots_outside",
    "unstable_poles",
]
