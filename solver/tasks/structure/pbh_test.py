"""The test of Popov, Belevitch and Hautus: the rank of [λI − A, B], or of λI − A over C, at every eigenvalue."""

from __future__ import annotations

from typing import Any

from solver.arithmetic.row_operations import row_operations
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import product
from solver.stated.matrices import rank
from solver.tasks.linear_algebra.eigenstructure import eigenvalues_of
from solver.tasks.structure.pairs import Pair


@lemma("pbh_test")
def deficient_eigenvalues_of(pair: Pair) -> Derivation[list[exact.PencilRank]]:
    """The eigenvalues at which [λI − A, B] (dual: λI − A over C) has a rank below n."""
    yield from eigenvalues_of(pair.A)
    ranks = exact.pencil_ranks(pair.F, pair.G)
    yield Step("idea", unclaimed="the condition that is tested next", dual=pair.dual, n=pair.n)
    for i, found in enumerate(ranks):
        if _is_lower_of_pair(found, ranks[:i]):
            continue
        yield _at_eigenvalue(pair, found, i + 1)
    deficient = [found for found in ranks if found.rank < pair.n]
    yield Step(
        "verdict",
        unclaimed="it follows from the ranks",
        deficient=[found.root.value for found in deficient],
        dual=pair.dual,
        n=pair.n,
        generic=bool(pair.parameters),
    )
    return deficient


def _is_lower_of_pair(found: Any, before: Any) -> bool:
    """Whether the conjugate eigenvalue has been treated: A and B are real, so its rank is the same."""
    value = found.root.value
    return bool(value.has(sp.I)) and sp.conjugate(value) in [each.root.value for each in before]


def _at_eigenvalue(pair: Pair, found: exact.PencilRank, i: int) -> Step:
    """The matrix at one eigenvalue with its rank, and the eigenvectors that annihilate B (C) where it is too low."""
    pencil, w, value = pair.turned(found.pencil), pair.turned(found.unreached), found.root.value
    claims = {"rank": Claim(rank(pencil), sp.Integer(found.rank), "rank at an eigenvalue")}
    if found.rank < pair.n:
        left, right = (
            (product(pencil, w), (pencil.rows, w.cols)) if pair.dual else (product(w, pencil), (w.rows, pencil.cols))
        )
        claims["unreached"] = Claim(left, sp.ImmutableMatrix(sp.zeros(*right)), "eigenvectors that the test finds")
    reduction = found.reduction if not pair.dual else _dual_reduction(pencil, value)
    return Step(
        "eigenvalue",
        claims=claims,
        steps=row_operations(pencil, reduction),
        i=i,
        value=value,
        paired=bool(value.has(sp.I)),
        pencil=pencil,
        reduced=sp.ImmutableMatrix(reduction.reduced[: found.rank]) if reduction and found.rank else None,
        rank=found.rank,
        unreached=w,
        count=pair.n - found.rank,
        multiplicity=found.root.multiplicity,
        dual=pair.dual,
        n=pair.n,
    )


def _dual_reduction(pencil: Any, value: Any) -> Any:
    """The row reduction of λI − A over C, for a rational λ; others are not shown."""
    return exact.row_reduction(pencil) if value.is_Rational else None
