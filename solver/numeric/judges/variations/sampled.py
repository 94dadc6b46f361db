"""Questions in numbers at admissible points, functions of t at several times, and how far numbers differ."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import numpy as np
import sympy as sp
from numpy.linalg import LinAlgError

from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.environment import Environment, Point
from solver.numeric.evaluation.expressions import value_of
from solver.numeric.evaluation.points import PointSource, free_symbols
from solver.numeric.evaluation.values import NotEvaluable, ShapeMismatch, Undefined
from solver.words import Phrase

Found = TypeVar("Found")
TRIES = 20


def at_admissible_points(make: Callable[[Point], Found], symbols: frozenset[Any], own: frozenset[Any]) -> list[Found]:
    """Return what is made of a question at two points of its symbols but t, at one where it has none.

    The `own` symbols (of weights, times and factors) are positive there; where `make` raises Undefined the point is not
    admissible. Raises NotEvaluable where none is.
    """
    symbols -= {sp.Symbol("t")}
    source, found = PointSource(symbols), []
    for _ in range(TRIES if symbols else 1):
        point = {s: abs(v) if s in own else v for s, v in source.draw().items()}
        try:
            found.append(make(point))
        except (LinAlgError, Undefined):
            continue
        if len(found) == (2 if symbols else 1):
            break
    if not found:
        raise NotEvaluable("no values of the parameters were found for which the problem has a solution")
    return found


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
