"""The resolvent (xI − A)⁻¹, its partial fractions, and the transform pairs that they need."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.derivation.stated import Stated, product, quotient
from solver.exact.faddeev import faddeev_leverrier
from solver.exact.fields import Algebraic, Modulus, collected, expressions, matrix_of
from solver.exact.functions import closed_form, polar
from solver.exact.instances import value_at
from solver.exact.residues import (
    FactorResidues,
    Residue,
    divided_by,
    multiply_by,
    reduce_modulo,
    residues_at,
    resolvent_residues,
)
from solver.exact.spectrum import Factor, Root, irreducible_factors, polynomial


def resolvent(A: sp.ImmutableMatrix, x: sp.Symbol) -> sp.ImmutableMatrix:
    """(xI − A)⁻¹ (n×n): entries in lowest terms, denominators as products of the irreducible factors of χ."""
    fl = faddeev_leverrier(A)
    K, n = fl.domain, A.rows
    entries = []
    for flat in zip(*(N.to_list_flat() for N in fl.N), strict=True):
        numerator = sp.Poly(list(flat), x, domain=K)
        denominator = sp.Integer(1)
        for p, multiplicity in irreducible_factors(A):
            factor, left = sp.Poly(p.rep.to_list(), x, domain=K), multiplicity
            while left and not numerator.is_zero and numerator.rem(factor).is_zero:
                numerator, left = numerator.quo(factor), left - 1
            denominator *= polynomial(factor, x) ** left
        entries.append(_fraction(numerator, denominator, x))
    return sp.ImmutableMatrix(n, n, entries)


def _fraction(numerator: sp.Poly, denominator: sp.Expr, x: sp.Symbol) -> sp.Expr:
    """The fraction as it is written: zero as 0, a numerator that begins with a minus with the minus in front."""
    if numerator.is_zero:
        return sp.Integer(0)
    written = polynomial(numerator, x)
    negative = sp.expand(-written)
    if all(term.could_extract_minus_sign() for term in sp.Add.make_args(written)):
        return -(negative / denominator)
    return written / denominator


def partial_fractions(A: sp.ImmutableMatrix, x: sp.Symbol) -> list[Stated]:
    """The terms of (xI − A)⁻¹ = Σ (1/p(x)ʲ) R_j(x), R_j a matrix polynomial of lower degree than p.

    Factors with real roots are split into (x − λ)ʲ; a conjugate pair (or one whose nature is undecided) keeps its
    quadratic denominator.
    """
    terms: list[Stated] = []
    for each in resolvent_residues(A):
        if _keeps_quadratic(each.factor):
            terms += _quadratic_terms(A, each.factor, x)
        else:
            terms += _linear_terms(each, A.shape, x)
    return [term for term in terms if any(term.operands[1])]


def _keeps_quadratic(factor: Factor) -> bool:
    return factor.degree == 2 and factor.roots[0].kind != "surd"


def _quadratic_terms(A: sp.ImmutableMatrix, factor: Factor, x: sp.Symbol) -> Iterator[Stated]:
    """The p-adic digits of adj·(χ/pᵐ)⁻¹ mod pᵐ, the highest power of p first."""
    p = factor.polynomial(x)
    for k, (constant, linear) in enumerate(_digits(A, factor)):
        numerator = matrix_of(linear) * x + matrix_of(constant)
        yield product(quotient(sp.Integer(1), p ** (factor.multiplicity - k)), sp.ImmutableMatrix(numerator))


def _digits(A: sp.ImmutableMatrix, factor: Factor) -> list[Residue]:
    """R_m, …, R_1 of one factor, as coefficients of 1, x, …."""
    fl, p, m = faddeev_leverrier(A), factor.modulus, factor.multiplicity
    K = p.domain
    X = sp.Dummy("x")
    single = sp.Poly([K.one, *reversed(p.low)], X, domain=K)
    whole = single**m
    P = Modulus(tuple(reversed(whole.rep.to_list()[1:])), K)
    others = sp.Poly(list(fl.chi), X, domain=K).quo(whole)
    inverse = Algebraic(P.reduce([*reversed(others.rep.to_list())]), P).inverse()
    rest = multiply_by(reduce_modulo(list(fl.N[::-1]), P), inverse)
    digits = []
    for _ in range(m):
        rest, digit = divided_by(rest, p)
        digits.append(digit)
    return digits


def _linear_terms(each: FactorResidues, shape: tuple[int, int], x: sp.Symbol) -> Iterator[Stated]:
    """Z_j/(x − λ)ʲ for each root; a simple pair of decimal roots is put over its real quadratic."""
    for root in each.factor.roots:
        for j, Z in enumerate(each.residues, 1):
            matrix = residue_at(Z, root, shape)
            if not _is_simple_decimal_pair(root):
                yield product(quotient(sp.Integer(1), (x - root.value) ** j), matrix)
            elif root.shift > 0:
                X, Y = matrix.applyfunc(sp.re), matrix.applyfunc(sp.im)
                numerator = 2 * X * x - 2 * (root.sigma * X + root.shift * Y)
                yield product(quotient(sp.Integer(1), _decimal_quadratic(root, x)), sp.ImmutableMatrix(numerator))


def residue_at(Z: Residue, root: Root, shape: tuple[int, int]) -> sp.ImmutableMatrix:
    """A matrix over L at one root of its factor."""
    parts = [expressions(M) for M in Z]
    entries = parts[0] if len(parts) == 1 else [value_at(list(c), root) for c in zip(*parts, strict=True)]
    return sp.ImmutableMatrix(*shape, entries)


def transform_pairs(
    A: sp.ImmutableMatrix, x: sp.Symbol, time: sp.Symbol, *, discrete: bool
) -> list[tuple[sp.Expr, sp.Expr]]:
    """Pairs (image, function of time) for the partial fractions; in discrete time the images carry the factor z."""
    pairs: list[tuple[sp.Expr, sp.Expr]] = []
    for each in resolvent_residues(A):
        highest = max(j for j, Z in enumerate(each.residues, 1) if any(any(M.to_list_flat()) for M in Z))
        for j in range(1, highest + 1):
            of_factor = _quadratic_pairs if _keeps_quadratic(each.factor) else _linear_pairs
            pairs += of_factor(each.factor, j, x, time, discrete=discrete)
    return pairs


def _quadratic_pairs(
    factor: Factor, j: int, x: sp.Symbol, time: sp.Symbol, *, discrete: bool
) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """The pairs of (x − σ)/pʲ and of ω/p or 1/pʲ."""
    K, low = factor.modulus.domain, factor.modulus.low
    p, root = factor.polynomial(x), factor.roots[-1 if factor.roots[0].kind == "symbolic" else 0]
    carried = x if discrete else sp.Integer(1)
    scale = root.shift if j == 1 else sp.Integer(1)
    yield carried * (x - root.sigma) / p**j, _scalar(factor, j, [low[1] / 2, K.one], time, discrete=discrete)
    sine = _scalar(factor, j, [K.one], time, discrete=discrete)
    yield carried * scale / p**j, collected(scale * sine) if j == 1 and not scale.free_symbols else scale * sine


def _linear_pairs(
    factor: Factor, j: int, x: sp.Symbol, time: sp.Symbol, *, discrete: bool
) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """The pairs of 1/(x − λ)ʲ; of a simple pair of decimal roots, those of its real quadratic."""
    for root in factor.roots:
        if _is_simple_decimal_pair(root):
            if root.shift > 0:
                yield from _decimal_pairs(root, x, time, discrete=discrete)
        elif discrete and root.value == 0:
            yield x ** (1 - j), sp.KroneckerDelta(time, j - 1)
        elif discrete:
            binomial = sp.expand(sp.ff(time, j - 1)) / sp.factorial(j - 1)
            yield x / (x - root.value) ** j, binomial * root.value ** (time - j + 1)
        else:
            yield 1 / (x - root.value) ** j, time ** (j - 1) / sp.factorial(j - 1) * sp.exp(root.value * time)


def _is_simple_decimal_pair(root: Root) -> bool:
    return root.kind == "decimal" and root.shift != 0 and root.multiplicity == 1


def _decimal_pairs(root: Root, x: sp.Symbol, time: sp.Symbol, *, discrete: bool) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    if discrete:
        r, theta = polar(root)
        envelope, angle = r**time, theta * time
    else:
        envelope, angle = sp.exp(root.sigma * time), root.shift * time
    carried, p = x if discrete else sp.Integer(1), _decimal_quadratic(root, x)
    yield carried * (x - root.sigma) / p, envelope * sp.cos(angle)
    yield carried * root.shift / p, envelope * sp.sin(angle)


def _decimal_quadratic(root: Root, x: sp.Symbol) -> sp.Expr:
    return x**2 - 2 * root.sigma * x + (root.sigma**2 + root.shift**2)


def _scalar(factor: Factor, j: int, numerator: list[Any], time: sp.Symbol, *, discrete: bool) -> sp.Expr:
    """The function of time with the image numerator/pʲ (times z in discrete time)."""
    K = factor.modulus.domain
    p = sp.Poly([K.one, *reversed(factor.modulus.low)], sp.Dummy("x"), domain=K)
    alone = Factor(factor.modulus, j, factor.roots)
    coefficients = [DomainMatrix([[c]], (1, 1), K) for c in numerator]
    residues = residues_at(coefficients, (p**j).rep.to_list()[::-1], alone)
    return closed_form((1, 1), [residues], time, discrete=discrete).matrix[0]
