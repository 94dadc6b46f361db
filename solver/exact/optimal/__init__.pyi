"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.optimal.discrete_riccati import DiscreteRiccati, Undetermined, discrete_riccati
from solver.exact.optimal.long_horizons import limit_of_the_recursion
from solver.exact.optimal.minimal import MinimalSolution, minimal_solution
from solver.exact.optimal.pencils import annihilator, pencil_polynomial, reciprocal_factor, symplectic_pencil
from solver.exact.optimal.riccati import NotStabilizable, Riccati, RiccatiSolution, riccati
from solver.exact.optimal.riccati_cases import Case, case_split
from solver.exact.optimal.riccati_entries import (
    discrete_riccati_entries,
    expanded_around_roots,
    riccati_entries,
    riccati_weight,
)
from solver.exact.optimal.root_choices import OnTheAxis
from solver.exact.optimal.weighting import completed_square, weighted_input, weighted_transpose

__all__ = [
    "Case",
    "DiscreteRiccati",
    "MinimalSolution",
    "NotStabilizable",
    "OnTheAxis",
    "Riccati",
    "RiccatiSolution",
    "Undetermined",
    "annihilator",
    "case_split",
    "completed_square",
    "discrete_riccati",
    "discrete_riccati_entries",
    "expanded_around_roots",
    "limit_of_the_recursion",
    "minimal_solution",
    "pencil_polynomial",
    "reciprocal_factor",
    "riccati",
    "riccati_entries",
    "riccati_weight",
    "symplectic_pencil",
    "weighted_input",
    "weighted_transpose",
]
