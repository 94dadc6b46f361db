"""Functions of t as numbers at several times, and how far numbers are from each other."""

from __future__ import annotations

from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.environment import Environment, Point
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import free_symbols
from solver.numeric.evaluation.values import ShapeMismatch, Undefined
from solver.words import Phrase


def real(matrix: Any) -> Array:
    """Return a matrix of numbers as floats; raises Undefined where it is not real."""
    if np.abs(np.imag(matrix)).max(initial=0.0) > 1e-9 * (1 + np.abs(matrix).max(initial=0.0)):
        raise Undefined("it is not real here")
    return np.asarray(np.real(matrix), dtype=float)


def relative(gap: Array, *scales: Array) -> float:
    """Return the largest entry of a difference over the largest of what was compared."""
    size = max((float(np.abs(scale).max(initial=0.0)) for scale in scales), default=0.0)
    found = float(np.abs(gap).max(initial=0.0))
    return found / size if size > 0 else found


def functions_at(formula: Any, point: Point, times: Array, shape: tuple[int, int]) -> Array:
    """Return a matrix of functions of t at some times (k×rows×columns), an expression as a matrix of one.

    Raises ShapeMismatch for another shape, or for symbols that the question does not have.
    """
    t = sp.Symbol("t")
    if shape == (1, 1) and not hasattr(formula, "shape"):
        formula = sp.ImmutableMatrix([formula])
    if getattr(formula, "shape", None) != shape:
        raise ShapeMismatch(Phrase("it must be {rows}×{columns}", rows=shape[0], columns=shape[1]))
    unknown = free_symbols(formula) - set(point) - {t}
    if unknown:
        listed = ", ".join(sorted(map(str, unknown)))
        raise ShapeMismatch(Phrase("it holds {unknown}, which the question does not", unknown=listed))
    found = value_of(formula, Environment.at([{**point, t: complex(time)} for time in times])).value
    return real(np.broadcast_to(found, (len(times), *shape)))
