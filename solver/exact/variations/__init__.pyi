"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.variations.along import along, definite_integral, tidy_in_time
from solver.exact.variations.constant_coefficients import FundamentalSystem, Trial, fundamental_system, trials
from solver.exact.variations.increments import Increment, increment
from solver.exact.variations.linear_forms import LinearForm, factors_that_vanish, highest_jet, linear_form
from solver.exact.variations.minimum_energy import MinimumEnergy, NotReachable, minimum_energy
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
    "MinimumEnergy",
    "NotReachable",
    "Trial",
    "VariationalDerivative",
    "along",
    "cleared",
    "definite_integral",
    "factors_that_vanish",
    "fundamental_system",
    "highest_jet",
    "increment",
    "integrated",
    "linear_form",
    "minimum_energy",
    "never_zero",
    "table_integral",
    "tidy_in_time",
    "trials",
    "variational_derivative",
]
