"""Matrices of vectors, many of which are right: judged column by column, or row by row."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from solver.classroom.judging.entries import word_of
from solver.classroom.judging.question import Question, checks_of
from solver.classroom.judging.rounding import within_rounding
from solver.classroom.submitted import Submitted, replaced
from solver.derivation import Check, CheckStatus

MOST_VECTORS = 5
"""Larger matrices with many right values are judged as a whole only."""


def vectors(question: Question, name: str, each: Submitted) -> Any:
    """Entries of a matrix with many right values: a column (or row) is right that can replace one of a right matrix."""
    ours, own = question.ours.get(name), each.value
    if not isinstance(own, sp.MatrixBase) or not isinstance(ours, sp.MatrixBase) or own.shape != ours.shape:
        return None
    rows = _in_rows(question, name)
    right = _right_vectors(question, name, each) or set()
    if len(right) == (own.rows if rows else own.cols):  # each is right, but not all together
        right = set()
    return [[word_of((i if rows else j) in right) for j in range(own.cols)] for i in range(own.rows)]


def _right_vectors(question: Question, name: str, each: Submitted) -> set[int] | None:
    """Return the columns (or rows) that can each take the place of another one of ours, to the digits written.

    None where the answer is no matrix of vectors, or too large a one.
    """
    ours: Any = question.ours.get(name)
    vectors = question.task.answers[name].vectors
    fits = isinstance(ours, sp.MatrixBase) and isinstance(each.form, sp.MatrixBase) and each.form.shape == ours.shape
    if not vectors or not fits or max(ours.shape) > MOST_VECTORS:
        return None
    rows = _in_rows(question, name)
    mine, own = (ours.T, each.form.T) if rows else (ours, each.form)
    left, found = list(range(mine.cols)), set[int]()
    for j in range(own.cols):
        for k in left:
            tried = mine.as_mutable()
            tried[:, k] = own[:, j]
            form = sp.ImmutableMatrix(tried.T if rows else tried)
            decimals = {symbol: each.decimals[symbol] for symbol in form.free_symbols & each.decimals.keys()}
            value = replaced(form, {symbol: decimal.number for symbol, decimal in decimals.items()})
            if _is_right(question, name, Submitted(value, form, decimals)):
                found.add(j)
                left.remove(k)
                break
    return found


def _is_right(question: Question, name: str, each: Submitted) -> bool:
    """Whether a value passes its own checks, exactly or but for rounding."""
    own = [check for check in checks_of(question, {name: each}) or () if name in check.judges]
    failed = [check for check in own if check.status is CheckStatus.FAILED]
    if not failed:
        return bool(own) and all(check.status is CheckStatus.PASSED for check in own)
    return bool(each.decimals) and within_rounding(question, name, each, {name: each}, failed)


def rounded(question: Question, name: str, fitting: Mapping[str, Submitted], failed: list[Check]) -> bool:
    """Whether rounding explains what is left: of each vector of a matrix by itself, where it is made of such."""
    each = fitting[name]
    if not within_rounding(question, name, each, fitting, failed):
        return False
    right = _right_vectors(question, name, each)
    return right is None or len(right) == (each.value.rows if _in_rows(question, name) else each.value.cols)


def _in_rows(question: Question, name: str) -> bool:
    return question.task.answers[name].vectors == "rows"
