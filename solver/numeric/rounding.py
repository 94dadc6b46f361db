"""Whether a value written with decimals agrees with another one to the digits written."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from solver.numeric.evaluate import evaluate
from solver.numeric.points import admissible, free_symbols

SLACK = 1e-6
"""Relative: a number half way between two decimals may be rounded either way."""


def agrees_to_digits(form: Any, decimals: Mapping[Any, tuple[Any, Any]], target: Any) -> bool:
    """Whether `form` = `target` to the digits written, at random values of the other symbols.

    `decimals` gives for each symbol that stands for a decimal its value and half a unit of its last digit. To first
    order the form may differ by Σ |∂form/∂d| · half a unit. Raises NotEvaluable.
    """
    own = [symbol for symbol in decimals if symbol in form.free_symbols]
    values = {symbol: complex(decimals[symbol][0]) for symbol in own}
    slopes = [(sp.diff(form, symbol), float(decimals[symbol][1])) for symbol in own]
    others = (free_symbols(form) | free_symbols(target)) - set(own)
    for point in admissible(others, 3):
        here = {**point, **values}
        reference = evaluate(target, here)
        allowed = sum(abs(evaluate(slope, here)) * half for slope, half in slopes)
        bound = allowed * (1 + SLACK) + 1e-9 * abs(reference)
        if not abs(evaluate(form, here) - reference) <= bound:
            return False
    return True
