"""The entries of a matrix, as expressions."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from solver.lazy import sympy as sp

if TYPE_CHECKING:
    from sympy import ImmutableMatrix, MatrixBase


def entry_alone(value: Any) -> Any:
    """Return the entry of a matrix that has no other; any other value as it is."""
    return value[0, 0] if isinstance(value, sp.MatrixBase) and value.shape == (1, 1) else value


@lru_cache(maxsize=64)
def identity(n: int) -> ImmutableMatrix:
    """Return the identity with n rows."""
    return sp.ImmutableMatrix(sp.eye(n))


def entries(M: MatrixBase) -> Sequence[Any]:
    """Return the entries row by row; `flat()` would make the expressions anew, an immutable matrix keeps its own."""
    return M.args[2].args if isinstance(M, sp.ImmutableDenseMatrix) else M.flat()
