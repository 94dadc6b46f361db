"""The resolvent (xI − A)⁻¹ and its partial fractions: lemmas for transforms in s and in z."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.stated.algebra import power, quotient, total
from solver.stated.matrices import adjugate, inverse
from solver.stated.transforms import inverse_laplace, inverse_z
from solver.tasks.linear_algebra.characteristic_polynomial import determinant_of

if TYPE_CHECKING:
    from sympy import ImmutableMatrix, Symbol


@lemma("resolvent")
def adjugate_of_pencil(A: ImmutableMatrix, x: Symbol) -> Derivation[ImmutableMatrix]:
    """det(xI − A) and adj(xI − A); returns the adjugate."""
    resolvent = yield from determinant_of(A, x)
    pencil, adj = exact.pencil(A, x), resolvent.adjugate(x)
    yield Step(
        "adjugate",
        claims={"adjugate": Claim(adjugate(pencil), adj, "adjugate of the matrix")},
        x=x,
        n=A.rows,
    )
    return adj


@lemma("resolvent")
def inverse_of_pencil(A: ImmutableMatrix, x: Symbol) -> Derivation[ImmutableMatrix]:
    """(xI − A)⁻¹ = adj(xI − A)/det(xI − A); returns it with cancelled entries."""
    adj = yield from adjugate_of_pencil(A, x)
    pencil, chi = exact.pencil(A, x), exact.factored(A, x)
    inverted = exact.resolvent(A, x)
    yield Step(
        "inverse",
        claims={
            "quotient": Claim(inverse(pencil), quotient(adj, chi), "inverse by the adjugate"),
            "entries": Claim(quotient(adj, chi), inverted, "entries of the inverse"),
        },
        x=x,
        cancels=exact.resolvent_cancels(A),
    )
    return inverted


@lemma("resolvent")
def partial_fractions_of(A: ImmutableMatrix, x: Symbol) -> Derivation[Any]:
    """(xI − A)⁻¹ as a sum of matrices over powers of the irreducible factors of det(xI − A); returns the sum."""
    pencil = exact.pencil(A, x)
    terms = exact.partial_fractions(A, x)
    expansion = total(*terms)
    yield Step(
        "partial_fractions",
        claims={"expansion": Claim(inverse(pencil), expansion, "partial fractions of the inverse")},
        x=x,
        terms=terms,
        exceptions=exact.spectrum(A).exceptions,
        **exact.Denominators.of(exact.resolvent_matrix(A), x).named,
    )
    return expansion


@lemma("resolvent")
def completed_squares_of(image: exact.RationalMatrix, x: Symbol) -> Derivation[None]:
    """Quadratic denominators as (x − σ)² + ω², as the tables have them; no step where all are so already."""
    quadratics = exact.Denominators.of(image, x).quadratics
    shifted = [each for each in quadratics if each[1] != 0]
    if shifted:
        yield Step(
            "completed_squares",
            claims={
                f"square{i}": Claim(p, total(power(x - sigma, 2), omega**2), "completed square")
                for i, (p, sigma, omega) in enumerate(shifted, 1)
            },
            detail="full",
            x=x,
            quadratics=quadratics,
        )


@lemma("resolvent")
def transform_pairs_of(A: ImmutableMatrix, x: Symbol, time: Symbol, *, discrete: bool) -> Derivation[None]:
    """List the transform pairs that the partial fractions need; in discrete time the images carry the factor z."""
    pairs = exact.transform_pairs(A, x, time, discrete=discrete)
    yield from completed_squares_of(exact.resolvent_matrix(A), x)
    invert = inverse_z if discrete else inverse_laplace
    yield Step(
        "pairs",
        claims={
            f"pair{i}": Claim(invert(image, x, time), original, "transform pair")
            for i, (image, original) in enumerate(pairs, 1)
        },
        discrete=discrete,
        undecided=any(root.kind == "symbolic" and root.shift != 0 for root in exact.spectrum(A).roots),
    )
