"""Bᵏ."""

from __future__ import annotations

from typing import Any

import numpy as np
import sympy as sp

from solver.numeric.evaluation.arithmetic import Arithmetic, Array
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.matrices import inverted, square
from solver.numeric.evaluation.poles import poles_of, zeros_of, zeros_of_determinant
from solver.numeric.evaluation.values import NotEvaluable, Value
from solver.numeric.evaluation.walk import general_power, walk, whole_power


def evaluate(environment: Environment, base: Any, exponent: Any) -> Value:
    """Bᵏ; a matrix takes whole exponents, which may differ from point to point."""
    B, order = walk(base, environment), walk(exponent, environment)
    whole = _whole(order, environment)
    if not B.is_matrix:
        if whole is not None and len(set(whole)) == 1:
            return whole_power(B, whole[0], environment.arithmetic)
        return general_power(B, order, environment.arithmetic)
    if whole is None:
        raise NotEvaluable("a power of a matrix with an exponent that is not whole")
    return matrix_power(square(base, environment), whole, environment.arithmetic)


def _whole(order: Value, environment: Environment) -> list[int] | None:
    """Return the exponents at the P points if all are whole numbers."""
    values = np.asarray(environment.arithmetic.approximate(order.value))
    if np.any(values.imag != 0) or np.any(values.real != np.round(values.real)) or np.any(np.abs(values) > 10_000):
        return None
    return [int(value) for value in np.broadcast_to(values.real, (environment.points,))]


def matrix_power(B: Value, exponents: list[int], arithmetic: Arithmetic) -> Value:
    """Return at each point p the power with exponent exponents[p], by numpy's repeated squaring."""
    if min(exponents, default=0) < 0:
        B_inverse = inverted(B, arithmetic)
        chosen = np.array([exponent < 0 for exponent in exponents])[:, None, None]
        B = Value(np.where(chosen, B_inverse.value, B.value), np.where(chosen, B_inverse.magnitude, B.magnitude))
    value = np.empty_like(B.value)
    magnitude = np.empty_like(B.magnitude)
    for p, exponent in enumerate(map(abs, exponents)):
        value[p] = np.linalg.matrix_power(B.value[p], exponent)
        magnitude[p] = max(1, exponent) * np.linalg.matrix_power(B.magnitude[p], exponent)
    return Value(value, magnitude)


def poles(operands: tuple[Any, ...], s: Any, point: Environment) -> list[Array]:
    """The poles of B; where k < 0, the zeros of det B too."""
    base, exponent = operands
    if not isinstance(exponent, int | sp.Integer):
        raise NotEvaluable("the poles of a power are known for numbers as exponents only")
    found = poles_of(base, s, point)
    return found if exponent >= 0 else [*found, zeros_of_determinant(base, s, point)]


def zeros(operands: tuple[Any, ...], s: Any, point: Environment) -> Array:
    """The zeros of B."""
    base, exponent = operands
    if not isinstance(exponent, int | sp.Integer):
        raise NotEvaluable("the zeros of a power are known for numbers as exponents only")
    return zeros_of(base, s, point)
