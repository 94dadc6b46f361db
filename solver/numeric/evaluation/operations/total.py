"""T₁ + T₂ + …."""

from __future__ import annotations

from typing import Any

from solver.numeric.evaluation.combining import add, joined
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.poles import poles_of_operands
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import walk

ENTRYWISE = True


def evaluate(environment: Environment, *terms: Any) -> Value:
    """T₁ + T₂ + …; a matrix 1×1 and a scalar may be added."""
    if not terms:
        return Value(environment.arithmetic.number(0), 0.0)
    return joined(add, (walk(term, environment) for term in terms))


poles = poles_of_operands
