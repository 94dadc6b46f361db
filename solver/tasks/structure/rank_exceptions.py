"""The parameters that lower a rank."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from solver.lazy import exact

if TYPE_CHECKING:
    from sympy import ImmutableMatrix


def rank_exceptions(matrix: ImmutableMatrix) -> list[Any] | None:
    """Return the conditions on parameters under which the rank is lower; None if they cannot be found."""
    try:
        return list(exact.rank_conditions(matrix))
    except exact.NotExact:
        return None
