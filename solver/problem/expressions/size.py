"""Upper bounds for parts of an expression, and how they add, multiply and grow. Needs no algebra of its own."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import islice
from typing import Any

_LONG = 4096
_NOISE = 1e-9
_NODES = 1000


@dataclass(frozen=True, slots=True)
class Size:
    """Upper bounds for one part of an expression.

    `bits`: of a numerator and a denominator that may occur in it; `below`: of the denominator alone, 0 for whole
    numbers;
    `value`: the number itself, where it is rational; `constant`: whether it holds no symbol; `estimate`: roughly its
    value where it is constant, None where that is not known; `weight`: the sum of the sizes of its coefficients,
    which are what exponents are made of; `reach`: the weight of the largest exponent of e in it;
    `logs`: whether it holds a logarithm, which may undo an exponential.
    """

    bits: int = 0
    value: Fraction | None = None
    constant: bool = False
    estimate: complex | None = None
    weight: float = 1.0
    reach: float = 0.0
    logs: bool = False
    below: int = 0

    @property
    def magnitude(self) -> float:
        """The absolute value of a constant, infinite where that is not known."""
        return math.inf if self.estimate is None else abs(self.estimate)

    @property
    def as_exponent(self) -> float:
        """A bound for the whole numbers that may become exponents if this is one."""
        return max(self.weight, self.magnitude) if self.constant else self.weight


SYMBOL = Size()


def bits_of(value: Fraction) -> int:
    """Return the number of bits that numerator and denominator take together."""
    return value.numerator.bit_length() + value.denominator.bit_length()


def of_number(value: Fraction) -> Size:
    """Return the size of a rational number."""
    estimate = attempt(lambda: complex(float(value)))
    weight = math.inf if estimate is None else abs(estimate)
    below = 0 if value.denominator == 1 else value.denominator.bit_length()
    return Size(bits_of(value), value=value, constant=True, estimate=estimate, weight=weight, below=below)


def of_constant(estimate: complex, bits: int = 0) -> Size:
    """Return the size of an irrational (or infinite) constant."""
    return Size(bits, constant=True, estimate=estimate, weight=max(1.0, abs(estimate)))


CONSTANTS = {
    "pi": of_constant(cmath.pi),
    "e": of_constant(cmath.e),
    "j": of_constant(1j, bits=1),
    "inf": Size(constant=True, weight=math.inf),
}


def of_value(value: Any) -> Size:
    """Return the size of a sympy object that stands for a name."""
    if value.is_Symbol:
        return SYMBOL
    if value.is_Rational:
        return of_number(Fraction(int(value.p), int(value.q)))
    parts = list(islice(_parts(value), _NODES))
    numbers = [Fraction(int(part.p), int(part.q)) for part in parts if part.is_Rational]
    bits, below = sum(map(bits_of, numbers)), sum(of_number(number).below for number in numbers)
    constant = not value.free_symbols
    estimate = attempt(lambda: complex(value)) if constant else None
    weight = max(1.0, abs(estimate)) if estimate is not None else _power(2.0, bits)
    logs = any(type(part).__name__ == "log" for part in parts)
    return Size(bits, None, constant, estimate, weight, weight, logs, below)


def _parts(value: Any) -> Iterator[Any]:
    """A sympy object and all that it is made of."""
    yield value
    for part in value.args:
        yield from _parts(part)


def plus(terms: Sequence[tuple[str, Size]]) -> Size:
    """Return the size of a sum; of a ± only the sizes of both values are known, not the values."""
    sizes = [size for _, size in terms]
    known = all(sign != "±" for sign, _ in terms)
    values = [-size.value if sign == "-" else size.value for sign, size in terms if size.value is not None]
    if known and len(values) == len(terms):
        return of_number(sum(values, Fraction(0)))
    constant = all(size.constant for size in sizes)
    numbers = [-size.estimate if sign == "-" else size.estimate for sign, size in terms if size.estimate is not None]
    estimate = sum(numbers) if known and constant and len(numbers) == len(terms) else None
    if estimate is not None and abs(estimate) < _NOISE * max(map(abs, numbers)):
        estimate = None  # the terms cancel: what is left may be rounding noise
    below = sum(size.below for size in sizes)  # over a common denominator: j/3 + j/7 is 10j/21
    return Size(
        max(size.bits - 2 * size.below for size in sizes) + 2 * below + len(terms).bit_length(),
        None,
        constant,
        estimate,
        sum(size.weight for size in sizes),
        max(size.reach for size in sizes),
        any(size.logs for size in sizes),
        below,
    )


def times(sizes: Sequence[Size]) -> Size:
    """Return the size of a product."""
    bits = sum(size.bits for size in sizes)
    values = [size.value for size in sizes if size.value is not None]
    if len(values) == len(sizes) and bits <= _LONG:
        return of_number(math.prod(values, start=Fraction(1)))
    constant = all(size.constant for size in sizes)
    numbers = [size.estimate for size in sizes if size.estimate is not None]
    return Size(
        bits,
        None,
        constant,
        attempt(lambda: math.prod(numbers, start=complex(1))) if len(numbers) == len(sizes) else None,
        math.prod(size.weight for size in sizes),
        sum(size.reach for size in sizes),
        any(size.logs for size in sizes),
        sum(size.below for size in sizes),
    )


def inverse(size: Size) -> Size:
    """Return the size of 1/x, x not the number zero."""
    if size.value:
        return of_number(1 / size.value)
    estimate, above = size.estimate, size.bits - size.below
    below = 2 * above + 2 if size.constant else above  # d/(a + jb) is d(a - jb)/(a² + b²)
    return replace(
        size,
        bits=(size.bits if size.constant else size.below) + below,
        below=below,
        estimate=attempt(lambda: 1 / estimate) if estimate is not None else None,
        weight=_power(2.0, size.bits),
    )


def integer_power(base: Size, n: int) -> Size:
    """Return the size of xⁿ, x not the number zero if n < 0."""
    if n < 0:
        return integer_power(inverse(base), -n)
    bits = base.bits * max(n, 1)
    if base.value is not None and bits <= _LONG:
        return of_number(base.value**n)
    estimate = base.estimate
    return replace(
        base,
        bits=bits,
        below=base.below * n,
        value=None,
        estimate=attempt(lambda: estimate**n) if estimate is not None else None,
        weight=_power(base.weight, n),
        reach=base.reach * n,
    )


def power(base: Size, exponent: Size) -> Size:
    """Return the size of a power that is not by a whole number; the exponent is bounded."""
    growth = max(1, math.ceil(exponent.as_exponent))
    x, y = base.estimate, exponent.estimate
    return Size(
        (2 * base.bits + 2) * growth + exponent.bits,
        None,
        base.constant and exponent.constant,
        attempt(lambda: x**y) if x is not None and y is not None else None,
        _power(max(base.weight, 1.0), growth),
        base.reach * growth,
        base.logs or exponent.logs,
        base.bits * growth,
    )


def function(name: str, argument: Size, evaluate: Callable[[complex], complex]) -> Size:
    """Return the size of a function's value; functions that undo each other leave the argument's coefficients."""
    x = argument.estimate
    estimate = attempt(lambda: evaluate(x)) if x is not None else None
    weight = max(1.0, abs(estimate) if estimate is not None else 0.0, argument.reach)
    if name == "exp" and argument.logs:  # exp(n log q) is qⁿ
        argument = integer_power(replace(argument, value=None), math.ceil(argument.as_exponent))
    return Size(
        2 * argument.bits + 2,
        None,
        argument.constant,
        estimate,
        weight if name == "log" else max(weight, argument.weight),
        max(argument.weight, argument.reach) if name in ("exp", "sinh", "cosh") else argument.reach,
        argument.logs or name == "log",
        argument.bits,
    )


def attempt(compute: Callable[[], complex]) -> complex | None:
    """Return what is computed, or None if it is no finite number."""
    try:
        result = compute()
    except (ValueError, TypeError, ArithmeticError):
        return None
    return result if cmath.isfinite(result) else None


def _power(x: float, n: int) -> float:
    """xⁿ, infinite where it overflows."""
    try:
        return x**n
    except OverflowError:
        return math.inf
