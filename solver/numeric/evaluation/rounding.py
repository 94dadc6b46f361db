"""Whether a value written with decimals agrees with another one to the digits written."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from typing import Any

import sympy as sp

from solver.numeric.evaluation.expressions import evaluate
from solver.numeric.evaluation.points import PointSource, free_symbols, nodes, whole_symbols

NOTHING = 1e-40
"""What is left of a zero evaluated with 100 digits."""

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
    for point in _points(form, target, (free_symbols(form) | free_symbols(target)) - set(own)):
        here = {**point, **values}
        reference = evaluate(target, here)
        allowed = sum(abs(evaluate(slope, here)) * half for slope, half in slopes)
        bound = allowed * (1 + SLACK) + 1e-9 * abs(reference) + NOTHING
        if not abs(evaluate(form, here) - reference) <= bound:
            return False
    return True


def _points(form: Any, target: Any, symbols: Collection[Any]) -> Iterable[Mapping[Any, complex]]:
    """Values of the other symbols; more of them, and at later times, where a function of time is made of pieces."""
    if not symbols:
        return [{}]
    whole = whole_symbols(form, target) & frozenset(symbols)
    source = PointSource(symbols, whole)
    pieces = any(isinstance(each, sp.Heaviside | sp.Piecewise) for side in (form, target) for each in nodes(side))
    drawn = source.several(12 if pieces else 6 if whole else 3)
    return [_later(point, 1 + i if pieces else 1) for i, point in enumerate(drawn)]


def _later(point: Mapping[Any, complex], factor: int) -> Mapping[Any, complex]:
    return {symbol: value * factor if symbol.name == "t" else value for symbol, value in point.items()}
