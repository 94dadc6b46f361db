"""Lemma: the first conjugate point of several functions whose second variation couples them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.derivation import Claim, Derivation, Step, lemma
from solver.jets import jet_symbol
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.calculus import value_at
from solver.stated.matrices import determinant
from solver.tasks.variations.conjugate_points import LETTER, FirstConjugate, jets_along, name_of_variation
from solver.tasks.variations.ordinary_equations import solved, way_of

if TYPE_CHECKING:
    from solver.systems import Functional
    from solver.tasks.variations.found_extremal import Extremal


@lemma("coupled_points")
def coupled_point_of(system: Functional, found: Extremal) -> Derivation[FirstConjugate]:
    """Jacobi's equations together; U of the solutions that begin with zero; the first zero of det U."""
    t, at = system.t, system.start
    letter = name_of_variation(system)
    names = [f"{letter}{i}" for i in range(1, len(system.functions) + 1)]
    u = [[jet_symbol((name, k)) for k in range(3)] for name in names]
    functions, rates = ([system.symbol((name, k)) for name in system.functions] for k in (0, 1))
    of = exact.coupled_variations(system.integrand, functions, rates, jets_along(system, found), t)
    equations = exact.jacobi_equations(of, u, t)
    yield Step("jacobi_system", unclaimed="the coefficients of the second variation", P=of.P, Q=of.Q, R=of.R,
               equations=equations, names=[each[0] for each in u])  # fmt: skip
    if not way_of(equations, names, t):
        return FirstConjugate(None, reason="jacobi")
    (family,) = yield from solved(equations, names, t, letter=LETTER)
    U = exact.from_zero([family.functions[name] for name in names], family.constants, t, at)
    if U is None:
        return FirstConjugate(None, reason="jacobi")
    det = exact.in_time(sp.expand(U.det()), t)
    claims = {
        "start": Claim(value_at(U, t, at), sp.ImmutableMatrix(sp.zeros(*U.shape)), "$U$ at the start"),
        "determinant": Claim(determinant(U), det, "the determinant"),
    }
    yield Step("columns", claims=claims, U=U, det=det, start=at)
    zero = exact.first_singular(det, t, at, found.t_f)
    if zero is None:
        return FirstConjugate(None, reason="zero")
    yield Step(
        "singular", unclaimed="where the determinant vanishes", point=zero.point, searched=zero.searched, start=at
    )
    return FirstConjugate(zero.point)
