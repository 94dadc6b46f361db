"""The form M q'' + C q' + g of equations of motion, from their energies."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import sympy as sp

from solver.exact.modelling.collecting import coefficients, in_factors


class Manipulator(NamedTuple):
    """M, C by Christoffel symbols (with the skew matrix of terms of T linear in the velocities), and g."""

    M: sp.ImmutableMatrix
    C: sp.ImmutableMatrix
    g: sp.ImmutableMatrix


def manipulator_form(
    kinetic: sp.Expr, potential: sp.Expr, q: Sequence[sp.Symbol], velocities: Sequence[sp.Symbol]
) -> Manipulator | None:
    """Return M, C and g; None where the kinetic energy is not of degree two in the velocities."""
    found = coefficients(kinetic, velocities)
    if found is None or any(sp.degree(monomial, v) > 2 for monomial, _ in found for v in velocities):
        return None
    if any(sum(monomial.as_powers_dict().get(v, 0) for v in velocities) > 2 for monomial, _ in found):
        return None
    n = len(q)
    rest = dict.fromkeys(velocities, sp.S.Zero)
    M = sp.ImmutableMatrix(n, n, lambda i, j: in_factors(sp.diff(kinetic, velocities[i], velocities[j])))
    linear = [sp.diff(kinetic, v).xreplace(rest) for v in velocities]
    C = sp.ImmutableMatrix(n, n, lambda i, j: in_factors(
        sp.Add(*(christoffel(M, q, i, j, k) * v for k, v in enumerate(velocities)))
        + sp.diff(linear[i], q[j]) - sp.diff(linear[j], q[i])
    ))  # fmt: skip
    effective = potential - kinetic.xreplace(rest)
    return Manipulator(M, C, sp.ImmutableMatrix([slope(effective, each) for each in q]))


def slope(energy: sp.Expr, x: sp.Symbol) -> sp.Expr:
    """Return the derivative of a sum, in each term the number in front: k (x − l), not k (2 x − 2 l)/2."""
    terms = (sp.diff(term, x).as_content_primitive() for term in sp.Add.make_args(energy))
    return sp.Add(*(sp.Mul(number, rest) for number, rest in terms))


def christoffel(M: sp.ImmutableMatrix, q: Sequence[sp.Symbol], i: int, j: int, k: int) -> sp.Expr:
    """Return ½ (∂M_ij/∂q_k + ∂M_ik/∂q_j − ∂M_jk/∂q_i)."""
    total: sp.Expr = sp.diff(M[i, j], q[k]) + sp.diff(M[i, k], q[j]) - sp.diff(M[j, k], q[i])
    return total / 2
