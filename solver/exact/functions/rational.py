"""Matrices of rational functions N(x)/χ(x) over a field: lowest terms, residues, partial fractions.

(xI − A)⁻¹ is one, and so is L (xI − A)⁻¹ R, the transform of a response. All results come from the irreducible factors
of χ; those that cancel show as residues that are zero.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import dropwhile
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.functions.closed_forms import MatrixFunction, closed_form
from solver.exact.functions.residues import (
    FactorResidues,
    MatrixPolynomial,
    Residue,
    divided_by,
    multiply_by,
    reduce_modulo,
    residues_at,
)
from solver.exact.linear_algebra.assembly import product_of_powers
from solver.exact.linear_algebra.biquadratic import tidied
from solver.exact.linear_algebra.faddeev import faddeev_leverrier
from solver.exact.linear_algebra.fields import (
    Algebraic,
    Modulus,
    common_factors_below,
    domain_matrix,
    expressions,
    in_powers,
    matrix_of,
)
from solver.exact.linear_algebra.instances import value_at
from solver.exact.linear_algebra.radicals import complex_parts
from solver.exact.linear_algebra.spectrum import Factor, Root, is_lower, spectrum
from solver.stated import Stated
from solver.stated.algebra import product, quotient


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

    @property
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
        """The terms of Σ (1/p(x)ʲ) R_j(x), R_j a matrix polynomial of lower degree than p.

        Factors with real roots are split into (x − λ)ʲ; a conjugate pair (or one whose nature is undecided) keeps its
        quadratic denominator.
        """
        terms: list[Stated] = []
        for each in self.residues:
            if keeps_quadratic(each.factor):
                terms += self._quadratic_terms(each.factor, x)
            else:
                terms += _linear_terms(each, self.shape, x)
        return [term for term in terms if any(term.operands[1])]

    def _quadratic_terms(self, factor: Factor, x: sp.Symbol) -> Iterator[Stated]:
        """The p-adic digits of N·(χ/pᵐ)⁻¹ mod pᵐ, the highest power of p first."""
        p = factor.polynomial(x)
        for k, (constant, linear) in enumerate(self._digits(factor)):
            numerator = matrix_of(linear) * x + matrix_of(constant)
            yield product(quotient(sp.Integer(1), p ** (factor.multiplicity - k)), sp.ImmutableMatrix(numerator))

    def _digits(self, factor: Factor) -> list[Residue]:
        """R_m, …, R_1 of one factor, as coefficients of 1, x, …."""
        p, m = factor.modulus, factor.multiplicity
        K = p.domain
        X = sp.Dummy("x")
        whole = sp.Poly([K.one, *reversed(p.low)], X, domain=K) ** m
        P = Modulus(tuple(reversed(whole.rep.to_list()[1:])), K)
        others = sp.Poly(list(reversed(self.chi)), X, domain=K).quo(whole)
        inverse = Algebraic(P.reduce([*reversed(others.rep.to_list())]), P).inverse()
        rest = multiply_by(reduce_modulo(list(self.numerator), P), inverse)
        digits = []
        for _ in range(m):
            rest, digit = divided_by(rest, p)
            digits.append(digit)
        return digits


@lru_cache(maxsize=64)
def resolvent_matrix(A: sp.ImmutableMatrix) -> RationalMatrix:
    """(xI − A)⁻¹ (n×n)."""
    fl = faddeev_leverrier(A)
    return RationalMatrix((A.rows, A.cols), fl.N[::-1], fl.chi[::-1], spectrum(A).factors)


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
    rest, left = cancelled(numerator, factors)
    if not rest:
        return sp.Integer(0)
    K = factors[0][0].domain
    below = [_written(p, x, -power) for p, power in left]
    if K.is_QQ:
        begins_with_minus = all(c <= 0 for c in rest)
        above = in_powers([-c for c in rest] if begins_with_minus else rest, K, x)
        if below and above.is_Number:
            return product_of_powers(-above if begins_with_minus else above, below)
        if below and above.is_Add:
            return product_of_powers(sp.Integer(-1 if begins_with_minus else 1), [above, *below])
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


def keeps_quadratic(factor: Factor) -> bool:
    """Whether the partial fractions keep the factor as a quadratic: a conjugate pair, or one that may be."""
    return factor.degree == 2 and factor.roots[0].kind != "surd"


def highest_power(each: FactorResidues) -> int:
    """The highest power of the factor with a residue that is not zero; 0 if the factor cancels."""
    occurring = [j for j, Z in enumerate(each.residues, 1) if any(any(M.to_list_flat()) for M in Z)]
    return max(occurring, default=0)


def _linear_terms(each: FactorResidues, shape: tuple[int, int], x: sp.Symbol) -> Iterator[Stated]:
    """Z_j/(x − λ)ʲ for each root; a simple pair is put over its real quadratic."""
    for root in each.factor.roots:
        for j, Z in enumerate(each.residues, 1):
            matrix = residue_at(Z, root, shape)
            if not is_simple_pair(root):
                yield product(quotient(sp.Integer(1), (x - root.value) ** j), matrix)
            elif not is_lower(root):
                parts = [complex_parts(entry) for entry in matrix.flat()]
                numerator = [2 * X * x - 2 * (root.sigma * X + root.shift * Y) for X, Y in parts]
                if root.kind == "complex":
                    numerator = [linear_in(x, entry) for entry in numerator]
                yield product(quotient(sp.Integer(1), real_quadratic(root, x)), sp.ImmutableMatrix(*shape, numerator))


def linear_in(x: sp.Symbol, entry: sp.Expr) -> sp.Expr:
    """The expression a x + b with a and b in the form shown."""
    expanded = sp.expand(entry)
    return tidied(expanded.coeff(x, 1)) * x + tidied(expanded.coeff(x, 0))


def residue_at(Z: Residue, root: Root, shape: tuple[int, int]) -> sp.ImmutableMatrix:
    """A matrix over L at one root of its factor."""
    parts = [expressions(M) for M in Z]
    entries = parts[0] if len(parts) == 1 else [value_at(list(c), root) for c in zip(*parts, strict=True)]
    return sp.ImmutableMatrix(*shape, [common_factors_below(entry) for entry in entries])


def is_simple_pair(root: Root) -> bool:
    """Whether the root, of a factor that is no such quadratic itself, is one of a simple conjugate pair."""
    return root.kind in ("complex", "decimal") and root.shift != 0 and root.multiplicity == 1


def real_quadratic(root: Root, x: sp.Symbol) -> sp.Expr:
    """The real quadratic of a pair."""
    constant = root.sigma**2 + root.shift**2
    return x**2 - 2 * root.sigma * x + (constant if root.kind == "decimal" else tidied(constant))
