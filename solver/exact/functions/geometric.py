"""What is added up in a convolution sum, Σ C λ^{k−1−i} μⁱ for i = 0 … k − 1: the bases of its powers."""

from __future__ import annotations

from typing import Any

import sympy as sp

Bases = tuple[sp.Expr, sp.Expr]
"""λ and μ of λ^{k−1−i} μⁱ."""


def geometric_terms(summand: sp.ImmutableMatrix, i: sp.Symbol, k: sp.Symbol) -> dict[Bases, sp.ImmutableMatrix] | None:
    """The constant matrices C by λ and μ, summand = Σ C λ^{k−1−i} μⁱ; None where there is a term of another kind."""
    found: dict[Bases, list[sp.Expr]] = {}
    entries = summand.flat()
    for position, entry in enumerate(entries):
        for term in sp.Add.make_args(sp.expand_mul(entry)):
            read = _read(term, i, k)
            if read is None:
                return None
            constant, *bases = read
            if constant != 0:
                found.setdefault((bases[0], bases[1]), [sp.S.Zero] * len(entries))[position] += constant
    return {bases: sp.ImmutableMatrix(*summand.shape, constants) for bases, constants in found.items()}


def _read(term: sp.Expr, i: sp.Symbol, k: sp.Symbol) -> tuple[sp.Expr, sp.Expr, sp.Expr] | None:
    """C, λ and μ of a term."""
    constant, of_k, of_i = sp.S.One, sp.S.One, sp.S.One
    parts: tuple[Any, ...] = sp.Mul.make_args(term)
    for each in parts:
        base, exponent = each.as_base_exp()
        if not exponent.has(i, k):
            constant *= each
            continue
        slopes = [sp.diff(exponent, x) for x in (i, k)]
        if not all(slope.is_Integer for slope in slopes):
            return None
        of_i, of_k = of_i * base ** slopes[0], of_k * base ** slopes[1]
        constant *= base ** sp.expand(exponent - slopes[0] * i - slopes[1] * k)
    if constant.has(i, k):
        return None
    return constant * of_k, of_k, of_k * of_i
