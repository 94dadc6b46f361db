"""Parts of a system that its transfer function needs, and a transfer matrix put together from those of its poles."""

from __future__ import annotations

from typing import Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product, quotient, total
from solver.stated.matrices import inverse, rank
from solver.tasks.representation.realization_lemmas import (
    assembled,
    companion_form_of,
    direct_path_of,
    fractions,
    proper_part,
)

State = tuple[Any, Any, Any]
"""A, B and C."""


@lemma("minimal_parts")
def least_realization_of(given: exact.TransferMatrix, *, discrete: bool) -> Derivation[exact.Realization]:
    """A companion form with a chain for each input or output where one is minimal, else pole by pole."""
    G = exact.entries_in_lowest_terms(given)
    if (given.tops, given.bottoms) != (G.tops, G.bottoms):
        yield Step(
            "entries",
            claims={"lowest": Claim(fractions(given), fractions(G), "each entry in lowest terms")},
            x=G.variable,
        )
    yield from direct_path_of(G)
    by_inputs, by_outputs = exact.companion_orders(G)
    form = "controllable" if by_inputs <= by_outputs else "observable"
    start = _companion(G, form)
    least = G.pole_polynomial.degree()
    if start.A.rows > least:
        return (yield from _pole_by_pole(G, start, form, (by_inputs, by_outputs), discrete))
    if not least:
        return start
    yield from companion_form_of(G, form, first=False, discrete=discrete)
    yield from kept_part_of(start.A, start.B, start.C, _other(form), companion=True)
    return start


def _companion(G: exact.TransferMatrix, form: str) -> exact.Realization:
    return exact.controllable_realization(G) if form == "controllable" else exact.observable_realization(G)


def _other(form: str) -> str:
    """What a companion form need not be."""
    return "observable" if form == "controllable" else "controllable"


@lemma("minimal_parts")
def _pole_by_pole(
    G: exact.TransferMatrix, start: exact.Realization, form: str, orders: tuple[int, int], discrete: bool
) -> Derivation[exact.Realization]:
    """The parts of the partial fractions realized one by one, which stays in small numbers."""
    x, matrix = G.variable, _test_matrix(start.A, start.B, start.C, _other(form))
    least = G.pole_polynomial.degree()
    yield Step(
        "orders",
        claims={"rank": Claim(rank(matrix), sp.Integer(least), "the least order")},
        by_inputs=orders[0],
        by_outputs=orders[1],
        part=_other(form),
        matrix=matrix,
        least=least,
    )
    parts = exact.parts_by_poles(G)
    terms = [quotient(part.numerators, part.polynomial) for part in parts]
    yield Step(
        "parts",
        claims={"sum": Claim(proper_part(G), total(*terms), "partial fractions")},
        x=x,
        through=not G.direct.is_zero_matrix,
    )
    blocks = []
    for number, part in enumerate(parts, 1):
        blocks.append((yield from _realized_part(part, number, x)))
    A, B, C = (list(matrices) for matrices in zip(*blocks, strict=True))
    found = exact.Realization(
        sp.ImmutableMatrix(sp.diag(*A)),
        sp.ImmutableMatrix(sp.Matrix.vstack(*B)),
        sp.ImmutableMatrix(sp.Matrix.hstack(*C)),
        G.direct,
        tuple(block.rows for block in A),
    )
    yield from assembled(G, found, x=x, discrete=discrete)
    return found


@lemma("minimal_parts")
def _realized_part(part: exact.PolePart, number: int, x: Any) -> Derivation[State]:
    """A simple pole: its residue as a product with as few states as its rank; else a companion form, reduced."""
    if part.pole is not None:
        R = part.numerators
        C, B = exact.rank_factors(R)
        yield Step(
            "residue",
            claims={
                "rank": Claim(rank(R), sp.Integer(B.rows), "rank of the residue"),
                "product": Claim(R, product(C, B), "residue as a product"),
            },
            number=number,
            pole=part.pole,
            rank=B.rows,
            x=x,
            A=sp.ImmutableMatrix(part.pole * sp.eye(B.rows)),
            B=B,
            C=C,
        )
        return sp.ImmutableMatrix(part.pole * sp.eye(B.rows)), B, C
    by_inputs, by_outputs = exact.companion_orders(part.G)
    form = "controllable" if by_inputs <= by_outputs else "observable"
    start = _companion(part.G, form)
    A, B, C = start.A, start.B, start.C
    pencil = difference(product(x, sp.ImmutableMatrix(sp.eye(A.rows))), A)
    yield Step(
        "chains",
        claims={
            "same": Claim(
                product(C, inverse(pencil), B), quotient(part.numerators, part.polynomial), "the chains have this part"
            )
        },
        number=number,
        form=form,
        polynomial=part.polynomial,
        x=x,
        A=A,
        B=B,
        C=C,
    )
    return (yield from kept_part_of(A, B, C, _other(form), number=number))


@lemma("minimal_parts")
def kept_part_of(
    A: Any, B: Any, C: Any, part: str, *, number: int | str = 0, companion: bool = False
) -> Derivation[State]:
    """The controllable (observable) part, which is all that the transfer function needs.

    `number` is that of the block, if it is one, or an index that the matrices of the part get; of a `companion` form
    it is known that the other part is whole.
    """
    controllable, n = part == "controllable", A.rows
    found = exact.reached_in_echelon(A, B, C) if controllable else exact.seen_in_echelon(A, B, C)
    r, matrix = found.orders[0], _test_matrix(A, B, C, part)
    claims = {"rank": Claim(rank(matrix), sp.Integer(r), _RANKS[part])}
    shown = {"part": part, "n": n, "matrix": matrix, "number": number, "companion": companion}
    if r == n:
        yield Step("complete", claims=claims, **shown)
        return A, B, C
    kept = found.block(0, 0), found.input_block(0), found.output_block(0)
    if r:
        claims["A"] = Claim(product(A, found.T), product(found.T, found.A), "$A T = T \\bar{A}$")
        claims["B"] = Claim(product(found.T, found.B), B, "$T \\bar{B} = B$")
        claims["C"] = Claim(product(C, found.T), found.C, "$C T = \\bar{C}$")
    moved = (found.A, found.B, found.C)
    yield Step("reduction", claims=claims, r=r, T=found.T, moved=moved, kept=kept, **shown)
    return kept


_RANKS = {
    "controllable": "rank of the controllability matrix",
    "observable": "rank of the observability matrix",
}


def _test_matrix(A: Any, B: Any, C: Any, part: str) -> Any:
    """The controllability or the observability matrix."""
    if part == "controllable":
        return exact.controllability_matrix(A, B)
    return sp.ImmutableMatrix(exact.controllability_matrix(sp.ImmutableMatrix(A.T), sp.ImmutableMatrix(C.T)).T)
