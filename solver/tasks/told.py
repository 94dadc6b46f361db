"""Numbers as a sheet tells them: exact where they are short, else decimals of four digits; pairs as one."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, NamedTuple

from solver.lazy import sympy as sp
from solver.numeric.judges import linear_algebra as judges

LARGEST = 12
"""The largest denominator of numbers that are told exactly."""

MULTIPLE = 27720
"""A multiple of all these denominators."""

LONG = 10_000
NEAR = 1e-9
DIGITS = 4


class Told(NamedTuple):
    """A number as it is told; `beside` is the imaginary part of a conjugate pair, None for one number."""

    at: Any
    beside: Any = None


def short(number: Any) -> Any:
    """Return a number as it is told; what is no finite number stays as it is."""
    if not number.is_number or number.is_finite is False:
        return number
    value = complex(number)
    real, imaginary = (_exact(x) for x in (value.real, value.imag))
    if real is None or imaginary is None:
        real, imaginary = (_decimal(x) for x in (value.real, value.imag))
    return real + sp.I * imaginary


def _exact(x: float) -> Any:
    """The short rational number that x is, None where it is none."""
    if not abs(x) < LONG:
        return None
    near = sp.Rational(round(x * MULTIPLE), MULTIPLE)
    return near if near.q <= LARGEST and abs(x - float(near)) < NEAR * max(1.0, abs(x)) else None


def _decimal(x: float) -> Any:
    near = round(x)
    return sp.Integer(near) if abs(x - near) < NEAR and abs(x) < LONG else sp.Float(f"{x:.{DIGITS}g}", 15)


def alike(one: Any, other: Any) -> bool:
    """Whether two numbers are told alike: to four digits."""
    a, b = complex(one), complex(other)
    return all(f"{x + 0:.{DIGITS}g}" == f"{y + 0:.{DIGITS}g}" for x, y in ((a.real, b.real), (a.imag, b.imag)))


def shortened(value: Any) -> Any:
    """Return an expression or a matrix with its numbers as they are told, entry by entry."""
    return sp.ImmutableMatrix(value.applyfunc(short)) if isinstance(value, sp.MatrixBase) else short(value)


def told(numbers: Iterable[Any]) -> list[Told]:
    """Return numbers in rising order as they are told, those of a conjugate pair as one; symbols come last."""
    left, found = [short(number) for number in numbers], list[Told]()
    while left:
        number = left.pop(0)
        if number.is_number and (other := sp.conjugate(number)) != number and other in left:
            left.remove(other)
            found.append(Told(sp.re(number), abs(sp.im(number))))
        else:
            found.append(Told(number))
    return sorted(found, key=_place)


def _place(each: Told) -> tuple[Any, ...]:
    if not each.at.is_number:
        return (1, str(each.at))
    value = complex(each.at)
    return (0, value.real, abs(value.imag), float(each.beside or 0))


def spectrum(M: Any) -> list[Told] | None:
    """Return the eigenvalues of a square matrix as they are told, None where it holds symbols."""
    return None if M.free_symbols else told(judges.decimal_eigenvalues(M))
