"""Submitted values compared with ours entry by entry, to the digits written."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import sympy as sp

from solver.classroom.submitted import Submitted
from solver.classroom.verdicts import Verdict
from solver.derivation import Check, CheckStatus
from solver.lazy import numeric


def entrywise(each: Submitted, ours: Any, *, ordered: bool = False) -> Any:
    """Return "correct" or "wrong" for each entry compared with ours, in its shape; None if they can't be compared."""
    try:
        return _compared(each, ours, ordered=ordered)
    except numeric.NotEvaluable:
        return None


def _compared(each: Submitted, ours: Any, *, ordered: bool) -> Any:
    if isinstance(each.value, sp.MatrixBase) and isinstance(ours, sp.MatrixBase):
        if each.value.shape != ours.shape:
            return None
        rows = range(ours.rows)
        return [[word_of(_agrees(each, each.form[i, j], ours[i, j])) for j in range(ours.cols)] for i in rows]
    if isinstance(each.value, list) and isinstance(ours, list | tuple):
        return _in_order(each, ours) if ordered else _as_set(each, list(ours))
    if is_scalar(each.value) and is_scalar(ours):
        return word_of(_agrees(each, each.form, ours))
    if isinstance(each.value, Mapping) and isinstance(ours, Mapping):
        return word_of(_same_item(each, each.form, ours))
    return word_of(each.value == ours) if isinstance(each.value, bool | str) else None


def _in_order(each: Submitted, ours: Sequence[Any]) -> list[Any]:
    """Items compared with those at the same place; what is left over or missing is wrong."""
    pairs = zip(each.form, ours, strict=False)
    words = [word_of(_same_item(each, form, mine)) for form, mine in pairs]
    return words + [str(Verdict.WRONG)] * (max(len(each.form), len(ours)) - len(words))


def same(each: Submitted, value: Any) -> bool:
    """Whether a submitted value is this one to the digits written; of a matrix no entry is tried after a wrong one."""
    try:
        if isinstance(each.value, sp.MatrixBase) and isinstance(value, sp.MatrixBase):
            pairs = zip(each.form.flat(), value.flat(), strict=False)
            return each.value.shape == value.shape and all(_agrees(each, form, mine) for form, mine in pairs)
        if isinstance(each.value, Mapping) and isinstance(value, Mapping):
            return _same_item(each, each.form, value)
        entries = _compared(each, value, ordered=False)
    except numeric.NotEvaluable:
        return False
    return entries not in (None, []) and all_right(entries)


def same_entry(each: Submitted, i: int, j: int, value: Any) -> bool:
    """Whether an entry of a submitted matrix is this number to the digits written."""
    return _agrees(each, each.form[i, j], value)


def is_scalar(value: Any) -> bool:
    """Whether a value is an expression; sympy's immutable matrices are expressions too."""
    return isinstance(value, sp.Expr) and not isinstance(value, sp.MatrixBase)


def _as_set(each: Submitted, ours: list[Any]) -> list[Any]:
    """Items found among ours, in any order, each as often as it stands there; a list that is too short is wrong."""
    left = list(ours)
    words = []
    for form in each.form:
        partner = next((i for i, mine in enumerate(left) if _same_item(each, form, mine)), None)
        words.append(word_of(partner is not None))
        if partner is not None:
            del left[partner]
    return words + [str(Verdict.WRONG)] * max(0, len(ours) - len(words))


def _same_item(each: Submitted, form: Any, mine: Any) -> bool:
    if isinstance(form, sp.MatrixBase) and isinstance(mine, sp.MatrixBase):
        return form.shape == mine.shape and all(
            _agrees(each, a, b) for a, b in zip(form.flat(), mine.flat(), strict=True)
        )
    if is_scalar(form) and is_scalar(mine):
        return _agrees(each, form, mine)
    if isinstance(form, Mapping) and isinstance(mine, Mapping):
        own = {str(name): value for name, value in form.items()}
        return set(own) == set(map(str, mine)) and all(_agrees(each, own[str(x)], v) for x, v in mine.items())
    return bool(form == mine)


def _agrees(each: Submitted, form: Any, mine: Any) -> bool:
    """Whether an entry is ours, to the digits written, also those of decimals in ours. Raises NotEvaluable."""
    if mine.free_symbols & each.decimals.keys():
        form, mine = form - mine, sp.Integer(0)
    decimals = {symbol: (decimal.number, decimal.half_unit) for symbol, decimal in each.decimals.items()}
    return bool(form == mine) or bool(numeric.agrees_to_digits(form, decimals, mine))


def by_items(checks: Iterable[Check], entries: Any, value: Any, ours: Any) -> Any:
    """Entries of a list whose items have checks of their own: one that passes is right, what is missing is wrong."""
    passed = {check.item: check.status is CheckStatus.PASSED for check in checks if check.item}
    if not passed or not isinstance(value, list) or not isinstance(entries, list):
        return entries
    found = [word_of(passed.get(i, False) or entries[i - 1] == Verdict.CORRECT) for i in range(1, len(value) + 1)]
    right, left = found.count(str(Verdict.CORRECT)), len(ours) - len(found)
    return found + [str(Verdict.WRONG)] * max(left, 1 if right == len(found) else 0)


def word_of(right: bool) -> str:
    """Return the verdict of an entry as it is reported."""
    return str(Verdict.CORRECT if right else Verdict.WRONG)


def all_right(entries: Any) -> bool:
    """Whether every entry of what `entrywise` returned is right."""
    if isinstance(entries, list):
        return all(map(all_right, entries))
    return bool(entries == Verdict.CORRECT)


def shaped(value: Any, of: Any, *, keep: bool = False) -> Any:
    """Apply a function to every entry; a matrix becomes nested lists, or stays a matrix if `keep`."""
    if isinstance(value, sp.MatrixBase):
        if keep:
            return sp.ImmutableMatrix(value.applyfunc(of))
        return [[of(value[i, j]) for j in range(value.cols)] for i in range(value.rows)]
    if isinstance(value, list):
        return [shaped(item, of, keep=keep) if isinstance(item, sp.MatrixBase) else of(item) for item in value]
    if isinstance(value, dict):
        return {name if keep else str(name): of(item) for name, item in value.items()}
    return of(value) if keep and isinstance(value, sp.Basic) else (value if keep else of(value))
