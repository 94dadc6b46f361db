"""Two arithmetics with one face: numpy's complex doubles and mpmath's complex numbers of many digits.

Both work on a batch of P points: scalars are arrays (P,), matrices (P, n, m); with many digits the arrays hold
mpmath numbers as objects. Constants are plain Python (mpmath) numbers that broadcast.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import mpmath
import numpy as np
from numpy.typing import NDArray

from solver.numeric.evaluation import multiple_precision
from solver.numeric.evaluation.values import Undefined, Value

Array = NDArray[Any]

NUMPY_NAMES = {
    "asin": "arcsin",
    "acos": "arccos",
    "atan": "arctan",
    "asinh": "arcsinh",
    "acosh": "arccosh",
    "atanh": "arctanh",
    "re": "real",
    "im": "imag",
    "arg": "angle",
}

FROM_BELOW = frozenset({"asin", "acos", "atanh"})
"""Functions with a cut at x > 1, where mpmath (like Abramowitz and Stegun) takes the value from below."""

ODD_ON_CUTS = frozenset({"atan", "asinh"})
"""Functions with cuts on the imaginary axis, on which mpmath keeps them odd."""


def equilibration(M: Array) -> tuple[Array, Array]:
    """Return factors of rows and columns, powers of two, that bring the entries of M (P, m, n) to about unit size."""
    size = np.abs(M)
    rows = _powers_of_two(size.max(axis=2))
    return rows, _powers_of_two((size * rows[:, :, None]).max(axis=1))


def _powers_of_two(sizes: Array) -> Array:
    """Return 2^−round(log₂ x), 1 for x = 0."""
    return np.asarray(np.exp2(-np.round(np.log2(np.where(sizes > 0, sizes, 1.0)))))


class Double:
    """Complex doubles: numpy, and scipy for the matrix exponential."""

    eps = 2.0**-52
    digits = 15
    dtype: Any = np.complex128

    def rational(self, numerator: int, denominator: int = 1) -> Any:
        """p/q, correctly rounded."""
        return complex(numerator / denominator)

    def constant(self, name: str) -> Any:
        """`pi` or `e`."""
        return complex(getattr(np, name))

    def imaginary(self) -> Any:
        """√−1."""
        return 1j

    def number(self, value: Any) -> Any:
        """Return a Python number, or an mpmath number, in this arithmetic."""
        return complex(value)

    def array(self, values: Any) -> Array:
        """Return Python numbers as an array of this arithmetic."""
        return np.asarray(values, dtype=np.complex128)

    def size(self, value: Any) -> Any:
        """Return absolute values as floats."""
        return abs(value) if isinstance(value, complex) else np.abs(value)

    def approximate(self, value: Any) -> Any:
        """Return values as complex doubles."""
        return value

    def apply(self, name: str, value: Any) -> Any:
        """Return an elementary function, by its name in mpmath, of each value; on cuts as mpmath has it."""
        function = getattr(np, NUMPY_NAMES.get(name, name))
        if name in FROM_BELOW:
            value = np.where((np.imag(value) == 0) & (np.real(value) > 1), np.conj(value), value)[()]
        if name in ODD_ON_CUTS:
            sign = np.where((np.real(value) == 0) & (np.imag(value) < 0), -1.0, 1.0)[()]
            return sign * function(sign * value)
        result: Any = function(value)
        return result + 0j

    def power(self, base: Any, exponent: Any) -> Any:
        """Return the principal value of base^exponent, 0⁰ = 1."""
        return np.power(base, exponent)

    def determinant(self, M: Array) -> Array:
        """Det M at each point, by numpy's LU decomposition."""
        return np.asarray(np.linalg.det(M))

    def inverse(self, M: Array) -> Array:
        """M⁻¹ at each point; raises Undefined where M is singular."""
        try:
            rows, columns = equilibration(M)
            scaled = np.linalg.inv(M * rows[:, :, None] * columns[:, None, :])
        except np.linalg.LinAlgError as singular:
            raise Undefined("the matrix to invert is singular") from singular
        return np.asarray(scaled * columns[:, :, None] * rows[:, None, :])

    def exponential(self, M: Array) -> Value:
        """e^M at each point, by scipy.linalg.expm."""
        from scipy.linalg import expm  # noqa: PLC0415 - 150 ms that most checks do not need

        if not np.all(np.isfinite(M)):
            raise Undefined("the exponent is not finite")
        return Value(expm(M), lambda: np.abs(expm(np.abs(M))) * (1.0 + np.abs(M).sum(axis=(1, 2)))[:, None, None])


class Multiple:
    """Complex numbers of a given number of decimal digits: mpmath, and algorithms of our own on matrices."""

    dtype: Any = object

    def __init__(self, digits: int) -> None:
        self.digits = digits
        self.context = mpmath.mp.clone()
        self.context.dps = digits
        self.eps = float(self.context.eps)

    def rational(self, numerator: int, denominator: int = 1) -> Any:
        """p/q."""
        above = self.context.mpf(numerator)
        return above if denominator == 1 else above / denominator

    def constant(self, name: str) -> Any:
        """`pi` or `e`."""
        return +getattr(self.context, name)

    def imaginary(self) -> Any:
        """√−1."""
        return self.context.mpc(0, 1)

    def number(self, value: Any) -> Any:
        """Return a Python number, or an mpmath number of any context, in this arithmetic; a real one as real."""
        number = self.context.mpc(value)
        return number if number.imag else number.real

    def array(self, values: Any) -> Array:
        """Return Python numbers, taken as exact, as an array of this arithmetic."""
        return np.asarray(self._each(self.number)(np.asarray(values, dtype=object)), dtype=object)

    def size(self, value: Any) -> Any:
        """Return absolute values as floats."""
        return np.abs(self.approximate(value)) if isinstance(value, np.ndarray) else abs(complex(value))

    def approximate(self, value: Any) -> Any:
        """Return values as complex doubles."""
        return np.asarray(value, dtype=np.complex128)

    def apply(self, name: str, value: Any) -> Any:
        """Return an elementary function, by its name in mpmath, of each value."""
        return self._each(getattr(self.context, name))(value)

    def power(self, base: Any, exponent: Any) -> Any:
        """Return the principal value of base^exponent, 0⁰ = 1; a whole exponent is taken by multiplication."""
        return np.frompyfunc(self._power, 2, 1)(base, exponent)

    def _power(self, base: Any, exponent: Any) -> Any:
        if exponent.imag == 0 and exponent.real == int(exponent.real):
            return base ** int(exponent.real)
        return base**exponent

    def determinant(self, M: Array) -> Array:
        """Det M at each point, by elimination."""
        return np.array([multiple_precision.determinant(each) for each in M], dtype=object)

    def inverse(self, M: Array) -> Array:
        """M⁻¹ at each point, by elimination; raises Undefined where M is singular."""
        return np.stack([multiple_precision.inverse(each) for each in M])

    def exponential(self, M: Array) -> Value:
        """e^M at each point, by the Taylor series in whole numbers."""
        found = [multiple_precision.exponential(each, self.context) for each in M]
        values = np.stack([value for value, _ in found])
        return Value(values, lambda: np.stack([error() for _, error in found]) / self.eps + self.size(values))

    def _each(self, function: Callable[[Any], Any]) -> Any:
        return np.frompyfunc(function, 1, 1)


Arithmetic = Double | Multiple

DOUBLE = Double()


@cache
def multiple(digits: int) -> Multiple:
    """Return the arithmetic of that many digits (made once)."""
    return Multiple(digits)
