"""The oracles: formulas and answers judged by numbers, on their own algorithms; nothing exact is imported here.

scipy is imported by the functions that need it.
"""

import os

# Of small matrices the threads of the linear algebra library cost ten to a hundred times what they save. It reads
# this when numpy is first imported; a choice of the user's is respected.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from solver.numeric.claims import check_claim, check_residual, check_steps
from solver.numeric.compare import TOLERANCE
from solver.numeric.eigen import (
    chain_residual,
    eigenpair_residual,
    left_residual,
    polynomial_residual,
    spectrum_residual,
)
from solver.numeric.evaluate import evaluate
from solver.numeric.exponential import equality_residual, exponential_residual, power_residual
from solver.numeric.jordan import chains_residual, diagonalizable, is_jordan_form, same_jordan_structure
from solver.numeric.minimal import (
    cancelled_residual,
    characteristic_residual,
    order_of_minimal_part,
    pole_residual,
    realized,
    zero_residual,
)
from solver.numeric.rank import independent, rank
from solver.numeric.values import NotEvaluable, ShapeMismatch, Undefined

__all__ = [
    "TOLERANCE",
    "NotEvaluable",
    "ShapeMismatch",
    "Undefined",
    "cancelled_residual",
    "chain_residual",
    "chains_residual",
    "characteristic_residual",
    "check_claim",
    "check_residual",
    "check_steps",
    "diagonalizable",
    "eigenpair_residual",
    "equality_residual",
    "evaluate",
    "exponential_residual",
    "independent",
    "is_jordan_form",
    "left_residual",
    "order_of_minimal_part",
    "pole_residual",
    "polynomial_residual",
    "power_residual",
    "rank",
    "realized",
    "same_jordan_structure",
    "spectrum_residual",
    "zero_residual",
]
