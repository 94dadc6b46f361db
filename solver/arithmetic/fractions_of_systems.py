"""The transfer function of a small system multiplied out: the adjugate, its product with the input matrix, the rest."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.arithmetic.determinants import worked_out
from solver.arithmetic.exactness import where_exact
from solver.arithmetic.inverses import LARGEST, cofactors
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.stated.matrices import adjugate
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import ImmutableMatrix, Symbol


@where_exact
def fraction_multiplied_out(
    x: Symbol, matrices: tuple[ImmutableMatrix, ImmutableMatrix, ImmutableMatrix, ImmutableMatrix]
) -> tuple[Step, ...]:
    """The numerator of C (xI − F)⁻¹ B + D over det(xI − F); none of a larger system, or of several channels."""
    F, B, C, D = matrices
    small = 1 < F.rows <= LARGEST and D.shape == (1, 1)
    return tuple(_fraction_multiplied_out(x, F, B, C, D)) if small else ()


@lemma("arithmetic/fractions_of_systems")
def _fraction_multiplied_out(
    x: Symbol, F: ImmutableMatrix, B: ImmutableMatrix, C: ImmutableMatrix, D: ImmutableMatrix
) -> Derivation[None]:
    pencil = exact.pencil(F, x)
    resolvent = exact.faddeev_leverrier(F)
    adj, chi = resolvent.adjugate(x), resolvent.characteristic_polynomial(x)
    column = sp.ImmutableMatrix((adj * B).applyfunc(sp.expand))
    through = [product(D, chi)] if D[0] != 0 else []
    numerator = sp.expand((C * column)[0] + D[0] * chi)
    yield from worked_out(rf"\det({x}I - F)", pencil, chi, x)
    yield from cofactors(pencil, adj)
    yield Step(
        "fraction",
        detail="tutor",
        claims={
            "adjugate": Claim(adjugate(pencil), adj, Phrase("the adjugate")),
            "column": Claim(product(adj, B), column, Phrase("times the input matrix")),
            "numerator": Claim(total(product(C, column), *through), numerator, Phrase("the numerator")),
        },
        x=x,
        through=bool(through),
    )
