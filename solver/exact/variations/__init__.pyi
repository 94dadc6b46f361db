"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.variations.constant_coefficients import FundamentalSystem, Trial, fundamental_system, trials
from solver.exact.variations.increments import Increment, increment
from solver.exact.variations.linear_forms import LinearForm, factors_that_vanish, highest_jet, linear_form
from solver.exact.variations.table_of_integrals import integrated, table_integral
from solver.exact.variations.variational_derivatives import (
    Cleared,
    VariationalDerivative,
    cleared,
    never_zero,
    variational_derivative,
)

__all__ = [
    "Cleared",
    "FundamentalSystem",
    "Increment",
    "LinearForm",
    "Trial",
    "VariationalDerivative",
    "cleared",
    "factors_that_vanish",
    "fundamental_system",
    "highest_jet",
    "increment",
    "integrated",
    "linear_form",
    "never_zero",
    "table_integral",
    "trials",
    "variational_derivative",
]
