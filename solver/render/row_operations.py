"""Row operations as LaTeX."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from solver.formula.pieces import is_sum, joined, parenthesized, summed


def row_operation(operation: Any, tex: Callable[[Any], str]) -> str:
    """Return a row operation (`exact.row_reduction`: Swap, Scale or Add); rows are counted from 1."""
    row = f"R_{{{operation.i + 1}}}"
    if not hasattr(operation, "factor"):
        return rf"{row} \leftrightarrow R_{{{operation.j + 1}}}"
    if not hasattr(operation, "j"):
        return rf"{row} \leftarrow {_multiple(tex(operation.factor), row)}"
    other = _multiple(tex(operation.factor), f"R_{{{operation.j + 1}}}")
    return rf"{row} \leftarrow {summed([row, other])}"


def _multiple(factor: str, row: str) -> str:
    if factor in {"1", "-1"}:
        return factor.replace("1", row)
    return joined([factor if not is_sum(factor.removeprefix("-")) else parenthesized(factor), row])
