"""Matrices of rational functions N(x)/χ(x) over a field: lowest terms, residues, partial fractions.

(xI − A)⁻¹ is one, and so is L (xI − A)⁻¹ R, the transform of a response. All results come from the irreducible factors
of χ; those that cancel show as residues that are zero.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import dropwhile
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.functions.closed_forms import MatrixFunction, closed_form
from solver.exact.functions.fractions import Fraction, fractions_of, highest_power
from solver.exact.functions.residues import FactorResidues, MatrixPolynomial, residues_at, resolvent_residues
from solver.exact.linear_algebra.assembly import product_of_powers
from solver.exact.linear_algebra.faddeev import faddeev_leverrier
from solver.exact.linear_algebra.fields import Modulus, domain_matrix, in_powers
from solver.exact.linear_algebra.spectrum import Factor, spectrum
from solver.stated import Stated


@dataclass(frozen=True)
class RationalMatrix:
    """Σ numerator[i] xⁱ/χ(x) over K, `chi` with the lowest power first; `factors` are those of χ."""

    shape: tuple[int, int]
    numerator: tuple[DomainMatrix, ...]
    chi: tuple[Any, ...]
    factors: tuple[Factor, ...]

    @cached_property
    def residues(self) -> tuple[FactorResidues, ...]:
        """The residues at the roots of each factor."""
        numerator = MatrixPolynomial(self.numerator)
        return tuple(residues_at(numerator, self.chi, factor) for factor in self.factors)

    @cached_property
    def fractions(self) -> dict[sp.Symbol, Sequence[Fraction]]:
        """The partial fractions that were found, by the variable they are written in."""
        return {}

    @cached_property
    def poles(self) -> list[tuple[FactorResidues, int]]:
        """The factors that do not cancel in all entries, with the highest power at which each occurs."""
        orders = ((each, highest_power(each)) for each in self.residues)
        return [(each, order) for each, order in orders if order]

    def function(self, time: sp.Symbol, *, discrete: bool) -> MatrixFunction:
        """The inverse Laplace transform; in discrete time the inverse z-transform of z times the matrix."""
        return closed_form(self.shape, self.residues, time, discrete=discrete)

    def expression(self, x: sp.Symbol) -> sp.ImmutableMatrix:
        """The entries in lowest terms, denominators as products of irreducible factors."""
        factors = [(each.modulus, each.multiplicity) for each in self.factors]
        flat = zip(*(C.to_list_flat() for C in reversed(self.numerator)), strict=True)
        return sp.ImmutableMatrix(*self.shape, [in_lowest_terms(list(entry), factors, x) for entry in flat])

    def partial_fractions(self, x: sp.Symbol) -> list[Stated]:
        """The terms of Σ (1/p(x)ʲ) R_j(x), R_j a matrix polynomial of lower degree than p, see `fractions_of`."""
        return [each.stated for each in fractions_of(self, x)]


@dataclass(frozen=True)
class Resolvent(RationalMatrix):
    """(xI − A)⁻¹: its residues are those that e^{At} and Aᵏ are made of."""

    A: sp.ImmutableMatrix

    @cached_property
    def residues(self) -> tuple[FactorResidues, ...]:
        """The residues at the roots of each factor."""
        return resolvent_residues(self.A)


def fraction_of_term(term: Stated) -> sp.Expr:
    """A term of the partial fractions of one entry as one fraction; its numerator has none, and no minus in front."""
    below, numerator = term.operands
    above, common = sp.fraction(sp.together(numerator[0]))
    above = sp.expand(above)
    sign = -1 if above.is_Add and above.could_extract_minus_sign() else 1
    return sp.Mul(sp.Rational(sign), 1 / common, sp.expand(sign * above), 1 / below.operands[1])


@lru_cache(maxsize=64)
def resolvent_matrix(A: sp.ImmutableMatrix) -> RationalMatrix:
    """(xI − A)⁻¹ (n×n)."""
    fl = faddeev_leverrier(A)
    return Resolvent((A.rows, A.cols), fl.N[::-1], fl.chi[::-1], spectrum(A).factors, A)


def between(left: sp.ImmutableMatrix, A: sp.ImmutableMatrix, right: sp.ImmutableMatrix) -> RationalMatrix:
    """L (xI − A)⁻¹ R over the smallest field that holds L, A and R; raises NotExact if there is none."""
    found = resolvent_matrix(A)
    K = domain_matrix(sp.ImmutableMatrix([[*left.flat(), *A.flat(), *right.flat()]])).domain
    L, R = (domain_matrix(M).convert_to(K) for M in (left, right))
    numerator = tuple(L * N.convert_to(K) * R for N in found.numerator)
    chi = tuple(K.convert(c, found.factors[0].modulus.domain) for c in found.chi)
    factors = tuple(_over(K, factor) for factor in found.factors)
    return RationalMatrix((left.rows, right.cols), numerator, chi, factors)


def _over(K: Any, factor: Factor) -> Factor:
    """The factor with its coefficients in a larger field."""
    p = factor.modulus
    return Factor(Modulus(tuple(K.convert(c, p.domain) for c in p.low), K), factor.multiplicity, factor.roots)


def in_lowest_terms(numerator: Sequence[Any], factors: Sequence[tuple[Modulus, int]], x: sp.Symbol) -> sp.Expr:
    """A fraction, its numerator by coefficients (highest power first), its denominator by irreducible factors."""
    return written_out(*cancelled(numerator, factors), factors[0][0].domain, x)


def written_out(rest: Sequence[Any], left: Sequence[tuple[Modulus, int]], K: Any, x: sp.Symbol) -> sp.Expr:
    """A fraction over K of which that is left."""
    if not rest:
        return sp.Integer(0)
    below = [_written(p, x, -power) for p, power in left]
    if K.is_QQ:
        begins_with_minus = all(c <= 0 for c in rest)
        above = in_powers([-c for c in rest] if begins_with_minus else rest, K, x)
        if below:
            number, power = (sp.S.One, above) if above.is_Add else above.as_coeff_Mul()
            powers = below if power is sp.S.One else [power, *below]
            return product_of_powers(-number if begins_with_minus else number, powers)
    else:
        above = in_powers(rest, K, x)
        begins_with_minus = all(term.could_extract_minus_sign() for term in sp.Add.make_args(above))
        above = sp.expand(-above) if begins_with_minus else above
    whole = sp.Mul(above, *below)
    return -whole if begins_with_minus else whole  # a numerator that begins with a minus has it in front


def cancelled(
    numerator: Sequence[Any], factors: Iterable[tuple[Modulus, int]]
) -> tuple[list[Any], list[tuple[Modulus, int]]]:
    """What is left of a numerator (empty if it is zero), and of the powers of the irreducible factors below it."""
    rest = list(dropwhile(lambda c: not c, numerator))
    below = []
    for p, multiplicity in factors if rest else ():
        left = multiplicity
        while left and len(rest) > p.degree and (quotient_of := _exact_quotient(rest, p.low)) is not None:
            rest, left = quotient_of, left - 1
        if left:
            below.append((p, left))
    return rest, below


def _exact_quotient(numerator: Sequence[Any], low: Sequence[Any]) -> list[Any] | None:
    """The quotient by the monic polynomial of a modulus (highest power first); None if there is a remainder."""
    rest, d = list(numerator), len(low)
    for i in range(len(rest) - d):
        if rest[i]:
            for j, c in enumerate(low):
                rest[i + d - j] -= rest[i] * c
    return None if any(rest[-d:]) else rest[:-d]


@lru_cache(maxsize=256)
def _written(p: Modulus, x: sp.Symbol, power: int) -> sp.Expr:
    """A power of the polynomial of a modulus as an expression."""
    return in_powers([p.domain.one, *reversed(p.low)], p.domain, x) ** power
