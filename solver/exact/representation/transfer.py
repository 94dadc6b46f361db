"""The transfer matrix G = C (xI − A)⁻¹ B + D: uncancelled, cancelled, its poles and zeros."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.faddeev import faddeev_leverrier
from solver.exact.linear_algebra.fields import NotExact, domain_matrix, expression
from solver.exact.representation.polynomials import (
    eigenvalues_of,
    expanded,
    factored_form,
    factors_of,
    in_lowest_terms,
    invariant_factors,
    least_common_multiple,
)

PolyRows = tuple[tuple[sp.Poly, ...], ...]


@dataclass(frozen=True)
class TransferMatrix:
    """G (p×m) as quotients tops/bottoms of polynomials over K, as they arise: uncancelled, bottoms monic."""

    variable: sp.Symbol
    tops: PolyRows
    bottoms: PolyRows

    @property
    def shape(self) -> tuple[int, int]:
        """Outputs p and inputs m."""
        return len(self.tops), len(self.tops[0])

    @property
    def domain(self) -> Any:
        """The field K."""
        return self.tops[0][0].domain

    @cached_property
    def numerators(self) -> tuple[tuple[sp.Expr, ...], ...]:
        """The numerators, multiplied out."""
        return tuple(tuple(expanded(p) for p in row) for row in self.tops)

    @cached_property
    def denominators(self) -> tuple[tuple[sp.Expr, ...], ...]:
        """The monic denominators, multiplied out."""
        return tuple(tuple(expanded(p) for p in row) for row in self.bottoms)

    @cached_property
    def common_denominator(self) -> sp.Poly:
        """The monic least common multiple of the denominators; of a state-space system χ."""
        return least_common_multiple(p for row in self.bottoms for p in row)

    @property
    def chi(self) -> sp.Expr:
        """The common denominator, multiplied out."""
        return expanded(self.common_denominator)

    @property
    def chi_factored(self) -> sp.Expr:
        """The common denominator as a product of irreducible factors."""
        return factored_form(self.factors)

    @cached_property
    def factors(self) -> list[tuple[sp.Poly, int]]:
        """The irreducible factors of the common denominator."""
        return factors_of(self.common_denominator)

    @cached_property
    def matrix(self) -> sp.ImmutableMatrix:
        """G with every entry in lowest terms, denominators as products of irreducible factors."""
        entries = [
            in_lowest_terms(top, bottom, self.factors)
            for tops, bottoms in zip(self.tops, self.bottoms, strict=True)
            for top, bottom in zip(tops, bottoms, strict=True)
        ]
        return sp.ImmutableMatrix(*self.shape, entries)

    @cached_property
    def direct(self) -> sp.ImmutableMatrix:
        """D = G(∞): the quotients of the leading coefficients where the degrees are equal."""
        rows = zip(self.tops, self.bottoms, strict=True)
        return sp.ImmutableMatrix([[_at_infinity(p, q) for p, q in zip(*row, strict=True)] for row in rows])

    @cached_property
    def remainders(self) -> PolyRows:
        """The numerators of G − D: what is left when D has been divided out."""
        return tuple(
            tuple(_strictly_proper(top, bottom) for top, bottom in zip(*rows, strict=True))
            for rows in zip(self.tops, self.bottoms, strict=True)
        )

    @cached_property
    def strictly_proper_numerators(self) -> tuple[tuple[sp.Expr, ...], ...]:
        """The numerators of G − D, multiplied out."""
        return tuple(tuple(expanded(p) for p in row) for row in self.remainders)

    @property
    def numerator_factored(self) -> sp.Expr:
        """The numerator of the only entry in factors."""
        top = self.tops[0][0]
        if top.is_zero:
            return sp.Integer(0)
        lead = expression(self.domain, top.rep.to_list()[0])
        return lead * factored_form(factors_of(top.monic()))

    @cached_property
    def smith_mcmillan(self) -> list[tuple[sp.Poly, sp.Poly]]:
        """The diagonal ε₁/ψ₁, ε₂/ψ₂, … of the Smith–McMillan form, in lowest terms, monic (shorter: rank of G)."""
        d = self.common_denominator
        over_d = [
            [top * d.quo(bottom) for top, bottom in zip(tops, bottoms, strict=True)]
            for tops, bottoms in zip(self.tops, self.bottoms, strict=True)
        ]
        reduced = []
        for invariant in invariant_factors(over_d):
            shared = invariant.gcd(d)
            reduced.append((invariant.quo(shared).monic(), d.quo(shared).monic()))
        return reduced

    @cached_property
    def pole_polynomial(self) -> sp.Poly:
        """The monic polynomial whose roots are the poles of G, with multiplicity: Π ψᵢ."""
        return _product((psi for _, psi in self.smith_mcmillan), self._one)

    @cached_property
    def zero_polynomial(self) -> sp.Poly:
        """The monic polynomial whose roots are the (transmission) zeros of G, with multiplicity: Π εᵢ."""
        return _product((epsilon for epsilon, _ in self.smith_mcmillan), self._one)

    @cached_property
    def cancelled_polynomial(self) -> sp.Poly:
        """What χ has and the poles have not; one where several inputs and outputs share no realization yet."""
        quotient, rest = self.common_denominator.div(self.pole_polynomial)
        return quotient.monic() if rest.is_zero else self._one

    @property
    def reduced(self) -> TransferMatrix:
        """The only entry without the common factor of its numerator and denominator."""
        c = self.cancelled_polynomial
        return TransferMatrix(self.variable, ((self.tops[0][0].quo(c),),), ((self.bottoms[0][0].quo(c),),))

    @property
    def _one(self) -> sp.Poly:
        return sp.Poly([self.domain.one], self.variable, domain=self.domain)

    @property
    def poles(self) -> list[sp.Expr] | None:
        """The poles with multiplicity; None where their polynomial has no roots in a usable form (parameters)."""
        return roots_if_any(self.pole_polynomial)

    @property
    def zeros(self) -> list[sp.Expr] | None:
        """The zeros with multiplicity; None as for the poles."""
        return roots_if_any(self.zero_polynomial)

    @property
    def cancelled(self) -> list[sp.Expr] | None:
        """The modes of χ that are no poles of G, with multiplicity; None as for the poles."""
        return roots_if_any(self.cancelled_polynomial)

    @property
    def poles_factored(self) -> sp.Expr:
        """The pole polynomial in factors."""
        return factored_form(factors_of(self.pole_polynomial))

    @property
    def zeros_factored(self) -> sp.Expr:
        """The zero polynomial in factors."""
        return factored_form(factors_of(self.zero_polynomial))

    @property
    def cancelled_factored(self) -> sp.Expr:
        """The cancelled polynomial in factors."""
        return factored_form(factors_of(self.cancelled_polynomial))


def roots_if_any(p: sp.Poly) -> list[sp.Expr] | None:
    """The roots of a polynomial with multiplicity; None where they have no usable form."""
    try:
        return eigenvalues_of(p)
    except NotExact:
        return None


def _strictly_proper(top: sp.Poly, bottom: sp.Poly) -> sp.Poly:
    if top.is_zero or top.degree() < bottom.degree():
        return top
    return top - bottom * sp.Poly([top.rep.to_list()[0]], top.gen, domain=top.domain)


def _at_infinity(top: sp.Poly, bottom: sp.Poly) -> sp.Expr:
    same = not top.is_zero and top.degree() == bottom.degree()
    return expanded(sp.Poly([top.rep.to_list()[0]], top.gen, domain=top.domain)) if same else sp.Integer(0)


def _product(polynomials: Any, one: sp.Poly) -> sp.Poly:
    for p in polynomials:
        one = one * p
    return one


@lru_cache(maxsize=64)
def transfer_matrix(
    A: sp.ImmutableMatrix,
    B: sp.ImmutableMatrix,
    C: sp.ImmutableMatrix,
    D: sp.ImmutableMatrix | None,
    variable: sp.Symbol,
) -> TransferMatrix:
    """G = (C adj(xI − A) B + χ D)/χ for A n×n, B n×m, C p×n, D p×m (None: zero); raises NotExact."""
    n, m, p = A.rows, B.cols, C.rows
    through = D if D is not None else sp.zeros(p, m)
    whole = domain_matrix(sp.Matrix(sp.BlockMatrix([[A, B], [C, through]]).as_explicit()))
    K, rows = whole.domain, whole.to_list()
    b = DomainMatrix([row[n:] for row in rows[:n]], (n, m), K)
    c = DomainMatrix([row[:n] for row in rows[n:]], (p, n), K)
    recursion = faddeev_leverrier(A)
    chi = [K.convert(a, recursion.domain) for a in recursion.chi]
    products = [(c * N.convert_to(K) * b).to_list() for N in recursion.N]
    bottom = sp.Poly(chi, variable, domain=K)

    def top(i: int, j: int) -> sp.Poly:
        strictly = sp.Poly([each[i][j] for each in products], variable, domain=K)
        return strictly + bottom * sp.Poly([rows[n + i][n + j]], variable, domain=K)

    tops = tuple(tuple(top(i, j) for j in range(m)) for i in range(p))
    return TransferMatrix(variable, tops, tuple(tuple(bottom for _ in range(m)) for _ in range(p)))


def transfer_matrix_of_fractions(
    numerators: Sequence[Sequence[sp.Expr]], denominators: Sequence[Sequence[sp.Expr]], variable: sp.Symbol
) -> TransferMatrix:
    """G from quotients of polynomials as they were typed (not cancelled); raises NotExact."""
    pairs = list(zip(_flat(numerators), _flat(denominators), strict=True))
    listed = [_coefficients(each, variable) for pair in pairs for each in pair]
    flat = domain_matrix(sp.Matrix([[c for coefficients in listed for c in coefficients]]))
    K, supply = flat.domain, iter(flat.to_list_flat())
    polynomials = [sp.Poly([next(supply) for _ in coefficients], variable, domain=K) for coefficients in listed]
    tops, bottoms = polynomials[::2], polynomials[1::2]
    leads = [K.one / q.rep.LC() for q in bottoms]
    width = len(numerators[0])
    return TransferMatrix(
        variable,
        _rows([p.mul_ground(lead) for p, lead in zip(tops, leads, strict=True)], width),
        _rows([q.mul_ground(lead) for q, lead in zip(bottoms, leads, strict=True)], width),
    )


def _flat(rows: Sequence[Sequence[sp.Expr]]) -> list[sp.Expr]:
    return [entry for row in rows for entry in row]


def _coefficients(p: sp.Expr, x: sp.Symbol) -> list[sp.Expr]:
    """The coefficients, highest power first."""
    found: list[sp.Expr] = sp.Poly(p, x).all_coeffs()
    return found


def _rows(flat: list[sp.Poly], width: int) -> PolyRows:
    return tuple(tuple(flat[i : i + width]) for i in range(0, len(flat), width))
