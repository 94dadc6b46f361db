"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.structure.controllability import controllability_matrix, reachable_order
from solver.exact.structure.critical_angles import CriticalAngles, critical_angles, is_in_angles, vanishing_form
from solver.exact.structure.critical_values import CriticalValues, critical_values, telling_minors
from solver.exact.structure.decomposition import (
    Decomposition,
    controllable_decomposition,
    controllable_part,
    independent_columns,
    kalman_decomposition,
    observable_decomposition,
    reached_in_echelon,
    seen_in_echelon,
)
from solver.exact.structure.gramian import InputResponse, discrete_gramian, finite_gramian, input_response
from solver.exact.structure.rank_conditions import rank_conditions
from solver.exact.structure.ranks import (
    HiddenPart,
    PencilRank,
    hidden_part,
    null_basis,
    pencil_ranks,
    rank,
    row_reduction,
)

__all__ = [
    "CriticalAngles",
    "CriticalValues",
    "Decomposition",
    "HiddenPart",
    "InputResponse",
    "PencilRank",
    "controllability_matrix",
    "controllable_decomposition",
    "controllable_part",
    "critical_angles",
    "critical_values",
    "discrete_gramian",
    "finite_gramian",
    "hidden_part",
    "independent_columns",
    "input_response",
    "is_in_angles",
    "kalman_decomposition",
    "null_basis",
    "observable_decomposition",
    "pencil_ranks",
    "rank",
    "rank_conditions",
    "reachable_order",
    "reached_in_echelon",
    "row_reduction",
    "seen_in_echelon",
    "telling_minors",
    "vanishing_form",
]
