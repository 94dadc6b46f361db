"""The exact kernels: algebra on matrices over a field, with no prose and no floats."""

from solver.exact.affine import Solution, affine, solve_affine, tidy
from solver.exact.conditions import all_positive
from solver.exact.coordinates import inverse_in_full, is_singular, product_of
from solver.exact.decomposition import (
    Decomposition,
    controllable_decomposition,
    independent_columns,
    kalman_decomposition,
    observable_decomposition,
)
from solver.exact.definiteness import definiteness_of_numbers
from solver.exact.eigen import Eigenspace, Eigenstructure, eigenstructure
from solver.exact.faddeev import FaddeevLeVerrier, faddeev_leverrier
from solver.exact.fields import NotExact
from solver.exact.functions import MatrixFunction, exponential, interpolation_coefficients, power
from solver.exact.gramian import InputResponse, discrete_gramian, finite_gramian, input_response
from solver.exact.inequalities import sign_of
from solver.exact.input_generators import Piece, read_inputs
from solver.exact.interpolation import Condition, interpolation
from solver.exact.long_run import Peak, constant_root, decays, horizon
from solver.exact.luenberger import CompanionCoordinates, controllable_coordinates, observable_coordinates
from solver.exact.lyapunov import SingularEquation, Unknowns, lyapunov, lyapunov_equations, lyapunov_residual
from solver.exact.matrices import determinant_and_adjugate, inverse, multiply, powers, taylor, truncated_series
from solver.exact.matrix_functions import FunctionOfMatrix, matrix_function
from solver.exact.model_matching import Matching, descending_form, matching
from solver.exact.modes import (
    Mode,
    diagonal_realization,
    is_upper,
    jordan_realization,
    modal_realization,
    modes,
    real_and_imaginary,
)
from solver.exact.observers import Partition, chosen_error_matrix, left_inverse, measured_first
from solver.exact.placement import (
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
from solver.exact.pole_placement import ackermann, controllability_matrix
from solver.exact.rank_conditions import CriticalValues, critical_values, rank_conditions, telling_minors
from solver.exact.rational import RationalMatrix, resolvent_matrix
from solver.exact.realization import (
    Realization,
    common_denominators,
    controllable_realization,
    observable_realization,
)
from solver.exact.response import ClosedForm, Response, piece_response, response, shifted
from solver.exact.riccati import NotStabilizable, Riccati, RiccatiSolution, riccati, weighted_input
from solver.exact.riccati_cases import Case, case_split
from solver.exact.riccati_entries import riccati_entries
from solver.exact.root_choices import OnTheAxis
from solver.exact.routh import RouthArray, RouthRow, bilinear, routh, routh_parts
from solver.exact.row_reduction import RowReduction, null_space, row_reduce
from solver.exact.scalar_functions import ScalarFunction
from solver.exact.second_order import Inconsistent, SecondOrder, second_order, specified
from solver.exact.set_point import NoSetPoint, SetPoint, equations_of_rest, set_point
from solver.exact.single_input import (
    ControllablePart,
    Direction,
    controllable_part,
    direction,
    lifted_gain,
    reachable_order,
)
from solver.exact.spectrum import Factor, Root, Spectrum, factored, spectrum
from solver.exact.stability import (
    Location,
    definiteness,
    is_stable_polynomial,
    location,
    off_the_point_one,
    polynomial_conditions,
    stable_where,
)
from solver.exact.structure import (
    HiddenPart,
    PencilRank,
    hidden_part,
    null_basis,
    pencil_ranks,
    rank,
    row_reduction,
)
from solver.exact.tracking import added, at_rest, with_integrators
from solver.exact.transfer import TransferMatrix, transfer_matrix, transfer_matrix_of_fractions
from solver.exact.transforms import Denominators, pairs_for, partial_fractions, resolvent, transform_pairs

__all__ = [
    "Case",
    "ClosedForm",
    "CompanionCoordinates",
    "Condition",
    "ControllablePart",
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
    "weighted_input",
    "with_integrators",
]
