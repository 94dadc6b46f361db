"""A polynomial matrix on its way to Smith's form: elementary operations, each recorded.

Rows and columns are numbered from 0. Source: F. R. Gantmacher, The Theory of Matrices I, chapter VI §2.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property, reduce
from typing import Any

import sympy as sp

from solver.exact.linear_algebra.row_reduction import Add, Operation, Scale, Swap, carry_out
from solver.exact.multivariable.polynomial_matrices import Rows, by_powers, in_parameters, matrix_of_rows, size_of

STAGE = 12
"""What a stage costs beside the figures of its matrix."""


@dataclass(frozen=True, slots=True)
class Division:
    """A polynomial divided by the pivot: dividend = quotient · divisor + remainder; it stands at `place`."""

    place: tuple[int, int]
    dividend: sp.Poly
    divisor: sp.Poly
    quotient: sp.Poly
    remainder: sp.Poly

    @property
    def expressions(self) -> tuple[sp.Expr, sp.Expr, sp.Expr, sp.Expr]:
        """The four as expressions, in their order."""
        p, d, q, r = map(by_powers, (self.dividend, self.divisor, self.quotient, self.remainder))
        return p, d, q, r


@dataclass(frozen=True)
class SmithStage:
    """What is done at once, on rows or on columns, and the matrix before and after it.

    `kind`: "pivot" (an entry of least degree is brought to place k, k), "rows" or "columns" (multiples of the
    pivot's line are taken from the others), "divisibility" (the pivot does not divide the entry at `place`, whose
    row is added to that of the pivot), "monic" (the pivot gets the leading coefficient 1).
    """

    kind: str
    k: int
    place: tuple[int, int]
    operations: tuple[Operation, ...]
    divisions: tuple[Division, ...]
    rows_before: Rows
    rows_after: Rows

    @cached_property
    def before(self) -> sp.ImmutableMatrix:
        """The matrix before it."""
        return matrix_of_rows(self.rows_before)

    @cached_property
    def after(self) -> sp.ImmutableMatrix:
        """The matrix after it."""
        return matrix_of_rows(self.rows_after)

    @property
    def left(self) -> sp.ImmutableMatrix:
        """The unimodular matrix whose product with the one before, from the left, does the operations on rows."""
        return carried_out(self.operations, "R", self.rows_before)

    @property
    def right(self) -> sp.ImmutableMatrix:
        """The unimodular matrix that does the operations on columns, from the right."""
        return carried_out(self.operations, "C", self.rows_before)

    @property
    def shown(self) -> tuple[Operation, ...]:
        """The operations with expressions as their factors."""
        return tuple(
            each if isinstance(each, Swap) else replace(each, factor=by_powers(each.factor)) for each in self.operations
        )

    @property
    def leaves(self) -> bool:
        """Whether remainders are left."""
        return any(not each.remainder.is_zero for each in self.divisions)

    @cached_property
    def figures(self) -> int:
        """How much is to be written for it."""
        return STAGE + sum(sum(size_of(p)) for row in self.rows_after for p in row if not p.is_zero)


class Reduction:
    """A polynomial matrix brought to Smith's form, what was done to it, and how much is to be written for it.

    `order` says whether rows or columns are cleared first; with `stays` Euclid's algorithm goes on in one line until
    it is clear, else with the best entry anywhere. Beyond `limit` figures, or `bound` for a matrix, it is given up, not
    `finished`.
    """

    def __init__(
        self, rows: Rows, order: tuple[str, str], stays: bool, limit: int | None = None, bound: int | None = None
    ) -> None:
        self.M = [list(row) for row in rows]
        self.order, self.stays, self.limit, self.bound = order, stays, limit, bound
        self.stages: list[SmithStage] = []
        self.leads: list[Any] = []
        self.invariants: list[sp.Poly] = []
        self.figures = 0
        self.finished = True
        for k in range(min(len(rows), len(rows[0]))):
            if not self._make_pivot(k):
                break
            self.invariants.append(self.M[k][k])

    def _make_pivot(self, k: int) -> bool:
        """Bring e_k to place (k, k) with zeros beside and below it; False if nothing but zeros is left."""
        if (place := self._best(k)) is None:
            return False
        left = None
        while not self._grows_long():
            self._bring(k, place)
            order = self.order if not (left and self.stays) or left == self.order[0] else self.order[::-1]
            left = next((kind for kind in order if not self._clear(k, kind)), None)
            if left is None:
                if (bad := self._indivisible(k)) is None:
                    self._make_monic(k)
                    return True
                self._do("divisibility", k, bad, [Add(k, bad[0], self.M[0][0].one)])
                left = None if self._clear(k, "columns") else "columns"
            place = self._best(k, left if self.stays else None) or (k, k)
        self.finished = False
        return False

    def _grows_long(self) -> bool:
        longest = self.stages[-1].figures if self.stages else 0
        return (self.limit is not None and self.figures >= self.limit) or (
            self.bound is not None and longest > self.bound
        )

    def _best(self, k: int, line: str | None = None) -> tuple[int, int] | None:
        """The place of the best pivot: of least degree, dividing much of its row and column, short."""
        rows = range(k, k + 1 if line == "columns" else len(self.M))
        columns = range(k, k + 1 if line == "rows" else len(self.M[0]))
        places = [(i, j) for i in rows for j in columns if not self.M[i][j].is_zero]
        if not places:
            return None
        least = min(self.M[i][j].degree() for i, j in places)
        candidates = [(i, j) for i, j in places if self.M[i][j].degree() == least]
        return min(candidates, key=lambda place: self._effort(k, place)) if candidates[1:] else candidates[0]

    def _effort(self, k: int, place: tuple[int, int]) -> tuple[Any, ...]:
        i, j = place
        p, beside = self.M[i][j], self._beside(k, place)
        left = sum(not q.rem(p).is_zero for q in beside) if p.degree() else 0
        parameters, figures = size_of(p)
        return parameters, left, p not in (p.one, -p.one), (i != k) + (j != k), len(beside), figures, i, j

    def _beside(self, k: int, place: tuple[int, int]) -> list[sp.Poly]:
        """The entries in the row and the column of a place that are not zero."""
        i, j = place
        found = [row[j] for at, row in enumerate(self.M) if at >= k and at != i]
        found += [q for at, q in enumerate(self.M[i]) if at >= k and at != j]
        return [q for q in found if not q.is_zero]

    def _bring(self, k: int, place: tuple[int, int]) -> None:
        """Exchange lines so that the pivot stands at (k, k), its row without a common factor from K."""
        i, j = place
        operations: list[Operation] = [Swap(k, i)] if i != k else []
        operations += [Swap(k, j, "C")] if j != k else []
        below = any(not row[j].is_zero for at, row in enumerate(self.M) if at >= k and at != i)
        if below or (self.M[i][j].degree() and self._beside(k, place)):
            content, lead = content_of(self.M[i])
            if content != content / content:
                self.leads += [lead]
                operations.append(Scale(k, self.M[0][0].one.mul_ground(1 / content)))
        if operations:
            self._do("pivot", k, place, operations)

    def _clear(self, k: int, kind: str) -> bool:
        """Take multiples of the pivot's row (column) from those below (beside) it; whether only zeros are left."""
        M, on_rows = self.M, kind == "rows"
        line, length = ("R", len(M)) if on_rows else ("C", len(M[0]))
        operations: list[Operation] = []
        divisions = []
        for at in range(k + 1, length):
            place = (at, k) if on_rows else (k, at)
            dividend = M[place[0]][place[1]]
            if not dividend.is_zero:
                quotient, remainder = dividend.div(M[k][k])
                operations.append(Add(at, k, -quotient, line))
                divisions.append(Division(place, dividend, M[k][k], quotient, remainder))
        if operations:
            self.leads.append(M[k][k].rep.LC())
            self._do(kind, k, (k, k), operations, tuple(divisions))
        return all(each.remainder.is_zero for each in divisions)

    def _indivisible(self, k: int) -> tuple[int, int] | None:
        """The place of an entry that the pivot does not divide."""
        pivot = self.M[k][k]
        if pivot.degree() == 0:
            return None
        places = ((i, j) for i in range(k + 1, len(self.M)) for j in range(k + 1, len(self.M[0])))
        return next(((i, j) for i, j in places if not self.M[i][j].rem(pivot).is_zero), None)

    def _make_monic(self, k: int) -> None:
        lead, one = self.M[k][k].rep.LC(), self.M[0][0].one
        if lead != one.domain.one:
            self.leads.append(lead)
            self._do("monic", k, (k, k), [Scale(k, one.mul_ground(one.domain.one / lead))])

    def _do(
        self,
        kind: str,
        k: int,
        place: tuple[int, int],
        operations: list[Operation],
        divisions: tuple[Division, ...] = (),
    ) -> None:
        before = tuple(map(tuple, self.M))
        for operation in operations:
            if operation.line == "R":
                carry_out(self.M, operation)
            else:
                turned = [list(column) for column in zip(*self.M, strict=True)]
                carry_out(turned, operation)
                self.M = [list(row) for row in zip(*turned, strict=True)]
        stage = SmithStage(kind, k, place, tuple(operations), divisions, before, tuple(map(tuple, self.M)))
        self.stages.append(stage)
        self.figures += stage.figures


def content_of(polynomials: Sequence[sp.Poly]) -> tuple[Any, Any]:
    """The factor from K that all coefficients have in common (rationals, parameters), and its numerator."""
    K = polynomials[0].domain
    numbers = [c for p in polynomials for c in p.rep.to_list() if c]
    if K.is_QQ:
        content = reduce(K.gcd, numbers[1:], abs(numbers[0]))
        return content, content
    if not in_parameters(K):
        return K.one, K.one
    R = K.get_ring()
    above = reduce(R.gcd, (K.numer(c) for c in numbers))
    below = reduce(R.lcm, (K.denom(c) for c in numbers))
    lead = K.convert(above, R)
    return lead / K.convert(below, R), lead


def carried_out(operations: Sequence[Operation], line: str, rows: Rows) -> sp.ImmutableMatrix:
    """The operations on rows (columns) carried out on the identity that stands before (behind) the matrix."""
    one, size = rows[0][0].one, len(rows) if line == "R" else len(rows[0])
    M = [[one if i == j else one.zero for j in range(size)] for i in range(size)]
    for operation in operations:
        if operation.line == line:
            carry_out(M, operation)
    found = matrix_of_rows(M)
    return found if line == "R" else sp.ImmutableMatrix(found.T)
