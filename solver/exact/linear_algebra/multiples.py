"""Vectors over L = K[x]/(p) scaled to the multiple that a person writes."""

from __future__ import annotations

from functools import lru_cache, reduce
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.fields import Algebraic, Modulus

Vector = tuple[Any, ...]

LARGEST = 1000
"""Integers beyond this are harder to read than fractions, or decimals, beside a one."""


def cleared(v: Vector) -> Vector:
    """V times the factor that makes its coefficients integers (polynomials) without a common divisor, lead positive.

    With a quadratic irrationality that factor is any element of L: of the multiples with a rational entry the one
    with the smallest integers is taken, and of two that are alike the one that begins with the rational entry.
    """
    p = v[0].modulus
    if p.degree == 4 and not any(p.low[1::2]):
        return min([v, *(tuple(b / a for b in v) for a in v if any(a.coefficients[1:]))], key=_written)
    if p.degree != 2 or not p.domain.is_QQ:
        return without_common_factor([v])[0]
    multiples = [without_common_factor([v])[0]]
    multiples += [without_common_factor([tuple(b / a for b in v)])[0] for a in v if any(a.coefficients[1:])]

    def size(each: Vector) -> tuple[Any, bool]:
        lead = next(a for a in each if a)
        return sum(abs(c) for a in each for c in _over_root(a)), any(lead.coefficients[1:])

    return min(multiples, key=size)


def _written(v: Vector) -> tuple[int, int, int]:
    """How much there is to write of a vector, of two alike the one whose one comes first: powers, odd powers, zeros."""
    powers = [[bool(c) for c in a.coefficients] for a in v]
    first = next((i for i, a in enumerate(powers) if a[0] and not any(a[1:])), len(v))
    return sum(map(sum, powers)), sum(any(a[1::2]) for a in powers), first


def _over_root(a: Algebraic) -> tuple[Any, ...]:
    """The numbers that are seen: a = r + q√d, d without square factors, for a quadratic p over ℚ; else as they are."""
    p = a.modulus
    if p.degree != 2 or not p.domain.is_QQ:
        return a.coefficients
    outside = _square_factor(*p.low)
    return a.coefficients[0] - a.coefficients[1] * p.low[1] / 2, a.coefficients[1] * outside


@lru_cache(maxsize=256)
def _square_factor(c: Any, b: Any) -> Any:
    """The rational k > 0 with √(b²/4 − c) = k√d, as it is written."""
    radicand = b * b / 4 - c
    shown = sp.sqrt(abs(sp.Rational(int(radicand.numerator), int(radicand.denominator)))).as_coeff_Mul()[0]
    return sp.QQ(shown.p, shown.q)


def _has_nice_multiples(p: Modulus) -> bool:
    """Whether a vector gets simpler when denominators are cleared: not with decimals, surds or half-angle tangents."""
    K = p.domain
    if K.is_FractionField and any(generator.has(sp.tan) for generator in K.symbols):
        return False
    return p.degree < 3 and (K.is_QQ or K.is_FractionField)


def without_common_factor(chain: list[Vector]) -> list[Vector]:
    """A chain times one factor of K, so that its coefficients are coprime integers or polynomials."""
    p = chain[0][0].modulus
    K = p.domain
    if not _has_nice_multiples(p):
        return chain
    coefficients = [c for v in chain for a in v for c in _over_root(a) if c]
    R = K.get_ring()
    denominator = reduce(R.lcm, (R.convert(K.denom(c)) if K.is_QQ else K.denom(c) for c in coefficients))
    numerators = [K.numer(c * K.convert(denominator, R)) for c in coefficients]
    divisor = reduce(R.gcd, numerators)
    factor = K.convert(denominator, R) / K.convert(divisor, R)
    if K.is_QQ and max(abs(c * factor) for c in coefficients) > LARGEST:
        return chain
    first = next(c for v in chain for a in v for c in reversed(a.coefficients) if c)
    if K.is_QQ and first < 0:
        factor = -factor
    return [tuple(Algebraic((c * factor for c in a.coefficients), p) for a in v) for v in chain]
