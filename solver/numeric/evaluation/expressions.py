"""Evaluation of sympy expressions by a walk of our own, with the rounding of each value known.

Neither `lambdify` nor `subs` nor `evalf` takes part, so that a fault there can't be on both sides of a check.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from solver.numeric.evaluation import functions, integrals, stated, unknown_functions  # noqa: F401 - they register rules
from solver.numeric.evaluation.arithmetic import DOUBLE, multiple
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import SAFETY, Undefined, Value
from solver.numeric.evaluation.walk import walk
from solver.words import Phrase


def evaluate(expression: Any, point: Mapping[Any, complex], *, tolerance: float = 1e-12) -> Any:
    """Return the value at one point: complex for an expression, a complex array for a matrix or (nested) list.

    Formulas that are `Stated` are evaluated too, by algorithms of their own.
    Where cancellation leaves fewer digits than `tolerance` (relative to each entry) asks for, the evaluation is
    repeated with 50, then with 100 digits. Raises NotEvaluable, or Undefined where there is no finite value.
    """
    for arithmetic in (DOUBLE, multiple(50), multiple(100)):
        result = value_of(expression, Environment.at([point], arithmetic))
        size = arithmetic.size(result.value)
        if np.all(SAFETY * arithmetic.eps * result.magnitude <= tolerance * size):
            break
    value = arithmetic.approximate(result.value)
    return value[0] if np.ndim(value) else complex(value)


def value_of(expression: Any, environment: Environment) -> Value:
    """Return the values of anything the walk knows, at all points; raises Undefined if one is not finite."""
    try:
        with np.errstate(all="ignore"):
            result = walk(expression, environment)
            finite = environment.arithmetic is not DOUBLE or bool(np.isfinite(result.value).all())
    except (ZeroDivisionError, OverflowError) as trouble:
        raise Undefined(Phrase("the formula is not defined here ({trouble})", trouble=str(trouble))) from trouble
    if not finite:
        raise Undefined("the formula has no finite value here")
    return Value(result.value, lambda: _quietly(result))


def _quietly(result: Value) -> Any:
    with np.errstate(all="ignore"):
        return result.magnitude


def values_at(expression: Any, symbol: Any, at: Any) -> Any:
    """Return the real values of an expression at many values of its one symbol (P,), as floats; nan where it has none.

    For drawing: where rounding spoils digits nobody would see it.
    """
    try:
        value = value_of(expression, Environment.at([{symbol: complex(x)} for x in at])).value
    except Undefined:
        if len(at) == 1:
            return np.full(1, np.nan)
        return np.concatenate([values_at(expression, symbol, at[i : i + 1]) for i in range(len(at))])
    return np.broadcast_to(np.real(value), (len(at),)).astype(float)
