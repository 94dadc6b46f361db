"""Matrices of vectors, many of which are right: judged column by column, or row by row."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp

from solver.classroom.judging.entries import word_of
from solver.classroom.judging.question import Question, checks_of
from solver.classroom.judging.rounding import within_rounding
from solver.classroom.submitted import Submitted, replaced
from solver.derivation import Check, CheckStatus

MOST_VECTORS = 5
"""Larger matrices with many right values are judged as a whole only."""


@dataclass(frozen=True)
class Vectors:
    """A submitted value that is not determined by the question, perhaps a matrix of vectors, each right or wrong."""

    question: Question
    name: str
    each: Submitted

    @property
    def in_rows(self) -> bool:
        """Whether the vectors are rows."""
        return self.question.task.answers[self.name].vectors == "rows"

    @property
    def count(self) -> int:
        """The number of vectors."""
        return int(self.each.value.rows if self.in_rows else self.each.value.cols)

    def entries(self) -> Any:
        """The entries: a vector is right that can replace one of a right matrix. None for another kind of value."""
        ours, own = self.question.ours.get(self.name), self.each.value
        if not isinstance(own, sp.MatrixBase) or not isinstance(ours, sp.MatrixBase) or own.shape != ours.shape:
            return None
        right = self.right or set()
        if len(right) == self.count:  # each is right, but not all together
            right = set()
        return [[word_of((i if self.in_rows else j) in right) for j in range(own.cols)] for i in range(own.rows)]

    def rounded(self, fitting: Mapping[str, Submitted], failed: list[Check]) -> bool:
        """Whether rounding explains what is left: of each vector by itself, where the value is made of such."""
        if self.right is None:
            return within_rounding(self.question, self.name, self.each, fitting, failed)
        return len(self.right) == self.count and all(check.residual is not None for check in failed)

    @cached_property
    def right(self) -> set[int] | None:
        """The vectors that can each take the place of another one of ours, to the digits written.

        None where the answer is no matrix of vectors, or too large a one.
        """
        question, name, each = self.question, self.name, self.each
        ours: Any = question.ours.get(name)
        fits = (
            isinstance(ours, sp.MatrixBase) and isinstance(each.form, sp.MatrixBase) and each.form.shape == ours.shape
        )
        if not question.task.answers[name].vectors or not fits or max(ours.shape) > MOST_VECTORS:
            return None
        mine, own = (ours.T, each.form.T) if self.in_rows else (ours, each.form)
        left, found = list(range(mine.cols)), set[int]()
        for j in range(own.cols):
            for k in left:
                tried = mine.as_mutable()
                tried[:, k] = own[:, j]
                form = sp.ImmutableMatrix(tried.T if self.in_rows else tried)
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
