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
    other = row(f"{operation.line}_{{{operation.j + 1}}}")
    if _begins_with_minus(operation.factor):
        return row(changed, r"\leftarrow", changed, "-", _multiple(show(-operation.factor), other))
    return row(changed, r"\leftarrow", summed([changed, _multiple(show(operation.factor), other)]))


def _begins_with_minus(factor: Any) -> bool:
    """Whether it is a sum whose highest term has a minus: −(s + 1) is subtracted."""
    if not getattr(factor, "is_Add", False):
        return False
    highest = max(factor.as_ordered_terms(), key=_degree)
    return bool(highest.could_extract_minus_sign())


def _degree(term: Any) -> Any:
    """The number of symbols that are multiplied in a term."""
    powers = term.as_powers_dict().items()
    return sum(exponent for base, exponent in powers if base.is_Symbol and exponent.is_Integer)


def _multiple(factor: Row, name: Row) -> Row:
    if is_negative(factor) and not is_sum(without_sign(factor)):
        return row("-", _multiple(without_sign(factor), name))
    if factor == row("1"):
        return name
    return joined([row(parenthesized(factor)) if is_sum(factor) else factor, name])
