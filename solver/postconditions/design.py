"""Matrices of plants with integrators and at rest, one input in place of several, eigenvectors, model matching."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp

from solver.derivation import Check, Claim
from solver.postconditions.structure import krylov
from solver.stated.algebra import difference, power, product, total
from solver.stated.complex_numbers import conjugate, imaginary_part, norm, real_part
from solver.stated.matrices import rank, transpose


def of_added(found: Any, *terms: Any) -> Iterator[Claim]:
    """The sum."""
    yield Claim(total(*terms), found)


def of_at_rest(found: Any, A: Any, *, discrete: bool) -> Iterator[Claim]:
    """A, in discrete time A − I."""
    yield Claim(difference(A, sp.ImmutableMatrix(sp.eye(A.rows))) if discrete else total(A), found)


def of_attainable_eigenvectors(found: Any, A: Any, B: Any, pole: Any) -> Iterator[Claim]:
    """B M + (λI − A) N = 0 for as many independent columns of N as there are, n + rank B − rank [B, λI − A]."""
    own = sp.ImmutableMatrix(pole * sp.eye(A.rows) - A)
    whole = sp.ImmutableMatrix(sp.Matrix(B).row_join(sp.Matrix(own)))
    yield Claim(whole, found.matrix)
    yield Claim(total(product(B, found.M), product(own, found.N)), _zeros(A.rows, found.N.cols))
    yield Claim(rank(found.N), sp.Integer(found.N.cols))
    yield Claim(difference(total(sp.Integer(A.rows), rank(B)), rank(whole)), sp.Integer(found.N.cols))
    yield Claim(pole, found.pole)


def of_nearest_eigenvector(found: Any, attainable: Any, wanted: Any) -> Iterator[Claim]:
    """v = N p and w = M p, the rest of the wanted vector orthogonal to N, and the share of its length that is left."""
    N, v = attainable.N, found.v
    yield Claim(product(N, found.p), v)
    yield Claim(product(attainable.M, found.p), found.w)
    adjoint = transpose(conjugate(N))
    yield Claim(product(adjoint, difference(wanted, v)), _zeros(N.cols, 1))
    yield Claim(product(adjoint, N), found.gram)
    yield Claim(product(adjoint, wanted), found.right)
    yield Claim(power(norm(v), 2), product(found.share, power(norm(wanted), 2)))


def of_parts_of_columns(found: Any, v: Any) -> Iterator[Claim]:
    """Re v and Im v."""
    yield Claim(real_part(v), found[0])
    yield Claim(imaginary_part(v), found[1])


def of_polynomial_in(found: Any, x: Any, coefficients: Sequence[Any]) -> Iterator[Claim]:
    """The coefficients, from that of the highest power on, beside their powers."""
    terms = (product(c, power(x, i)) for i, c in enumerate(reversed(coefficients)))
    yield Claim(total(*terms), found, "a polynomial by its coefficients")


def of_conjugated(found: Any, value: Any) -> Iterator[Claim]:
    """The conjugate."""
    if found != value or value.has(sp.I):
        yield Claim(conjugate(value), found)


def of_direction(found: Any, A: Any, B: Any) -> Iterator[Claim]:
    """(A − B K₀, B g) reaches as much as (A, B); which K₀ and g do is a free choice."""
    if found is not None:
        K0 = found.preliminary
        loop = A if K0 is None else sp.ImmutableMatrix(A - B * K0)
        yield Claim(rank(krylov(loop, sp.ImmutableMatrix(B * found.g))), rank(krylov(A, B)))


def of_matching(found: Any, numerator: Any, denominator: Any, target: Any, x: Any) -> Iterator[Claim]:
    """What is asked of the closed loop: degrees, zeros, and the compensator that would do the same."""
    above, below = sp.fraction(sp.cancel(target))
    degrees = [sp.degree(below, x) - sp.degree(above, x), sp.degree(denominator, x) - sp.degree(numerator, x)]
    own = sorted(map(sp.Integer, found.relative_degrees)), sorted(map(sp.Integer, degrees))
    yield Claim(sp.ImmutableMatrix([own[0]]), sp.ImmutableMatrix([own[1]]))
    yield Claim(sp.Integer(found.order), sp.Integer(sp.degree(denominator, x)))
    yield Claim(product(found.compensator, numerator), product(target, denominator))
    yield Claim(found.hidden, product(*(x - zero for zero in found.hidden_zeros)))


def of_measured_first(found: Any, A: Any, B: Any, C: Any) -> Iterator[Claim | Check]:
    """Q is C over the unit rows of the states that are not measured, T its inverse; A and B in these coordinates."""
    n, p = A.rows, C.rows
    unit = sp.eye(n)
    own = all(0 <= j < n for j in found.unmeasured) and len(found.unmeasured) == n - p == n - found.p
    yield Check.that("the states that are not measured", "counted", own)
    if own:
        rows = [sp.Matrix(C), *(unit[j, :] for j in found.unmeasured)]
        yield Claim(sp.ImmutableMatrix(sp.Matrix.vstack(*rows)), found.Q)
    yield Claim(product(found.Q, found.T), sp.ImmutableMatrix(unit))
    yield Claim(product(found.Q, A, found.T), found.A)
    yield Claim(product(found.Q, B), found.B)
    of = found.blocks
    blocks = [[sp.Matrix(of[f"A{i}1"]), sp.Matrix(of[f"A{i}2"]), sp.Matrix(of[f"B{i}"])] for i in (1, 2)]
    whole = sp.ImmutableMatrix(sp.Matrix(found.A).row_join(sp.Matrix(found.B)))
    yield Claim(whole, sp.ImmutableMatrix(sp.Matrix.vstack(*(sp.Matrix.hstack(*row) for row in blocks))))
    units = all(sorted(map(str, row)) == sorted(["1", *["0"] * (n - 1)]) for row in C.tolist())
    yield Check.that("outputs that are states", "compared", units == found.permutation)


def of_set_point(found: Any, A: Any, B: Any, C: Any, D: Any, *, discrete: bool = False) -> Iterator[Claim | Check]:
    """[[A, B], [C, D]] [F; N] = [0; I] (discrete: A − I), the rank of that matrix, and whether no other F and N do."""
    M = _at_rest(A, B, C, D, discrete=discrete)
    right = sp.ImmutableMatrix(sp.Matrix.vstack(sp.zeros(A.rows, C.rows), sp.eye(C.rows)))
    stacked = sp.ImmutableMatrix(sp.Matrix(found.F).col_join(sp.Matrix(found.N)))
    yield Claim(M, found.matrix)
    yield Claim(product(M, stacked), right)
    yield Claim(rank(M), sp.Integer(found.rank))
    yield Claim(stacked, found.stacked)
    yield Claim(right, found.right)
    yield Check.that("only one solution", "counted", (found.rank == M.cols) == found.unique)


def of_equations_of_rest(found: Any, A: Any, B: Any, C: Any, D: Any, *, discrete: bool = False) -> Iterator[Claim]:
    """[[A, B], [C, D]], in discrete time with A − I."""
    yield Claim(_at_rest(A, B, C, D, discrete=discrete), found)


def of_with_integrators(found: Any, A: Any, B: Any, C: Any, D: Any, *, discrete: bool = False) -> Iterator[Claim]:
    """[[A, 0], [−C, 0]] and [B; −D], in discrete time with the identity in the corner."""
    n, p = A.rows, C.rows
    below = (-sp.Matrix(C)).row_join(sp.eye(p) if discrete else sp.zeros(p))
    yield Claim(sp.ImmutableMatrix(sp.Matrix.vstack(sp.Matrix(A).row_join(sp.zeros(n, p)), below)), found[0])
    yield Claim(sp.ImmutableMatrix(sp.Matrix(B).col_join(-sp.Matrix(D))), found[1])


def _at_rest(A: Any, B: Any, C: Any, D: Any, *, discrete: bool) -> Any:
    rest = sp.Matrix(A - sp.eye(A.rows) if discrete else A)
    return sp.ImmutableMatrix(sp.Matrix.vstack(rest.row_join(sp.Matrix(B)), sp.Matrix(C).row_join(sp.Matrix(D))))


def _zeros(rows: int, columns: int) -> Any:
    return sp.ImmutableMatrix(sp.zeros(rows, columns))
