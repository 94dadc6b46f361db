"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.loops.errors import (
    order_at_origin,
    residual_beside_origin,
    residual_of_simulation,
    stable_loops,
)

__all__ = ["order_at_origin", "residual_beside_origin", "residual_of_simulation", "stable_loops"]
