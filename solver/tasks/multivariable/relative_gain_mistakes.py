"""Usual mistakes with relative gains."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from solver.derivation import Attempt, Slip
from solver.lazy import exact
from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from solver.derivation import Task

NOT_TRANSPOSED = Slip("transposed", "the inverse is not transposed: it is $G \\circ G^{-1}$")
MATRIX_PRODUCT = Slip("matrix_product", "the matrices are multiplied as matrices; the product is one entry by entry")
GAINS = Slip("gains", "these are the gains themselves")
OTHER_PAIRING = Slip("order", "rows or columns are exchanged")


def register(task: Task[Any, Any], gains_of: Any) -> None:
    """Register what goes wrong; `gains_of` tells the matrix K of a question."""

    def not_transposed(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        K, inverse = _found(attempt, gains_of)
        yield sp.ImmutableMatrix(K.multiply_elementwise(inverse))

    def multiplied(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        K, inverse = _found(attempt, gains_of)
        yield sp.ImmutableMatrix(K * inverse.T)

    def gains(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        yield _found(attempt, gains_of)[0]

    def exchanged(attempt: Attempt[Any, Any]) -> Iterable[Any]:
        yield sp.ImmutableMatrix(attempt.ours[:, ::-1])

    task.mistake(NOT_TRANSPOSED, "Lambda")(not_transposed)
    task.mistake(MATRIX_PRODUCT, "Lambda")(multiplied)
    task.mistake(GAINS, "Lambda")(gains)
    task.mistake(OTHER_PAIRING, "Lambda")(exchanged)


def _found(attempt: Attempt[Any, Any], gains_of: Any) -> tuple[Any, Any]:
    K = gains_of(attempt.given)
    return K, exact.relative_gains(K).inverse
