"""Smith's form of a polynomial matrix, with the elementary operations that lead to it."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from typing import Any

import sympy as sp

from solver.exact.multivariable.polynomial_matrices import Rows, in_factors, polynomial_rows
from solver.exact.multivariable.smith_reduction import Reduction, SmithStage, carried_out


@dataclass(frozen=True)
class SmithForm:
    """U M V = diag(e₁, …, e_r, 0, …) with monic e₁ | e₂ | … | e_r; `leads` are elements of K by which was divided."""

    variable: sp.Symbol
    rows: Rows
    invariants: tuple[sp.Poly, ...]
    stages: tuple[SmithStage, ...]
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

    @cached_property
    def longest(self) -> int:
        """How much is to be written for the longest matrix on the way."""
        return max((stage.figures for stage in self.stages), default=0)

    @cached_property
    def left(self) -> sp.ImmutableMatrix:
        """U (p×p), the operations on rows carried out on the identity."""
        return carried_out([each for stage in self.stages for each in stage.operations], "R", self.rows)

    @cached_property
    def right(self) -> sp.ImmutableMatrix:
        """V (m×m), the operations on columns carried out on the identity."""
        return carried_out([each for stage in self.stages for each in stage.operations], "C", self.rows)


def with_zeros(listed: list[sp.Expr], shape: tuple[int, int]) -> tuple[sp.Expr, ...]:
    """The entries of a diagonal, filled up with zeros."""
    return (*listed, *[sp.S.Zero] * (min(shape) - len(listed)))


def diagonal_matrix(diagonal: tuple[sp.Expr, ...], shape: tuple[int, int]) -> sp.ImmutableMatrix:
    """The matrix of any shape with this diagonal."""
    return sp.ImmutableMatrix(*shape, lambda i, j: diagonal[i] if i == j else sp.S.Zero)


@lru_cache(maxsize=64)
def smith_form(M: sp.ImmutableMatrix, x: sp.Symbol) -> SmithForm:
    """Smith's form of a matrix (p×m) of polynomials in x, with the operations that lead to it; raises NotExact.

    Of several ways the one with the least to write is taken.
    """
    rows = polynomial_rows(M, x)
    best: Reduction | None = None
    for order in (("rows", "columns"), ("columns", "rows")):
        for stays in (True, False):
            work = Reduction(rows, order, stays, best.figures if best else None)
            best = work if work.finished else best
    if best is None:
        raise AssertionError("a way without a limit is finished")
    return SmithForm(x, rows, tuple(best.invariants), tuple(best.stages), tuple(best.leads))
