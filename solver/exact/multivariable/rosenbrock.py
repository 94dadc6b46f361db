"""Rosenbrock's matrix of a state-space system: its rank, its invariant zeros, and the modes that are hidden.

Source: H. H. Rosenbrock, State-space and Multivariable Theory (1970), chapter 2; zeros by their kinds as in
A. G. J. MacFarlane and N. Karcanias, Int. J. Control 24 (1976).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import combinations, islice
from math import comb
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.faddeev import faddeev_leverrier
from solver.exact.linear_algebra.fields import domain_matrix, expression
from solver.exact.representation.polynomials import Rows, factored_form, factors_of, invariant_factors

MOST_TRIED = 400
"""Of so many minors the ones are sought whose greatest common divisor is that of all."""


@dataclass(frozen=True)
class SystemMatrix:
    """P(x) = [xI − A, −B; C, D], (n + p)×(n + m), as polynomials over the field of the entries."""

    variable: sp.Symbol
    order: int
    rows: tuple[tuple[sp.Poly, ...], ...]

    @cached_property
    def matrix(self) -> sp.ImmutableMatrix:
        """P as a matrix of expressions."""
        return sp.ImmutableMatrix([[p.as_expr() for p in row] for row in self.rows])

    @cached_property
    def invariants(self) -> list[sp.Poly]:
        """The monic invariant factors of P."""
        return invariant_factors([list(row) for row in self.rows])

    @property
    def rank(self) -> int:
        """The normal rank of P, which is n more than that of G."""
        return len(self.invariants)

    @cached_property
    def zero_polynomial(self) -> sp.Poly:
        """The monic greatest common divisor of the minors of normal rank; its roots are the invariant zeros."""
        found = sp.Poly([self.rows[0][0].domain.one], self.variable, domain=self.rows[0][0].domain)
        for p in self.invariants:
            found = found * p
        return found

    @property
    def square(self) -> bool:
        """Whether P is square and its determinant not zero."""
        return len(self.rows) == len(self.rows[0]) == self.rank

    @cached_property
    def determinant(self) -> sp.Poly:
        """The determinant of P, where it is square and not zero."""
        return polynomial_determinant([list(row) for row in self.rows])

    @cached_property
    def deciding(self) -> tuple[PolynomialMinor, ...]:
        """Minors of normal rank with the greatest common divisor of all; none where few do not suffice, or P is 0."""
        if not self.rank:
            return ()
        wanted, found, divisor = self.zero_polynomial, [], None
        for minor in islice(self._largest(), MOST_TRIED):
            together = minor.value.monic() if divisor is None else divisor.gcd(minor.value).monic()
            if together != divisor:
                found.append(minor)
                divisor = together
            if divisor == wanted:
                return tuple(found)
        return ()

    @property
    def count(self) -> int:
        """How many minors of normal rank there are."""
        return comb(len(self.rows), self.rank) * comb(len(self.rows[0]), self.rank)

    def _largest(self) -> Iterator[PolynomialMinor]:
        """The minors of normal rank that are not zero, those first that keep all of xI − A."""
        for rows in _kept_first(len(self.rows), self.rank, self.order):
            for columns in _kept_first(len(self.rows[0]), self.rank, self.order):
                value = polynomial_determinant([[self.rows[i][j] for j in columns] for i in rows])
                if not value.is_zero:
                    yield PolynomialMinor(rows, columns, value)


@dataclass(frozen=True)
class PolynomialMinor:
    """The determinant of some rows and columns (counted from 0) of a matrix of polynomials."""

    rows: tuple[int, ...]
    columns: tuple[int, ...]
    value: sp.Poly

    @property
    def factored(self) -> sp.Expr:
        """The value as a product of irreducible factors."""
        return in_factors(self.value)


@lru_cache(maxsize=64)
def system_matrix(
    A: sp.ImmutableMatrix, B: sp.ImmutableMatrix, C: sp.ImmutableMatrix, D: sp.ImmutableMatrix, x: sp.Symbol
) -> SystemMatrix:
    """Rosenbrock's matrix of A n×n, B n×m, C p×n, D p×m; raises NotExact."""
    n = A.rows
    whole = domain_matrix(sp.Matrix(sp.BlockMatrix([[A, B], [C, D]]).as_explicit()) if n else sp.Matrix(D))
    K = whole.domain

    def entry(i: int, j: int, a: Any) -> sp.Poly:
        if i >= n:
            return sp.Poly([a], x, domain=K)
        return sp.Poly([K.one, -a] if i == j else [-a], x, domain=K)

    rows = tuple(tuple(entry(i, j, a) for j, a in enumerate(row)) for i, row in enumerate(whole.to_list()))
    return SystemMatrix(x, n, rows)


def common_decoupling_polynomial(
    A: sp.ImmutableMatrix, input_hidden: sp.Expr, output_hidden: sp.Expr, poles: sp.Expr, x: sp.Symbol
) -> sp.Expr:
    """What both decoupling polynomials have of χ: χ p⁻¹ = φᵢ φₒ/φᵢₒ, so φᵢₒ = φᵢ φₒ p/χ."""
    chi = faddeev_leverrier(A)
    whole = sp.Poly(sp.Add(*(expression(chi.domain, c) * x**i for i, c in enumerate(reversed(chi.chi)))), x)
    return sp.factor(sp.cancel(input_hidden * output_hidden * poles / whole.as_expr()))


def in_factors(p: sp.Poly) -> sp.Expr:
    """A polynomial that is not zero as its leading coefficient times irreducible factors."""
    lead = expression(p.domain, p.rep.to_list()[0])
    return lead * factored_form(factors_of(p.monic()))


def _kept_first(size: int, chosen: int, n: int) -> list[tuple[int, ...]]:
    """The choices of `chosen` out of `size`, those first that have 0, …, n − 1 among them."""
    return sorted(combinations(range(size), chosen), key=lambda each: sum(i < n for i in each), reverse=True)


def polynomial_determinant(rows: Rows) -> sp.Poly:
    """The determinant of a square matrix of polynomials, by Bareiss's elimination, whose quotients leave no rest."""
    M, sign = [list(row) for row in rows], 1
    before = M[0][0] ** 0
    while len(M) > 1:
        k = next((i for i, row in enumerate(M) if not row[0].is_zero), None)
        if k is None:
            return M[0][0] * 0
        if k:
            M[0], M[k], sign = M[k], M[0], -sign
        top = M[0]
        M = [[(top[0] * a - row[0] * b).exquo(before) for a, b in zip(row[1:], top[1:], strict=True)] for row in M[1:]]
        before = top[0]
    return M[0][0] * sign
