"""Where the public names of this package are; `__init__.py` reads it."""

from solver.exact.design.model_matching import Matching, descending_form, matching
from solver.exact.design.observers import Partition, chosen_error_matrix, left_inverse, measured_first
from solver.exact.design.placement import (
    combine,
    companion_rows,
    divided,
    fixed_factor,
    loop_coefficients,
    monic,
    polynomial_in,
    polynomial_of_matrix,
    roots_of,
    toeplitz,
)
from solver.exact.design.pole_placement import ackermann
from solver.exact.design.second_order import Inconsistent, SecondOrder, second_order, specified
from solver.exact.design.set_point import NoSetPoint, SetPoint, equations_of_rest, set_point
from solver.exact.design.single_input import Direction, direction, lifted_gain
from solver.exact.design.tracking import added, at_rest, with_integrators
from solver.exact.functions.closed_forms import MatrixFunction, exponential, interpolation_coefficients, power
from solver.exact.functions.interpolation import Condition, interpolation
from solver.exact.functions.matrix_functions import FunctionOfMatrix, matrix_function
from solver.exact.functions.rational import RationalMatrix, resolvent_matrix
from solver.exact.functions.scalar_functions import ScalarFunction
from solver.exact.functions.transforms import (
    Denominators,
    pairs_for,
    partial_fractions,
    resolvent,
    resolvent_cancels,
    transform_pairs,
)
from solver.exact.linear_algebra.affine import Solution, affine, solve_affine, tidy
from solver.exact.linear_algebra.eigen import Eigenspace, Eigenstructure, eigenstructure
from solver.exact.linear_algebra.faddeev import FaddeevLeVerrier, faddeev_leverrier
from solver.exact.linear_algebra.fields import NotExact, vanishing_factors
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
from solver.exact.linear_algebra.row_reduction import RowReduction, null_space, row_reduce
from solver.exact.linear_algebra.spectrum import Factor, Root, Spectrum, factored, spectrum
from solver.exact.optimal.riccati import NotStabilizable, Riccati, RiccatiSolution, riccati, weighted_input
from solver.exact.optimal.riccati_cases import Case, case_split
from solver.exact.optimal.riccati_entries import riccati_entries
from solver.exact.optimal.root_choices import OnTheAxis
from solver.exact.representation.coordinates import inverse_in_full, is_singular, product_of
from solver.exact.representation.luenberger import (
    CompanionCoordinates,
    controllable_coordinates,
    observable_coordinates,
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
from solver.exact.stability.conditions import all_positive
from solver.exact.stability.definiteness import definiteness_of_numbers
from solver.exact.stability.inequalities import sign_of
from solver.exact.stability.location import (
    Location,
    definiteness,
    is_stable_polynomial,
    location,
    off_the_point_one,
    polynomial_conditions,
    stable_where,
)
from solver.exact.stability.lyapunov import SingularEquation, Unknowns, lyapunov, lyapunov_equations, lyapunov_residual
from solver.exact.stability.routh import RouthArray, RouthRow, bilinear, routh, routh_parts
from solver.exact.structure.controllability import controllability_matrix, reachable_order
from solver.exact.structure.critical_values import CriticalValues, critical_values, telling_minors
from solver.exact.structure.decomposition import (
    Decomposition,
    controllable_decomposition,
    controllable_part,
    independent_columns,
    kalman_decomposition,
    observable_decomposition,
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
from solver.exact.time_response.input_generators import Piece, read_inputs
from solver.exact.time_response.long_run import constant_root, decays, horizon
from solver.exact.time_response.peaks import Peak
from solver.exact.time_response.response import ClosedForm, Response, piece_response, response, shifted

__all__ = [
    "Case",
    "ClosedForm",
    "CompanionCoordinates",
    "Condition",
    "CriticalValues",
    "Decomposition",
    "Denominators",
    "Direction",
    "Eigenspace",
    "Eigenstructure",
    "Factor",
    "FaddeevLeVerrier",
    "FunctionOfMatrix",
    "HiddenPart",
    "Inconsistent",
    "InputResponse",
    "Location",
    "Matching",
    "MatrixFunction",
    "Mode",
    "NoSetPoint",
    "NotExact",
    "NotStabilizable",
    "OnTheAxis",
    "Partition",
    "Peak",
    "PencilRank",
    "Piece",
    "RationalMatrix",
    "Realization",
    "Response",
    "Riccati",
    "RiccatiSolution",
    "Root",
    "RouthArray",
    "RouthRow",
    "RowReduction",
    "ScalarFunction",
    "SecondOrder",
    "SetPoint",
    "SingularEquation",
    "Solution",
    "Spectrum",
    "TransferMatrix",
    "Unknowns",
    "ackermann",
    "added",
    "affine",
    "all_positive",
    "at_rest",
    "bilinear",
    "case_split",
    "chosen_error_matrix",
    "combine",
    "common_denominators",
    "companion_rows",
    "constant_root",
    "controllability_matrix",
    "controllable_coordinates",
    "controllable_decomposition",
    "controllable_part",
    "controllable_realization",
    "critical_values",
    "decays",
    "definiteness",
    "definiteness_of_numbers",
    "descending_form",
    "determinant",
    "determinant_and_adjugate",
    "diagonal_realization",
    "direction",
    "discrete_gramian",
    "divided",
    "eigenstructure",
    "equations_of_rest",
    "exponential",
    "factored",
    "faddeev_leverrier",
    "finite_gramian",
    "fixed_factor",
    "hidden_part",
    "horizon",
    "independent_columns",
    "input_response",
    "interpolation",
    "interpolation_coefficients",
    "inverse",
    "inverse_in_full",
    "is_singular",
    "is_stable_polynomial",
    "is_upper",
    "jordan_realization",
    "kalman_decomposition",
    "left_inverse",
    "lifted_gain",
    "location",
    "loop_coefficients",
    "lyapunov",
    "lyapunov_equations",
    "lyapunov_residual",
    "matching",
    "matrix_function",
    "measured_first",
    "modal_realization",
    "modes",
    "monic",
    "multiply",
    "null_basis",
    "null_space",
    "observable_coordinates",
    "observable_decomposition",
    "observable_realization",
    "off_the_point_one",
    "pairs_for",
    "partial_fractions",
    "pencil",
    "pencil_ranks",
    "piece_response",
    "polynomial_conditions",
    "polynomial_in",
    "polynomial_of_matrix",
    "power",
    "powers",
    "product_of",
    "rank",
    "rank_conditions",
    "reachable_order",
    "read_inputs",
    "real_and_imaginary",
    "resolvent",
    "resolvent_cancels",
    "resolvent_matrix",
    "response",
    "riccati",
    "riccati_entries",
    "roots_of",
    "routh",
    "routh_parts",
    "row_reduce",
    "row_reduction",
    "second_order",
    "set_point",
    "shifted",
    "sign_of",
    "solve_affine",
    "specified",
    "spectrum",
    "stable_where",
    "taylor",
    "telling_minors",
    "tidy",
    "toeplitz",
    "transfer_matrix",
    "transfer_matrix_of_fractions",
    "transform_pairs",
    "truncated_series",
    "vanishing_factors",
    "weighted_input",
    "with_integrators",
]
