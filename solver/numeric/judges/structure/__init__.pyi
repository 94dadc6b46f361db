"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.structure.angle_falls import every_angle_is_named, is_in_angles, rank_falls_at
from solver.numeric.judges.structure.controllability import (
    HiddenPart,
    hidden_modes_decay,
    hidden_modes_residual,
    krylov_matrix,
)
from solver.numeric.judges.structure.decomposition import (
    coordinates_residual,
    hidden_polynomial_residual,
    kalman_orders,
    separation_residual,
    visible_part_residual,
)
from solver.numeric.judges.structure.isolated_falls import every_isolated_fall_is_named
from solver.numeric.judges.structure.rank_falls import all_differ, every_fall_is_named, rank_falls_where

__all__ = [
    "HiddenPart",
    "all_differ",
    "coordinates_residual",
    "every_angle_is_named",
    "every_fall_is_named",
    "every_isolated_fall_is_named",
    "hidden_modes_decay",
    "hidden_modes_residual",
    "hidden_polynomial_residual",
    "is_in_angles",
    "kalman_orders",
    "krylov_matrix",
    "rank_falls_at",
    "rank_falls_where",
    "separation_residual",
    "visible_part_residual",
]
