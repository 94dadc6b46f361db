"""What the input does not reach (the output does not show): combinations of states with a motion of their own."""

from __future__ import annotations

from typing import Any

from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import power, product
from solver.stated.matrices import determinant
from solver.tasks.structure.pairs import Pair


@lemma("hidden_part")
def hidden_modes_of(pair: Pair, matrix: Any) -> Derivation[list[Any] | None]:
    """N 𝒞 = 0 and N A = H N (dual: 𝒪 N = 0, A N = N H): the eigenvalues of H, with their multiplicities.

    None where they have no usable form. `matrix` is the pair's controllability (observability) matrix.
    """
    hidden = exact.hidden_part(pair.F, pair.G)
    if hidden is None:
        return []
    N, H, k = pair.turned(hidden.N), pair.turned(hidden.H), hidden.N.rows
    zero = sp.ImmutableMatrix(sp.zeros(*((matrix.rows, k) if pair.dual else (k, matrix.cols))))
    yield Step(
        "annihilator",
        claims={"zero": Claim(product(matrix, N) if pair.dual else product(N, matrix), zero, _says(pair, "zero"))},
        N=N,
        k=k,
        dual=pair.dual,
    )
    left, right = (product(pair.A, N), product(N, H)) if pair.dual else (product(N, pair.A), product(H, N))
    moved = exact.multiply(*((pair.A, N) if pair.dual else (N, pair.A)))
    claims = {"invariant": Claim(left, right, _says(pair, "invariant"))}
    claims["moved"] = Claim(left, moved, _says(pair, "invariant"))
    lamda = sp.Symbol("lamda")
    try:
        roots = hidden.spectrum.roots
    except exact.NotExact:
        roots = None
    if k > 1:
        pencil = exact.pencil(H, lamda)
        found = (
            exact.factored(H, lamda)
            if roots is None
            else product(*(power(lamda - root.value, root.multiplicity) for root in roots))
        )
        claims["polynomial"] = Claim(determinant(pencil), found, "hidden eigenvalues")
    yield Step("motion", claims=claims, N=N, H=H, k=k, dual=pair.dual, roots=roots, discrete=pair.discrete)
    return None if roots is None else hidden.spectrum.eigenvalues


def _says(pair: Pair, what: str) -> str:
    words = {
        "zero": (r"$N\,\sym{controllability_matrix} = 0$", r"$\sym{observability_matrix} N = 0$"),
        "invariant": (r"$N A = H N$", r"$A N = N H$"),
    }
    return words[what][pair.dual]
