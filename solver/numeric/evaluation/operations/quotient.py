"""N/d."""

from __future__ import annotations

from typing import Any

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.combining import multiply, size_in_words
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.poles import poles_of, zeros_of
from solver.numeric.evaluation.values import ShapeMismatch, Value, shape_of
from solver.numeric.evaluation.walk import walk, whole_power
from solver.words import Phrase

ENTRYWISE = True


def evaluate(environment: Environment, numerator: Any, denominator: Any) -> Value:
    """N/d; d is a scalar (or 1×1)."""
    divisor = walk(denominator, environment)
    if divisor.is_matrix:
        if shape_of(divisor) != (1, 1):
            raise ShapeMismatch(Phrase("a quotient by a matrix {size}", size=size_in_words(divisor)))
        divisor = Value(divisor.value[:, 0, 0], divisor.magnitude[:, 0, 0])
    return multiply(
        walk(numerator, environment), whole_power(divisor, -1, environment.arithmetic), environment.arithmetic
    )


def poles(operands: tuple[Any, ...], s: Any, point: Environment) -> list[Array]:
    """The poles of both and the zeros of the denominator."""
    numerator, denominator = operands
    return [*poles_of(numerator, s, point), *poles_of(denominator, s, point), zeros_of(denominator, s, point)]
