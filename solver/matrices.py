"""The entries of a matrix, as expressions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sympy import ImmutableDenseMatrix, MatrixBase


def entry_alone(value: Any) -> Any:
    """Return the entry of a matrix that has no other; any other value as it is."""
    return value[0, 0] if isinstance(value, MatrixBase) and value.shape == (1, 1) else value


def entries(M: MatrixBase) -> Sequence[Any]:
    """Return the entries row by row; `flat()` would make the expressions anew, an immutable matrix keeps its own."""
    return M.args[2].args if isinstance(M, ImmutableDenseMatrix) else M.flat()
