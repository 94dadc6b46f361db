"""Where the poles of a rational formula lie: a circle that encloses them all, for the inversion integrals.

The circle is found from the denominators as they stand (nothing is cancelled: a circle around too much is still
right). What is not plainly rational is refused, never guessed.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import product, zip_longest
from typing import Any, NamedTuple

import numpy as np
import sympy as sp
from sympy.matrices.matrixbase import MatrixBase

from solver.matrices import entries
from solver.numeric.evaluation.arithmetic import Array
from solver.numeric.evaluation.environment import Environment
from solver.numeric.evaluation.points import free_symbols
from solver.numeric.evaluation.stated import about
from solver.numeric.evaluation.values import SAFETY, NotEvaluable, Value
from solver.numeric.evaluation.walk import walk
from solver.stated import Stated
from solver.words import Phrase

EPS = 2.0**-52


class Circle(NamedTuple):
    """Circles |s − centre| = radius that enclose all poles, one for each point (arrays of shape (P,))."""

    centre: Array
    radius: Array


def circle_around_poles(image: Any, s: Any, environment: Environment, *, centred: bool) -> Circle:
    """Return circles that enclose the poles in s of the image at each point, with room to spare.

    `centred` asks for centre 0. The poles lie within half the radius of the centre, up to rounding. Raises
    NotEvaluable if the image is not rational in s or a denominator may have lost its leading coefficient.
    """
    alike = free_symbols(image) <= {s}  # no parameters: the same poles at each point
    if alike and _is_hashable(image):
        circles = [_circle_of_numbers(image, s, centred)]
    else:
        approximate = environment.approximate()
        points = [_single(approximate, p) for p in range(1 if alike else environment.points)]
        circles = [_circle_around(poles_of(image, s, point), centred) for point in points]
    return Circle(*(np.full(environment.points, each) for each in zip(*circles, strict=True)))


def _circle_around(found: Sequence[Array], centred: bool) -> tuple[float, float]:
    """Return centre and radius."""
    poles = np.concatenate([np.zeros(0), *found])
    centre = 0.0 if centred or not len(poles) else poles.real.sum() / len(poles)
    spread = np.max(np.abs(poles - centre), initial=0.0)
    return float(centre), float(2.1 * spread + 0.5 * abs(centre) or 1.0)


@lru_cache(maxsize=256)
def _circle_of_numbers(image: Any, s: Any, centred: bool) -> tuple[float, float]:
    """Return the circle of an image without parameters; the transforms of a derivation ask for it several times."""
    return _circle_around(poles_of(image, s, Environment({}, 1)), centred)


def _is_hashable(image: Any) -> bool:
    """Whether the image can be remembered: it holds no list and no matrix that may change."""
    try:
        hash(image)
    except TypeError:
        return False
    return True


def _single(environment: Environment, p: int) -> Environment:
    return Environment({symbol: value[p : p + 1] for symbol, value in environment.values.items()}, 1)


def poles_of(image: Any, s: Any, point: Environment) -> list[Array]:
    """Return (a superset of) the poles at one point, as arrays."""
    if s not in free_symbols(image):
        return []
    if isinstance(image, Stated):
        return _poles_of_stated(image, s, point)
    if isinstance(image, MatrixBase):
        return _poles_of_expressions(entries(image), s, point)
    if isinstance(image, list | tuple):
        return [pole for entry in image for pole in poles_of(entry, s, point)]
    return _poles_of_expressions([image], s, point)


def _poles_of_stated(image: Stated, s: Any, point: Environment) -> list[Array]:
    of_operation = about(image.operation, "poles")
    if of_operation is None:
        raise NotEvaluable(Phrase("the poles of the operation {operation} are not known", operation=image.operation))
    found: list[Array] = of_operation(image.operands, s, point)
    return found


def poles_of_operands(operands: tuple[Any, ...], s: Any, point: Environment) -> list[Array]:
    """Return the poles of all operands: those of an operation without division are among them."""
    return [pole for operand in operands for pole in poles_of(operand, s, point)]


def zeros_of(formula: Any, s: Any, point: Environment) -> Array:
    """Return (a superset of) the zeros in s of a scalar formula at one point."""
    if not isinstance(formula, Stated):
        return _zeros_of_rational(sp.S.One * formula, s, point)
    of_operation = about(formula.operation, "zeros")
    if of_operation is None:
        raise NotEvaluable(Phrase("the zeros of the operation {operation} are not known", operation=formula.operation))
    found: Array = of_operation(formula.operands, s, point)
    return found


def zeros_of_determinant(matrix: Any, s: Any, point: Environment) -> Array:
    """Return the zeros of det(M₀ + M₁ s + … + M_d s^d), by the eigenvalues of the block companion matrix."""
    if isinstance(matrix, Stated):
        matrix = _pencil(matrix)
    if not isinstance(matrix, MatrixBase):
        return zeros_of(matrix, s, point)
    rationals = [rational(entry, s, point) for entry in entries(matrix)]
    if any(len(denominator) > 1 for _, denominator in rationals):
        raise NotEvaluable("the zeros of a determinant are found for polynomial entries only")
    degree = max((len(numerator) for numerator, _ in rationals), default=1) - 1
    coefficients = np.zeros((degree + 1, len(rationals)), dtype=complex)
    for i, (numerator, denominator) in enumerate(rationals):
        coefficients[: len(numerator), i] = [c.value / denominator[0].value for c in numerator]
    return _zeros_of_polynomial_matrix(coefficients.reshape(degree + 1, *matrix.shape))


def _pencil(matrix: Stated) -> Any:
    """Return a difference or sum of sympy matrices carried out, e.g. s I − A."""
    parts = matrix.operands
    if matrix.operation == "product" and all(isinstance(each, sp.Basic | MatrixBase | int) for each in parts):
        return sp.prod(parts)
    if matrix.operation in ("difference", "total"):
        terms = [_pencil(each) if isinstance(each, Stated) else each for each in parts]
        if all(isinstance(each, MatrixBase) for each in terms):
            return terms[0] - terms[1] if matrix.operation == "difference" else sum(terms[1:], terms[0])
    unknown = "the zeros of the determinant of the operation {operation} are not known"
    raise NotEvaluable(Phrase(unknown, operation=matrix.operation))


def _zeros_of_polynomial_matrix(M: Array) -> Array:
    degree, n = len(M) - 1, M.shape[1]
    if degree == 0:
        return np.zeros(0)
    if not np.all(np.isfinite(M)) or np.linalg.cond(M[-1]) > 1e8:
        raise NotEvaluable("the leading coefficients of the matrix to invert are singular")
    top = np.hstack([-np.linalg.solve(M[-1], M[k]) for k in reversed(range(degree))])
    below = np.eye(n * (degree - 1), n * degree)
    return np.asarray(np.linalg.eigvals(np.vstack([top, below])))


def _poles_of_expressions(expressions: Sequence[Any], s: Any, point: Environment) -> list[Array]:
    bases = dict.fromkeys(base for expression in expressions for base in _denominators(expression, s))
    return [_zeros_of_rational(base, s, point) for base in bases]


@lru_cache(maxsize=1024)
def _denominators(expression: Any, s: Any) -> tuple[Any, ...]:
    """Return all that the expression divides by and that holds s, in its order: sums of poles are rounded by it."""
    if isinstance(expression, sp.Add | sp.Mul):
        return tuple(dict.fromkeys(base for argument in expression.args for base in _denominators(argument, s)))
    if not isinstance(expression, sp.Basic) or expression == s or s not in free_symbols(expression):
        return ()
    if isinstance(expression, sp.Pow):
        base, exponent = expression.args
        if not exponent.is_Integer:
            raise NotEvaluable(Phrase("{expression} is not rational in {s}", expression=str(expression), s=str(s)))
        return (*_denominators(base, s), *([base] if exponent < 0 else []))
    raise NotEvaluable(Phrase("{function} of {s} is not rational", function=type(expression).__name__, s=str(s)))


Polynomial = list[Value]
"""Coefficients, the lowest power first, with their magnitudes."""


def _zeros_of_rational(expression: Any, s: Any, point: Environment) -> Array:
    alike = free_symbols(expression) <= {s}
    return _zeros_of_numbers(expression, s) if alike else _roots(rational(expression, s, point)[0])


@lru_cache(maxsize=256)
def _zeros_of_numbers(expression: Any, s: Any) -> Array:
    """Return the zeros of an expression without parameters; the terms of an image and the image share them."""
    return _roots(rational(expression, s, Environment({}, 1))[0])


def _roots(numerator: Polynomial) -> Array:
    kept = list(numerator)
    while kept and abs(kept[-1].value) <= SAFETY * EPS * kept[-1].magnitude:
        if kept[-1].value != 0:
            raise NotEvaluable("the degree of a denominator can't be told from its rounded coefficients")
        kept.pop()
    if not kept:
        raise NotEvaluable("a denominator is zero")
    if len(kept) == 2:
        return np.array([-kept[0].value / kept[1].value])
    coefficients = np.array([c.value for c in reversed(kept)])
    return np.asarray(np.roots(coefficients / np.max(np.abs(coefficients))))


def rational(expression: Any, s: Any, point: Environment) -> tuple[Polynomial, Polynomial]:
    """Return numerator and denominator of a rational expression at one point, without cancelling."""
    expression = sp.S.One * expression
    if s not in expression.free_symbols:
        value = walk(expression, point)
        return [Value(complex(np.ravel(value.value)[0]), float(np.ravel(value.magnitude)[0]))], [Value(1.0, 0.0)]
    if expression == s:
        return [Value(0.0, 0.0), Value(1.0, 0.0)], [Value(1.0, 0.0)]
    if isinstance(expression, sp.Pow) and expression.exp.is_Integer and abs(expression.exp) <= 64:
        numerator, denominator = rational(expression.base, s, point)
        result = _power(numerator, abs(int(expression.exp))), _power(denominator, abs(int(expression.exp)))
        return result if expression.exp > 0 else result[::-1]
    if not isinstance(expression, sp.Add | sp.Mul):
        raise NotEvaluable(Phrase("{function} of {s} is not rational", function=type(expression).__name__, s=str(s)))
    numerator, denominator = rational(expression.args[0], s, point)
    for argument in expression.args[1:]:
        p, q = rational(argument, s, point)
        numerator = _times(numerator, p) if expression.is_Mul else _plus(_times(numerator, q), _times(p, denominator))
        denominator = _times(denominator, q)
    return numerator, denominator


def _plus(p: Polynomial, q: Polynomial) -> Polynomial:
    zero = Value(0.0, 0.0)
    pairs = zip_longest(p, q, fillvalue=zero)
    return [Value(a.value + b.value, _size(a) + _size(b)) for a, b in pairs]


def _size(coefficient: Value) -> float:
    return max(float(coefficient.magnitude), float(abs(coefficient.value)))


def _times(p: Polynomial, q: Polynomial) -> Polynomial:
    values, sizes = ([0.0] * (len(p) + len(q) - 1) for _ in range(2))
    for (i, a), (j, b) in product(enumerate(p), enumerate(q)):  # short: numpy would take longer
        values[i + j] += a.value * b.value
        sizes[i + j] += _size(a) * _size(b)
    return [Value(value, size) for value, size in zip(values, sizes, strict=True)]


def _power(p: Polynomial, exponent: int) -> Polynomial:
    result: Polynomial = [Value(1.0, 0.0)]
    for _ in range(exponent):
        result = _times(result, p)
    return result
