"""The Smith–McMillan form of a matrix of rational functions: Smith's form over the common denominator, cancelled."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import sympy as sp

from solver.exact.multivariable.generic import changed_where, common_roots_where
from solver.exact.multivariable.polynomial_matrices import in_factors, matrix_of_rows
from solver.exact.multivariable.smith import SmithForm, diagonal_matrix, smith_form_of, with_zeros
from solver.exact.representation.polynomials import least_common_multiple, signed_fraction
from solver.exact.representation.transfer import TransferMatrix


@dataclass(frozen=True)
class SmithMcMillan:
    """G = N/d with N = U⁻¹ S V⁻¹, and eᵢ/d = εᵢ/ψᵢ in lowest terms, all monic; `fractions` are (εᵢ, ψᵢ), i ≤ rank."""

    G: TransferMatrix
    denominator: sp.Poly
    smith: SmithForm
    fractions: tuple[tuple[sp.Poly, sp.Poly], ...]

    @cached_property
    def numerator(self) -> sp.ImmutableMatrix:
        """N (p×m); in factors where its form is found by minors."""
        rows = self.smith.rows
        if not self.smith.is_long:
            return matrix_of_rows(rows)
        return sp.ImmutableMatrix([[in_factors(p) for p in row] for row in rows])

    @property
    def variable(self) -> sp.Symbol:
        """The symbol s or z."""
        return self.G.variable

    @property
    def shape(self) -> tuple[int, int]:
        """Outputs p and inputs m."""
        return self.G.shape

    @property
    def rank(self) -> int:
        """The normal rank r."""
        return len(self.fractions)

    @cached_property
    def diagonal(self) -> tuple[sp.Expr, ...]:
        """The min(p, m) entries εᵢ/ψᵢ, in factors; zeros where the rank falls short."""
        return with_zeros([written(*each) for each in self.fractions], self.shape)

    @property
    def form(self) -> sp.ImmutableMatrix:
        """The diagonal matrix (p×m)."""
        return diagonal_matrix(self.diagonal, self.shape)

    @cached_property
    def pole_polynomial(self) -> sp.Poly:
        """Π ψᵢ, monic: its roots are the poles, as often as they count."""
        return self._product(1)

    @cached_property
    def zero_polynomial(self) -> sp.Poly:
        """Π εᵢ, monic: its roots are the transmission zeros, as often as they count."""
        return self._product(0)

    def _product(self, part: int) -> sp.Poly:
        found = self.denominator.one
        for each in self.fractions:
            found = found * each[part]
        return found

    @cached_property
    def exceptions(self) -> tuple[sp.Expr, ...]:
        """Expressions in the parameters; where one of them is zero the form may be another."""
        common = [factor for each in self.fractions for factor in common_roots_where(*each)]
        return tuple(dict.fromkeys([*changed_where(self.smith), *common]))


def written(above: sp.Poly, below: sp.Poly) -> sp.Expr:
    """The fraction of two monic polynomials in factors."""
    return signed_fraction(in_factors(above), in_factors(below))


@lru_cache(maxsize=64)
def smith_mcmillan(G: TransferMatrix) -> SmithMcMillan:
    """The Smith–McMillan form of G (p×m), over the least common denominator of its entries; raises NotExact."""
    pairs = [
        [_cancelled(top, bottom) for top, bottom in zip(tops, bottoms, strict=True)]
        for tops, bottoms in zip(G.tops, G.bottoms, strict=True)
    ]
    d = least_common_multiple(bottom for row in pairs for _, bottom in row)
    rows = tuple(tuple(top * d.quo(bottom) for top, bottom in row) for row in pairs)
    smith = smith_form_of(rows, G.variable)
    return SmithMcMillan(G, d, smith, tuple(_cancelled(e, d) for e in smith.invariants))


def _cancelled(above: sp.Poly, below: sp.Poly) -> tuple[sp.Poly, sp.Poly]:
    """The fraction in lowest terms, the polynomial below monic."""
    if above.is_zero:
        return above, below.one
    shared = above.gcd(below)
    if shared.degree() > 0:
        above, below = above.quo(shared), below.quo(shared)
    if below.rep.LC() == below.domain.one:
        return above, below
    lead = below.domain.one / below.rep.LC()
    return above.mul_ground(lead), below.mul_ground(lead)
