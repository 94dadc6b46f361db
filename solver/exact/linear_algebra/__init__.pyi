"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.linear_algebra.affine import Solution, affine, multiplied_out, solve_affine, tidy
from solver.exact.linear_algebra.eigen import Eigenspace, Eigenstructure, eigenstructure
from solver.exact.linear_algebra.elimination import LinearEquation, Substitution, elimination, independent_equations
from solver.exact.linear_algebra.faddeev import FaddeevLeVerrier, faddeev_leverrier
from solver.exact.linear_algebra.fields import NotExact, vanishing_factors
from solver.exact.linear_algebra.instances import squares_of_roots
from solver.exact.linear_algebra.matrices import (
    determinant,
    determinant_and_adjugate,
    inverse,
    multiply,
    pencil,
    powers,
    taylor,
    truncated_series,
)
from solver.exact.linear_algebra.radicals import complex_parts, without_bars
from solver.exact.linear_algebra.row_reduction import RowReduction, null_space, row_reduce
from solver.exact.linear_algebra.signs import always_holds, contradict
from solver.exact.linear_algebra.special_values import divisors, special_values
from solver.exact.linear_algebra.spectrum import (
    Factor,
    Root,
    Spectrum,
    characteristic_factors,
    factored,
    spectrum,
    spectrum_of_polynomial,
)

__all__ = [
    "Eigenspace",
    "Eigenstructure",
    "Factor",
    "FaddeevLeVerrier",
    "LinearEquation",
    "NotExact",
    "Root",
    "RowReduction",
    "Solution",
    "Spectrum",
    "Substitution",
    "affine",
    "always_holds",
    "characteristic_factors",
    "complex_parts",
    "contradict",
    "determinant",
    "determinant_and_adjugate",
    "divisors",
    "eigenstructure",
    "elimination",
    "factored",
    "faddeev_leverrier",
    "independent_equations",
    "inverse",
    "multiplied_out",
    "multiply",
    "null_space",
    "pencil",
    "powers",
    "row_reduce",
    "solve_affine",
    "special_values",
    "spectrum",
    "spectrum_of_polynomial",
    "squares_of_roots",
    "taylor",
    "tidy",
    "truncated_series",
    "vanishing_factors",
    "without_bars",
]
