"""Inverse transforms by their defining contour integrals.

ℒ⁻¹{F}(t) = (1/2πj) ∮ F(s) e^{st} ds and 𝒵⁻¹{F}(k) = (1/2πj) ∮ F(z) z^{k−1} dz around all poles. On a circle the
trapezoid rule converges geometrically (Trefethen and Weideman, SIAM Review 56 (2014), section 2).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, lru_cache, partial, reduce
from typing import Any, NamedTuple

import numpy as np
import sympy as sp
from sympy.matrices.matrixbase import MatrixBase

from solver.matrices import entries
from solver.numeric.evaluation.arithmetic import DOUBLE, Arithmetic, Array
from solver.numeric.evaluation.combining import add, joined, multiply
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.linear_terms import linear_terms
from solver.numeric.evaluation.points import free_symbols
from solver.numeric.evaluation.poles import Circle
from solver.numeric.evaluation.values import Value, gathered
from solver.numeric.evaluation.walk import walk
from solver.stated import Stated

RATIONAL = frozenset({"total", "difference", "product", "quotient", "inverse", "adjugate", "determinant"})
"""Operations that make rational functions of rational functions."""


def accuracy(arithmetic: Arithmetic) -> float:
    """Return the relative error the trapezoid rule may have: the roundoff of doubles, two thirds of many digits."""
    return arithmetic.eps if arithmetic is DOUBLE else 10.0 ** (-0.65 * arithmetic.digits)


def number_of_nodes(arithmetic: Arithmetic, growth: float) -> int:
    """Return N with (1/2)^N and the tail of the series of e^{growth} below the accuracy."""
    return int(16 * np.ceil((-np.log2(accuracy(arithmetic)) + 4.0 * growth) / 16))


@cache
def unit_roots(count: int, arithmetic: Arithmetic) -> Array:
    """e^{2πj i/N} for i = 0 … N − 1."""
    turns = [arithmetic.rational(2 * i, count) for i in range(count)]
    angle = arithmetic.constant("pi") * arithmetic.imaginary()
    return np.asarray(arithmetic.apply("exp", np.array([turn * angle for turn in turns], dtype=arithmetic.dtype)))


class Turns(NamedTuple):
    """The N-th roots of unity, or the upper half of them with how often each counts."""

    roots: Array
    times: Array

    @property
    def number(self) -> int:
        """N."""
        return int(self.times.sum())


def turns(environment: Environment, image: Any, time: Any, count: int) -> Turns:
    """Return the roots at which a transform takes the image.

    With many digits only the upper half, where the image has conjugate values at the others: all its numbers are real.
    """
    roots = unit_roots(count, environment.arithmetic)
    if environment.arithmetic is DOUBLE or not _is_real([image, time], environment):
        return Turns(roots, np.ones(count, dtype=int))
    times = np.full(count // 2 + 1, 2)
    times[[0, -1]] = 1
    return Turns(roots[: len(times)], times)


def _is_real(formulas: Sequence[Any], environment: Environment) -> bool:
    """Whether formulas hold rational numbers and symbols with real values only; the variable of an image has none."""
    known = [environment.values[each] for each in free_symbols(formulas) if each in environment.values]
    values = (environment.arithmetic.approximate(environment.full(value)) for value in known)
    return all(map(_is_rational, formulas)) and not any(np.any(value.imag) for value in values)


def _is_rational(formula: Any) -> bool:
    """Whether a formula is made of rational numbers and symbols by the four operations."""
    if isinstance(formula, Stated):
        return formula.operation in RATIONAL and all(map(_is_rational, formula.operands))
    if isinstance(formula, MatrixBase):
        return all(map(_is_rational_expression, entries(formula)))
    return isinstance(formula, int) or (isinstance(formula, sp.Basic) and _is_rational_expression(formula))


@lru_cache(maxsize=4096)
def _is_rational_expression(expression: Any) -> bool:
    if isinstance(expression, sp.Symbol | sp.Rational):
        return True
    whole = not isinstance(expression, sp.Pow) or expression.exp.is_Integer
    return whole and isinstance(expression, sp.Add | sp.Mul | sp.Pow) and all(map(_is_rational, expression.args))


def combined(environment: Environment, image: Any, variable: Any, transform: Callable[[Any], Value]) -> Value:
    """Return the transform of a sum of terms L f(s) R with constant L and R: Σ L (transform of f) R."""
    parts = []
    for term in linear_terms(image, variable):
        factors = (*(walk(each, environment) for each in term.left), transform(term.core))
        factors = (*factors, *(walk(each, environment) for each in term.right))
        parts.append(reduce(partial(multiply, arithmetic=environment.arithmetic), factors))
    return joined(add, parts)


def columns(circle: Circle, arithmetic: Arithmetic) -> tuple[Array, Array]:
    """Return centre and radius as columns (P, 1) of the arithmetic."""
    return arithmetic.array(circle.centre)[:, None], arithmetic.array(circle.radius)[:, None]


def mean_on_circle(
    environment: Environment, image: Any, variable: Any, nodes: Array, weights: Array, turned: Turns
) -> Value:
    """Return the mean over the nodes (P×N) of the image times the weights (P×N)."""
    F = walk(image, environment.spread(variable, nodes))
    arithmetic = environment.arithmetic
    points, count = nodes.shape
    samples = gathered(F, points, count)
    factor = (weights * turned.times).reshape((points, count, *(1 for _ in samples.value.shape[2:])))
    mean = (samples.value * factor).sum(axis=1) / turned.number
    if count < turned.number:
        mean = arithmetic.apply("re", mean)

    def magnitude() -> Array:
        # what the rule itself leaves out, beside the rounding of the values
        left_out = arithmetic.size(samples.value) * (accuracy(arithmetic) / arithmetic.eps)
        return ((samples.magnitude + left_out) * arithmetic.size(factor)).sum(axis=1) / turned.number

    return Value(mean, magnitude)
