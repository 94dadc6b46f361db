"""A ∘ B, entry by entry."""

from __future__ import annotations

from typing import Any

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import ShapeMismatch, Value, shape_of
from solver.numeric.evaluation.walk import walk
from solver.words import Phrase


def evaluate(environment: Environment, left: Any, right: Any) -> Value:
    """The products of entries at the same place; both have one shape."""
    A, B = walk(left, environment), walk(right, environment)
    if shape_of(A) != shape_of(B):
        sizes = ["×".join(map(str, shape_of(each) or (1, 1))) for each in (A, B)]
        raise ShapeMismatch(Phrase("the shapes differ: {left} and {right}", left=sizes[0], right=sizes[1]))
    size = environment.arithmetic.size
    return Value(A.value * B.value, size(A.value) * B.magnitude + A.magnitude * size(B.value))
