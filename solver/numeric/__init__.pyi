"""Where the public names of this package are; `__init__.py` reads it."""

from solver.numeric.evaluation.claims import check_claim, check_residual, check_steps
from solver.numeric.evaluation.environment import Environments
from solver.numeric.evaluation.equalities import equality_residual
from solver.numeric.evaluation.expressions import evaluate, values_at
from solver.numeric.evaluation.points import free_symbols, holds_decimals, typed_decimals
from solver.numeric.evaluation.precision import TOLERANCE
from solver.numeric.evaluation.ranks import independent, rank
from solver.numeric.evaluation.relations import check_relation
from solver.numeric.evaluation.rounding import agrees_to_digits
from solver.numeric.evaluation.values import NoRule, NotEvaluable, ShapeMismatch, Undefined
from solver.numeric.evaluation.vanishing import can_vanish

__all__ = [
    "TOLERANCE",
    "Environments",
    "NoRule",
    "NotEvaluable",
    "ShapeMismatch",
    "Undefined",
    "agrees_to_digits",
    "can_vanish",
    "check_claim",
    "check_relation",
    "check_residual",
    "check_steps",
    "equality_residual",
    "evaluate",
    "free_symbols",
    "holds_decimals",
    "independent",
    "rank",
    "typed_decimals",
    "values_at",
]
