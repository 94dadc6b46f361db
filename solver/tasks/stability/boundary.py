"""What happens at the ends of a range of stability: the eigenvalues that reach the boundary there."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.calculus import value_at
from solver.stated.matrices import determinant
from solver.words import Phrase

if TYPE_CHECKING:
    from solver.systems import StateSpace


@lemma("boundary")
def edges_of(plant: StateSpace, condition: Any) -> Derivation[None]:
    """At each end of the range, the eigenvalues on the imaginary axis (discrete: on the unit circle)."""
    x = sp.Symbol("z" if plant.discrete else "s")
    coefficients = exact.faddeev_leverrier(plant.A).coefficients
    for parameter, bound in exact.edges(condition):
        there = [sp.expand(c.xreplace({parameter: bound})) for c in coefficients]
        roots = exact.boundary_roots(there, discrete=plant.discrete)
        if roots:
            p = exact.polynomial_in(x, there)
            A = plant.A.xreplace({parameter: bound})
            claims = {"polynomial": Claim(determinant(exact.pencil(A, x)), p, "characteristic polynomial there")} | {
                f"root{i}": Claim(value_at(p, x, root), sp.Integer(0), Phrase("a root on the boundary"))
                for i, root in enumerate(roots, 1)
            }
            yield Step(
                "edge", claims=claims, detail="full", parameter=parameter, bound=bound, p=p, x=x, roots=roots,
                frequencies=[root / sp.I for root in roots],
                discrete=plant.discrete,
            )  # fmt: skip
