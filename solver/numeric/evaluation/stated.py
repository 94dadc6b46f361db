"""Evaluation of formulas as stated (`solver.stated`): the operations of matrix algebra.

Each operation has an algorithm of its own here; magnitudes bound the rounding to first order.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

from solver.numeric.evaluation.arithmetic import DOUBLE, Arithmetic, Array
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.values import NotEvaluable, ShapeMismatch, Undefined, Value, shape_of
from solver.numeric.evaluation.walk import floored, general_power, rule, walk, whole_power
from solver.stated import Stated

Operation = Callable[..., Value]
OPERATIONS: dict[str, Operation] = {}
"""Operations by name; each takes the environment and the operands."""


def operation(function: Operation) -> Operation:
    """Register the evaluation of the operation of the function's name."""
    OPERATIONS[function.__name__] = function
    return function


@rule(Stated)
def _stated(formula: Stated, environment: Environment) -> Value:
    if formula.operation not in OPERATIONS:
        raise NotEvaluable(f"no rule for the operation {formula.operation}")
    return OPERATIONS[formula.operation](environment, *formula.operands)


def square(operand: Any, environment: Environment) -> Value:
    """Return the values of a square matrix, finite; a scalar stands for a matrix 1×1."""
    result = walk(operand, environment)
    if not result.is_matrix:
        result = environment.stack([result], (1, 1))
    rows, columns = shape_of(result)
    if rows != columns:
        raise ShapeMismatch(f"a matrix {rows}×{columns} is not square")
    if environment.arithmetic is DOUBLE and not np.isfinite(result.value).all():
        raise Undefined("the matrix is not finite here")
    return result


@operation
def determinant(environment: Environment, matrix: Any) -> Value:
    """Det M, rounding within Hadamard's bound of |M|."""
    M = square(matrix, environment)
    return Value(environment.arithmetic.determinant(M.value), hadamard(M.magnitude))


def hadamard(magnitude: Array) -> Array:
    """Π of the norms of the rows: no determinant of a matrix of such entries is larger."""
    return np.asarray(np.prod(np.sqrt((magnitude**2).sum(axis=-1)), axis=-1))


@operation
def adjugate(environment: Environment, matrix: Any) -> Value:
    """Adj M by minors; with many digits det M · M⁻¹ where M is safely invertible."""
    M = square(matrix, environment)
    n = M.value.shape[1]
    if environment.arithmetic is not DOUBLE and n > 3:
        det = environment.arithmetic.determinant(M.value)
        if np.all(environment.arithmetic.size(det) > 1e-20 * hadamard(M.magnitude)):
            inverted = _inverse(M, environment.arithmetic)
            scale = hadamard(M.magnitude)[:, None, None]
            return Value(inverted.value * det[:, None, None], inverted.magnitude * scale)
    return _by_minors(M, environment)


def _by_minors(M: Value, environment: Environment) -> Value:
    """Adj M: the entry (j, i) is (−1)^{i+j} times the determinant of M without row i and column j."""
    n = M.value.shape[1]
    if n == 1:
        return Value(np.full_like(M.value, environment.arithmetic.number(1)), np.ones_like(M.magnitude))
    rows, columns, signs = _places_of_minors(n)
    minors, sizes = (part[:, rows, columns].reshape(-1, n - 1, n - 1) for part in M)
    shape = (environment.points, n, n)
    return Value(environment.arithmetic.determinant(minors).reshape(shape) * signs, hadamard(sizes).reshape(shape))


@cache
def _places_of_minors(n: int) -> tuple[Array, Array, Array]:
    """Return the rows and columns that the minors of adj M keep, entry by entry, and their signs."""
    keep = np.array([[k for k in range(n) if k != i] for i in range(n)])
    rows, columns = np.tile(keep, (n, 1)), np.repeat(keep, n, axis=0)
    signs = np.array([[(-1) ** (i + j) for j in range(n)] for i in range(n)])
    return rows[:, :, None], columns[:, None, :], signs


@operation
def partitioned(environment: Environment, matrix: Any, _rows: Any, _columns: Any) -> Value:
    """M: the lines say nothing about its value."""
    return walk(matrix, environment)


@operation
def trace(environment: Environment, matrix: Any) -> Value:
    """Tr M."""
    M = square(matrix, environment)
    diagonal = range(M.value.shape[1])
    return Value(sum(M.value[:, i, i] for i in diagonal), sum(M.magnitude[:, i, i] for i in diagonal))


@operation
def rank(environment: Environment, matrix: Any) -> Value:
    """Rank M at each point."""
    from solver.numeric.evaluation.ranks import rank_at  # noqa: PLC0415 - ranks are found by evaluating entries, by this module

    full = {symbol: environment.full(value) for symbol, value in environment.values.items()}
    counts = [
        rank_at(matrix, {symbol: values[p] for symbol, values in full.items()}) for p in range(environment.points)
    ]
    return Value(environment.arithmetic.array(counts), np.zeros(environment.points))


@operation
def inverse(environment: Environment, matrix: Any) -> Value:
    """M⁻¹ (1/m of a scalar)."""
    M = walk(matrix, environment)
    if not M.is_matrix:
        return whole_power(M, -1, environment.arithmetic)
    return _inverse(square(matrix, environment), environment.arithmetic)


