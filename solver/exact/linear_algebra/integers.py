"""Rational vectors and matrices as integers over one denominator; integer roots of polynomials."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import accumulate
from math import lcm
from operator import attrgetter, mul
from typing import Any

import sympy as sp
from sympy import QQ
from sympy.polys.matrices import DomainMatrix

Integers = list[int]

_is_rational = attrgetter("is_Rational")


def are_rational(entries: Sequence[sp.Expr]) -> bool:
    """Whether all entries are rational numbers."""
    return all(map(_is_rational, entries))


def over_rationals(flat: Sequence[sp.Rational], shape: tuple[int, int]) -> DomainMatrix:
    """Return the matrix over QQ with these entries, row by row."""
    rows, columns = shape
    entries = [QQ(int(x.p), int(x.q)) for x in flat]
    return DomainMatrix([entries[i * columns : (i + 1) * columns] for i in range(rows)], shape, QQ)


def common_denominator(numbers: Sequence[sp.Rational]) -> int:
    """The least common denominator of the numbers."""
    return lcm(*[int(x.q) for x in numbers])


def over_denominator(numbers: Sequence[sp.Rational], denominator: int) -> Integers:
    """The numerators of the numbers over a common denominator."""
    return [int(x.p) * (denominator // int(x.q)) for x in numbers]


def integer_rows(flat: Sequence[sp.Rational], width: int) -> tuple[list[Integers], int]:
    """Return F (rows of integers) and f with M = F/f, for the entries of M row by row."""
    f = common_denominator(flat)
    F = over_denominator(flat, f)
    return [F[i : i + width] for i in range(0, len(F), width)], f


def times(F: list[Integers], v: Integers) -> Integers:
    """The product F v."""
    return [sum(map(mul, row, v)) for row in F]


def _horner(coefficients: list[int], x: int) -> list[int]:
    """Horner's scheme: the coefficients of the quotient by (· − x), then the value at x."""
    return list(accumulate(coefficients, lambda value, c: value * x + c))


def small_integer_roots(coefficients: list[Any]) -> tuple[list[int], list[Any]]:
    """Integer roots −99 … 99 of a polynomial (highest power first), with multiplicity, and what is left without them.

    Most polynomials of a course split like this, and factoring over the integers costs more than the rest of e^{At}.
    """
    if any(c.denominator != 1 for c in coefficients):
        return [], coefficients
    roots: list[int] = []
    rest = [int(c) for c in coefficients]
    for root in range(-99, 100):
        while len(rest) > 1 and (rest[-1] % root == 0 if root else rest[-1] == 0):  # a root divides the constant term
            *quotient, value = _horner(rest, root)
            if value:
                break
            roots, rest = [*roots, root], quotient
    return roots, [QQ(c) for c in rest]
