"""Lemma: the Lyapunov equation, written out entry by entry and solved."""

from __future__ import annotations

from typing import TYPE_CHECKING

from solver.arithmetic.determinants import leading_minors
from solver.arithmetic.equations import eliminated
from solver.arithmetic.exactness import where_exact
from solver.arithmetic.products import multiplied
from solver.arithmetic.row_operations import row_operations
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated import Stated
from solver.stated.algebra import difference, product, total
from solver.stated.matrices import determinant, transpose
from solver.words import Phrase

if TYPE_CHECKING:
    from collections.abc import Sequence

    from sympy import Expr, ImmutableMatrix


FEW = 3
"""Row operations are written out for so many unknowns at most."""

SOME = 6
"""So many unknowns at most are eliminated one after the other."""


@lemma("lyapunov_equation")
def lyapunov_solution_of(
    A: ImmutableMatrix, Q: ImmutableMatrix, *, dual: bool = False, discrete: bool = False
) -> Derivation[ImmutableMatrix | None]:
    """The symmetric P of AᵀP + PA = −Q (dual: AP + PAᵀ; discrete: AᵀPA − P); None where the equation is singular."""
    unknowns = exact.lyapunov_equations(A, Q, dual=dual, discrete=discrete)
    negative = sp.ImmutableMatrix(-Q)
    written = sp.ImmutableMatrix(exact.lyapunov_residual(A, unknowns.P, sp.zeros(A.rows), dual=dual, discrete=discrete))
    P: ImmutableMatrix | None = None
    solvable = True
    try:
        P = exact.lyapunov(A, Q, dual=dual, discrete=discrete)
    except exact.SingularEquation as singular:
        solvable = singular.solvable
    yield Step(
        "equation",
        claims={"left": Claim(left_side(A, unknowns.P, dual=dual, discrete=discrete), written, "the left side")},
        steps=_products(A, unknowns.P, dual=dual, discrete=discrete) if len(unknowns.symbols) <= FEW else (),
        Q=Q,
        P=unknowns.P,
        negative=negative,
        equations=[(written[i, j], negative[i, j]) for i in range(A.rows) for j in range(i, A.rows)],
        dual=dual,
        discrete=discrete,
        solvable=solvable,
    )
    if P is None:
        reason = "the equations have no unique solution; the eigenvalues tell why"
        yield Step("singular", unclaimed=reason, solvable=solvable, discrete=discrete)
        return None
    sides = [(written[i, j], negative[i, j]) for i in range(A.rows) for j in range(i, A.rows)]
    elimination = _elimination(unknowns, sides, P)
    yield Step(
        "solution",
        claims={"solves": Claim(left_side(A, P, dual=dual, discrete=discrete), negative, "the Lyapunov equation")},
        steps=elimination,
        P=P,
        count=len(unknowns.equations),
        reduced=bool(elimination) and len(unknowns.symbols) <= FEW,
        eliminated=bool(elimination) and len(unknowns.symbols) > FEW,
        discrete=discrete,
    )
    return P


@where_exact
def _elimination(unknowns: exact.Unknowns, sides: Sequence[tuple[Expr, Expr]], P: ImmutableMatrix) -> tuple[Step, ...]:
    """The linear equations as an augmented matrix, reduced, where there are few; else one put into the others."""
    if len(unknowns.symbols) > SOME or any(x.free_symbols - set(unknowns.symbols) for x in unknowns.equations):
        return ()
    if len(unknowns.symbols) > FEW:
        values = [P[place] for place in ((i, j) for i in range(P.rows) for j in range(i, P.rows))]
        names = [unknowns.P[place] for place in ((i, j) for i in range(P.rows) for j in range(i, P.rows))]
        return eliminated(sides, names, values)
    coefficients, right = sp.linear_eq_to_matrix(unknowns.equations, unknowns.symbols)
    augmented = sp.ImmutableMatrix(sp.Matrix.hstack(coefficients, right))
    return row_operations(augmented, exact.row_reduction(augmented))


@where_exact
def _products(A: ImmutableMatrix, P: ImmutableMatrix, *, dual: bool, discrete: bool) -> tuple[Step, ...]:
    """The product of the left side; in continuous time the other one is its transpose."""
    left, right = (sp.ImmutableMatrix(M) for M in ((A, A.T) if dual else (A.T, A)))
    LP = sp.ImmutableMatrix((left * P).applyfunc(sp.expand))
    lines = multiplied(left, P, LP, "AP" if dual else "A^{T}P")
    if discrete:
        lines += multiplied(LP, right, sp.ImmutableMatrix((LP * right).applyfunc(sp.expand)))
    return lines


def left_side(A: ImmutableMatrix, P: ImmutableMatrix, *, dual: bool, discrete: bool) -> Stated:
    """AᵀP + PA, AP + PAᵀ, AᵀPA − P or APAᵀ − P, as stated."""
    left, right = (A, transpose(A)) if dual else (transpose(A), A)
    if discrete:
        return difference(product(left, P, right), P)
    return total(product(left, P), product(P, right))


def function_of(P: ImmutableMatrix, Q: ImmutableMatrix) -> dict[str, Claim]:
    """xᵀPx and −xᵀQx in the states; nothing of many."""
    if P.rows > FEW:
        return {}
    x = sp.ImmutableMatrix(sp.symbols(f"x_1:{P.rows + 1}"))
    forms = {"V": P, "rate": sp.ImmutableMatrix(-Q)}
    return {
        name: Claim(product(transpose(x), M, x), sp.expand((x.T * M * x)[0, 0]), Phrase("a quadratic form"))
        for name, M in forms.items()
    }


@lemma("lyapunov_equation")
def is_positive_definite(P: ImmutableMatrix) -> Derivation[bool | None]:
    """Whether all leading principal minors of P are positive; None where their signs depend on parameters."""
    blocks = [sp.ImmutableMatrix(P[:k, :k]) for k in range(1, P.rows + 1)]
    minors = [exact.determinant(block) for block in blocks]
    signs = [exact.sign_of(minor) for minor in minors]
    definite = False if any(sign is not None and sign < 1 for sign in signs) else None if None in signs else True
    claims = {
        f"minor{k}": Claim(determinant(block), minor, Phrase("leading minor {k}", k=k))
        for k, (block, minor) in enumerate(zip(blocks, minors, strict=True), 1)
    }
    lines, signed = leading_minors(blocks, minors), list(zip(minors, signs, strict=True))
    yield Step("minors", claims=claims, steps=lines, minors=signed, definite=definite)
    return definite
