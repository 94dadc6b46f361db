"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.stability.boundary import boundary_roots, edges
from solver.exact.stability.conditions import all_positive
from solver.exact.stability.definiteness import definiteness_of_numbers, negative_by_rounding
from solver.exact.stability.inequalities import sign_of
from solver.exact.stability.location import (
    Location,
    definiteness,
    is_stable_polynomial,
    location,
    off_the_point_one,
    polynomial_conditions,
    root_conditions,
    stable_where,
)
from solver.exact.stability.lyapunov import SingularEquation, Unknowns, lyapunov, lyapunov_equations, lyapunov_residual
from solver.exact.stability.planar import PlanarSigns, invariants, invariants_in_z, planar_signs, planar_signs_in_z
from solver.exact.stability.root_counts import RootCounts, hurwitz_matrix, root_counts, sign_changes
from solver.exact.stability.routh import RouthArray, RouthRow, bilinear, routh, routh_parts

__all__ = [
    "Location",
    "PlanarSigns",
    "RootCounts",
    "RouthArray",
    "RouthRow",
    "SingularEquation",
    "Unknowns",
    "all_positive",
    "bilinear",
    "boundary_roots",
    "definiteness",
    "definiteness_of_numbers",
    "edges",
    "hurwitz_matrix",
    "invariants",
    "invariants_in_z",
    "is_stable_polynomial",
    "location",
    "lyapunov",
    "lyapunov_equations",
    "lyapunov_residual",
    "negative_by_rounding",
    "off_the_point_one",
    "planar_signs",
    "planar_signs_in_z",
    "polynomial_conditions",
    "root_conditions",
    "root_counts",
    "routh",
    "routh_parts",
    "sign_changes",
    "sign_of",
    "stable_where",
]
