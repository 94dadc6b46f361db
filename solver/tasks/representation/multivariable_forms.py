"""Companion forms of a plant with several inputs (outputs): a change of coordinates, which keeps the order."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.arithmetic.coordinates import in_coordinates
from solver.arithmetic.inverses import inverted
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.stated.algebra import product
from solver.stated.matrices import inverse
from solver.tasks.representation.plants import matrices_of, variable_of
from solver.tasks.representation.realization_lemmas import assembled
from solver.words import Phrase

if TYPE_CHECKING:
    from solver.systems import StateSpace


@lemma("multivariable_forms")
def companion_coordinates_of(plant: StateSpace, form: str, *, first: bool) -> Derivation[exact.Realization | None]:
    """Luenberger's form; None (and no step) where the plant is not controllable (observable)."""
    A, B, C, D = matrices_of(plant)
    controllable = form == "controllable"
    find = exact.controllable_coordinates if controllable else exact.observable_coordinates
    coordinates = find(A, B, C, D, first_row=first)
    if coordinates is None:
        return None
    T, P, found = coordinates.T, coordinates.P, coordinates.found
    yield from chains_of(A, B if controllable else C, P, coordinates.indices, controllable=controllable)
    yield Step(
        "coordinates",
        claims={
            "inverse": Claim(inverse(P), exact.inverse(P), "$P^{-1}$"),
            "T": Claim(inverse(coordinates.T_inverse), T, "$T$"),
            "A": Claim(product(inverse(T), A, T), found.A, "$T^{-1} A T$"),
            "B": Claim(product(inverse(T), B), found.B, "$T^{-1} B$"),
            "C": Claim(product(C, T), found.C, "$C T$"),
        },
        steps=(*inverted("P", P, exact.inverse(P)), *in_coordinates(T, coordinates.T_inverse, A, B, C)),
        T=T,
        T_inverse=coordinates.T_inverse,
        controllable=controllable,
        first=first,
        indices=coordinates.indices,
    )
    x = variable_of(plant)
    G = exact.transfer_matrix(A, B, C, D, x)
    yield from assembled(G, found, cancelled=True, x=x, discrete=plant.discrete)
    return found


@lemma("multivariable_forms")
def chains_of(A: Any, B: Any, P: Any, indices: tuple[int, ...], *, controllable: bool = True) -> Derivation[None]:
    """The independent columns of the controllability matrix, chain by chain (rows of the observability matrix of C)."""
    claims = _columns(A, B, P, indices, controllable=controllable)
    yield Step("chains", claims=claims, P=P, indices=indices, controllable=controllable)


def _columns(A: Any, B: Any, P: Any, indices: tuple[int, ...], *, controllable: bool) -> dict[str, Claim]:
    """Each column (row) of P as a power of A times a column of B (a row of C)."""
    claims: dict[str, Claim] = {}
    k = 0
    for i, length in enumerate(indices):
        for power in range(length):
            vector = P[:, k] if controllable else P[k, :]
            start = B[:, i] if controllable else B[i, :]
            factors = [*[A] * power, start] if controllable else [start, *[A] * power]
            claims[f"vector{k + 1}"] = Claim(product(*factors), vector, Phrase("vector {k} of $P$", k=k + 1))
            k += 1
    return claims
