"""Sums of multiples of powers of a matrix, entry by entry, and products of several matrices, one after the other."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from solver.arithmetic.exactness import where_exact
from solver.arithmetic.products import multiplied, powers_of
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import power, product, total
from solver.stated.matrices import matrix_of

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol

    from solver.stated import Stated

SMALL = 4
"""In a matrix with more entries the values of the coefficients would fill the page."""


@where_exact
def combined(
    A: ImmutableMatrix, names: Sequence[Symbol], coefficients: Sequence[Expr], value: ImmutableMatrix
) -> tuple[Step, ...]:
    """Σ cᵢ Aⁱ = value, i = 0, 1, …: the powers of A, the entries in terms of the names of the cᵢ, the cᵢ put in."""
    return tuple(_combined(A, names, coefficients, value)) if A.rows > 1 else ()


@where_exact
def multiplied_out(factors: Sequence[ImmutableMatrix], value: ImmutableMatrix) -> tuple[Step, ...]:
    """F G … = value, from the left."""
    first, *others = factors
    steps: list[Step] = []
    for i, each in enumerate(others, 1):
        last = i == len(others)
        found = value if last else sp.ImmutableMatrix(first * each)
        if last or not each.is_diagonal():  # a diagonal matrix only multiplies the columns
            steps += multiplied(first, each, found)
        first = found
    return tuple(steps)


@lemma("arithmetic/combinations")
def _combined(
    A: ImmutableMatrix, names: Sequence[Symbol], coefficients: Sequence[Expr], value: ImmutableMatrix
) -> Derivation[None]:
    yield from powers_of(A, len(names) - 1)
    powers = exact.powers(A, len(names))
    by_name = total(*(product(name, M) for name, M in zip(names, powers, strict=True)))
    entries = sp.ImmutableMatrix(
        *A.shape, lambda i, j: sp.Add(*(c * M[i, j] for c, M in zip(names, powers, strict=True)))
    )
    claims = {"entries": Claim(by_name, entries, "added entry by entry")}
    if len(A) <= SMALL:
        claims["put_in"] = Claim(_with(coefficients, powers), value, "values put in")
    yield Step(
        "entries",
        detail="tutor",
        claims=claims,
        polynomial=total(*(product(name, power(sp.Symbol("A"), i)) for i, name in enumerate(names))),
    )


def _with(coefficients: Sequence[Expr], powers: Sequence[ImmutableMatrix]) -> Stated:
    """The matrix of the sums cᵢ (Aⁱ)ⱼₖ, not worked out."""
    n, m = powers[0].shape
    pairs = list(zip(coefficients, powers, strict=True))
    return matrix_of(
        [
            [total(*(product(M[i, j], c) for c, M in pairs if M[i, j] != 0 and c != 0)) for j in range(m)]
            for i in range(n)
        ]
    )
