"""Square roots and square factors of the elements of a field K: rational numbers, or rational functions over them."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from math import isqrt
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.signs import is_positive


def root_in(K: Any, c: Any) -> Any | None:
    """A square root of c in K, or None (also where K is neither QQ nor a field of rational functions over it)."""
    if not c:
        return K.zero
    if K.is_QQ:
        p, q = int(c.numerator), int(c.denominator)
        if p < 0 or isqrt(p) ** 2 != p or isqrt(q) ** 2 != q:
            return None
        return K(isqrt(p), isqrt(q))
    if not has_factors(K):
        return None
    content, powers = _factors(c)
    number = root_in(sp.QQ, content)
    if number is None or any(power % 2 for _, power in powers):
        return None
    root = _rational(K, number)
    for factor, power in powers:
        root = root * K(factor) ** (power // 2)
    return root


def has_factors(K: Any) -> bool:
    """Whether K is a field of rational functions over the rational numbers."""
    return bool(K.is_FractionField and (K.domain.is_QQ or K.domain.is_ZZ))


def _rational(K: Any, number: Any) -> Any:
    """A rational number as an element of K."""
    return K(int(number.numerator)) / K(int(number.denominator))


def _factors(c: Any) -> tuple[Any, list[tuple[Any, int]]]:
    """Return a rational number and the irreducible polynomials with their powers that make up c."""
    above, numerator = c.numer.factor_list()
    below, denominator = c.denom.factor_list()
    content = sp.QQ.convert(above) / sp.QQ.convert(below)
    return content, [*numerator, *((factor, -power) for factor, power in denominator)]


def known_square(K: Any, elements: Sequence[Any]) -> Any:
    """A factor c, known to be positive, with x/c² free of common squares and denominators as far as that can be seen.

    `elements` are those of K that make up x, none of them zero.
    """
    if K.is_QQ:
        return K(*square_content(elements))
    number, powers = common_factors(K, elements)
    found = _rational(K, number)
    for factor, power in powers:
        found = found * K(factor) ** (power // 2)
    return found


def common_factors(K: Any, elements: Sequence[Any]) -> tuple[Any, list[tuple[Any, int]]]:
    """The rational number whose square elements have in common, and their common factors that are known positive.

    Negative powers are those of the common denominator.
    """
    if not has_factors(K):
        return sp.QQ.one, []
    above = reduce(lambda a, b: a.gcd(b), (x.numer for x in elements))
    below = reduce(lambda a, b: a.lcm(b), (x.denom for x in elements))
    scale, _ = _factors(K(below))
    numbers = [sp.QQ.convert(n) / scale for x in elements for n in (x * K(below)).numer.coeffs()]
    _, powers = _factors(K(above) / K(below))
    return sp.QQ(*square_content(numbers)), [each for each in powers if known_positive(each[0].as_expr())]


def known_positive(x: sp.Expr) -> bool:
    """Whether a polynomial other than zero is known to be positive, up to special values where it is zero.

    A quadratic a y² + b y + c is where a and 4ac − b² are.
    """
    if is_positive(x) or not x.is_polynomial(*x.free_symbols):
        return is_positive(x)
    for y in sorted(x.free_symbols, key=str):
        p = sp.Poly(x, y)
        if p.degree() == 2 and y.is_real is not False:
            a, b, c = p.all_coeffs()
            if is_positive(a) and sp.factor(4 * a * c - b**2).is_nonnegative:
                return True
    return False


def square_content(numbers: Sequence[Any]) -> tuple[int, int]:
    """Return (p, q) such that the numbers divided by (p/q)² are integers without a common square factor."""
    q = sp.ilcm(1, *(int(x.denominator) for x in numbers))
    outside, root_of_q = 1, 1
    for prime, power in sp.factorint(q).items():
        root_of_q *= prime ** ((power + 1) // 2)
    whole = [int(x.numerator) * (root_of_q**2 // int(x.denominator)) for x in numbers]
    for prime, power in sp.factorint(sp.igcd(0, *whole)).items():
        outside *= prime ** (power // 2)
    return outside, root_of_q
