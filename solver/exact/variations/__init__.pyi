"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.variations.along import along, decimal_integral, definite_integral, in_time, without_roots
from solver.exact.variations.constant_coefficients import FundamentalSystem, Trial, fundamental_system, trials
from solver.exact.variations.coupled_variations import (
    CoupledVariations,
    coupled_variations,
    first_singular,
    from_zero,
    jacobi_equations,
)
from solver.exact.variations.euler_cauchy import EulerCauchy, euler_cauchy, powers_of_time, trials_in_powers
from solver.exact.variations.horizons import FiniteHorizon, finite_horizon
from solver.exact.variations.increments import Increment, increment
from solver.exact.variations.integrating_factors import IntegratingFactor, integrating_factor
from solver.exact.variations.linear_forms import LinearForm, factors_that_vanish, highest_jet, linear_form
from solver.exact.variations.minimum_energy import MinimumEnergy, NotReachable, minimum_energy
from solver.exact.variations.recursions import Recursion, riccati_recursion
from solver.exact.variations.second_variation import (
    Conjugate,
    SecondVariation,
    bending,
    conjugate,
    definite_in_time,
    first_zero_from,
    hessian,
    in_motion,
    jacobi_equation,
    second_variation,
    with_values,
)
from solver.exact.variations.separated import Rate, Separated, rate_of, separated, with_square
from solver.exact.variations.signs_in_time import leaves_reals, signs_in_time, without_squares
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
    "Conjugate",
    "CoupledVariations",
    "EulerCauchy",
    "FiniteHorizon",
    "FundamentalSystem",
    "Increment",
    "IntegratingFactor",
    "LinearForm",
    "MinimumEnergy",
    "NotReachable",
    "Rate",
    "Recursion",
    "SecondVariation",
    "Separated",
    "Trial",
    "VariationalDerivative",
    "along",
    "bending",
    "cleared",
    "conjugate",
    "coupled_variations",
    "decimal_integral",
    "definite_in_time",
    "definite_integral",
    "euler_cauchy",
    "factors_that_vanish",
    "finite_horizon",
    "first_singular",
    "first_zero_from",
    "from_zero",
    "fundamental_system",
    "hessian",
    "highest_jet",
    "in_motion",
    "in_time",
    "increment",
    "integrated",
    "integrating_factor",
    "jacobi_equation",
    "jacobi_equations",
    "leaves_reals",
    "linear_form",
    "minimum_energy",
    "never_zero",
    "powers_of_time",
    "rate_of",
    "riccati_recursion",
    "second_variation",
    "separated",
    "signs_in_time",
    "table_integral",
    "trials",
    "trials_in_powers",
    "variational_derivative",
    "with_square",
    "with_values",
    "without_roots",
    "without_squares",
]
