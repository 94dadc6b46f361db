"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.variations.constant_coefficients import FundamentalSystem, Trial, fundamental_system, trials
from solver.exact.variations.linear_forms import LinearForm, factors_that_vanish, highest_jet, linear_form

__all__ = [
    "FundamentalSystem",
    "LinearForm",
    "Trial",
    "factors_that_vanish",
    "fundamental_system",
    "highest_jet",
    "linear_form",
    "trials",
]
