"""Σ f(i) g(k − i)."""

from __future__ import annotations

from typing import Any

from solver.numeric.evaluation.combining import add, joined, multiply
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.indices import at_each_point
from solver.numeric.evaluation.stated import Oracle
from solver.numeric.evaluation.values import Value
from solver.numeric.evaluation.walk import walk

ORACLE = Oracle(70, "summation")
SAMPLED = True


def evaluate(environment: Environment, left: Any, right: Any, step: Any) -> Value:
    """The products f(i) g(k − i) added up, i = 0 … k; for k < 0 there are none."""

    def at(here: Environment, k: int) -> Value:
        pairs = ((here.having({step: i}), here.having({step: k - i})) for i in range(k + 1))
        products = (multiply(walk(left, one), walk(right, other), here.arithmetic) for one, other in pairs)
        return joined(add, products)

    return at_each_point(environment, (0, step), lambda here, _, k: at(here, k))
