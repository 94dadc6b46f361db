"""Σ T(i) over whole numbers i."""

from __future__ import annotations

from functools import reduce
from typing import Any

import numpy as np

from solver.numeric.evaluation.combining import add
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import Undefined, Value
from solver.numeric.evaluation.walk import walk

MOST_TERMS = 200


def evaluate(environment: Environment, term: Any, index: Any, lower: Any, upper: Any) -> Value:
    """Σ T(i), added up one by one at each point; an empty sum has no shape, so there it has no value."""
    first, last = (
        [
            round(float(each.real))
            for each in environment.arithmetic.approximate(environment.full(walk(end, environment).value))
        ]
        for end in (lower, upper)
    )
    if any(b < a or b - a > MOST_TERMS for a, b in zip(first, last, strict=True)):
        raise Undefined("an empty sum, or one of too many terms")
    sums = []
    for p, (a, b) in enumerate(zip(first, last, strict=True)):
        point = {symbol: environment.full(value)[p : p + 1] for symbol, value in environment.values.items()}
        here = Environment(point, 1, environment.arithmetic)
        sums.append(reduce(add, (walk(term, here.having({index: i})) for i in range(a, b + 1))))
    values, magnitudes = (
        np.stack([np.reshape(part, np.shape(part)[1:]) for part in parts]) for parts in zip(*sums, strict=True)
    )
    return Value(values, magnitudes)
