"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.representation.forms import (
    has_companion_blocks,
    is_chain_form,
    is_companion,
    is_diagonal,
    is_unit_vector,
)
from solver.numeric.judges.representation.minimal import (
    cancelled_residual,
    characteristic_residual,
    order_of_minimal_part,
    pole_residual,
    realized,
)
from solver.numeric.judges.representation.zeros import zero_residual

__all__ = [
    "cancelled_residual",
    "characteristic_residual",
    "has_companion_blocks",
    "is_chain_form",
    "is_companion",
    "is_diagonal",
    "is_unit_vector",
    "order_of_minimal_part",
    "pole_residual",
    "realized",
    "zero_residual",
]
