"""Jacobi's equations of several functions, d/dt (R u' + Qᵀu) = Q u' + P u, and the first zero of det U."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.affine import solve_affine
from solver.exact.variations.along import in_time
from solver.exact.variations.second_variation import Conjugate, conjugate, first_zero_from, in_motion


@dataclass(frozen=True)
class CoupledVariations:
    """The matrices φ_xx, φ_xx' and φ_x'x' along an extremal."""

    P: sp.ImmutableMatrix
    Q: sp.ImmutableMatrix
    R: sp.ImmutableMatrix


def coupled_variations(
    phi: sp.Expr,
    functions: Sequence[sp.Symbol],
    rates: Sequence[sp.Symbol],
    jets: Mapping[sp.Symbol, sp.Expr],
    t: sp.Symbol,
) -> CoupledVariations:
    """φ's second derivatives with the extremal put in."""
    n = len(functions)

    def second(rows: Sequence[sp.Symbol], columns: Sequence[sp.Symbol]) -> sp.ImmutableMatrix:
        return sp.ImmutableMatrix(n, n, lambda i, j: in_motion(sp.diff(phi, rows[i], columns[j]), jets, t))

    return CoupledVariations(second(functions, functions), second(functions, rates), second(rates, rates))


def jacobi_equations(of: CoupledVariations, u: Sequence[Sequence[sp.Symbol]], t: sp.Symbol) -> list[sp.Expr]:
    """What is zero, in the symbols uᵢ, uᵢ', uᵢ''."""
    found = []
    for i in range(len(u)):
        terms: list[sp.Expr] = []
        for j, (value, rate, second) in enumerate(each[:3] for each in u):
            terms += [of.R[i, j] * second, (sp.diff(of.R[i, j], t) + of.Q[j, i] - of.Q[i, j]) * rate,
                      (sp.diff(of.Q[j, i], t) - of.P[i, j]) * value]  # fmt: skip
        found.append(sp.expand(sp.Add(*terms)))
    return found


def from_zero(
    general: Sequence[sp.Expr], constants: Sequence[sp.Symbol], t: sp.Symbol, start: sp.Expr
) -> sp.ImmutableMatrix | None:
    """U with U = 0 and U' = I at the start, from a general solution; None if there is none."""
    n = len(general)
    sides = [f.subs(t, start) for f in general] + [sp.diff(f, t).subs(t, start) for f in general]
    if any(side.has(sp.nan, sp.zoo, sp.oo) for side in sides) or len(constants) != 2 * n:
        return None
    M = sp.ImmutableMatrix([[sp.diff(side, c) for c in constants] for side in sides])
    columns = []
    for k in range(n):
        solved = solve_affine(M, [sp.Integer(int(row == n + k)) for row in range(2 * n)], constants)
        if solved.free or solved.residue:
            return None
        values: dict[Any, Any] = dict(zip(constants, solved.values, strict=True))
        columns.append([in_time(f.subs(values), t) for f in general])
    return sp.ImmutableMatrix(n, n, lambda i, j: columns[j][i])


def first_singular(det: sp.Expr, t: sp.Symbol, start: sp.Expr, stop: sp.Expr) -> Conjugate | None:
    """The first zero of det U after the start, factor by factor; None where it is not located."""
    points, searched = [], None
    for factor in sp.Mul.make_args(det if det.is_Mul else sp.factor(det)):
        base = factor.as_base_exp()[0]
        if isinstance(factor, sp.exp) or not base.has(t):
            continue
        there = base.subs(t, start)
        vanishes = sp.expand(there) == 0
        found = conjugate(base, t, start, stop) if vanishes else first_zero_from(base / there, t, start, stop)
        if found is None:
            return None
        searched = found.searched if searched is None else searched
        points += [] if found.point is None else [found.point]
    if len(points) > 1 and any(point.free_symbols for point in points):
        return None
    return Conjugate(min(points, key=sp.N, default=None), searched)
