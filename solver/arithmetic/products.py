"""Products of matrices, row times column, and polynomials of a matrix, term by term."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from solver.arithmetic.exactness import where_exact
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product, total
from solver.stated.matrices import matrix_of
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix

    from solver.stated import Stated


@where_exact
def multiplied(
    left: ImmutableMatrix, right: ImmutableMatrix, value: ImmutableMatrix, name: str = ""
) -> tuple[Step, ...]:
    """L R = value, each entry as a row of L times a column of R; none where no entry needs more than a look.

    `name` is the LaTeX by which the page calls the product, if it does.
    """
    return tuple(_multiplied(left, right, value, name)) if is_worked_out(left, right) else ()


@where_exact
def polynomial_of(A: ImmutableMatrix, coefficients: Sequence[Expr], value: ImmutableMatrix) -> tuple[Step, ...]:
    """c₀Aⁿ + … + cₙI = value: the powers one from the other, the terms, their sum. n ≥ 1."""
    return tuple(_polynomial_of(A, coefficients, value))


def is_worked_out(left: ImmutableMatrix, right: ImmutableMatrix) -> bool:
    """Whether any entry of L R is a sum or a product that a reader has to work out."""
    return any(not _is_plain(each) for line in _terms(left, right) for each in line)


def rows_times_columns(left: ImmutableMatrix, right: ImmutableMatrix) -> Stated:
    """L R as the matrix of sums of products that its entries are."""
    return matrix_of([[total(*each) for each in line] for line in _terms(left, right)])


@lemma("arithmetic/products")
def _multiplied(left: ImmutableMatrix, right: ImmutableMatrix, value: ImmutableMatrix, name: str) -> Derivation[None]:
    yield _row_times_column(left, right, value, name=name)


@lemma("arithmetic/products")
def powers_of(A: ImmutableMatrix, highest: int) -> Derivation[list[ImmutableMatrix]]:
    """I, A, A², … up to the highest power, one from the other; returns them."""
    powers = [sp.ImmutableMatrix(sp.eye(A.rows)), A]
    for k in range(2, highest + 1):
        powers.append(sp.ImmutableMatrix(exact.multiply(powers[-1], A)))
        yield _row_times_column(powers[-2], A, powers[-1], power=k)
    return powers


@lemma("arithmetic/products")
def _polynomial_of(A: ImmutableMatrix, coefficients: Sequence[Expr], value: ImmutableMatrix) -> Derivation[None]:
    n = len(coefficients) - 1
    powers = yield from powers_of(A, n)
    shares = [(c, powers[n - i]) for i, c in enumerate(coefficients) if c != 0]
    terms = [sp.ImmutableMatrix((c * M).applyfunc(exact.tidy)) for c, M in shares]
    yield Step(
        "terms",
        detail="tutor",
        claims={
            "multiples": Claim(total(*(product(c, M) for c, M in shares)), total(*terms), "the terms"),
            "sum": Claim(total(*terms), value, "their sum, entry by entry"),
        },
    )


def _row_times_column(
    left: ImmutableMatrix, right: ImmutableMatrix, value: ImmutableMatrix, *, power: int = 0, name: str = ""
) -> Step:
    entries = rows_times_columns(left, right)
    return Step(
        "product",
        detail="tutor",
        claims={
            "entries": Claim(product(left, right), entries, Phrase("rows times columns")),
            "value": Claim(entries, value, Phrase("the entries worked out")),
        },
        power=power,
        name=name,
        sparse=0 in left.flat() or 0 in right.flat(),
    )


def _terms(left: ImmutableMatrix, right: ImmutableMatrix) -> list[list[list[Stated]]]:
    """The products that each entry of L R is the sum of, without those that have a factor of zero."""
    return [
        [
            [product(left[i, k], right[k, j]) for k in range(left.cols) if left[i, k] != 0 and right[k, j] != 0]
            for j in range(right.cols)
        ]
        for i in range(left.rows)
    ]


def _is_plain(terms: Sequence[Stated]) -> bool:
    """Whether a sum of products is at most one product in which a factor is 1."""
    return not terms or (len(terms) == 1 and 1 in terms[0].operands)
