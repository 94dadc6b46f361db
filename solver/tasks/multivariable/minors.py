"""Lemma: poles and zeros of a transfer matrix from its minors."""

from __future__ import annotations

from dataclasses import dataclass
from functools import reduce
from typing import TYPE_CHECKING, Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.matrices import entry_alone
from solver.stated.algebra import difference, power, product, quotient
from solver.stated.matrices import determinant
from solver.tasks.representation.lowest_terms import over_chi
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import Poly

    from solver.stated import Stated


@dataclass(frozen=True)
class Found:
    """What a method knows of G: its normal rank, and the monic polynomials of its poles and its zeros."""

    G: exact.TransferMatrix
    rank: int
    poles: Poly
    zeros: Poly


@lemma("minors")
def poles_and_zeros_by_minors(G: exact.TransferMatrix) -> Derivation[Found]:
    """All minors in lowest terms; their least common denominator; what the largest ones share over it."""
    yield from lowest_of(G)
    minors = exact.rational_minors(G)
    first = minors.orders[0]
    yield Step(
        "entries",
        unclaimed="the minors of first order are the entries of G",
        listed=[(minor.rows[0] + 1, minor.columns[0] + 1, minor.value) for minor in first],
        single=len(first) == 1,
        x=G.variable,
    )
    for order, listed in enumerate(minors.orders[1:], 2):
        yield _minors_of_order(G, order, listed, minors.rank)
    yield _pole_polynomial(minors)
    if minors.rank:
        yield _zero_polynomial(minors)
    return Found(G, minors.rank, minors.pole_polynomial, minors.zero_polynomial)


@lemma("minors")
def lowest_of(G: exact.TransferMatrix) -> Derivation[None]:
    """Each entry in lowest terms, where it is not given so."""
    lowest = Claim(over_chi(G), entry_alone(G.matrix), "lowest terms")
    if lowest.left != lowest.right:
        yield Step("lowest", claims={"lowest": lowest}, x=G.variable)


def _minors_of_order(G: exact.TransferMatrix, order: int, listed: tuple[exact.Minor, ...], rank: int) -> Step:
    """The minors of one order; each by its formula, and in lowest terms."""
    square = G.shape[0] == G.shape[1] == order
    return Step(
        "minors",
        claims={
            f"minor{i}": Claim(_formula(G, minor), minor.value, Phrase("a minor of order {order}", order=order))
            for i, minor in enumerate(listed, 1)
        },
        order=order,
        places=[([i + 1 for i in minor.rows], [j + 1 for j in minor.columns]) for minor in listed],
        values=[minor.value for minor in listed],
        square=square,
        vanishing=order > rank,
        x=G.variable,
    )


def _formula(G: exact.TransferMatrix, minor: exact.Minor) -> Stated:
    """The determinant of the rows and columns; of two written out."""
    M = sp.ImmutableMatrix(G.matrix.extract(list(minor.rows), list(minor.columns)))
    if minor.order > 2:
        return determinant(M)
    ((a, b), (c, d)) = M.tolist()
    first, second = ((x, y) for x, y in ((a, d), (b, c)))
    if 0 in first or 0 in second:
        kept = product(*first) if 0 in second else difference(sp.Integer(0), product(*second))
        return determinant(M) if 0 in first else kept
    return difference(product(*first), product(*second))


def _pole_polynomial(minors: exact.RationalMinors) -> Step:
    """Each factor of the denominators to the highest power that it has in a minor."""
    powers = minors.pole_powers
    p = minors.pole_polynomial.as_expr()
    return Step(
        "pole_polynomial",
        claims={"expanded": Claim(product(*(power(f, m) for f, m, _ in powers)), p, "pole polynomial")}
        if powers
        else {},
        unclaimed="" if powers else "no minor has a denominator",
        powers=[
            (f, m, minor.order, [i + 1 for i in minor.rows], [j + 1 for j in minor.columns]) for f, m, minor in powers
        ],
        x=minors.variable,
        union=_largest_in_entries(minors),
    )


def _largest_in_entries(minors: exact.RationalMinors) -> Any:
    """The least common denominator of the entries alone, where it is not yet the pole polynomial; else None."""
    bottoms = [minor.bottom for minor in minors.orders[0]]
    alone = reduce(lambda p, q: p.lcm(q).monic(), bottoms)
    return None if alone == minors.pole_polynomial else exact.in_factors(alone)


def _zero_polynomial(minors: exact.RationalMinors) -> Step:
    """The minors of normal rank over the pole polynomial, and what their numerators have in common."""
    p = exact.in_factors(minors.pole_polynomial)
    tops = [exact.in_factors(top) for top in minors.over_the_poles]
    return Step(
        "zero_polynomial",
        claims={
            f"over{i}": Claim(minor.value, quotient(top, p), "a minor over the pole polynomial")
            for i, (minor, top) in enumerate(zip(minors.largest, tops, strict=True), 1)
        },
        x=minors.variable,
        rank=minors.rank,
        full=minors.rank == min(minors.G.shape),
        places=[([i + 1 for i in minor.rows], [j + 1 for j in minor.columns]) for minor in minors.largest],
        tops=tops,
        extended=any(minor.bottom != minors.pole_polynomial for minor in minors.largest),
        poles=p,
        zeros=exact.in_factors(minors.zero_polynomial),
    )
