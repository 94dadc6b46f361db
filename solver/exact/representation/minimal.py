"""On the way to a minimal realization with small numbers: lowest terms, the shorter companion form, parts by poles.

Sources: T. Kailath, Linear Systems (1980), section 6.1 (chains for each input or each output); E. G. Gilbert,
Controllability and observability in multivariable control systems, SIAM J. Control 1 (1963) (residues as products).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.fields import domain_matrix, expression
from solver.exact.linear_algebra.row_reduction import row_reduce
from solver.exact.representation.polynomials import expanded, factored_form, least_common_multiple
from solver.exact.representation.realization import controllable_realization, observable_realization
from solver.exact.representation.transfer import TransferMatrix

Matrix = sp.ImmutableMatrix


def entries_in_lowest_terms(G: TransferMatrix) -> TransferMatrix:
    """The same matrix with each entry cancelled."""
    pairs = [[_in_lowest_terms(p, q) for p, q in zip(*row, strict=True)] for row in zip(G.tops, G.bottoms, strict=True)]
    return TransferMatrix(
        G.variable, tuple(tuple(p for p, _ in row) for row in pairs), tuple(tuple(q for _, q in row) for row in pairs)
    )


def _in_lowest_terms(top: sp.Poly, bottom: sp.Poly) -> tuple[sp.Poly, sp.Poly]:
    common = top.gcd(bottom).monic()
    return top.quo(common), bottom.quo(common)


def companion_orders(G: TransferMatrix) -> tuple[int, int]:
    """The orders of the realizations with a chain for each input, and with a chain for each output."""
    return controllable_realization(G).A.rows, observable_realization(G).A.rows


@dataclass(frozen=True)
class PolePart:
    """The part N/pᵐ of G − D that belongs to the irreducible factor p of the common denominator."""

    factor: sp.Poly
    multiplicity: int
    G: TransferMatrix

    @property
    def polynomial(self) -> sp.Expr:
        """The power pᵐ."""
        return factored_form([(self.factor, self.multiplicity)])

    @property
    def numerators(self) -> sp.ImmutableMatrix:
        """The matrix N of polynomials."""
        rows = zip(self.G.tops, self.G.bottoms, strict=True)
        whole = self.factor**self.multiplicity
        return Matrix([[expanded(p * whole.quo(q)) for p, q in zip(*row, strict=True)] for row in rows])

    @property
    def pole(self) -> sp.Expr | None:
        """The pole, where it is simple and lies in the field of the coefficients."""
        if self.factor.degree() * self.multiplicity != 1:
            return None
        return expression(self.factor.domain, -self.factor.rep.to_list()[1])


def parts_by_poles(G: TransferMatrix) -> list[PolePart]:
    """G − D as the sum of its parts, one for each irreducible factor of the common denominator."""
    d = G.common_denominator
    rows = [
        [top * d.quo(bottom) for top, bottom in zip(*row, strict=True)]
        for row in zip(G.remainders, G.bottoms, strict=True)
    ]
    found = []
    for factor, multiplicity in G.factors:
        own = factor**multiplicity
        weight = d.quo(own).invert(own)
        pairs = [[_in_lowest_terms((p * weight).rem(own), own) for p in row] for row in rows]
        tops, bottoms = (tuple(tuple(pair[i] for pair in row) for row in pairs) for i in (0, 1))
        part = TransferMatrix(G.variable, tops, bottoms)
        power = least_common_multiple(q for row in bottoms for q in row).degree() // factor.degree()
        found.append(PolePart(factor, power, part))
    return found


def rank_factors(R: sp.MatrixBase) -> tuple[sp.ImmutableMatrix, sp.ImmutableMatrix]:
    """R = C B (p×m) with as few columns in C as the rank: pivot columns of R, rows of its echelon form.

    Where a row can have integers without fractions arising in C, it has.
    """
    M = domain_matrix(R)
    found = row_reduce(tuple(map(tuple, M.to_list())))
    columns, rows = [], []
    for pivot, row in zip(found.pivots, found.reduced, strict=False):
        column = [entries[pivot] for entries in M.to_list()]
        q = _common_denominator(row, M.domain)
        if q != 1 and _common_denominator([a / q for a in column], M.domain) != 1:
            q = M.domain.one
        columns += [expression(M.domain, a / q) for a in column]
        rows += [expression(M.domain, a * q) for a in row]
    r = len(found.pivots)
    return Matrix(Matrix(r, R.rows, columns).T), Matrix(r, R.cols, rows)


def _common_denominator(entries: Any, K: Any) -> Any:
    """The least common denominator of rationals; one over other fields, where nothing is moved."""
    return K.convert(int(sp.ilcm(1, *(int(a.denominator) for a in entries)))) if K.is_QQ else K.one
