"""Values of the parameters at which answers with letters are judged."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import sympy as sp

from solver.numeric.evaluation.points import PointSource, free_symbols

POINTS = 3
"""How often values are drawn."""


def values_of_parameters(formulas: Iterable[Any], variables: Iterable[Any]) -> list[dict[Any, Any]]:
    """Return some values of the letters in formulas but the variables, as is assumed of them; [{}] without letters."""
    letters = free_symbols([sp.S.Zero + each for each in formulas]) - set(variables)
    if not letters:
        return [{}]
    return [
        {x: sp.Rational(repr(value)) for x, value in point.items()} for point in PointSource(letters).several(POINTS)
    ]


__all__ = ["values_of_parameters"]
