"""Smith's form of a polynomial matrix, with the elementary operations that lead to it."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from typing import Any

import sympy as sp

from solver.exact.multivariable.polynomial_matrices import (
    Rows,
    divisors_of,
    in_factors,
    polynomial_rows,
)
from solver.exact.multivariable.smith_reduction import Reduction, SmithStage, carried_out


@dataclass(frozen=True)
class SmithForm:
    """U M V = diag(e₁, …, e_r, 0, …) with monic e₁ | e₂ | … | e_r.

    `stages` are the operations that lead to it, None where it was found by minors; `leads` are the elements of K by
    which was divided.
    """

    variable: sp.Symbol
    rows: Rows
    invariants: tuple[sp.Poly, ...]
    stages: tuple[SmithStage, ...] | None
    leads: tuple[Any, ...] = field(repr=False)

    @property
    def shape(self) -> tuple[int, int]:
        """Rows p and columns m."""
        return len(self.rows), len(self.rows[0])

    @property
    def rank(self) -> int:
        """The normal rank r."""
        return len(self.invariants)

    @cached_property
    def invariant_factors(self) -> tuple[sp.Expr, ...]:
        """The min(p, m) invariant factors as products of irreducible ones, zeros where the rank falls short."""
        return with_zeros([in_factors(e) for e in self.invariants], self.shape)

    @property
    def form(self) -> sp.ImmutableMatrix:
        """The diagonal matrix (p×m)."""
        return diagonal_matrix(self.invariant_factors, self.shape)

    @property
    def is_long(self) -> bool:
        """Whether matrices on the way grow long, so that the minors are the shorter one."""
        return self.stages is None or any(stage.figures > LONG for stage in self.stages)

    @property
    def is_general(self) -> bool:
        """Whether there are parameters and it is not known for which of their values the form is another."""
        return self.stages is None and bool(self.rows[0][0].domain.is_Composite)

    @cached_property
    def left(self) -> sp.ImmutableMatrix | None:
        """U (p×p), the operations on rows carried out on the identity."""
        return self._carried_out("R")

    @cached_property
    def right(self) -> sp.ImmutableMatrix | None:
        """V (m×m), the operations on columns carried out on the identity."""
        return self._carried_out("C")

    def _carried_out(self, line: str) -> sp.ImmutableMatrix | None:
        if self.stages is None:
            return None
        return carried_out([each for stage in self.stages for each in stage.operations], line, self.rows)


def with_zeros(listed: list[sp.Expr], shape: tuple[int, int]) -> tuple[sp.Expr, ...]:
    """The entries of a diagonal, filled up with zeros."""
    return (*listed, *[sp.S.Zero] * (min(shape) - len(listed)))


def diagonal_matrix(diagonal: tuple[sp.Expr, ...], shape: tuple[int, int]) -> sp.ImmutableMatrix:
    """The matrix of any shape with this diagonal."""
    return sp.ImmutableMatrix(*shape, lambda i, j: diagonal[i] if i == j else sp.S.Zero)


LONG = 160
"""Beyond so many figures in a matrix on the way the form is found by minors."""


MOST, LEAST, FEW = 600, 60, 8
"""Beyond so many, with a few parameters and with more, it is given up to find where the form is another."""


@lru_cache(maxsize=64)
def smith_form(M: sp.ImmutableMatrix, x: sp.Symbol) -> SmithForm:
    """Smith's form of a matrix (p×m) of polynomials in x, with the operations that lead to it; raises NotExact."""
    return smith_form_of(polynomial_rows(M, x), x)


def smith_form_of(rows: Rows, x: sp.Symbol) -> SmithForm:
    """Smith's form of rows of polynomials in x over one field.

    Of several ways the one with the least to write is taken. A way is not gone to its end where matrices on it grow
    long; with parameters they may be longer, since it tells where the form is another.
    """
    K = rows[0][0].domain
    parameters = len(K.symbols) if K.is_Composite else 0
    bound = LONG if not parameters else MOST if parameters <= FEW else LEAST
    best: Reduction | None = None
    for stays in (True, False) if parameters or not _is_hopeless(rows) else ():
        for order in (("rows", "columns"), ("columns", "rows")):
            work = Reduction(rows, order, stays, best.figures if best else None, bound)
            best = work if work.finished else best
        if best is None:
            break
    if best is not None:
        return SmithForm(x, rows, tuple(best.invariants), tuple(best.stages), tuple(best.leads))
    before, found = rows[0][0].one, []
    for divisor in divisors_of(rows):
        found.append(divisor.quo(before))
        before = divisor
    return SmithForm(x, rows, tuple(found), None, ())


def _is_hopeless(rows: Rows) -> bool:
    """Whether Euclid's algorithm would be long: three rows and columns of polynomials of degree three and more."""
    filled = [p for row in rows for p in row if not p.is_zero]
    return min(len(rows), len(rows[0])) > 2 and bool(filled) and all(p.degree() > 2 for p in filled)