def _inverse(M: Value, arithmetic: Arithmetic) -> Value:
    """M⁻¹ with magnitude |M⁻¹| m |M⁻¹|, m the largest magnitude in M: elimination spreads rounding to zeros too."""
    value = arithmetic.inverse(M.value)
    size = arithmetic.size(value)
    largest = M.magnitude.max(axis=(1, 2), keepdims=True)
    return Value(value, size + largest * size.sum(axis=2, keepdims=True) * size.sum(axis=1, keepdims=True))


@operation
def transpose(environment: Environment, matrix: Any) -> Value:
    """Mᵀ."""
    M = walk(matrix, environment)
    return Value(np.swapaxes(M.value, 1, 2), np.swapaxes(M.magnitude, 1, 2)) if M.is_matrix else M


@operation
def product(environment: Environment, *factors: Any) -> Value:
    """F₁ F₂ … from left to right."""
    result = Value(environment.arithmetic.number(1), 1.0)
    for factor in factors:
        result = multiply(result, walk(factor, environment), environment.arithmetic)
    return result


def multiply(left: Value, right: Value, arithmetic: Arithmetic) -> Value:
    """Return the product of matrices, or of a scalar and anything."""
    if left.is_matrix and right.is_matrix:
        if left.value.shape[2] != right.value.shape[1]:
            raise ShapeMismatch(f"a product of matrices {_text(left)} and {_text(right)}")
        magnitude = arithmetic.size(left.value) @ right.magnitude + left.magnitude @ arithmetic.size(right.value)
        return Value(left.value @ right.value, magnitude)
    left, right = aligned(left, right)
    magnitude = arithmetic.size(left.value) * right.magnitude + left.magnitude * arithmetic.size(right.value)
    return Value(np.multiply(left.value, right.value), magnitude)


def aligned(left: Value, right: Value) -> tuple[Value, Value]:
    """Give a scalar beside a matrix (or list) the axes it needs to broadcast."""
    left_depth, right_depth = (getattr(side.value, "ndim", 0) for side in (left, right))
    if left_depth == right_depth:
        return left, right
    depth = max(left_depth, right_depth)
    return _deepened(left, depth), _deepened(right, depth)


def _deepened(scalar: Value, depth: int) -> Value:
    if np.ndim(scalar.value) != 1 or depth < 2:
        return scalar
    axes = (slice(None), *(None for _ in range(depth - 1)))
    magnitude = scalar.magnitude
    return Value(scalar.value[axes], magnitude[axes] if np.ndim(magnitude) else magnitude)


def _text(value: Value) -> str:
    return "×".join(map(str, shape_of(value))) or "1×1"


@operation
def total(environment: Environment, *terms: Any) -> Value:
    """T₁ + T₂ + …; a matrix 1×1 and a scalar may be added."""
    result = Value(environment.arithmetic.number(0), 0.0)
    for i, term in enumerate(terms):
        part = walk(term, environment)
        result = add(result, part) if i else part
    return result


def add(left: Value, right: Value) -> Value:
    """Return the sum; raises ShapeMismatch unless the shapes agree (1×1 and a scalar do)."""
    if (shape_of(left) or (1, 1)) != (shape_of(right) or (1, 1)):
        raise ShapeMismatch(f"a sum of matrices {_text(left)} and {_text(right)}")
    left, right = aligned(left, right)
    return Value(np.add(left.value, right.value), left.magnitude + right.magnitude)


@operation
def difference(environment: Environment, left: Any, right: Any) -> Value:
    """L − R."""
    subtrahend = walk(right, environment)
    return add(walk(left, environment), Value(-subtrahend.value, subtrahend.magnitude))


@operation
def quotient(environment: Environment, numerator: Any, denominator: Any) -> Value:
    """N/d; d is a scalar (or 1×1)."""
    divisor = walk(denominator, environment)
    if divisor.is_matrix:
        if shape_of(divisor) != (1, 1):
            raise ShapeMismatch(f"a quotient by a matrix {_text(divisor)}")
        divisor = Value(divisor.value[:, 0, 0], divisor.magnitude[:, 0, 0])
    return multiply(
        walk(numerator, environment), whole_power(divisor, -1, environment.arithmetic), environment.arithmetic
    )


@operation
def power(environment: Environment, base: Any, exponent: Any) -> Value:
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
        inverted = _inverse(B, arithmetic)
        chosen = np.array([exponent < 0 for exponent in exponents])[:, None, None]
        B = Value(np.where(chosen, inverted.value, B.value), np.where(chosen, inverted.magnitude, B.magnitude))
    value = np.empty_like(B.value)
    magnitude = np.empty_like(B.magnitude)
    for p, exponent in enumerate(map(abs, exponents)):
        value[p] = np.linalg.matrix_power(B.value[p], exponent)
        magnitude[p] = max(1, exponent) * np.linalg.matrix_power(B.magnitude[p], exponent)
    return Value(value, magnitude)


@operation
def exponential(environment: Environment, exponent: Any) -> Value:
    """e^X."""
    X = walk(exponent, environment)
    arithmetic = environment.arithmetic
    if X.is_matrix:
        X = square(exponent, environment)
        value, magnitude = arithmetic.exponential(X.value)
        cancelled = X.magnitude / floored(X, arithmetic)
        return Value(value, magnitude * np.maximum(1.0, cancelled.max(axis=(1, 2), keepdims=True)))
    value = arithmetic.apply("exp", X.value)
    return Value(value, arithmetic.size(value) * (1.0 + X.magnitude))
