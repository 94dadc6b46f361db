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
    from sympy import Expr, Symbol

    from solver.systems import StateSpace


@lemma("boundary")
def edges_of(plant: StateSpace, condition: Any, x: Symbol) -> Derivation[None]:
    """At each end of the range, the eigenvalues on the imaginary axis (discrete: on the unit circle)."""
    coefficients = exact.faddeev_leverrier(plant.A).coefficients
    for parameter, bound in exact.edges(condition):
        there = [sp.expand(c.xreplace({parameter: bound})) for c in coefficients]
        roots = exact.boundary_roots(there, discrete=plant.discrete)
        if roots:
            p = exact.polynomial_in(x, there)
            factors = sp.factor(p)
            A = plant.A.xreplace({parameter: bound})
            claims = {
                "polynomial": Claim(determinant(exact.pencil(A, x)), p, "characteristic polynomial there"),
                "factors": Claim(p, factors, "its factors, which show the roots on the boundary"),
            } | {
                f"root{i}": Claim(value_at(p, x, root), sp.Integer(0), Phrase("a root on the boundary"))
                for i, root in enumerate(roots, 1)
            }
            yield Step(
                "edge", claims=claims, detail="full", parameter=parameter, bound=bound, p=p, x=x, roots=roots,
                frequencies=[root / sp.I for root in roots],
                squares=[_square_of_unknown_sign(root) for root in roots],
                discrete=plant.discrete,
            )  # fmt: skip


def _square_of_unknown_sign(root: Expr) -> Expr | None:
    """Return ω² of a pair ±jω that is there only where ω² is positive; None where that is known, or of other roots."""
    square = sp.expand(-(root**2))
    return square if square.free_symbols and exact.sign_of(square) is None else None
