"""Ranks and what they are found from: controllability matrices, independent columns, row reductions, null spaces."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.lazy import numeric
from solver.numeric.judges import structure as judges
from solver.postconditions.linear_algebra import factors, of_spectrum, pencil, root_claim
from solver.stated.algebra import power, product, total
from solver.stated.matrices import determinant, rank
from solver.words import Told


def of_controllability_matrix(found: Any, A: Any, B: Any) -> Iterator[Claim]:
    """[B, AB, …, Aⁿ⁻¹B] is Σ AⁱB Eᵢ, with the rows Eᵢ of the identity that belong to a block."""
    n, m = B.shape
    rows = sp.eye(n * m)
    blocks = [sp.ImmutableMatrix(rows[i * m : (i + 1) * m, :]) for i in range(n)]
    yield Claim(total(*(product(*([power(A, i)] if i else []), B, each) for i, each in enumerate(blocks))), found)


def of_reachable_order(found: int, A: Any, B: Any) -> Iterator[Claim]:
    """The rank of [B, AB, …, Aⁿ⁻¹B]."""
    yield _has_rank(krylov(A, B), found)


def of_critical_angles(found: Any, M: Any, parameter: Any) -> Iterator[Claim]:
    """At each of the angles the rows of M are dependent, and the families have as many angles a turn."""
    slope, start = sp.diff(found.angle, parameter), found.angle.xreplace({parameter: sp.Integer(0)})
    for angle in found.angles:
        here = M.xreplace({parameter: (angle - start) / slope})
        yield Claim(determinant(sp.ImmutableMatrix(here if here.rows == here.cols else here * here.T)), sp.Integer(0))
    a_turn = [2 * sp.pi / sp.diff(family, found.number) for family in found.families]
    yield Claim(total(*a_turn), sp.Integer(len(found.angles)))


def of_rank(found: int, M: Any) -> Iterator[Claim]:
    """The rank."""
    if 0 not in M.shape:
        yield _has_rank(M, found)


def of_independent_columns(found: Sequence[int], M: Any) -> Iterator[Claim]:
    """So many columns as the rank, and of the same rank; what is left of each depends on those chosen before it."""
    yield _has_rank(M, len(found))
    yield _has_rank(_columns(M, found), len(found))
    for i, j in enumerate(found):
        yield _has_rank(sp.ImmutableMatrix(M[:, :j]) if j >= 0 else M, i)


def of_row_reduction(found: Any, M: Any) -> Iterator[Claim]:
    """The rows span those of M, with the identity at the pivots; each stage follows from the one before."""
    yield from reduced(found, M)


def of_null_basis(found: Any, M: Any) -> Iterator[Claim]:
    """M V = 0, and as many independent columns V as the rank leaves."""
    yield _has_rank(M, M.cols - found.cols)
    if found.cols:
        yield Claim(product(M, found), _zeros(M.rows, found.cols))
        yield _has_rank(found, found.cols)


def of_hidden_part(found: Any, A: Any, B: Any) -> Iterator[Claim]:
    """N 𝒞 = 0 for as many independent rows N as the rank leaves, and N A = H N."""
    reached = krylov(A, B)
    if found is None:
        yield _has_rank(reached, A.rows)
        return
    yield _has_rank(reached, A.rows - found.N.rows)
    yield _has_rank(found.N, found.N.rows)
    yield Claim(product(found.N, reached), _zeros(found.N.rows, reached.cols))
    yield Claim(product(found.N, A), product(found.H, found.N))
    with suppress(Told):  # no roots of a polynomial with parameters
        yield from of_spectrum(found.spectrum, found.H)


def of_pencil_ranks(found: Iterable[Any], A: Any, B: Any) -> Iterator[Claim]:
    """Each eigenvalue as often as in χ; the rank of [λI − A, B], its reduction, and the rows that annihilate it."""
    x = sp.Symbol("lamda")
    yield Claim(determinant(pencil(A, x)), factors([each.root for each in found], x))
    for each in found:
        whole = sp.ImmutableMatrix(sp.Matrix.hstack(each.root.value * sp.eye(A.rows) - A, B))
        yield Claim(whole, each.pencil)
        yield root_claim(each.root)
        yield _has_rank(whole, each.rank)
        yield _has_rows(each.unreached, A.rows - each.rank)
        if each.unreached.rows:
            yield Claim(product(each.unreached, whole), _zeros(each.unreached.rows, whole.cols))
            yield _has_rank(each.unreached, A.rows - each.rank)
        if each.reduction is not None:
            yield from reduced(each.reduction, whole)


def _has_rows(M: Any, count: int) -> Claim:
    """The number of rows."""
    return Claim(sp.Integer(M.rows), sp.Integer(count))


def reduced(found: Any, M: Any) -> Iterator[Claim]:
    """What must hold of a reduced row echelon form of M and of the stages on the way."""
    R, r = sp.ImmutableMatrix(found.reduced), len(found.pivots)
    yield _has_rank(M, r)
    if r:
        unit = sp.ImmutableMatrix(sp.eye(M.rows)[:, :r])
        yield Claim(_columns(R, found.pivots), unit)
    yield _has_rank(sp.ImmutableMatrix(sp.Matrix.vstack(sp.Matrix(M), sp.Matrix(R))), r)
    stages = [sp.ImmutableMatrix(stage) for stage in found.stages]
    yield Claim(stages[0], sp.ImmutableMatrix(M))
    yield Claim(stages[-1], R)
    yield Claim(sp.Integer(len(found.operations) + 1), sp.Integer(len(stages)))
    for operation, before, after in zip(found.operations, stages, stages[1:], strict=False):
        yield Claim(product(_elementary(operation, M.rows), before), after)


def _elementary(operation: Any, n: int) -> Any:
    """The matrix of a row operation: an exchange of i and j, or c times row j added to row i, or row i times c."""
    E = sp.eye(n)
    i, j = operation.i, getattr(operation, "j", operation.i)
    factor = getattr(operation, "factor", None)
    if factor is None:
        E[i, i] = E[j, j] = 0
        E[i, j] = E[j, i] = 1
    else:
        E[i, j] = factor
    return sp.ImmutableMatrix(E)


def krylov(A: Any, B: Any) -> Any:
    """[B, AB, …, Aⁿ⁻¹B]."""
    blocks = [sp.Matrix(B)]
    for _ in range(A.rows - 1):
        blocks.append(sp.Matrix(A * blocks[-1]))
    return sp.ImmutableMatrix(sp.Matrix.hstack(*blocks))


def _columns(M: Any, chosen: Sequence[int]) -> Any:
    columns = [sp.Matrix(M[:, j]) for j in chosen]
    return sp.ImmutableMatrix(sp.Matrix.hstack(*columns) if columns else sp.zeros(M.rows, 0))


def _has_rank(M: Any, r: int) -> Claim:
    empty = 0 in M.shape
    return Claim(sp.Integer(0) if empty else rank(M), sp.Integer(r))


def _zeros(rows: int, columns: int) -> Any:
    return sp.ImmutableMatrix(sp.zeros(rows, columns))


def of_controllable_decomposition(found: Any, A: Any, B: Any, C: Any) -> Iterator[Claim | Check]:
    """See `_parts`."""
    yield from _parts(found, "controllable", A, B, C)


def of_observable_decomposition(found: Any, A: Any, B: Any, C: Any) -> Iterator[Claim | Check]:
    """See `_parts`."""
    yield from _parts(found, "observable", A, B, C)


def of_reached_in_echelon(found: Any, A: Any, B: Any, C: Any) -> Iterator[Claim | Check]:
    """See `_parts`."""
    yield from _parts(found, "controllable", A, B, C)


def of_seen_in_echelon(found: Any, A: Any, B: Any, C: Any) -> Iterator[Claim | Check]:
    """See `_parts`."""
    yield from _parts(found, "observable", A, B, C)


def of_kalman_decomposition(found: Any, A: Any, B: Any, C: Any) -> Iterator[Claim | Check]:
    """See `_parts`."""
    yield from _parts(found, "full", A, B, C)


def _parts(found: Any, part: str, A: Any, B: Any, C: Any) -> Iterator[Claim | Check]:
    """T is made of the bases, as large as they must be; the system in its coordinates, and the hidden eigenvalues."""
    T = sp.ImmutableMatrix(sp.Matrix.hstack(*(sp.Matrix(basis) for basis in found.bases)))
    yield Claim(T, found.T)
    yield Claim(product(T, found.T_inverse), sp.ImmutableMatrix(sp.eye(A.rows)))
    right = judges.kalman_orders(part, A, B, C)
    orders = [basis.cols for basis in found.bases]
    yield Check.that("the orders of the parts", "numpy.linalg.svd", orders == right == list(found.orders))
    yield Check.that("whether anything is hidden", "counted", (orders[0] == A.rows) == found.trivial)
    yield Check.that("whether T is the identity", "compared", (sp.eye(A.rows) != T) == found.changes)
    yield Claim(product(A, T), product(T, found.A))
    if B is not None:
        yield Claim(B, product(T, found.B))
    if C is not None:
        yield Claim(product(C, T), found.C)
    yield from _bases(found, A, B, C)


def _bases(found: Any, A: Any, B: Any, C: Any) -> Iterator[Claim]:
    """As many columns as the rank, of what is reached; a basis of what is unseen."""
    if found.reached is not None and found.reached.cols:
        reached = krylov(A, B)
        joined = sp.ImmutableMatrix(sp.Matrix.hstack(sp.Matrix(reached), sp.Matrix(found.reached)))
        yield _has_rank(joined, found.reached.cols)
        yield Claim(rank(found.reached), rank(reached))
    if found.unseen is not None and found.unseen.cols:
        seen = sp.ImmutableMatrix(krylov(A.T, C.T).T)
        yield Claim(product(seen, found.unseen), _zeros(seen.rows, found.unseen.cols))
        yield _has_rank(found.unseen, A.rows - numeric.rank(seen))
