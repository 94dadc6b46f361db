"""The steps with which a Riccati equation begins: its entries written out, and the spectrum behind its solutions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Step
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product
from solver.stated.matrices import determinant
from solver.tasks.design.regulator import Regulator
from solver.tasks.design.regulator_products import products_of_the_equation
from solver.tasks.design.riccati import hamiltonian_step
from solver.tasks.design.symplectic import pencil_step

if TYPE_CHECKING:
    from sympy import ImmutableMatrix


def entries_of(problem: Regulator, P: ImmutableMatrix) -> tuple[dict[str, Any], ImmutableMatrix]:
    """The facts of a step that puts unknown entries into the equation, and its left side multiplied out.

    In discrete time it is multiplied by det(R + BᵀPB), so that its entries are polynomials.
    """
    stated = difference(problem.linear_part(P), problem.quadratic_part(P))
    if not problem.discrete:
        left = exact.riccati_entries(problem.A, exact.weighted_input(problem.B, problem.R), problem.Q, P)
        claims = {"entries": Claim(stated, left, "the Riccati equation entry by entry")}
        lines = products_of_the_equation(problem, P)
        return {"claims": claims, "P": P, "steps": lines, **problem.names}, left
    by, left = exact.discrete_riccati_entries(problem.A, problem.B, problem.Q, problem.R, P)
    weight = exact.riccati_weight(problem.B, problem.R, P)
    seen = sp.ImmutableMatrix((problem.Bt * P * problem.A).expand())
    claims = {
        "weight": Claim(problem.weight_of(P), weight, "the weight of the input"),
        "seen": Claim(product(problem.Bt, P, problem.A), seen, "what the input acts on"),
        "by": Claim(determinant(weight), by, "its determinant"),
        "entries": Claim(product(by, difference(stated, P)), left, "the Riccati equation entry by entry"),
    }
    lines = products_of_the_equation(problem, P)
    several = weight.rows > 1
    return {"claims": claims, "P": P, "by": by, "several": several, "steps": lines, **problem.names}, left


def spectrum_step(problem: Regulator, equation: exact.Riccati) -> Step:
    """The Hamiltonian matrix, or in discrete time the pencil, and its polynomial."""
    if isinstance(equation, exact.DiscreteRiccati):
        return pencil_step(problem, equation)
    return hamiltonian_step(problem, equation)
