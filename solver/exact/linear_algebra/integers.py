"""Rational vectors and matrices as integers over one denominator, where many products are to be taken."""

from __future__ import annotations

from collections.abc import Sequence
from math import lcm
from operator import attrgetter, mul

import sympy as sp

Integers = list[int]

_is_rational = attrgetter("is_Rational")


def are_rational(entries: Sequence[sp.Expr]) -> bool:
    """Whether all entries are rational numbers."""
    return all(map(_is_rational, entries))


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
