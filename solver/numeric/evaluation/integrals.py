"""Integrals that stand in a formula as they are written, as of a signal that is not given: ∫₀ᵗ v(τ) dτ."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import sympy as sp

from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.operations import integral
from solver.numeric.evaluation.values import NotEvaluable, Value
from solver.numeric.evaluation.walk import rule


@rule(sp.Integral)
def _integral(expression: Any, environment: Environment) -> Value:
    """By quadrature; an integral of an integral from the same beginning on as one, by Cauchy's formula."""
    limits = expression.limits
    if any(len(each) != 3 for each in limits):
        raise NotEvaluable("an integral without limits has no value")
    function, variable, lower, upper = expression.function, limits[0][0], limits[0][1], limits[-1][2]
    if len(limits) > 1:
        chained = all(
            inner[2] == outer[0] and outer[1] == lower and not function.has(outer[0])
            for inner, outer in pairwise(limits)
        )
        if not chained:
            raise NotEvaluable("only integrals over the same time are evaluated within each other")
        n = len(limits) - 1
        function = function * (upper - variable) ** n / sp.factorial(n)
    return integral.evaluate(environment, function, variable, lower, upper)
