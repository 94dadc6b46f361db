"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.judges.linear_algebra.eigen import (
    chain_residual,
    decimal_eigenvalues,
    eigenpair_residual,
    left_residual,
    polynomial_residual,
    spectrum_residual,
)
from solver.numeric.judges.linear_algebra.jordan import (
    are_in_order,
    chains_residual,
    diagonalizable,
    is_jordan_form,
    same_jordan_structure,
)
from solver.numeric.judges.linear_algebra.spaces import null_residual, range_residual

__all__ = [
    "are_in_order",
    "chain_residual",
    "chains_residual",
    "decimal_eigenvalues",
    "diagonalizable",
    "eigenpair_residual",
    "is_jordan_form",
    "left_residual",
    "null_residual",
    "polynomial_residual",
    "range_residual",
    "same_jordan_structure",
    "spectrum_residual",
]
