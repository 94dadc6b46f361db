"""Lowest terms of a transfer function given as fractions, its poles and its zeros."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from solver.derivation import Answers, Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.matrices import entry_alone
from solver.stated import Stated
from solver.stated.algebra import difference, power, product, quotient
from solver.tasks.figures import plane, roots

if TYPE_CHECKING:
    from sympy import Expr, ImmutableMatrix, Symbol


def rows_as_matrix(rows: Sequence[Sequence[Expr]]) -> ImmutableMatrix:
    """The matrix with these rows."""
    return sp.ImmutableMatrix([list(row) for row in rows])


@lemma("lowest_terms")
def fractions_of(system: Any) -> Derivation[exact.TransferMatrix]:
    """G as it is given, the denominators made monic; not cancelled."""
    G = exact.transfer_matrix_of_fractions(system.numerators, system.denominators, system.variable)
    given, monic = (
        entry_alone(
            sp.ImmutableMatrix(*G.shape, [p / q for row in zip(*pair, strict=True) for p, q in zip(*row, strict=True)])
        )
        for pair in ((system.numerators, system.denominators), (G.numerators, G.denominators))
    )
    if given == monic:
        yield Step(
            "as_given", claims={"given": Claim(given, system.matrix, "the fraction as given")}, x=G.variable, G=given
        )
    else:
        yield Step("monic", claims={"monic": Claim(given, monic, "denominators made monic")}, x=G.variable)
    return G


@lemma("lowest_terms")
def lowest_terms_of(G: exact.TransferMatrix, *, given_as_fraction: bool = False) -> Derivation[Answers]:
    """Common factors cancelled and named; poles and zeros."""
    x, siso = G.variable, G.shape == (1, 1)
    uncancelled = over_chi(G)
    common = None if given_as_fraction and not siso else G.cancelled_factored
    yield Step(
        "cancel",
        claims={"lowest": Claim(uncancelled, entry_alone(G.matrix), "lowest terms")},
        x=x,
        siso=siso,
        factored=_factored_fraction(G) if siso and G.matrix[0, 0] != 0 else None,
        common=common,
        cancelled=G.cancelled if common is not None else None,
    )
    poles, zeros = G.poles, G.zeros
    yield Step(
        "poles_zeros",
        claims={
            **({"poles": Claim(G.poles_factored, from_roots(x, poles), "poles")} if poles else {}),
            **({"zeros": Claim(G.zeros_factored, from_roots(x, zeros), "zeros")} if zeros else {}),
        },
        unclaimed="" if poles or zeros else "there are no roots to put into a product",
        x=x,
        poles=poles,
        zeros=zeros,
        siso=siso,
        pole_polynomial=G.poles_factored,
        zero_polynomial=G.zeros_factored,
        vanishes=bool(G.matrix.is_zero_matrix),
        figures=plane(
            "Poles and zeros",
            roots("poles", poles or ()),
            roots("zeros", zeros or (), "ring"),
            discrete=str(x) == "z",
        ),
    )
    found = {"poles": poles, "zeros": zeros, "cancelled": G.cancelled if common is not None else None}
    return Answers(G=entry_alone(G.matrix), **{name: value for name, value in found.items() if value is not None})


def over_chi(G: exact.TransferMatrix) -> Any:
    """G before anything is cancelled, over the common denominator where the entries have it."""
    same = len({q for row in G.denominators for q in row}) == 1
    if same:
        return quotient(entry_alone(rows_as_matrix(G.numerators)), G.chi)
    entries = [p / q for row in zip(G.numerators, G.denominators, strict=True) for p, q in zip(*row, strict=True)]
    return sp.ImmutableMatrix(*G.shape, entries)


def _factored_fraction(G: exact.TransferMatrix) -> Any:
    """Numerator and denominator of the only entry in factors."""
    return quotient(G.numerator_factored, G.chi_factored)


def from_roots(x: Symbol, roots: Sequence[Expr]) -> Stated:
    """The product of x − r over the roots, as powers."""
    distinct = dict.fromkeys(roots)
    return product(*(power(difference(x, root), list(roots).count(root)) for root in distinct))
