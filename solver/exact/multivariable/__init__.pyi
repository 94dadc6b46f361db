"""Where the public names of this topic are; `solver.exact` reads it."""

from solver.exact.multivariable.decoupling import (
    Channel,
    DecouplingLaw,
    HiddenMotion,
    Interaction,
    decoupling_law,
    dynamically_decouplable,
    hidden_motion,
    interaction,
    interaction_conditions,
)
from solver.exact.multivariable.exceptions import parameter_exceptions
from solver.exact.multivariable.generic import changed_where
from solver.exact.multivariable.polynomial_matrices import (
    MinorOf,
    determinantal_divisors,
    in_factors,
    minors_in_factors,
)
from solver.exact.multivariable.rational_minors import (
    Minor,
    RationalMinors,
    rational_determinant,
    rational_minors,
    rational_zeros_of_entries,
)
from solver.exact.multivariable.relative_gains import (
    Pairing,
    RelativeGains,
    ScaledGains,
    gains_at,
    pairing,
    relative_gains,
    values_at,
)
from solver.exact.multivariable.rosenbrock import (
    PolynomialMinor,
    SystemMatrix,
    common_decoupling_polynomial,
    system_matrix,
)
from solver.exact.multivariable.smith import SmithForm, smith_form
from solver.exact.multivariable.smith_mcmillan import SmithMcMillan, smith_mcmillan
from solver.exact.multivariable.smith_reduction import Division, SmithStage
from solver.exact.multivariable.zero_directions import Directions, null_directions, zero_directions

__all__ = [
    "Channel",
    "DecouplingLaw",
    "Directions",
    "Division",
    "HiddenMotion",
    "Interaction",
    "Minor",
    "MinorOf",
    "Pairing",
    "PolynomialMinor",
    "RationalMinors",
    "RelativeGains",
    "ScaledGains",
    "SmithForm",
    "SmithMcMillan",
    "SmithStage",
    "SystemMatrix",
    "changed_where",
    "common_decoupling_polynomial",
    "decoupling_law",
    "determinantal_divisors",
    "dynamically_decouplable",
    "gains_at",
    "hidden_motion",
    "in_factors",
    "interaction",
    "interaction_conditions",
    "minors_in_factors",
    "null_directions",
    "pairing",
    "parameter_exceptions",
    "rational_determinant",
    "rational_minors",
    "rational_zeros_of_entries",
    "relative_gains",
    "smith_form",
    "smith_mcmillan",
    "system_matrix",
    "values_at",
    "zero_directions",
]
