"""Linear differential equations with constant coefficients as P(D) x = Q(D) u + c, D the derivative, for n unknowns.

The Laplace transform makes it P(s) X = Q(s) U + c/s + I(s), where I holds the values at 0−: D^k x becomes
s^k X − s^{k−1} x(0−) − … − x^{(k−1)}(0−). Inputs are zero before 0, so that D^k u becomes s^k U.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import sympy as sp
from sympy.polys.matrices import DomainMatrix

from solver.exact.linear_algebra.affine import tidy
from solver.exact.linear_algebra.fields import NotExact

Jet = tuple[str, int]


@dataclass(frozen=True)
class Operators:
    """P (n×n) and Q (n×m) with polynomials in s, c (n×1) without s; of `unknowns` and `inputs` in this order."""

    P: sp.ImmutableMatrix
    Q: sp.ImmutableMatrix
    constants: sp.ImmutableMatrix
    unknowns: tuple[str, ...]
    inputs: tuple[str, ...]
    s: sp.Symbol

    @property
    def orders(self) -> dict[str, int]:
        """The order of the highest derivative of each unknown."""
        columns = ((name, self.P.col(j)) for j, name in enumerate(self.unknowns))
        return {name: max(sp.degree(p, self.s) for p in column if p != 0) for name, column in columns}

    def initial_part(self, initial: Mapping[Jet, sp.Expr]) -> sp.ImmutableMatrix:
        """I(s) (n×1); what is not given is zero."""
        rows = []
        for i in range(self.P.rows):
            total = sp.S.Zero
            for j, name in enumerate(self.unknowns):
                for (k,), c in sp.Poly(self.P[i, j], self.s).terms():
                    values = (self.s ** (k - 1 - m) * initial.get((name, m), sp.S.Zero) for m in range(k))
                    total += c * sp.Add(*values)
            rows.append(in_powers_of(total, self.s))
        return sp.ImmutableMatrix(rows)

    def right_side(self, images: Sequence[sp.Expr], initial: Mapping[Jet, sp.Expr]) -> sp.ImmutableMatrix:
        """Q U + c/s + I (n×1)."""
        U = sp.Matrix(list(images)) if images else sp.zeros(0, 1)
        forced = self.Q * U if images else sp.zeros(self.P.rows, 1)
        return sp.ImmutableMatrix(forced + self.constants / self.s + self.initial_part(initial))


def in_powers_of(polynomial: sp.Expr, s: sp.Symbol) -> sp.Expr:
    """A polynomial by falling powers of s, its coefficients tidy."""
    if polynomial == 0:
        return sp.S.Zero
    return sp.Add(*(tidy(c) * s**k for (k,), c in sp.Poly(sp.expand(polynomial), s).terms()))


def operators_of(
    equations: Sequence[sp.Expr],
    jets: Mapping[sp.Symbol, Jet],
    unknowns: Sequence[str],
    inputs: Sequence[str],
    s: sp.Symbol,
) -> Operators:
    """The operators of expressions that are zero, linear in `jets`; each row has the sign that the equation gives."""
    P = sp.zeros(len(equations), len(unknowns))
    Q = sp.zeros(len(equations), len(inputs))
    constants = sp.zeros(len(equations), 1)
    for i, equation in enumerate(equations):
        rest = sp.expand(equation)
        for symbol, (name, k) in jets.items():
            c: Any = sp.diff(rest, symbol)
            rest = sp.expand(rest - c * symbol)
            if c.has(*jets):
                raise NotExact("differential_equation/not_linear", equation=equation)
            if name in inputs:
                Q[i, list(inputs).index(name)] -= tidy(c) * s**k
            elif c != 0:
                P[i, list(unknowns).index(name)] += tidy(c) * s**k
        constants[i] = -rest
    left, right, rest = (sp.ImmutableMatrix(M) for M in (P, Q, constants))
    found = Operators(left, right, rest, tuple(unknowns), tuple(inputs), s)
    if adjugate_and_determinant(found)[1] == 0:
        raise NotExact("differential_equation/singular")
    return found


def images_of_unknowns(operators: Operators, right: sp.ImmutableMatrix) -> tuple[sp.Expr, tuple[sp.Expr, ...]]:
    """det P, and the numerators det Pⱼ of Cramer's rule, Pⱼ with the right side in column j: Xⱼ = det Pⱼ/det P.

    Expanded along that column, det Pⱼ is the sum of the right sides times the cofactors of P.
    """
    adjugate, whole = adjugate_and_determinant(operators)
    parts = tuple(
        sp.Add(*(c * r for c, r in zip(adjugate.row(j).flat(), right.flat(), strict=True) if c != 0 and r != 0))
        for j in range(adjugate.rows)
    )
    return whole, parts


@lru_cache(maxsize=16)
def adjugate_and_determinant(operators: Operators) -> tuple[sp.ImmutableMatrix, sp.Expr]:
    """adj P (n×n) and det P, multiplied out in powers of s."""
    found, whole = DomainMatrix.from_Matrix(operators.P.as_mutable(), extension=True).adj_det()
    adjugate = found.to_Matrix().applyfunc(lambda entry: in_powers_of(entry, operators.s))
    return sp.ImmutableMatrix(adjugate), in_powers_of(found.domain.to_sympy(whole), operators.s)
