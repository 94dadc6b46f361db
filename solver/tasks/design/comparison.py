"""Comparison of coefficients: the linear equations for the unknown entries of a gain, of a feedback or an observer."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from solver.derivation import Claim
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol


@dataclass(frozen=True)
class Comparison:
    """Coefficients M v + c in the unknowns v and the `wanted` values that they are to have, with all solutions."""

    coefficients: Sequence[Expr]
    wanted: Sequence[Expr]
    unknowns: Sequence[Symbol]
    M: ImmutableMatrix
    constant: Sequence[Expr]
    solution: exact.Solution

    @property
    def equations(self) -> list[tuple[Expr, Expr]]:
        """Each coefficient with what it is to be."""
        return list(zip(self.coefficients, self.wanted, strict=True))

    @property
    def free(self) -> list[Symbol]:
        """The unknowns that the equations leave open."""
        return [self.unknowns[j] for j in self.solution.free]

    def claim(self, values: Sequence[Expr]) -> Claim:
        """M v + c has the values wanted."""
        v, c, wanted = (sp.ImmutableMatrix(len(each), 1, list(each)) for each in (values, self.constant, self.wanted))
        return Claim(total(c, product(self.M, v)), wanted, "equations for the gain")


def compared(coefficients: Sequence[Expr], wanted: Sequence[Expr], unknowns: Sequence[Symbol]) -> Comparison:
    """Equate two monic polynomials, given without their leading coefficients, and solve for the unknowns."""
    M, constant = exact.affine(coefficients, unknowns)
    right = [exact.tidy(d - c) for d, c in zip(wanted, constant, strict=True)]
    return Comparison(coefficients, wanted, unknowns, M, constant, exact.solve_affine(M, right, unknowns))
