"""Chains of generalized eigenvectors: how many and how long by ranks of powers, and their equations."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from solver.arithmetic.exactness import where_exact
from solver.arithmetic.products import is_worked_out, rows_times_columns
from solver.derivation import Claim, Derivation, Step, lemma
from solver.lazy import exact
from solver.lazy import sympy as sp
from solver.stated.algebra import difference, product
from solver.stated.matrices import rank
from solver.words import Phrase

if TYPE_CHECKING:
    from sympy import ImmutableMatrix

    from solver.stated import Stated

LARGEST = 3
"""The entries of the powers of a larger matrix are not written out."""


@where_exact
def chains_worked_out(
    N: ImmutableMatrix, nullities: Sequence[int], chains: Sequence[Sequence[ImmutableMatrix]]
) -> tuple[Step, ...]:
    """N = A − λI (n×n): n − rank Nᵏ for k = 1, 2, … and the lengths that follow; each chain from its last vector on."""
    return tuple(_chains_worked_out(N, nullities, chains))


@lemma("arithmetic/chains")
def _chains_worked_out(
    N: ImmutableMatrix, nullities: Sequence[int], chains: Sequence[Sequence[ImmutableMatrix]]
) -> Derivation[None]:
    n, powers = N.rows, [N]
    for _ in nullities[1:]:
        powers.append(exact.multiply(powers[-1], N))
    yield Step(
        "lengths",
        detail="tutor",
        claims={
            f"nullity{k}": Claim(difference(n, rank(power)), sp.Integer(d), Phrase("the dimension of a null space"))
            for k, (power, d) in enumerate(zip(powers, nullities, strict=True), 1)
        }
        | {
            f"power{k}": Claim(product(powers[k - 2], N), powers[k - 1], Phrase("a power"))
            for k in range(2, len(powers) + 1)
        },
        N=N,
        powers=powers,
        entries=["", *(_entries(power, N) if n <= LARGEST else "" for power in powers[:-1])],
        nullities=[sp.Integer(d) for d in nullities],
        at_least=[d - before for before, d in zip((0, *nullities), nullities, strict=False)],
        lengths=[len(chain) for chain in chains],
    )
    for number, chain in enumerate(chains, 1):
        yield _chain(N, chain, number if len(chains) > 1 else 0, powers)


def _entries(left: ImmutableMatrix, right: ImmutableMatrix) -> Stated | str:
    """The entries of L R as sums of products; nothing where none has to be worked out."""
    return rows_times_columns(left, right) if is_worked_out(left, right) else ""


def _chain(
    N: ImmutableMatrix, chain: Sequence[ImmutableMatrix], number: int, powers: Sequence[ImmutableMatrix]
) -> Step:
    """From the last vector down: each is N times the one after it, and N times the first is zero."""
    zero = sp.ImmutableMatrix(sp.zeros(N.rows, 1))
    claims, rows = {}, _rows(powers[len(chain) - 1]) if 1 < len(chain) <= len(powers) else None
    for j in range(len(chain) - 1, -1, -1):
        right = chain[j - 1] if j else zero
        claims[f"vector{j + 1}"] = Claim(product(N, chain[j]), right, Phrase("chain of vectors"))
    return Step(
        "chain",
        detail="tutor",
        claims=claims,
        N=N,
        number=number,
        length=len(chain),
        rows=rows,
        last=chain[-1],
        entries=[_entries(N, v) for v in reversed(chain)],
    )


def _rows(power: ImmutableMatrix) -> ImmutableMatrix | None:
    """The independent rows of a power, reduced; None where it is zero, or is not reduced in exact numbers."""
    reduction = exact.row_reduction(power)
    if reduction is None or not reduction.pivots:
        return None
    return sp.ImmutableMatrix(reduction.reduced[: len(reduction.pivots)])
