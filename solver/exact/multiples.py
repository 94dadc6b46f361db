"""Vectors over L = K[x]/(p) scaled to the multiple that a person writes."""

from __future__ import annotations

from functools import reduce
from typing import Any

import sympy as sp

from solver.exact.fields import Algebraic, Modulus

Vector = tuple[Any, ...]


def cleared(v: Vector) -> Vector:
    """V times the factor that makes its coefficients integers (polynomials) without a common divisor, lead positive."""
    return without_common_factor([v])[0]


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
    coefficients = [c for v in chain for a in v for c in a.coefficients if c]
    R = K.get_ring()
    denominator = reduce(R.lcm, (R.convert(K.denom(c)) if K.is_QQ else K.denom(c) for c in coefficients))
    numerators = [K.numer(c * K.convert(denominator, R)) for c in coefficients]
    divisor = reduce(R.gcd, numerators)
    factor = K.convert(denominator, R) / K.convert(divisor, R)
    first = next(c for v in chain for a in v for c in reversed(a.coefficients) if c)
    if K.is_QQ and first < 0:
        factor = -factor
    return [tuple(Algebraic((c * factor for c in a.coefficients), p) for a in v) for v in chain]
