"""Polynomials over the field K of a system, and matrices of them: roots, factors, Smith's form.

Notation: a polynomial is a `Poly` in one variable over K; a matrix of polynomials is a list of rows.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import reduce
from itertools import pairwise
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.fields import expression
from solver.exact.linear_algebra.spectrum import Spectrum, irreducible_factors, polynomial, spectrum

Rows = list[list[sp.Poly]]


def companion(p: sp.Poly) -> sp.ImmutableMatrix:
    """The companion matrix of a monic polynomial: ones above the diagonal, its coefficients in the last row."""
    n = p.degree()
    low = [expression(p.domain, c) for c in reversed(p.rep.to_list()[1:])]
    return sp.ImmutableMatrix(n, n, lambda i, j: -low[j] if i == n - 1 else sp.Integer(int(j == i + 1)))


def roots_of(p: sp.Poly) -> Spectrum | None:
    """The roots of a monic polynomial, factor by factor (None: it is constant); raises NotExact."""
    return spectrum(companion(p)) if p.degree() > 0 else None


def eigenvalues_of(p: sp.Poly) -> list[sp.Expr]:
    """The roots of a polynomial with multiplicity; raises NotExact."""
    found = roots_of(p.monic())
    return found.eigenvalues if found else []


def factors_of(p: sp.Poly) -> list[tuple[sp.Poly, int]]:
    """The monic irreducible factors of a monic polynomial over K, with their multiplicities."""
    if p.degree() == 0:
        return []
    x, K = p.gen, p.domain
    if K.is_Algebraic or (K.is_FractionField and K.domain.is_Algebraic):  # what is irreducible over QQ may split
        return [(factor.monic(), multiplicity) for factor, multiplicity in p.factor_list()[1]]
    return [
        (sp.Poly(factor.rep.to_list(), x, domain=factor.domain).set_domain(K), multiplicity)
        for factor, multiplicity in irreducible_factors(companion(p))
    ]


def expanded(p: sp.Poly) -> sp.Expr:
    """The polynomial as an expression, sorted by powers."""
    return polynomial(p, p.gen) if not p.is_zero else sp.Integer(0)


def factored_form(factors: Iterable[tuple[sp.Poly, int]]) -> sp.Expr:
    """The product of powers of polynomials as an expression."""
    return sp.Mul(*(sp.Pow(expanded(p), m) for p, m in factors))


def least_common_multiple(polynomials: Iterable[sp.Poly]) -> sp.Poly:
    """The monic least common multiple of monic polynomials."""
    return reduce(lambda p, q: p if p == q else p.lcm(q).monic(), polynomials)


def in_lowest_terms(top: sp.Poly, bottom: sp.Poly, factors: Sequence[tuple[sp.Poly, int]]) -> sp.Expr:
    """The fraction top/bottom cancelled, its denominator a product of some irreducible factors."""
    if top.is_zero:
        return sp.Integer(0)
    left: list[tuple[sp.Poly, int]] = []
    for factor, highest in factors:
        remaining = 0
        while remaining < highest and bottom.rem(factor).is_zero:
            bottom = bottom.quo(factor)
            if top.rem(factor).is_zero:
                top = top.quo(factor)
            else:
                remaining += 1
        if remaining:
            left.append((factor, remaining))
    if _in_parameters(top.domain):
        return _cleared_fraction(top, left)
    return signed_fraction(expanded(top), factored_form(left))


def _in_parameters(K: Any) -> bool:
    """Whether K is a field of fractions in plain symbols (not in tangents of half an angle)."""
    return bool(K.is_FractionField and all(generator.is_Symbol for generator in K.symbols))


def _cleared_fraction(top: sp.Poly, factors: Sequence[tuple[sp.Poly, int]]) -> sp.Expr:
    """The fraction without fractions in its coefficients: 1/(m s² + d s + k), not (1/m)/(s² + d s/m + k/m)."""
    bottoms = [(*_cleared_of_denominators(p), m) for p, m in factors]
    for _, c, m in bottoms:
        top = top * sp.Poly([c**m], top.gen, domain=top.domain)
    cleared, c = _cleared_of_denominators(top)
    bottom = sp.Mul(expression(top.domain, c), *(sp.Pow(expanded(p), m) for p, _, m in bottoms))
    return signed_fraction(expanded(cleared), bottom)


def _cleared_of_denominators(p: sp.Poly) -> tuple[sp.Poly, Any]:
    """C p and c, the least common denominator of its coefficients."""
    K = p.domain
    R = K.get_ring()
    c = K.convert(reduce(R.lcm, (K.denom(each) for each in p.rep.to_list())), R)
    return sp.Poly([each * c for each in p.rep.to_list()], p.gen, domain=K), c


def signed_fraction(written: sp.Expr, denominator: sp.Expr) -> sp.Expr:
    """The fraction as it is written: a numerator that begins with a minus has the minus in front."""
    negative = sp.expand(-written)
    if all(term.could_extract_minus_sign() for term in sp.Add.make_args(written)):
        return -(negative / denominator)
    return written / denominator


def invariant_factors(rows: Rows) -> list[sp.Poly]:
    """The monic invariant factors e₁ | e₂ | … | e_r of a polynomial matrix of rank r (Smith's form).

    By Euclid's algorithm on rows and columns, pivots of least degree. Source: F. R. Gantmacher, The Theory of
    Matrices I, chapter VI §2.
    """
    M, found = [list(row) for row in rows], []
    while (pivot := _least(M)) is not None:
        i, j = pivot
        M[0], M[i] = M[i], M[0]
        for row in M:
            row[0], row[j] = row[j], row[0]
        if _cleared(M):
            found.append(M[0][0].monic())
            M = [row[1:] for row in M[1:]]
    return _dividing_each_other(found)


def _least(M: Rows) -> tuple[int, int] | None:
    """The place of a nonzero entry of least degree."""
    places = [(p.degree(), i, j) for i, row in enumerate(M) for j, p in enumerate(row) if not p.is_zero]
    return min(places)[1:] if places else None


def _cleared(M: Rows) -> bool:
    """Take multiples of the first row and column from the others; whether nothing is left beside the pivot."""
    for row in M[1:]:
        quotient = row[0].quo(M[0][0])
        if not quotient.is_zero:
            row[:] = [a - quotient * b for a, b in zip(row, M[0], strict=True)]
    if any(not row[0].is_zero for row in M[1:]):
        return False
    M[0][1:] = [a.rem(M[0][0]) for a in M[0][1:]]
    return all(a.is_zero for a in M[0][1:])


def _dividing_each_other(diagonal: list[sp.Poly]) -> list[sp.Poly]:
    """The invariant factors of a diagonal matrix: (a, b) becomes (gcd, lcm) until each divides the next."""
    found = list(diagonal)
    while any(not q.rem(p).is_zero for p, q in pairwise(found)):
        for i in range(len(found) - 1):
            p, q = found[i], found[i + 1]
            found[i], found[i + 1] = p.gcd(q).monic(), p.lcm(q).monic()
    return found


def elements(p: sp.Poly, length: int) -> list[Any]:
    """The coefficients in K, lowest power first, filled up with zeros."""
    low = list(reversed(p.rep.to_list())) if not p.is_zero else []
    return low + [p.domain.zero] * (length - len(low))
