"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.representation.coordinates import inverse_in_full, is_singular, product_of
from solver.exact.representation.interconnection import constant_realization, fed_back, in_series
from solver.exact.representation.linear_equations import Realized, is_linear, matrix_of, realized, solved_for
from solver.exact.representation.luenberger import (
    CompanionCoordinates,
    controllable_coordinates,
    observable_coordinates,
)
from solver.exact.representation.minimal import (
    PolePart,
    companion_orders,
    entries_in_lowest_terms,
    parts_by_poles,
    rank_factors,
)
from solver.exact.representation.modes import (
    Mode,
    diagonal_realization,
    is_upper,
    jordan_realization,
    modal_realization,
    modes,
    real_and_imaginary,
)
from solver.exact.representation.realization import (
    Realization,
    common_denominators,
    controllable_realization,
    observable_realization,
)
from solver.exact.representation.transfer import TransferMatrix, transfer_matrix, transfer_matrix_of_fractions

__all__ = [
    "CompanionCoordinates",
    "Mode",
    "PolePart",
    "Realization",
    "Realized",
    "TransferMatrix",
    "common_denominators",
    "companion_orders",
    "constant_realization",
    "controllable_coordinates",
    "controllable_realization",
    "diagonal_realization",
    "entries_in_lowest_terms",
    "fed_back",
    "in_series",
    "inverse_in_full",
    "is_linear",
    "is_singular",
    "is_upper",
    "jordan_realization",
    "matrix_of",
    "modal_realization",
    "modes",
    "observable_coordinates",
    "observable_realization",
    "parts_by_poles",
    "product_of",
    "rank_factors",
    "real_and_imaginary",
    "realized",
    "solved_for",
    "transfer_matrix",
    "transfer_matrix_of_fractions",
]
