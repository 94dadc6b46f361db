"""Row operations, and those of columns, as formulas."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from solver.formula.building import is_negative, is_sum, joined, parenthesized, row, summed, without_sign
from solver.formula.nodes import Row


def row_operation(operation: Any, show: Callable[[Any], Row]) -> Row:
    """Return an operation (`exact.row_reduction`: Swap, Scale or Add) on rows R or columns C, counted from 1."""
    changed = row(f"{operation.line}_{{{operation.i + 1}}}")
    if not hasattr(operation, "factor"):
        return row(changed, rf"\leftrightarrow {operation.line}_{{{operation.j + 1}}}")
    if not hasattr(operation, "j"):
        return row(changed, r"\leftarrow", _multiple(show(operation.factor), changed))
    other = _multiple(show(operation.factor), row(f"{operation.line}_{{{operation.j + 1}}}"))
    return row(changed, r"\leftarrow", summed([changed, other]))


def _multiple(factor: Row, name: Row) -> Row:
    if is_negative(factor) and not is_sum(without_sign(factor)):
        return row("-", _multiple(without_sign(factor), name))
    if factor == row("1"):
        return name
    return joined([row(parenthesized(factor)) if is_sum(factor) else factor, name])
