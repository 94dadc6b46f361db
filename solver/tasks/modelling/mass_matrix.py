"""Substep: equations that hold several of the highest derivatives, as M q'' = r, and how these are found."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, quotient
from solver.stated.matrices import determinant, inverse

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

LARGEST = 4
"""More equations are solved without being shown as matrices."""


def mass_matrix(
    differences: Sequence[Expr], wanted: Sequence[Symbol], found: Mapping[Symbol, Expr]
) -> tuple[Step, ...]:
    """Return how expressions that are zero are solved for symbols; nothing where each holds one of them only."""
    M, r = exact.coefficients_of(differences, wanted)
    coupled = any(sum(entry != 0 for entry in M.row(i)) > 1 for i in range(M.rows))
    if not coupled or len(wanted) > LARGEST:
        return ()
    return tuple(_shown(differences, M, r, list(wanted), found))


@lemma("mass_matrix")
def _shown(
    differences: Sequence[Expr],
    M: ImmutableMatrix,
    r: ImmutableMatrix,
    wanted: list[Symbol],
    found: Mapping[Symbol, Expr],
) -> Derivation[None]:
    unknown, values = sp.ImmutableMatrix(wanted), sp.ImmutableMatrix([found[each] for each in wanted])
    collected = difference(product(M, unknown), r)
    claims = {"collected": Claim(collected, sp.ImmutableMatrix(list(differences)), "the terms collected")}
    pairs, det = [], None
    if len(wanted) == 2:
        (a, b), (c, d) = M.tolist()
        det = exact.normal(a * d - b * c)
        claims["determinant"] = Claim(difference(product(a, d), product(b, c)), det, "the factor of both unknowns")
        for number, symbol, first, second, sides in (
            (0, wanted[0], d, b, (r[0], r[1])),
            (1, wanted[1], a, c, (r[1], r[0])),
        ):
            combined = difference(product(first, sides[0]), product(second, sides[1]))
            claims[f"combined{number}"] = Claim(quotient(combined, det), found[symbol], "one unknown left")
            pairs.append((symbol, combined, found[symbol]))
    else:
        det = exact.normal(exact.determinant(M)) if len(wanted) < LARGEST else None
        if det is not None:
            claims["determinant"] = Claim(determinant(M), det, "the determinant")
        claims["solved"] = Claim(product(inverse(M), r), values, "the inverse")
    yield Step("mass_matrix", detail="tutor", claims=claims, M=M, r=r, unknown=unknown, det=det, pairs=pairs)
